//! The pixels of a picture in the numbers of the scene.

use crate::color::Gamma;
use crate::image_io::{Picture, Samples, Stored, expand_pixel, round_gray_like_povray};
use serde::{Serialize, Serializer};
use std::sync::Arc;

/// Pixels of a bitmap's picture, decoded when they are read.
#[derive(Clone, Debug)]
pub struct Texels {
    picture: Arc<Picture>,
    /// Decoded value of each stored integer in the bitmap's colour channels; empty for floating-point pictures.
    curve: Arc<[f32]>,
    /// True if the bitmap's colours have to be divided by alpha.
    premultiplied: bool,
}

impl PartialEq for Texels {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.picture, &other.picture) && self.curve == other.curve
    }
}

impl Serialize for Texels {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq([self.width(), self.height()])
    }
}

impl Texels {
    /// Creates the pixels of a bitmap whose numbers in [0, 1] are decoded by `curve`.
    pub fn new(picture: Arc<Picture>, curve: impl Fn(f64) -> f64, premultiplied: bool) -> Self {
        let number = |part: f64| curve(part) as f32;
        let kept = |part: f64| if picture.gray_bytes { round_gray_like_povray(number(part)) } else { number(part) };
        let table = |n: u32| -> Arc<[f32]> { (0..n).map(|i| kept(f64::from(i) / f64::from(n - 1))).collect() };
        let curve = match picture.pixels.samples {
            Samples::U8(_) => table(256),
            Samples::U16(_) => table(65536),
            Samples::F32(_) => Arc::new([]),
        };
        Self { picture, curve, premultiplied }
    }

    /// Width of the bitmap in pixels.
    pub fn width(&self) -> usize {
        self.picture.pixels.width
    }

    /// Height of the bitmap in pixels.
    pub fn height(&self) -> usize {
        self.picture.pixels.height
    }

    /// True if the bitmap's file stores alpha, or a palette, which may have alpha.
    pub fn has_alpha(&self) -> bool {
        matches!(self.picture.pixels.channels, 2 | 4)
    }

    /// Palette index of the bitmap's pixel `i`; `None` without a palette.
    pub fn palette_index(&self, i: usize) -> Option<u8> {
        self.picture.indices.as_ref().and_then(|indices| indices.get(i).copied())
    }

    /// Red, green, blue and alpha of the bitmap's pixel `i`.
    pub fn rgba(&self, i: usize) -> [f64; 4] {
        let n = self.picture.pixels.channels;
        let range = i * n..(i + 1) * n;
        let [r, g, b, a] = match &self.picture.pixels.samples {
            Samples::U8(all) => expand_pixel(&all[range], |x| self.curve[x as usize], |x| f32::from(x) / 255.0),
            Samples::U16(all) => expand_pixel(&all[range], |x| self.curve[x as usize], |x| f32::from(x) / 65535.0),
            Samples::F32(all) => expand_pixel(&all[range], |x| x, |x| x),
        }
        .map(f64::from);
        if self.premultiplied && a != 0.0 { [r / a, g / a, b / a, a] } else { [r, g, b, a] }
    }
}

/// Returns the curve from a picture file's numbers to those of a scene, whose colours relate to light by `scene_gamma`.
/// `decodes_unmarked_srgb` is true if files without gamma information follow the sRGB curve. In scenes before version 3.7 without
/// `assumed_gamma`, numbers stay unchanged (quirk: `gamma_by_version`).
pub fn color_curve(
    stored: Stored,
    stated: Option<Gamma>,
    scene_gamma: Gamma,
    decodes_unmarked_srgb: bool,
) -> impl Fn(f64) -> f64 {
    let file = match (stated, stored) {
        (Some(gamma), _) => Some(gamma),
        (None, _) if scene_gamma == Gamma::Raw => None,
        (None, Stored::Plain) => None,
        (None, Stored::Unsaid) => decodes_unmarked_srgb.then_some(Gamma::Srgb),
        (None, Stored::Srgb) => Some(Gamma::Srgb),
        (None, Stored::Power(g)) => Some(Gamma::Power(g)),
    };
    let file = file.filter(|gamma| !gamma.is_equivalent(scene_gamma));
    move |v| file.map_or(v, |gamma| scene_gamma.encode(gamma.decode(v)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image_io::Pixels;

    #[test]
    fn grays_of_a_png_lose_their_fractions() {
        let pixels = Pixels { width: 256, height: 1, channels: 1, samples: Samples::U8((0..=255).collect()) };
        let picture = Picture { pixels, stored: Stored::Plain, indices: None, gray_bytes: true };
        let bytes = |curve: fn(f64) -> f64| {
            let texels = Texels::new(Arc::new(picture.clone()), curve, false);
            (0..256).map(|i| (texels.rgba(i)[0] * 255.0).round() as usize).collect::<Vec<_>>()
        };
        // 84 of the 256 numbers become one less although nothing is done to them, as in POV-Ray.
        let linear = bytes(|v| v);
        assert_eq!(linear.iter().enumerate().filter(|&(i, byte)| byte + 1 == i).count(), 84);
        assert_eq!([linear[0], linear[253], linear[255]], [0, 253, 255]);
        let decoded = bytes(|v| Gamma::Srgb.decode(v));
        assert_eq!([10, 60, 128, 200, 255].map(|i| decoded[i]), [0, 11, 55, 147, 255]);
    }
}
