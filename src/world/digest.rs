//! Digests of a World, which show whether light that an earlier run saved fits the scene.

use super::World;
use crate::scene::Digest;
use serde::Serialize;
use std::io::{self, Write};

/// Start of a span in JSON. Spans change when a text before them changes, and are no part of a digest.
const SPAN: &[u8] = b"{\"lo\":";

/// Hasher of JSON that omits spans.
#[derive(Default)]
struct JsonHasher {
    hasher: blake3::Hasher,
    /// Number of bytes of [`SPAN`] that were read last and not yet hashed.
    n_matched: usize,
    is_in_span: bool,
}

impl JsonHasher {
    /// Adds the JSON of a value to the hash, without spans.
    fn add(&mut self, value: &impl Serialize) {
        // A value that JSON cannot express counts as far as it was written.
        let _ = serde_json::to_writer(io::BufWriter::new(&mut *self), value);
        let _ = self.write(b"\n");
    }
}

impl Write for JsonHasher {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut kept = Vec::with_capacity(bytes.len() + SPAN.len());
        for &byte in bytes {
            if self.is_in_span {
                self.is_in_span = byte != b'}';
            } else if byte == SPAN[self.n_matched] {
                self.n_matched += 1;
                if self.n_matched == SPAN.len() {
                    (self.n_matched, self.is_in_span) = (0, true);
                }
            } else {
                kept.extend(&SPAN[..self.n_matched]);
                self.n_matched = usize::from(byte == SPAN[0]);
                kept.extend((self.n_matched == 0).then_some(byte));
            }
        }
        self.hasher.update(&kept);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl World {
    /// Returns the digest of all objects, lights and textures, and of the space around them.
    pub fn scene_digest(&self) -> Digest {
        let mut json = JsonHasher::default();
        json.add(&self.geometry);
        json.add(&self.parts);
        json.add(&self.parts.iter().map(|part| (part.collects_photons, part.no_shadow)).collect::<Vec<_>>());
        json.add(&self.objects);
        json.add(&self.cuts);
        json.add(&self.materials);
        json.add(&self.interiors);
        json.add(&(&self.media, &self.air, &self.filled));
        json.add(&(&self.noise, &self.waves, &self.irid_wavelength, &self.gamma));
        json.add(&self.photons);
        json.add(&(&self.lights, &self.lit_by));
        json.add(&(&self.sky, &self.fogs, &self.rainbows));
        *json.hasher.finalize().as_bytes()
    }

    /// Returns the digest of everything that determines the photons: the scene with the digest `scene`, settings, and the
    /// options of the render in `options`; or the digest in the file from which the photons are loaded; or `scene`
    /// itself for a scene without photons.
    pub fn photon_digest(&self, scene: &Digest, options: &str) -> Digest {
        let Some(settings) = &self.photon_map else { return *scene };
        if let Some(loaded) = &settings.saved.loaded {
            return loaded.file.header.computation;
        }
        let mut json = JsonHasher::default();
        json.add(&(scene, options, settings));
        json.add(&(self.max_trace_level, self.adc_bailout, self.opacity_by_color));
        *json.hasher.finalize().as_bytes()
    }

    /// Returns the digest of everything that determines the samples of radiosity: the scene with the digest `scene`, camera,
    /// settings, photons, and the options of the render in `options`.
    pub fn radiosity_digest(&self, scene: &Digest, options: &str) -> Digest {
        let mut json = JsonHasher::default();
        json.add(&(scene, options, self.photon_digest(scene, options)));
        json.add(&self.eye);
        json.add(&(&self.radiosity, &self.subsurface));
        json.add(&(self.max_trace_level, self.adc_bailout, self.opacity_by_color));
        *json.hasher.finalize().as_bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Span;

    #[test]
    fn spans_are_no_part_of_a_digest() {
        let digest = |value: &dyn Fn(&mut JsonHasher)| {
            let mut json = JsonHasher::default();
            value(&mut json);
            json.hasher.finalize()
        };
        let at = |lo| digest(&move |json| json.add(&(1, Span::new(lo, lo + 5), "{\"lo\":", 2)));
        assert_eq!(at(3), at(700));
        assert_ne!(digest(&|json| json.add(&(1, "{{\"l"))), digest(&|json| json.add(&(1, "{{\"lo"))));
    }
}
