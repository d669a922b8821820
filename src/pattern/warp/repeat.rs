//! `warp { repeat <vector> }`: repeats a slice of the pattern (manual, "Repeat Warp").
//!
//! ```pov
//! box { -1, 1 pigment { planar warp { repeat 0.5*y flip y offset x } } }
//! ```

use super::Bend;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::DVec3;
use crate::value::words::{Row, set, specs, word};
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Warp `repeat`: slices of the pattern side by side.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Repeat {
    /// Axis of repetition: 0, 1 or 2 for x, y or z.
    pub axis: usize,
    /// Width of a slice of a repeating warp; a negative one begins with its far side.
    pub width: f64,
    /// Offset in the pattern from each slice of a repeating warp to the next.
    pub offset: DVec3,
    /// Axes along which every other slice of a repeating warp is mirrored.
    pub flip: [bool; 3],
}

impl Readable for Repeat {
    const SPEC: Spec = Spec {
        name: "repeat",
        summary: "a slice of the pattern again and again",
        params: &[Param {
            name: "width",
            kind: ValueKind::Vector,
            summary: "from one slice to the next; only one of its three numbers may differ from 0",
        }],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        word("offset", ValueKind::Vector, "0", "how much farther in the pattern each slice lies")
            .sets(|s, r| set(&mut s.offset, r.vector())),
        word("flip", ValueKind::Vector, "0", "mirrors every other slice along the axes that are not 0 here")
            .sets(|s, r| set(&mut s.flip, r.vector().map(|v| v.to_array().map(|x| x != 0.0)))),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let widths = r.vector()?.to_array();
        let mut axes = (0..3).filter(|&i| widths[i] != 0.0);
        match (axes.next(), axes.next()) {
            // POV-Ray keeps the width in single precision.
            (Some(axis), None) => {
                Ok(Self { axis, width: f64::from(widths[axis] as f32), offset: DVec3::ZERO, flip: [false; 3] })
            }
            (None, _) => Diagnostic::err(codes::ZERO_VECTOR, span, "`repeat` needs a direction, this vector is zero"),
            _ => Diagnostic::new(
                codes::BAD_ARGUMENT,
                span,
                "`repeat` goes along one axis, this vector goes along several",
            )
            .help("use a `warp` for each axis: `warp { repeat 2*x } warp { repeat 3*y }`")
            .into(),
        }
    }
}

impl Bend for Repeat {
    fn apply(&self, p: DVec3) -> DVec3 {
        let slice = (p[self.axis] / self.width).floor();
        let mut q = p;
        // quirk: repeat_single_precision
        q[self.axis] -= f64::from(slice as f32 * self.width as f32);
        if slice % 2.0 != 0.0 {
            for axis in (0..3).filter(|&i| self.flip[i]) {
                q[axis] = if axis == self.axis { self.width - q[axis] } else { -q[axis] };
            }
        }
        q + slice * self.offset
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slices_repeat_and_flip() {
        let warp = Repeat { axis: 0, width: 2.0, offset: DVec3::Z, flip: [true, true, false] };
        assert_eq!(warp.apply(DVec3::new(4.5, 3.0, 0.0)), DVec3::new(0.5, 3.0, 2.0));
        assert_eq!(warp.apply(DVec3::new(2.5, 3.0, 0.0)), DVec3::new(1.5, -3.0, 1.0));
        assert_eq!(warp.apply(DVec3::new(-0.5, 3.0, 0.0)), DVec3::new(0.5, -3.0, -1.0));
    }
}
