//! Samples of radiosity in files, from which later runs read them.

use super::RadiosityState;
use super::cache::Sample;
use crate::color::Rgb;
use crate::math::{DVec3, cancel};
use crate::scene::{Digest, LightFile, LightHeader, LightKind, LightWriter, decode_numbers};
use std::io::{self, Write};

impl RadiosityState<'_> {
    /// Adds the samples of a file, in the order in which they were saved.
    pub fn add_file(&mut self, file: &LightFile) {
        for record in file.records() {
            if cancel::is_cancelled() {
                return;
            }
            self.cache.insert(Sample::from_bytes(record));
        }
    }

    /// Writes all samples to a file, with the digests of the scene and of the computation.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn save(&self, [scene, computation]: [Digest; 2], out: &mut dyn Write) -> io::Result<()> {
        let counts = [self.n_samples() as u64, 0];
        let mut writer = LightWriter::new(out, &LightHeader { kind: LightKind::Radiosity, scene, computation, counts });
        for sample in self.cache.samples() {
            let Sample { point, normal, light, radius, nearest, toward_nearest, depth } = sample;
            let vectors = [point, normal, light, toward_nearest].map(|vector| vector.to_array());
            let numbers = vectors.as_flattened().iter().chain([radius, nearest]);
            numbers.into_iter().try_for_each(|number| writer.push(&number.to_le_bytes()))?;
            writer.push(&[*depth])?;
        }
        writer.finish()
    }
}

impl Sample {
    /// Decodes a radiosity sample from its bytes in a file of saved samples.
    fn from_bytes(record: &[u8]) -> Self {
        let [px, py, pz, nx, ny, nz, r, g, b, tx, ty, tz, radius, nearest] = decode_numbers(record, f64::from_le_bytes);
        Self {
            point: DVec3::new(px, py, pz),
            normal: DVec3::new(nx, ny, nz),
            light: Rgb::new(r, g, b),
            radius,
            nearest,
            toward_nearest: DVec3::new(tx, ty, tz),
            depth: record[record.len() - 1],
        }
    }
}
