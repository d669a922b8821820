//! Comparison of two pictures.

use crate::image_io::Frame;

/// Allowed difference between two pictures.
///
/// One program renders the same bytes everywhere. Another version may round a last digit differently, which changes a
/// few pixels on edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Difference of a channel that is allowed in any pixel, in steps of 1/255.
    pub steps: u8,
    /// Number of pixels in a thousand that may differ by more than `steps`.
    pub per_mille: f64,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self { steps: 2, per_mille: 0.5 }
    }
}

/// Result of comparing a rendered picture with its snapshot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Verdict: all pixels equal those of the snapshot.
    Identical,
    /// Verdict: the pictures differ within the tolerance.
    Close,
    /// The pictures differ by more than the tolerance, or in size.
    Differs,
}

/// Difference of a rendered picture from its snapshot, with 8 bits per channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// Width and height of the expected picture; `None` if they equal those of the rendered picture.
    pub other_size: Option<(usize, usize)>,
    /// Number of compared pixels.
    pub pixels: usize,
    /// Number of pixels that differ from the snapshot.
    pub different: usize,
    /// Number of pixels that differ by more than [`Tolerance::steps`].
    pub beyond: usize,
    /// Largest difference of a channel, in steps of 1/255.
    pub largest: u8,
    /// Verdict of the comparison with the snapshot.
    pub verdict: Verdict,
}

/// Compares the expected picture with the rendered one. Colours of fully transparent pixels are ignored.
pub fn compare(expected: &Frame, rendered: &Frame, tolerance: Tolerance) -> Comparison {
    let pixels = rendered.pixels.len();
    if (expected.width, expected.height) != (rendered.width, rendered.height) {
        let other_size = Some((expected.width, expected.height));
        return Comparison {
            other_size,
            pixels,
            different: pixels,
            beyond: pixels,
            largest: 255,
            verdict: Verdict::Differs,
        };
    }
    let distances = pixel_differences(expected, rendered);
    let count = |limit| distances.iter().filter(|&&d| d > limit).count();
    let (different, beyond) = (count(0), count(tolerance.steps));
    let verdict = if different == 0 {
        Verdict::Identical
    } else if beyond as f64 <= pixels as f64 * tolerance.per_mille / 1000.0 {
        Verdict::Close
    } else {
        Verdict::Differs
    };
    let largest = distances.iter().copied().max().unwrap_or(0);
    Comparison { other_size: None, pixels, different, beyond, largest, verdict }
}

/// Returns the largest difference of a channel for each pixel, in steps of 1/255.
fn pixel_differences(a: &Frame, b: &Frame) -> Vec<u8> {
    let distance = |(p, q): (&[u8; 4], &[u8; 4])| match (p[3], q[3]) {
        (0, 0) => 0,
        _ => p.iter().zip(q).map(|(x, y)| x.abs_diff(*y)).max().unwrap_or(0),
    };
    a.rgba8().iter().zip(&b.rgba8()).map(distance).collect()
}

/// Returns a map of the differences of two pictures of one size: the expected picture in dim gray, with colours from
/// red for one step through orange and yellow to white for the largest difference. For pictures of different sizes, a
/// single black pixel.
pub fn difference_map(expected: &Frame, rendered: &Frame) -> Frame {
    let paint = |(pixel, d): (&[f32; 4], u8)| {
        let gray = 0.12 * (0.3 * pixel[0] + 0.59 * pixel[1] + 0.11 * pixel[2]).clamp(0.0, 1.0);
        let t = f32::from(d) / 255.0;
        if d == 0 { [gray, gray, gray, 1.0] } else { [1.0, (3.0 * t).min(1.0), (2.0 * t - 1.0).max(0.0), 1.0] }
    };
    if (expected.width, expected.height) != (rendered.width, rendered.height) {
        return Frame::new(1, 1).over_black();
    }
    let pixels = expected.pixels.iter().zip(pixel_differences(expected, rendered)).map(paint).collect();
    Frame { width: expected.width, height: expected.height, pixels }
}

impl std::fmt::Display for Comparison {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Comparison { different, pixels, largest, .. } = self;
        match (self.other_size, self.verdict) {
            (Some((width, height)), _) => write!(f, "the snapshot is {width}x{height}"),
            (None, Verdict::Identical) => write!(f, "identical"),
            (None, _) => write!(f, "{different} of {pixels} pixels differ, by up to {largest}/255"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gray(value: f32) -> Frame {
        Frame { width: 100, height: 50, pixels: vec![[value, value, value, 1.0]; 5000] }
    }

    #[test]
    fn the_three_verdicts() {
        let expected = gray(0.5);
        let verdict = |rendered: &Frame| compare(&expected, rendered, Tolerance::default()).verdict;
        let mut rendered = gray(0.5);
        assert_eq!(verdict(&rendered), Verdict::Identical);
        rendered.pixels[..2].fill([1.0, 0.0, 0.0, 1.0]);
        assert_eq!(verdict(&rendered), Verdict::Close);
        rendered.pixels[..3].fill([1.0, 0.0, 0.0, 1.0]);
        assert_eq!(verdict(&rendered), Verdict::Differs);
        assert_eq!(verdict(&gray(0.508)), Verdict::Close);
        assert_eq!(verdict(&gray(0.6)), Verdict::Differs);
        assert_eq!(verdict(&Frame::new(50, 100)), Verdict::Differs);
    }

    #[test]
    fn differing_pixels_are_counted() {
        let mut rendered = gray(0.5);
        rendered.pixels[7] = [0.5, 0.5, 0.0, 1.0];
        let c = compare(&gray(0.5), &rendered, Tolerance::default());
        assert_eq!((c.pixels, c.different, c.beyond, c.largest), (5000, 1, 1, 188));
        assert_eq!(c.to_string(), "1 of 5000 pixels differ, by up to 188/255");
        let map = difference_map(&gray(0.5), &rendered);
        assert!(map.pixels[7][0] == 1.0 && map.pixels[8][0] < 0.1);
    }

    #[test]
    fn transparent_pixels_have_no_colour() {
        let a = Frame { width: 1, height: 1, pixels: vec![[1.0, 0.0, 0.0, 0.0]] };
        assert_eq!(compare(&a, &Frame::new(1, 1), Tolerance::default()).verdict, Verdict::Identical);
    }
}
