//! Photon maps in files, from which later runs read them.

use super::map::{Photon, PhotonMap};
use super::{PhotonMapSettings, Photons};
use crate::scene::{Digest, LightFile, LightHeader, LightKind, LightWriter, decode_numbers};
use crate::transport::FrameContext;
use std::io::{self, Write};

impl Photons {
    /// Returns the photons of the file that the scene loads; `None` without a file, and for a quality without photons.
    pub fn from_scene_file(context: &FrameContext) -> Option<Self> {
        let settings = context.world.photon_map.as_ref().filter(|_| context.quality.reflection)?;
        settings.saved.loaded.as_ref().map(|loaded| Self::from_file(&loaded.file, settings))
    }

    /// Returns the photons of a file. The trees are those of the run that saved them.
    fn from_file(file: &LightFile, settings: &PhotonMapSettings) -> Self {
        let n_surface = file.header.counts[0] as usize;
        let map = |first: usize, count: usize| {
            let records = file.records().skip(first).take(count);
            PhotonMap::from_tree(records.map(|record| (Photon::from_bytes(record), record[record.len() - 1])))
        };
        Self::new(map(0, n_surface), map(n_surface, usize::MAX), settings)
    }

    /// Writes the photons to a file, with the digests of the scene and of the computation.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn save(&self, [scene, computation]: [Digest; 2], out: &mut dyn Write) -> io::Result<()> {
        let counts = [&self.surface, &self.media].map(|map| map.photons.len() as u64);
        let header = LightHeader { kind: LightKind::Photons, scene, computation, counts };
        let mut writer = LightWriter::new(out, &header);
        for (photon, axis) in self.surface.photons.tree().chain(self.media.photons.tree()) {
            photon.numbers().try_for_each(|number| writer.push(&number.to_le_bytes()))?;
            writer.push(&[axis])?;
        }
        writer.finish()
    }
}

impl Photon {
    /// Decodes a photon from its bytes in a file of saved photons.
    fn from_bytes(record: &[u8]) -> Self {
        let [a, b, c, d, e, f, g, h, i] = decode_numbers(record, f32::from_le_bytes);
        Self::from_numbers([a, b, c], [d, e, f], [g, h, i])
    }
}
