//! `brick`: bricks in mortar (manual, "Brick").
//!
//! ```pov
//! box { 0, <4, 3, 1> pigment { brick color rgb 0.8, color rgb <0.6, 0.2, 0.1> brick_size <1, 0.4, 0.5> mortar 0.05 } }
//! ```

use super::{Cells, EDGE};
use crate::color::{Color, Rgb};
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::words::{Row, set, specs, word};
use crate::value::{Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Pattern `brick`: rows of bricks; every other row is shifted by half a brick.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Brick {
    /// Distance from the start of one brick to the start of the next, along each axis.
    pub size: DVec3,
    /// Thickness of the mortar between bricks, in units of the pattern; `size` includes the mortar.
    pub mortar: f64,
}

impl Readable for Brick {
    const SPEC: Spec = Spec {
        name: "brick",
        summary: "bricks in mortar; the first colour is the mortar's",
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        word("brick_size", ValueKind::Vector, "<8, 3, 4.5>", "a brick with its mortar")
            .sets(|s, r| set(&mut s.size, r.vector())),
        word("mortar", ValueKind::Float, "0.5", "thickness of the mortar").sets(|s, r| set(&mut s.mortar, r.float())),
    ];

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self { size: DVec3::new(8.0, 3.0, 4.5), mortar: 0.5 })
    }
}

impl Brick {
    /// Position of a point in its brick, relative to the brick's corner.
    fn position_in_brick(&self, p: DVec3) -> DVec3 {
        let mut q = (p + EDGE) / self.size;
        // every other row is moved by half a brick in x, the others in z
        let odd = q.y.floor() as i64 & 1 != 0;
        if odd {
            q.x += 0.5;
        } else {
            q.z += 0.5;
        }
        (q - q.floor()) * self.size
    }
}

impl Cells for Brick {
    fn cell_kind_count(&self) -> usize {
        2
    }

    fn cell_kind(&self, p: DVec3) -> usize {
        // a point is in the mortar if it lies in the last `mortar` of a brick along any axis
        usize::from((self.position_in_brick(p) + self.mortar).cmple(self.size).all())
    }

    fn is_uniform(&self, p: DVec3, radius: f64) -> bool {
        // from the ends of the brick and of its mortar
        let within = self.position_in_brick(p);
        let from = within.abs().min((within - self.size).abs()).min((within + self.mortar - self.size).abs());
        from.min_element() > radius + EDGE
    }

    fn default_color(&self, cell: usize) -> Color {
        Color::opaque(if cell == 0 { Rgb::splat(0.5) } else { Rgb::new(0.6, 0.15, 0.15) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mortar_ends_each_brick() {
        let wall = Brick { size: DVec3::new(8.0, 3.0, 4.5), mortar: 0.5 };
        assert_eq!(wall.cell_kind(DVec3::new(1.0, 1.0, 0.0)), 1);
        assert_eq!(wall.cell_kind(DVec3::new(7.75, 1.0, 0.0)), 0);
        assert_eq!(wall.cell_kind(DVec3::new(1.0, 2.75, 0.0)), 0);
        // the next row is moved by half a brick
        assert_eq!(wall.cell_kind(DVec3::new(7.75, 3.5, 1.0)), 1);
        assert_eq!(wall.cell_kind(DVec3::new(3.75, 3.5, 1.0)), 0);
    }
}
