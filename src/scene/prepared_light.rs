//! Files of prepared light: the photons and radiosity samples of one picture, which `durer prepare` writes for the shards
//! of the picture.
//!
//! A file has a head (magic, kind, version of the format), and then the photons and the samples of radiosity: each is the
//! length in bytes as a `u64`, 0 for none, and a file of light of that length.

use super::light_file::{LightFile, LightFileError, LightKind, MAGIC};
use std::io::{self, Write};

/// Byte in a file's head that identifies a file with both photons and radiosity samples, in place of the byte of a
/// [`LightKind`].
const KIND: u8 = 3;
/// Version of the format of prepared light; the photons and radiosity samples have versions of their own.
const VERSION: u8 = 1;

/// Photons and radiosity samples of one picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PreparedLight {
    /// Photons; `None` for a picture without photons.
    pub photons: Option<LightFile>,
    /// Samples of radiosity; `None` for a picture without radiosity.
    pub radiosity: Option<LightFile>,
}

impl PreparedLight {
    /// Checks the bytes of a file that `durer prepare` wrote, and returns its photons and radiosity samples.
    ///
    /// # Errors
    /// The reason for which the file is not used.
    pub fn parse(bytes: &[u8]) -> Result<Self, LightFileError> {
        let rest = bytes.strip_prefix(&MAGIC).ok_or(LightFileError::NotWrittenByDurer)?;
        let mut rest = match rest {
            [KIND, VERSION, rest @ ..] => rest,
            [KIND, _, ..] => return Err(LightFileError::OtherVersion),
            [_, ..] => return Err(LightFileError::OtherKind),
            [] => return Err(LightFileError::Damaged),
        };
        let mut part = |kind| {
            let (length, after) = rest.split_first_chunk::<8>().ok_or(LightFileError::Damaged)?;
            let length = usize::try_from(u64::from_le_bytes(*length)).map_err(|_| LightFileError::Damaged)?;
            let (part, after) = after.split_at_checked(length).ok_or(LightFileError::Damaged)?;
            rest = after;
            if part.is_empty() { Ok(None) } else { LightFile::parse(part.to_vec(), kind).map(Some) }
        };
        let (photons, radiosity) = (part(LightKind::Photons)?, part(LightKind::Radiosity)?);
        if rest.is_empty() { Ok(Self { photons, radiosity }) } else { Err(LightFileError::Damaged) }
    }

    /// Writes a file from the bytes of a file of photons and of a file of radiosity samples; empty for none.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(photons: &[u8], radiosity: &[u8], out: &mut dyn Write) -> io::Result<()> {
        out.write_all(&MAGIC)?;
        out.write_all(&[KIND, VERSION])?;
        for part in [photons, radiosity] {
            out.write_all(&(part.len() as u64).to_le_bytes())?;
            out.write_all(part)?;
        }
        out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{LightHeader, LightWriter};

    fn light(kind: LightKind) -> Vec<u8> {
        let mut out = vec![];
        let header = LightHeader { kind, scene: [1; 32], computation: [2; 32], counts: [0, 0] };
        LightWriter::new(&mut out, &header).finish().unwrap();
        out
    }

    fn prepared(photons: &[u8], radiosity: &[u8]) -> Vec<u8> {
        let mut out = vec![];
        PreparedLight::write(photons, radiosity, &mut out).unwrap();
        out
    }

    #[test]
    fn files_are_read_as_they_were_written() {
        let (photons, radiosity) = (light(LightKind::Photons), light(LightKind::Radiosity));
        for (photons, radiosity) in [(&photons[..], &radiosity[..]), (&photons, &[]), (&[], &radiosity), (&[], &[])] {
            let light = PreparedLight::parse(&prepared(photons, radiosity)).unwrap();
            assert_eq!(light.photons.is_some(), !photons.is_empty());
            assert_eq!(light.radiosity.is_some(), !radiosity.is_empty());
        }
    }

    #[test]
    fn a_changed_or_cut_file_is_an_error() {
        let whole = prepared(&light(LightKind::Photons), &light(LightKind::Radiosity));
        for at in 0..whole.len() {
            assert!(PreparedLight::parse(&whole[..at]).is_err(), "cut at {at}");
            let mut changed = whole.clone();
            changed[at] ^= 0x10;
            assert!(PreparedLight::parse(&changed).is_err(), "changed at {at}");
        }
        assert_eq!(PreparedLight::parse(&[&whole[..], &[0]].concat()), Err(LightFileError::Damaged));
        assert_eq!(PreparedLight::parse(&light(LightKind::Photons)), Err(LightFileError::OtherKind));
        assert_eq!(PreparedLight::parse(b"sphere"), Err(LightFileError::NotWrittenByDurer));
    }
}
