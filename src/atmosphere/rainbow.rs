//! `rainbow { direction D angle A width W color_map { … } }`: an arc about the direction of a distant light (manual,
//! "Rainbow").
//!
//! ```pov
//! rainbow { direction <0, -0.3, 1> angle 42 width 6 color_map { [0 rgbt <1, 0, 0, 0.6>] [1 rgbt <0, 0, 1, 0.6>] } }
//! ```

use super::{Segment, transmittance_at_least_transmit};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{DVec3, Ray, fp};
use crate::source::Span;
use crate::texture::ColorMap;
use crate::value::ValueKind::{Block, Float, Vector};
use crate::value::words::{Row, joined, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec, Thing, WordSpec};
use serde::Serialize;
use std::sync::Arc;

/// Rainbow of a scene: a coloured arc at a fixed angle to the light. Angles are in radians.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rainbow {
    /// Direction in which the rainbow's light shines.
    pub direction: DVec3,
    /// Angle between the direction of the rainbow's light and the middle of the arc, in radians.
    pub angle: f64,
    /// Angle between the inner and outer edges of the rainbow, in radians.
    pub width: f64,
    /// Distance over which a rainbow attenuates light to 1/e, as in a fog.
    pub distance: f64,
    /// Random displacement of the rainbow's colours, as a share of its width.
    pub jitter: f64,
    /// Direction from the rainbow's centre to the middle of its arc.
    pub up: DVec3,
    /// Angle of the visible part of the rainbow's circle, in radians.
    pub arc_angle: f64,
    /// Angle of the part of the rainbow with full strength, in radians; beyond it the arc fades.
    pub falloff_angle: f64,
    /// Colours from the inner to the outer edge of the rainbow; a rainbow without them is invisible.
    pub color_map: Option<Arc<ColorMap>>,
}

/// Default distance of a rainbow: light from behind is not attenuated (quirk: `rainbow_default_distance`).
const USUAL_DISTANCE: f64 = 1e7;

impl Default for Rainbow {
    fn default() -> Self {
        Self {
            direction: DVec3::ZERO,
            angle: 0.0,
            width: 0.0,
            distance: USUAL_DISTANCE,
            jitter: 0.0,
            up: DVec3::Y,
            arc_angle: std::f64::consts::TAU,
            falloff_angle: std::f64::consts::TAU,
            color_map: None,
        }
    }
}

impl Thing for Rainbow {
    fn kind(&self) -> &'static str {
        "rainbow"
    }
}

const RAINBOW_ROWS: &[Row<Rainbow>] = &[
    word("direction", Vector, "", "from the sun, which is not drawn, to the middle of the circle")
        .sets(|s, r| set(&mut s.direction, r.vector())),
    word("angle", Float, "0", "between that direction and the arc, in degrees; 42 in nature")
        .sets(|s, r| set(&mut s.angle, r.float().map(f64::to_radians))),
    word("width", Float, "0", "from the inner edge to the outer, in degrees; 5 or so")
        .sets(|s, r| set(&mut s.width, r.float().map(f64::to_radians))),
    word("distance", Float, "", "as a fog's: it is seen on what is that far; else it is seen behind everything")
        .sets(|s, r| set(&mut s.distance, r.float())),
    word("jitter", Float, "0", "how far the colours are scattered, as a part of the width")
        .sets(|s, r| set(&mut s.jitter, r.float())),
    word("up", Vector, "<0, 1, 0>", "where the middle of the arc is").sets(|s, r| set(&mut s.up, r.vector())),
    word("arc_angle", Float, "360", "how much is seen of the whole circle, in degrees")
        .sets(|s, r| set(&mut s.arc_angle, r.float().map(f64::to_radians))),
    word("falloff_angle", Float, "360", "how much of that is seen in full, in degrees; the ends fade")
        .sets(|s, r| set(&mut s.falloff_angle, r.float().map(f64::to_radians))),
];

const RAINBOW_PARTS: &[WordSpec] = &[
    word(
        "color_map",
        Block,
        "",
        "the colours from the inner edge, 0, to the outer, 1; `transmit` leaves so much clear",
    ),
    word("colour_map", Block, "", "the same"),
];

/// Words of a `rainbow { … }` block.
pub const RAINBOW: Spec = Spec {
    name: "rainbow",
    summary: "an arc of colours about the direction of the sun",
    words: &joined::<{ RAINBOW_ROWS.len() + RAINBOW_PARTS.len() }>(specs!(RAINBOW_ROWS), RAINBOW_PARTS),
    ..Spec::EMPTY
};

impl Rainbow {
    /// Reads the items of a `rainbow` block; `source` is the span of the word `rainbow`.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read(r: &mut dyn Reader, source: Span) -> Result<Self> {
        let mut rainbow = Self::default();
        loop {
            match r.peek_next()? {
                Next::End => break,
                Next::Thing("rainbow") => {
                    if let Some(declared) = r.take_declared::<Rainbow>()? {
                        rainbow = (*declared).clone();
                    }
                }
                Next::Thing("color_map") => rainbow.color_map = r.take_declared::<ColorMap>()?,
                Next::Block("color_map" | "colour_map") => {
                    r.take_token()?;
                    rainbow.color_map = Some(Arc::new(ColorMap::read(r)?));
                    r.leave_block()?;
                }
                next if read_row(RAINBOW_ROWS, &mut rainbow, next, r)? => {}
                _ => return Err(r.unknown_word_in(&RAINBOW)),
            }
        }
        rainbow.check(source)?;
        Ok(rainbow)
    }

    fn check(&self, source: Span) -> Result<()> {
        let bad = |message: &str, help: &str| {
            Err(Diagnostic::new(codes::BAD_ARGUMENT, source, message).help(help.to_string()).into())
        };
        if self.direction.length_squared() == 0.0 {
            return bad("this `rainbow` has no `direction`", "`direction` goes from the sun into the picture");
        }
        if self.direction.cross(self.up).length_squared() == 0.0 {
            return bad("this `rainbow`'s `up` goes along its `direction`", "no side of the circle is up then");
        }
        if self.falloff_angle > self.arc_angle {
            return bad(
                "this `rainbow`'s `falloff_angle` is larger than its `arc_angle`",
                "`arc_angle` is what is seen at all, `falloff_angle` what is seen in full",
            );
        }
        Ok(())
    }

    /// Returns radiance and transmittance of the rainbow along a ray, up to the distance `length`; `None` outside the
    /// rainbow's arc, and for a rainbow without colours or with the distance 0. `random` returns numbers in [0, 1).
    fn segment(&self, ray: &Ray, length: f64, random: &mut dyn FnMut() -> f64) -> Option<Segment> {
        let map = self.color_map.as_ref()?;
        let direction = self.direction.normalize();
        let cos = ray.dir.dot(direction).clamp(-1.0, 1.0);
        // 0 at the inner edge, 1 at the outer
        let mut index = (fp::acos(cos) - self.angle) / self.width + 0.5;
        if self.jitter != 0.0 {
            index += (2.0 * random() - 1.0) * self.jitter;
        }
        if self.distance == 0.0 || !(0.0..=1.0).contains(&index) {
            return None;
        }
        let shown = self.arc_strength(ray.dir - direction * cos, direction);
        if shown == 0.0 {
            return None;
        }
        let color = map.color_at(index);
        let open = 1.0 - shown + shown * color.transmit;
        let clear = transmittance_at_least_transmit(
            &crate::color::Color { transmit: open, ..color },
            fp::exp(-length / self.distance),
        );
        Some(Segment::from_color(color.rgb, clear, color.filter * (1.0 - clear)))
    }

    /// Returns the strength of a rainbow's arc: 1 in the middle, 0 past its ends. `direction_across_axis` is the
    /// component of the ray's direction across the rainbow's axis.
    fn arc_strength(&self, direction_across_axis: DVec3, direction: DVec3) -> f64 {
        let up = self.up - direction * self.up.dot(direction);
        let from_up = direction_across_axis.angle_between(up);
        let (full, ends) = (self.falloff_angle / 2.0, self.arc_angle / 2.0);
        match from_up {
            a if a.is_nan() || a <= full => 1.0,
            a if a >= ends => 0.0,
            a => 1.0 - unclamped_smooth_step((a - full) / (ends - full)),
        }
    }
}

/// Returns 3x² - 2x³, which rises smoothly from 0 to 1.
fn unclamped_smooth_step(x: f64) -> f64 {
    x * x * (3.0 - 2.0 * x)
}

/// Combines all rainbows that a ray meets along its length: returns their mean (quirk: `rainbows_average`).
pub fn average_rainbows(rainbows: &[Rainbow], ray: &Ray, length: f64, random: &mut dyn FnMut() -> f64) -> Segment {
    let met: smallvec::SmallVec<[Segment; 2]> =
        rainbows.iter().filter_map(|rainbow| rainbow.segment(ray, length, random)).collect();
    if met.is_empty() {
        return Segment::NONE;
    }
    let share = 1.0 / met.len() as f64;
    met.iter().fold(
        Segment { radiance: crate::color::Rgb::ZERO, transmittance: crate::color::Rgb::ZERO },
        |all, one| Segment {
            radiance: all.radiance + one.radiance * share,
            transmittance: all.transmittance + one.transmittance * share,
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Color, Rgb};

    fn bow(color: Color) -> Rainbow {
        let map = ColorMap { entries: vec![(0.0, color), (1.0, color)] };
        let (angle, width) = (20f64.to_radians(), 5f64.to_radians());
        let color_map = Some(Arc::new(map));
        Rainbow { direction: DVec3::Z, angle, width, distance: 40.0, color_map, ..Rainbow::default() }
    }

    /// A ray at angles, in degrees, from z and from up.
    fn ray(from_z: f64, from_up: f64) -> Ray {
        let ((sin, cos), (s, c)) = (fp::sin_cos(from_z.to_radians()), fp::sin_cos(from_up.to_radians()));
        Ray::new(DVec3::ZERO, DVec3::new(sin * s, sin * c, cos))
    }

    fn seen(rainbows: &[Rainbow], from_up: f64, length: f64) -> Rgb {
        let veil = average_rainbows(rainbows, &ray(20.0, from_up), length, &mut || 0.5);
        veil.radiance + veil.transmittance * Rgb::new(1.0, 0.5, 0.25)
    }

    #[test]
    fn light_of_one_and_two_rainbows() {
        // POV-Ray: before a plane z = 50 of <1, 0.5, 0.25>
        let plane = 50.0 / fp::cos(20f64.to_radians());
        let color = |filter, transmit| Color { rgb: Rgb::new(0.2, 0.4, 0.6), filter, transmit };
        let close = |a: Rgb, b: [f64; 3]| assert!(a.distance(Rgb::from_array(b)) < 3e-5, "{a} {b:?}");
        close(seen(&[bow(color(0.0, 0.0))], 0.0, plane), [0.41154, 0.42644, 0.50745]);
        close(seen(&[bow(color(0.3, 0.0))], 0.0, plane), [0.36485, 0.40894, 0.50162]);
        close(seen(&[bow(color(0.3, 0.5))], 0.0, plane), [0.54, 0.4275, 0.4175]);
        let arc = Rainbow { arc_angle: 120f64.to_radians(), falloff_angle: 30f64.to_radians(), ..bow(color(0.3, 0.5)) };
        close(seen(std::slice::from_ref(&arc), 30.0, plane), [0.64774, 0.44197, 0.37263]);
        let near = Rainbow { distance: 30.0, ..bow(color(0.0, 0.0)) };
        close(seen(&[bow(color(0.0, 0.0)), near], 0.0, plane), [0.37366, 0.42171, 0.52403]);
        assert_eq!(average_rainbows(&[arc], &ray(23.0, 0.0), plane, &mut || 0.5), Segment::NONE);
    }
}
