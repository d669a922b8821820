//! `spotlight` and `cylinder`: light in one direction (manual, "Spotlights", "Cylindrical Lights").

use super::Light;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{DVec3, fp};
use crate::source::Span;
use crate::value::Reader;
use crate::value::ValueKind::{Float, Nothing};
use crate::value::words::{Row, set, word};
use serde::Serialize;

/// Directional distribution of a light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Beam {
    /// Light of equal strength in all directions.
    Round,
    /// Light of a spotlight, in a cone; the edge is in degrees.
    Spotlight(Edge),
    /// Light of a cylinder light, in a tube; the edge is in world units, which transforms do not change.
    Cylinder(Edge),
}

/// Fall-off of a spotlight or cylinder light towards its sides.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Edge {
    /// Angle or distance from the axis up to which the light has its full strength.
    pub radius: f64,
    /// Angle or distance from the axis beyond which the light is dark.
    pub falloff: f64,
    /// Exponent of the light's fall-off from the axis.
    pub tightness: f64,
}

impl Beam {
    const SPOTLIGHT: Self = Beam::Spotlight(Edge { radius: 30.0, falloff: 45.0, tightness: 0.0 });
    const CYLINDER: Self = Beam::Cylinder(Edge { radius: 0.75, falloff: 1.0, tightness: 0.0 });

    fn edge_mut(&mut self) -> Option<&mut Edge> {
        match self {
            Beam::Round => None,
            Beam::Spotlight(edge) | Beam::Cylinder(edge) => Some(edge),
        }
    }
}

/// Words of a spotlight's or cylinder light's beam, and how each is read.
pub(super) const BEAM_ROWS: &[Row<Light>] = &[
    word("spotlight", Nothing, "", "it shines into a cone").sets(|s, _| set(&mut s.beam, Ok(Beam::SPOTLIGHT))),
    word("cylinder", Nothing, "", "it shines along a tube").sets(|s, _| set(&mut s.beam, Ok(Beam::CYLINDER))),
    word(
        "radius",
        Float,
        "30 or 0.75",
        "behind `spotlight` or `cylinder`: within it, it is as bright as in the middle",
    )
    .sets(|s, r| s.read_edge("radius", r, |edge| &mut edge.radius)),
    word("falloff", Float, "45 or 1", "behind `spotlight` or `cylinder`: from here on it is dark")
        .sets(|s, r| s.read_edge("falloff", r, |edge| &mut edge.falloff)),
    word("tightness", Float, "0", "behind `spotlight` or `cylinder`: how fast it fades from the middle on")
        .sets(|s, r| s.read_edge("tightness", r, |edge| &mut edge.tightness)),
];

impl Light {
    fn read_edge(&mut self, word: &str, r: &mut dyn Reader, field: fn(&mut Edge) -> &mut f64) -> Result<()> {
        let at: Span = r.span();
        let number = super::read_finite(r)?;
        match self.beam.edge_mut() {
            Some(edge) => *field(edge) = number,
            None => {
                let message = format!("`{word}` changes nothing: this light shines to all sides");
                let d = Diagnostic::new(codes::MISPLACED, at, message);
                r.report(d.help("write `spotlight` or `cylinder` before it"));
            }
        }
        Ok(())
    }
}

/// Directional distribution of a lowered light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Profile {
    /// Lowered light of equal strength in all directions.
    Round,
    /// Lowered spotlight: its strength depends on the cosine of the angle to the axis.
    Cone {
        /// Cosine of the angle up to which a spotlight has its full strength.
        radius: f64,
        /// Cosine of the angle beyond which a spotlight is dark.
        falloff: f64,
        /// Exponent of the cosine in a spotlight's fall-off.
        tightness: f64,
    },
    /// Lowered cylinder light: its strength depends on the distance from the axis.
    Tube(Edge),
}

impl Profile {
    pub fn from_beam(beam: &Beam) -> Self {
        let cos = |degrees: f64| fp::cos(degrees.to_radians());
        match *beam {
            Beam::Round => Profile::Round,
            Beam::Spotlight(Edge { radius, falloff, tightness }) => {
                Profile::Cone { radius: cos(radius), falloff: cos(falloff), tightness }
            }
            Beam::Cylinder(edge) => Profile::Tube(edge),
        }
    }

    /// Returns the share of a light's strength that reaches a point: `cos_to_axis` is the cosine of the angle to the axis,
    /// `axis_distance` computes the distance from the axis, `along_axis` is the distance along it (quirk: `spotlight_profile`).
    #[inline]
    pub fn strength_share(&self, cos_to_axis: f64, axis_distance: impl FnOnce() -> f64, along_axis: f64) -> f64 {
        match *self {
            Profile::Round => 1.0,
            Profile::Cone { radius, falloff, tightness } => {
                let edge = match cos_to_axis {
                    cos if cos >= radius => 1.0,
                    cos if cos > falloff => unclamped_smooth_step((cos - falloff) / (radius - falloff)),
                    _ => return 0.0,
                };
                // Behind the light the cosine is negative, and its power is 0.
                if tightness == 0.0 { edge } else { edge * fp::power(cos_to_axis.max(0.0), tightness) }
            }
            Profile::Tube(Edge { radius, falloff, tightness }) => {
                let beside = axis_distance();
                if along_axis < 0.0 || beside >= falloff {
                    return 0.0;
                }
                let edge = match radius {
                    radius if radius > 0.0 && beside > radius => {
                        unclamped_smooth_step((falloff - beside) / (falloff - radius))
                    }
                    _ => 1.0,
                };
                if tightness == 0.0 { edge } else { edge * fp::power(1.0 - beside / falloff, tightness) }
            }
        }
    }
}

/// Returns 3x² - 2x³, which rises smoothly from 0 to 1.
fn unclamped_smooth_step(x: f64) -> f64 {
    x * x * (3.0 - 2.0 * x)
}

/// Returns the axis of a light's beam, of length 1; 0 if both points are equal.
pub(super) fn beam_axis(from: DVec3, to: DVec3) -> DVec3 {
    (to - from).normalize_or_zero()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spot(edge: [f64; 3], degrees: f64) -> f64 {
        let [radius, falloff, tightness] = edge;
        let beam = Beam::Spotlight(Edge { radius, falloff, tightness });
        Profile::from_beam(&beam).strength_share(fp::cos(f64::to_radians(degrees)), || 0.0, 1.0)
    }

    fn tube(edge: [f64; 3], beside: f64) -> f64 {
        let [radius, falloff, tightness] = edge;
        Profile::from_beam(&Beam::Cylinder(Edge { radius, falloff, tightness })).strength_share(1.0, || beside, 1.0)
    }

    #[test]
    fn profiles_of_spotlight_and_cylinder() {
        // Light on a white sphere about the light source, as POV-Ray renders it
        for (edge, degrees, seen) in [
            ([30.0, 45.0, 0.0], 35.0, 0.79033),
            ([20.0, 40.0, 0.0], 25.0, 0.90333),
            ([20.0, 40.0, 10.0], 10.0, 0.85805),
            ([20.0, 40.0, 10.0], 35.0, 0.03039),
            ([0.0, 40.0, 0.0], 20.0, 0.83492),
            ([70.0, 70.0, 2.5], 60.0, 0.17678),
            ([50.0, 20.0, 0.0], 49.0, 1.0),
            ([50.0, 20.0, 0.0], 51.0, 0.0),
        ] {
            assert!((spot(edge, degrees) - seen).abs() < 2e-5, "{edge:?} {degrees}: {}", spot(edge, degrees));
        }
        // Light on a plane across the beam
        for (edge, beside, seen) in [
            ([0.75, 1.0, 0.0], 0.8, 0.896),
            ([0.2, 0.5, 2.0], 0.1, 0.64),
            ([0.2, 0.5, 2.0], 0.3, 0.11852),
            ([1.0, 1.0, 10.0], 0.2, 0.10738),
            ([0.0, 1.0, 0.0], 0.8, 1.0),
            ([0.8, 0.4, 0.0], 0.3, 1.0),
            ([0.8, 0.4, 0.0], 0.45, 0.0),
        ] {
            assert!((tube(edge, beside) - seen).abs() < 2e-5, "{edge:?} {beside}: {}", tube(edge, beside));
        }
    }
}
