//! `background { rgb … }`: what rays see that hit nothing (manual, "Background").

use super::Segment;
use crate::color::{Color, Rgb};
use serde::Serialize;

/// A colour behind everything.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Background {
    /// `transmit` is how much shows of what is behind the picture.
    #[serde(flatten)]
    pub color: Color,
    /// Before 3.7: there is nothing of it in a picture that keeps alpha, and all of it in others, whatever it lets pass.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub by_picture: bool,
}

/// Who looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViewKind {
    /// A picture that keeps alpha.
    Alpha,
    /// A mirror in such a picture.
    Mirror,
    /// A picture without alpha, or a mirror in one.
    Opaque,
}

impl Background {
    /// Of a scene that says nothing of it.
    pub const NONE: Self = Self { color: Color { transmit: 1.0, ..Color::BLACK }, by_picture: false };

    /// Its light, and what transmittance of what is behind the picture (all measured on POV-Ray 3.7).
    pub fn seen_by(&self, beholder: ViewKind) -> Segment {
        let Color { rgb, filter, transmit } = self.color;
        let whole = Segment { radiance: rgb, transmittance: Rgb::ZERO };
        match beholder {
            ViewKind::Mirror => whole,
            ViewKind::Opaque if self.by_picture => whole,
            ViewKind::Alpha if self.by_picture => Segment::NONE,
            ViewKind::Alpha => {
                Segment { radiance: rgb * (1.0 - filter - transmit), transmittance: self.color.passing() }
            }
            // What it filters is of its own colour, which is not behind the picture.
            ViewKind::Opaque => {
                Segment { radiance: rgb * (1.0 - transmit), transmittance: Rgb::splat(transmit) + filter * rgb }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_looks_at_what_as_measured() {
        let color = Color { rgb: Rgb::new(1.0, 0.8, 0.6), filter: 0.3, transmit: 0.2 };
        let radiance = |by_picture, beholder| Background { color, by_picture }.seen_by(beholder).radiance;
        for (by_picture, beholder, share) in [
            (false, ViewKind::Alpha, 0.5),
            (false, ViewKind::Mirror, 1.0),
            (false, ViewKind::Opaque, 0.8),
            (true, ViewKind::Alpha, 0.0),
            (true, ViewKind::Mirror, 1.0),
            (true, ViewKind::Opaque, 1.0),
        ] {
            assert!(radiance(by_picture, beholder).distance(color.rgb * share) < 1e-12, "{by_picture} {beholder:?}");
        }
    }
}
