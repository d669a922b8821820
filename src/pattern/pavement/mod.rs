//! `pavement`: tiles of several triangles, squares or hexagons that pave the xz plane, with bevels at the joints
//! (manual, "Pavement Pattern"; quirk: `pavement_plans`).
//!
//! ```pov
//! plane { y, 0.1 pigment { pavement number_of_sides 4 number_of_tiles 5 pattern 7 exterior 2 interior 1 form 2
//!   color_map { [0.7 color rgb <0.7, 0.2, 0.1>] [0.8 color rgb 0.6] } } }
//! ```

mod grid;
mod plans;

use super::{Field, TextureContext};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{DVec2, fp};
use crate::source::Span;
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Readable, Reader, Spec, ValueKind};
use grid::{Cells, CornerJoints, H, Plan};
use serde::Serialize;
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};
use std::sync::Arc;

/// Pattern `pavement`: numbers from 0 in the middle of tiles to 1 at the joints.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pavement {
    /// Parameters of the pattern `pavement` as written.
    #[serde(flatten)]
    pub params: PavementWords,
    /// Joints and shapes that follow from the parameters of `pavement`.
    #[serde(skip)]
    layout: Arc<PavementLayout>,
}

/// Values of the words of the pattern `pavement`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PavementWords {
    /// Number of sides of each cell of `pavement`: 3, 4 or 6.
    pub number_of_sides: f64,
    /// Number of cells in a tile of `pavement`.
    pub number_of_tiles: f64,
    /// Variant of `pavement` among the tiles of this number of cells.
    pub pattern: f64,
    /// Shape of a pavement's joints at the tips of tiles.
    pub exterior: f64,
    /// Shape of a pavement's joints at the notches of tiles.
    pub interior: f64,
    /// Shape of a pavement's joints at all other corners.
    pub form: f64,
}

/// Shape of a pavement's joint at a corner.
#[derive(Clone, Copy, Debug, PartialEq)]
enum JointShape {
    /// Joint with a pointed corner.
    Pointed,
    /// Joint with a corner that is cut off.
    Cut,
    /// Joint with a corner that is an arc.
    Round,
    /// Joint of squares whose shape is that of `exterior` and `interior`, not of `form`.
    AsOthers,
}

impl JointShape {
    /// Returns the joint's shape for a number in the scene. POV-Ray keeps eight bits of the number, and wraps around.
    fn joint_shape_of_number(n: f64, shape_count: u8) -> Self {
        [Self::Pointed, Self::Cut, Self::Round, Self::AsOthers][usize::from(n as i64 as u8 % shape_count)]
    }
}

/// Plan of a pavement with the directions of the cells' corners and the shapes of joints.
#[derive(Clone, Debug, PartialEq)]
struct PavementLayout {
    cells: Cells,
    plan: Plan,
    /// Directions of the corners from the centre of a pavement's cell, for each kind of cell.
    corners: Vec<Vec<DVec2>>,
    exterior: JointShape,
    interior: JointShape,
    form: JointShape,
}

impl Readable for Pavement {
    const SPEC: Spec = Spec {
        name: "pavement",
        summary: "tiles of several triangles, squares or hexagons, with numbers up to 1 at the joints",
        words: specs!(PavementWords::ROWS),
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let params = PavementWords {
            number_of_sides: 3.0,
            number_of_tiles: 1.0,
            pattern: 1.0,
            exterior: 0.0,
            interior: 0.0,
            form: 0.0,
        };
        params.read_remaining_words(r)
    }

    fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        let found = read_row(PavementWords::ROWS, &mut self.params, next, r)?;
        if found {
            *self = self.params.read_remaining_words(r)?;
        }
        Ok(found)
    }
}

impl PavementWords {
    const ROWS: &'static [Row<Self>] = &[
        word("number_of_sides", ValueKind::Float, "3", "of the cells that tiles are made of: 3, 4 or 6")
            .sets(|s, r| set(&mut s.number_of_sides, r.float().map(f64::trunc))),
        word("number_of_tiles", ValueKind::Float, "1", "how many cells make a tile, 1 to 6; 1 to 5 hexagons")
            .sets(|s, r| set(&mut s.number_of_tiles, r.float().map(f64::trunc))),
        word("pattern", ValueKind::Float, "1", "which of the tiles that can be made of so many")
            .sets(|s, r| set(&mut s.pattern, r.float().map(f64::trunc))),
        word("exterior", ValueKind::Float, "0", "joints at tips: 0 pointed, 1 cut off, 2 round; not for hexagons")
            .sets(|s, r| set(&mut s.exterior, r.float())),
        word("interior", ValueKind::Float, "0", "joints at notches: 0 pointed, 1 cut off, 2 round")
            .sets(|s, r| set(&mut s.interior, r.float())),
        word(
            "form",
            ValueKind::Float,
            "0",
            "joints at blunt corners: 0 pointed, 1 cut off, 2 round; for squares 3 as the others",
        )
        .sets(|s, r| set(&mut s.form, r.float())),
    ];

    /// Reads the remaining words of `pavement`: they depend on each other in any order, so they are checked after the
    /// last.
    fn read_remaining_words(mut self, r: &mut dyn Reader) -> Result<Pavement> {
        let at = r.span();
        loop {
            let next = r.peek_next()?;
            if !read_row(Self::ROWS, &mut self, next, r)? {
                break;
            }
        }
        Pavement::from_words(self, at)
    }
}

impl Pavement {
    fn from_words(params: PavementWords, at: Span) -> Result<Self> {
        let fault = |message: String| Diagnostic::err(codes::BAD_ARGUMENT, at, message);
        let Some(cells) = Cells::with_sides(params.number_of_sides) else {
            return fault(format!("the cells of a pavement have 3, 4 or 6 sides, found {}", params.number_of_sides));
        };
        let Some(patterns) = nth_entry(cells.tile_plans(), params.number_of_tiles) else {
            let most = cells.tile_plans().len();
            let (sides, tiles) = (params.number_of_sides, params.number_of_tiles);
            return fault(format!("with {sides} sides, `number_of_tiles` is one of 1 to {most}, found {tiles}"));
        };
        let Some(row) = nth_entry(patterns, params.pattern) else {
            let (sides, tiles, most) = (params.number_of_sides, params.number_of_tiles, patterns.len());
            let what = format!("`pattern` of {tiles} cells with {sides} sides");
            return fault(format!("{what} is one of 1 to {most}, found {}", params.pattern));
        };
        let layout = PavementLayout {
            cells,
            plan: Plan::new(cells, row),
            corners: cells.corner_directions(),
            exterior: JointShape::joint_shape_of_number(params.exterior, 3),
            interior: JointShape::joint_shape_of_number(params.interior, 3),
            form: JointShape::joint_shape_of_number(params.form, if cells == Cells::Squares { 4 } else { 3 }),
        };
        Ok(Self { params, layout: Arc::new(layout) })
    }
}

/// Returns the n-th entry of a list, counted from 1; `None` without such an entry.
fn nth_entry<T: Copy>(all: &[T], n: f64) -> Option<T> {
    (n >= 1.0).then(|| all.get(n as usize - 1).copied()).flatten()
}

/// Position of a point relative to the bisector of the nearest corner of its pavement cell.
#[derive(Clone, Copy, Debug)]
struct BisectorPosition {
    /// Distance from the cell's corner towards its centre.
    along: f64,
    /// Distance from the line between the cell's corner and centre, towards the edge that follows the corner
    /// anticlockwise.
    across: f64,
    /// Distance from the point to the centre of its pavement cell.
    to_middle: f64,
}

impl BisectorPosition {
    /// Distance from the point to the nearest corner of its pavement cell.
    fn distance_to_corner(self) -> f64 {
        fp::hypot(self.along, self.across)
    }
}

impl PavementLayout {
    fn height_at(&self, p: DVec2) -> f64 {
        let (cell, place) = self.cells.cell_at(p);
        let directions = &self.corners[cell.kind];
        let k = nearest_direction(directions, place);
        let direction = directions[k];
        let position = BisectorPosition {
            along: self.cells.corner_radius() - place.dot(direction),
            across: direction.perp_dot(place),
            to_middle: place.length(),
        };
        let joints = self.plan.joints_at_corners(cell);
        let value = match self.cells {
            Cells::Triangles => self.height_in_triangle_cell(joints[k], position),
            Cells::Squares => match cell_corner_opposite_notch(joints) {
                Some(turn) => self.height_in_turning_square(joints[k], position, place.dot(directions[turn])),
                None => self.height_in_square_cell(joints[k], position, self.exterior, self.interior),
            },
            Cells::Hexagons => self.height_in_hexagon_cell(joints[k], position),
        };
        value.clamp(0.0, 1.0)
    }

    /// Returns the heights of the bevels at a corner of a pavement's cell: at the edge before the corner and at the
    /// edge after it, against the clock; 0 at an edge that is no joint.
    fn bevel_heights_before_after(&self, joints: CornerJoints, position: BisectorPosition) -> [f64; 2] {
        let (sin, cos) = match self.cells {
            Cells::Triangles => (0.5, H),
            Cells::Squares => (FRAC_1_SQRT_2, FRAC_1_SQRT_2),
            Cells::Hexagons => (H, 0.5),
        };
        let height = |is_joint: bool, across: f64| {
            let distance = position.along * sin - across * cos;
            if is_joint { (1.0 - distance / self.cells.bevel_width()).max(0.0) } else { 0.0 }
        };
        [height(joints.before, -position.across), height(joints.after, position.across)]
    }

    /// Height of a pavement at the tip of a triangle or square, from the heights of the bevels on both sides.
    fn tip_height(&self, bevel_heights: [f64; 2], position: BisectorPosition, joint: JointShape) -> f64 {
        match joint {
            JointShape::Cut => bevel_heights[0] + bevel_heights[1],
            JointShape::Round => position.to_middle / self.cells.bevel_width(),
            _ => bevel_heights[0].max(bevel_heights[1]),
        }
    }

    fn height_in_triangle_cell(&self, joints: CornerJoints, position: BisectorPosition) -> f64 {
        let bevels = self.bevel_heights_before_after(joints, position);
        match (joints.before, joints.after) {
            (true, true) => self.tip_height(bevels, position, self.exterior),
            // half of a 120° corner, with the open edge in its middle
            (true, false) if joints.first => {
                self.height_at_120_degrees(bevels, position.along * H + position.across / 2.0, position)
            }
            (false, true) if joints.last => {
                self.height_at_120_degrees(bevels, position.along * H - position.across / 2.0, position)
            }
            (false, false) if joints.any => match self.interior {
                JointShape::Cut => 1.0 - 3.0 * (position.along * H + position.across.abs() / 2.0),
                JointShape::Round => 1.0 - 3.0 * position.distance_to_corner(),
                _ => 1.0 - position.along / self.cells.bevel_width(),
            },
            _ => bevels[0].max(bevels[1]),
        }
    }

    fn height_in_hexagon_cell(&self, joints: CornerJoints, position: BisectorPosition) -> f64 {
        let bevels = self.bevel_heights_before_after(joints, position);
        // towards the edge that is not a joint, if one is not
        let open = if joints.before { position.across } else { -position.across };
        match (joints.before, joints.after) {
            (true, true) => self.height_at_120_degrees(bevels, position.along, position),
            (false, false) => 0.0,
            _ if open > 0.0 && self.interior == JointShape::Cut => {
                1.0 - 3.0 * position.along.max(position.along / 2.0 + H * open)
            }
            _ if open > 0.0 && self.interior == JointShape::Round => 1.0 - 3.0 * position.distance_to_corner(),
            _ => bevels[0].max(bevels[1]),
        }
    }

    /// Height of a pavement at a corner of 120° between two joints, whose shape there is `form`. The point is `along`
    /// from the corner, along the bisector of the corner.
    fn height_at_120_degrees(&self, bevel_heights: [f64; 2], along: f64, position: BisectorPosition) -> f64 {
        match self.form {
            JointShape::Cut => 2.0 - 4.0 * along,
            JointShape::Round => {
                // the hexagon's centre is at distance 1 on the bisector
                let from_corner = position.distance_to_corner();
                let from_middle = (from_corner * from_corner + 1.0 - 2.0 * along).sqrt();
                1.0 - (H - from_middle) / self.cells.bevel_width()
            }
            _ => bevel_heights[0].max(bevel_heights[1]),
        }
    }

    fn height_in_square_cell(
        &self,
        joints: CornerJoints,
        position: BisectorPosition,
        exterior: JointShape,
        interior: JointShape,
    ) -> f64 {
        let bevels = self.bevel_heights_before_after(joints, position);
        match (joints.before, joints.after) {
            (true, true) => self.tip_height(bevels, position, exterior),
            (false, false) if !joints.any => 0.0,
            (false, false) => match interior {
                JointShape::Cut => 1.0 - 2.0 * SQRT_2 * position.along,
                JointShape::Round => 1.0 - 2.0 * position.distance_to_corner(),
                _ => 1.0 - SQRT_2 * (position.along + position.across.abs()),
            },
            _ => bevels[0].max(bevels[1]),
        }
    }

    /// Height of a pavement in a square at which a tile turns, from a notch to the opposite corner. `along` is the
    /// distance from the centre towards that corner.
    fn height_in_turning_square(&self, joints: CornerJoints, position: BisectorPosition, along: f64) -> f64 {
        match self.form {
            JointShape::Pointed => {
                self.height_in_square_cell(joints, position, JointShape::Pointed, JointShape::Pointed)
            }
            JointShape::Cut => (1.0 + 2.0 * SQRT_2 * along).abs(),
            JointShape::Round => {
                // by the law of cosines, in halves of the square's side
                let (from_middle, along) = (2.0 * position.to_middle, 2.0 * along);
                let from_notch = (from_middle * from_middle + 2.0 + 2.0 * SQRT_2 * along).max(0.0).sqrt();
                (from_notch - 1.0).abs()
            }
            JointShape::AsOthers => self.height_in_square_cell(joints, position, self.exterior, self.interior),
        }
    }
}

/// Returns the index of the corner nearest to the direction of a point.
fn nearest_direction(directions: &[DVec2], place: DVec2) -> usize {
    let mut best = (0, f64::NEG_INFINITY);
    for (k, direction) in directions.iter().enumerate() {
        let along = place.dot(*direction);
        if along > best.1 {
            best = (k, along);
        }
    }
    best.0
}

/// Returns the index of the corner of a pavement cell that lies between two joints and opposite a notch.
fn cell_corner_opposite_notch(joints: &[CornerJoints]) -> Option<usize> {
    (0..4).find(|&k| {
        let across = joints[(k + 2) % 4];
        joints[k].before && joints[k].after && !across.before && !across.after && across.any
    })
}

impl Field for Pavement {
    fn value(&self, at: &TextureContext) -> f64 {
        self.layout.height_at(DVec2::new(at.p.x, at.p.z))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;
    use crate::pattern::extreme_points;

    /// POV-Ray 3.7's output: sides, tiles, pattern, exterior, interior, form, x, z, number (in single precision).
    const MEASURED: &str = include_str!("../../../tests/patterns/pavement.txt");

    #[test]
    fn numbers_match_povray() {
        for line in MEASURED.lines() {
            let n: Vec<f64> = line.split(' ').map(|n| n.parse().unwrap()).collect();
            let params = PavementWords {
                number_of_sides: n[0],
                number_of_tiles: n[1],
                pattern: n[2],
                exterior: n[3],
                interior: n[4],
                form: n[5],
            };
            let pavement = Pavement::from_words(params, Span::default()).unwrap();
            let ours =
                pavement.value(&TextureContext::without_surface(DVec3::new(n[6], 0.3, n[7]), Default::default()));
            assert!((ours - n[8]).abs() < 1e-5, "{line}: {ours}");
        }
    }

    #[test]
    fn every_pavement_reaches_everywhere() {
        for (sides, cells) in [(3.0, Cells::Triangles), (4.0, Cells::Squares), (6.0, Cells::Hexagons)] {
            let all =
                cells.tile_plans().iter().enumerate().flat_map(|(n, rows)| (0..rows.len()).map(move |row| (n, row)));
            for (tiles, pattern) in all {
                let joint = ((tiles + pattern) % 4) as f64;
                let params = PavementWords {
                    number_of_sides: sides,
                    number_of_tiles: tiles as f64 + 1.0,
                    pattern: pattern as f64 + 1.0,
                    exterior: joint,
                    interior: joint,
                    form: joint,
                };
                let pavement = Pavement::from_words(params, Span::default()).unwrap();
                for p in extreme_points() {
                    let value = pavement.value(&TextureContext::without_surface(p, Default::default()));
                    assert!(value.is_nan() || (0.0..=1.0).contains(&value), "{params:?} {p}: {value}");
                }
            }
        }
    }
}
