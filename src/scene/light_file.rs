//! Files of light that one run computes and another run uses: photons, and samples of radiosity.
//!
//! All numbers are little-endian. A file has a head (magic, kind, version of the format, two digests, two counts),
//! records of one length, and the BLAKE3 hash of all bytes before the hash.

use std::fmt;
use std::io::{self, Write};
use std::sync::Arc;

/// First bytes of each file in which durer saves photons or radiosity samples.
pub(super) const MAGIC: [u8; 6] = *b"\x89durer";
/// Length of a digest in bytes.
const DIGEST: usize = 32;
/// Length in bytes of the head of a file of saved photons or radiosity samples.
const HEAD: usize = MAGIC.len() + 2 + 2 * DIGEST + 16;
/// Number of bytes that a writer collects before it hashes and writes them.
const CHUNK: usize = 1 << 16;
/// Maximum length in bytes of a file of saved photons or radiosity samples.
pub const MAX_LENGTH: u64 = 4 << 30;
/// Maximum number of diffuse bounces before a radiosity sample in a file; a file with more is damaged.
const MAX_DEPTH: u8 = 20;
/// Maximum radius of a radiosity sample in a file, in world units; a file with a larger one is damaged.
const MAX_RADIUS: f64 = 1e100;

/// BLAKE3 hash of the input from which photons or radiosity samples were computed.
pub type Digest = [u8; DIGEST];

/// Kind of the records in a file of saved light: photons or radiosity samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightKind {
    /// Photons on surfaces, and then photons in media. Record: position, flux and direction, 3 × `f32` each, and for the first
    /// photon of a leaf of the tree the axis of the division in front of the leaf, else 0.
    Photons,
    /// Samples of radiosity. Record: point, normal, light, and direction to the nearest surface, 3 × `f64` each, the
    /// radius, the distance to the nearest surface, and the number of bounces.
    Radiosity,
}

/// Head of a file of saved photons or radiosity samples: kind, digests and counts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LightHeader {
    /// Kind of the file's records: photons or radiosity samples.
    pub kind: LightKind,
    /// Digest of the scene's objects, materials and light sources; the camera and the radiosity settings do not affect
    /// this digest.
    pub scene: Digest,
    /// Digest of everything that determines the light.
    pub computation: Digest,
    /// Numbers of the file's records: of photons on surfaces and of photons in media, or of radiosity samples and 0.
    pub counts: [u64; 2],
}

/// Contents of a file of saved photons or radiosity samples whose hash and records were checked.
#[derive(Clone)]
pub struct LightFile {
    /// Head of the file of saved photons or radiosity samples.
    pub header: LightHeader,
    bytes: Arc<[u8]>,
}

/// Reason for which a file of saved photons or radiosity samples is not used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightFileError {
    /// POV-Ray wrote the file of photons or radiosity samples, in a format that durer does not read.
    WrittenByPovRay,
    /// The file does not begin like a file of photons or radiosity samples that durer wrote.
    NotWrittenByDurer,
    /// The file holds photons where radiosity samples are expected, or the other way round.
    OtherKind,
    /// The file has another version of the format.
    OtherVersion,
    /// Bytes of the file are missing or wrong.
    Damaged,
}

impl LightKind {
    /// Returns the length in bytes of one photon or one radiosity sample in a file.
    fn record_length(self) -> usize {
        match self {
            Self::Photons => 9 * 4 + 1,
            Self::Radiosity => 14 * 8 + 1,
        }
    }

    /// Returns the version of the format, which changes when the records, what they mean, or the head do.
    fn version(self) -> u8 {
        match self {
            Self::Photons => 3,
            Self::Radiosity => 2,
        }
    }

    /// Returns the byte by which a file's head identifies the kind: photons or radiosity samples.
    fn number(self) -> u8 {
        self as u8 + 1
    }

    /// Returns the words for messages: `photons` or `samples of radiosity`.
    pub fn plural_name(self) -> &'static str {
        match self {
            Self::Photons => "photons",
            Self::Radiosity => "samples of radiosity",
        }
    }

    /// Returns radiosity samples for photons, and photons for radiosity samples.
    pub fn other(self) -> Self {
        match self {
            Self::Photons => Self::Radiosity,
            Self::Radiosity => Self::Photons,
        }
    }

    /// True if the numbers of a record are in range.
    fn is_valid(self, record: &[u8]) -> bool {
        let is_unit = |v: &[f64]| (v.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-3;
        let (numbers, last) = record.split_at(record.len() - 1);
        match self {
            Self::Photons => {
                let numbers: [f64; 9] = decode_numbers(numbers, f32::from_le_bytes).map(f64::from);
                numbers.iter().all(|x| x.is_finite()) && is_unit(&numbers[6..9]) && last[0] < 3
            }
            Self::Radiosity => {
                let numbers: [f64; 14] = decode_numbers(numbers, f64::from_le_bytes);
                let (toward_nearest, radius, nearest) = (&numbers[9..12], numbers[12], numbers[13]);
                numbers.iter().all(|x| x.is_finite())
                    && is_unit(&numbers[3..6])
                    && (is_unit(toward_nearest) || toward_nearest == [0.0; 3])
                    && (0.0..=radius).contains(&nearest)
                    && (f64::MIN_POSITIVE..=MAX_RADIUS).contains(&radius)
                    && last[0] <= MAX_DEPTH
            }
        }
    }
}

/// Decodes the numbers at the start of a record, each from `B` bytes; numbers that are missing are the default.
pub fn decode_numbers<T: Copy + Default, const N: usize, const B: usize>(
    record: &[u8],
    decode: fn([u8; B]) -> T,
) -> [T; N] {
    let mut numbers = [T::default(); N];
    numbers.iter_mut().zip(record.as_chunks::<B>().0).for_each(|(number, bytes)| *number = decode(*bytes));
    numbers
}

impl LightFile {
    /// Checks the bytes of a file of this kind.
    ///
    /// # Errors
    /// The reason for which the file is not used.
    pub fn parse(bytes: Vec<u8>, kind: LightKind) -> Result<Self, LightFileError> {
        let Some(rest) = bytes.strip_prefix(&MAGIC) else {
            return Err(if is_of_povray(&bytes) {
                LightFileError::WrittenByPovRay
            } else {
                LightFileError::NotWrittenByDurer
            });
        };
        match rest {
            [number, ..] if *number == kind.other().number() => return Err(LightFileError::OtherKind),
            [number, version, ..] if *number == kind.number() && *version != kind.version() => {
                return Err(LightFileError::OtherVersion);
            }
            _ => {}
        }
        let header = parse_head(&bytes, kind).ok_or(LightFileError::Damaged)?;
        let (content, hash) = bytes.split_at(bytes.len() - DIGEST);
        let mut records = content[HEAD..].chunks_exact(kind.record_length());
        if blake3::hash(content).as_bytes() != hash || !records.all(|record| kind.is_valid(record)) {
            return Err(LightFileError::Damaged);
        }
        Ok(Self { header, bytes: bytes.into() })
    }

    /// Returns the bytes of each photon or radiosity sample of the file, in the order of the file.
    pub fn records(&self) -> impl ExactSizeIterator<Item = &[u8]> {
        self.bytes[HEAD..self.bytes.len() - DIGEST].chunks_exact(self.header.kind.record_length())
    }

    /// Returns the BLAKE3 hash at the end of the file, which was checked against the contents.
    pub fn hash(&self) -> &[u8] {
        &self.bytes[self.bytes.len() - DIGEST..]
    }
}

/// Returns the head of a file; `None` if it does not fit the kind or the length of the file.
fn parse_head(bytes: &[u8], kind: LightKind) -> Option<LightHeader> {
    let mut rest = bytes.get(MAGIC.len()..HEAD)?;
    let mut take = |length: usize| {
        let (taken, after) = rest.split_at_checked(length)?;
        rest = after;
        Some(taken)
    };
    if take(2)? != [kind.number(), kind.version()] {
        return None;
    }
    let (scene, computation) = (take(DIGEST)?.try_into().ok()?, take(DIGEST)?.try_into().ok()?);
    let counts = [u64::from_le_bytes(take(8)?.try_into().ok()?), u64::from_le_bytes(take(8)?.try_into().ok()?)];
    let n_bytes = counts[0].checked_add(counts[1])?.checked_mul(kind.record_length() as u64)?;
    let is_complete = n_bytes.checked_add((HEAD + DIGEST) as u64)? == bytes.len() as u64;
    let is_possible = counts.iter().all(|&count| count <= u64::from(u32::MAX));
    (is_complete && is_possible).then_some(LightHeader { kind, scene, computation, counts })
}

/// True for the contents of a file of light that any version of durer saved, and for an empty file.
pub fn is_light_file_or_empty(bytes: &[u8]) -> bool {
    bytes.is_empty() || bytes.starts_with(&MAGIC)
}

/// True for the contents of a file that POV-Ray saved: photon maps, each with a count before photons of 20 bytes, or lines
/// of radiosity samples that begin with `C` and the bounce.
fn is_of_povray(bytes: &[u8]) -> bool {
    if let [b'C', digit, b'\t', ..] = bytes {
        return digit.is_ascii_digit();
    }
    let mut rest = bytes;
    for _ in 0..2 {
        let Some((count, after)) = rest.split_first_chunk::<4>() else { return false };
        let length = (u32::from_le_bytes(*count) as usize).saturating_mul(20);
        let Some(after) = after.get(length..) else { return false };
        rest = after;
    }
    rest.is_empty()
}

impl fmt::Debug for LightFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LightFile").field("header", &self.header).finish_non_exhaustive()
    }
}

impl PartialEq for LightFile {
    fn eq(&self, other: &Self) -> bool {
        self.hash() == other.hash()
    }
}

/// Writer of a file of photons or radiosity samples, which hashes the bytes while it writes them.
pub struct LightWriter<'a> {
    out: &'a mut dyn Write,
    hasher: blake3::Hasher,
    buffer: Vec<u8>,
}

impl<'a> LightWriter<'a> {
    /// Creates the writer of a file of photons or radiosity samples, with the head as the first bytes.
    pub fn new(out: &'a mut dyn Write, header: &LightHeader) -> Self {
        let mut buffer = Vec::with_capacity(CHUNK + 128);
        buffer.extend(MAGIC);
        buffer.extend([header.kind.number(), header.kind.version()]);
        buffer.extend(header.scene);
        buffer.extend(header.computation);
        header.counts.iter().for_each(|count| buffer.extend(count.to_le_bytes()));
        Self { out, hasher: blake3::Hasher::new(), buffer }
    }

    /// Appends bytes of a photon or radiosity sample to the file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn push(&mut self, part: &[u8]) -> io::Result<()> {
        self.buffer.extend(part);
        if self.buffer.len() >= CHUNK { self.flush() } else { Ok(()) }
    }

    /// Ends the file with the hash.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(mut self) -> io::Result<()> {
        self.flush()?;
        self.out.write_all(self.hasher.finalize().as_bytes())?;
        self.out.flush()
    }

    fn flush(&mut self) -> io::Result<()> {
        self.hasher.update(&self.buffer);
        self.out.write_all(&self.buffer)?;
        self.buffer.clear();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(kind: LightKind, n: u64) -> Vec<u8> {
        let header = LightHeader { kind, scene: [1; DIGEST], computation: [2; DIGEST], counts: [n, 0] };
        let mut out = vec![];
        let mut writer = LightWriter::new(&mut out, &header);
        for i in 0..n {
            match kind {
                LightKind::Photons => {
                    let numbers = [i as f32, 2.0, 3.0, 0.1, 0.2, 0.3, 0.0, 1.0, 0.0];
                    numbers.iter().for_each(|x| writer.push(&x.to_le_bytes()).unwrap());
                }
                LightKind::Radiosity => {
                    let numbers = [i as f64, 2.0, 3.0, 0.0, 0.0, 1.0, 0.1, 0.2, 0.3, 1.0, 0.0, 0.0, 0.5, 0.4];
                    numbers.iter().for_each(|x| writer.push(&x.to_le_bytes()).unwrap());
                }
            }
            writer.push(&[1]).unwrap();
        }
        writer.finish().unwrap();
        out
    }

    #[test]
    fn files_are_read_as_they_were_written() {
        for kind in [LightKind::Photons, LightKind::Radiosity] {
            for n in [0, 1, 7, 3000] {
                let parsed = LightFile::parse(file(kind, n), kind).unwrap();
                assert_eq!((parsed.header.counts, parsed.records().len() as u64), ([n, 0], n));
                assert_eq!(LightFile::parse(file(kind, n), kind.other()), Err(LightFileError::OtherKind));
            }
        }
    }

    #[test]
    fn a_changed_or_cut_file_is_an_error() {
        for kind in [LightKind::Photons, LightKind::Radiosity] {
            let whole = file(kind, 5);
            for at in 0..whole.len() {
                assert!(LightFile::parse(whole[..at].to_vec(), kind).is_err(), "cut at {at}");
                let mut flipped = whole.clone();
                flipped[at] ^= 0x10;
                assert!(LightFile::parse(flipped, kind).is_err(), "changed at {at}");
            }
            let mut longer = whole.clone();
            longer.push(0);
            assert_eq!(LightFile::parse(longer, kind), Err(LightFileError::Damaged));
        }
    }

    #[test]
    fn numbers_out_of_range_are_an_error_in_spite_of_the_hash() {
        for (at, number) in [
            (96, 1e200),
            (0, f64::NAN),
            (8, f64::INFINITY),
            (96, 0.0),
            (96, -1.0),
            (24, 2.0),
            (72, 0.5),
            (104, 0.6),
            (104, -0.1),
        ] {
            let mut bytes = file(LightKind::Radiosity, 2);
            bytes[HEAD + at..HEAD + at + 8].copy_from_slice(&f64::to_le_bytes(number));
            bytes.truncate(bytes.len() - DIGEST);
            let hash = blake3::hash(&bytes);
            bytes.extend(hash.as_bytes());
            assert_eq!(LightFile::parse(bytes, LightKind::Radiosity), Err(LightFileError::Damaged), "{at} {number}");
        }
    }

    #[test]
    fn files_of_povray_are_recognised() {
        let photons: Vec<u8> = [2, 0, 0, 0].into_iter().chain([7; 40]).chain([0; 4]).collect();
        assert_eq!(LightFile::parse(photons, LightKind::Photons), Err(LightFileError::WrittenByPovRay));
        assert_eq!(
            LightFile::parse(b"C1\t3.4\t-1".to_vec(), LightKind::Radiosity),
            Err(LightFileError::WrittenByPovRay)
        );
        assert_eq!(LightFile::parse(b"sphere".to_vec(), LightKind::Radiosity), Err(LightFileError::NotWrittenByDurer));
        assert_eq!(LightFile::parse(vec![], LightKind::Photons), Err(LightFileError::NotWrittenByDurer));
    }
}
