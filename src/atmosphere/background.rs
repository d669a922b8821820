//! `background { rgb … }`: the colour of rays that hit nothing (manual, "Background").

use super::Segment;
use crate::color::{Color, Rgb};
use serde::Serialize;

/// A colour behind all objects.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Background {
    /// The colour; `transmit` is the share of what is behind the picture.
    #[serde(flatten)]
    pub color: Color,
    /// True for scenes before version 3.7: pictures with alpha have no background, others have all of it (quirk:
    /// `background_before_3_7`).
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub by_picture: bool,
}

/// Kind of the ray that reaches the background.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViewKind {
    /// A camera ray of a picture with alpha.
    Alpha,
    /// A reflected ray of such a picture.
    Mirror,
    /// Any ray of a picture without alpha.
    Opaque,
}

impl Background {
    /// A scene without `background`.
    pub const NONE: Self = Self { color: Color { transmit: 1.0, ..Color::BLACK }, by_picture: false };

    /// Returns the light of the background, and the transmittance for what is behind the picture (quirk:
    /// `background_by_view`).
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
            // Filtered light has the background's own colour.
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
    fn light_by_view_and_version() {
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
