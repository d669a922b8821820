//! `background { rgb … }`: the colour of rays that hit nothing (manual, "Background").

use super::Segment;
use crate::color::{Color, Rgb};
use serde::Serialize;

/// Background colour of a scene, seen where a ray hits no object.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Background {
    /// Colour of the background; `filter` and `transmit` are its shares of light from behind the picture.
    #[serde(flatten)]
    pub color: Color,
    /// True for scenes before version 3.7, where the background is absent from pictures with alpha and opaque in all
    /// others (quirk: `background_before_3_7`).
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub by_picture: bool,
}

/// Kind of the ray that reaches the background.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ViewKind {
    /// Camera ray in a picture with an alpha channel.
    Alpha,
    /// Reflected ray in a picture with an alpha channel.
    Mirror,
    /// Any ray in a picture without an alpha channel.
    Opaque,
}

impl Background {
    /// Background of a scene that has no `background` statement: black and transparent.
    pub const NONE: Self = Self { color: Color { transmit: 1.0, ..Color::BLACK }, by_picture: false };

    /// Returns the background's radiance, and the transmittance for what is behind the picture, for this kind of ray
    /// (quirk: `background_by_view`).
    pub fn segment_for_view(&self, view: ViewKind) -> Segment {
        let Color { rgb, filter, transmit } = self.color;
        let whole = Segment { radiance: rgb, transmittance: Rgb::ZERO };
        match view {
            ViewKind::Mirror => whole,
            ViewKind::Opaque if self.by_picture => whole,
            ViewKind::Alpha if self.by_picture => Segment::NONE,
            ViewKind::Alpha => {
                Segment { radiance: rgb * (1.0 - filter - transmit), transmittance: self.color.transmittance() }
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
        let radiance = |by_picture, beholder| Background { color, by_picture }.segment_for_view(beholder).radiance;
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
