//! `tiling N`: 27 tilings of the xz plane, each tile with a bevel at the joints (manual, "Tiling Pattern").
//!
//! ```pov
//! plane { y, 0.1 pigment { tiling 7
//!   color_map { [0.4 color rgb <0.7, 0.2, 0.1>] [0.5 color rgb 1] [0.9 color rgb <0.1, 0.2, 0.6>] [1 color rgb 1] } } }
//! ```

mod penrose;
mod seams;

use super::{Field, TextureContext};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{DVec2, fp};
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use penrose::Penrose;
use seams::value_on_seam;
use serde::Serialize;
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};
use std::sync::Arc;

/// √3 / 2, the height of a triangle whose sides are 1.
const H: f64 = 0.866_025_403_784_438_6;

/// Offset of points in the pattern `tiling`, which decides the tile of a point exactly on a joint, as on a face of a
/// box from -1 to 1 (quirk: tiling_joints).
const LEAN: DVec2 = DVec2::new(0.3e-9, 1e-9);

/// Number of tilings of the pattern `tiling`.
const TILINGS: f64 = 27.0;

/// Pattern `tiling`, tiles of several kinds: kind i of n has numbers from i/n, in its middle, to (i + 1)/n at its
/// edges.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Tiling {
    /// Number of the tiling in the scene, 1 to 27.
    pub number: usize,
    /// Tiles of the pattern `tiling`.
    #[serde(skip)]
    tiles: Tiles,
}

/// Tiles of the pattern `tiling`: periodic for most numbers; the last three tilings have no period.
#[derive(Clone, Debug, PartialEq)]
enum Tiles {
    Plan(Arc<Plan>),
    Penrose(Penrose),
}

/// A periodic tiling of the plane.
#[derive(Clone, Debug, PartialEq)]
struct Plan {
    /// The two periods: translations that map the tiling to itself.
    steps: [DVec2; 2],
    kinds: usize,
    /// Width of the bevel at the edges of a periodic tiling's tiles.
    depth: f64,
    /// Tiles of one period of the tiling; after [`Self::with_copies`], all that reach into the parallelogram of the
    /// periods.
    tiles: Vec<Tile>,
}

/// Tile of a tiling: a convex polygon.
#[derive(Clone, Debug, PartialEq)]
struct Tile {
    kind: usize,
    edges: Vec<Edge>,
    /// Bounding box of the tile's corners.
    bounds: [DVec2; 2],
}

/// Edge of a tile, the line a·p = b; the tile is where a·p is smaller. The length of `a` makes the bevel's width 1.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Edge {
    a: DVec2,
    b: f64,
}

impl Plan {
    fn new(steps: [(f64, f64); 2], kinds: usize, depth: f64) -> Self {
        Self { steps: steps.map(|(x, z)| DVec2::new(x, z)), kinds, depth, tiles: vec![] }
    }

    /// Adds a polygon to the tiling, with its corners in order against the clock.
    fn with_polygon(mut self, kind: usize, corners: &[DVec2]) -> Self {
        let next = corners.iter().cycle().skip(1);
        let edges = corners.iter().zip(next).map(|(&p, &q)| {
            let out = (q - p).perp().normalize() * -1.0 / self.depth;
            Edge { a: out, b: out.dot(p) }
        });
        let edges = edges.collect();
        self.tiles.push(Tile { kind, edges, bounds: bounding_box(corners) });
        self
    }

    /// Copies the tiles of a tiling to all positions that reach into the parallelogram of the periods.
    fn with_copies(mut self) -> Self {
        let [a, b] = self.steps;
        let [low, high] = bounding_box(&[DVec2::ZERO, a, b, a + b]);
        let mut spread = vec![];
        for tile in &self.tiles {
            for (i, j) in (-5..=5).flat_map(|i| (-5..=5).map(move |j| (i, j))) {
                let by = f64::from(i) * a + f64::from(j) * b;
                let [least, greatest] = tile.bounds.map(|p| p + by);
                if least.cmple(high).all() && greatest.cmpge(low).all() {
                    let edges = tile.edges.iter().map(|e| Edge { a: e.a, b: e.b + e.a.dot(by) }).collect();
                    spread.push(Tile { kind: tile.kind, edges, bounds: [least, greatest] });
                }
            }
        }
        self.tiles = spread;
        self
    }

    /// Adds a regular polygon with sides of length 1 to the tiling, around a centre; one of its corners is in the
    /// direction of `degrees`.
    fn with_regular_polygon(self, kind: usize, corners: u32, center: DVec2, degrees: f64) -> Self {
        let radius = 0.5 / fp::sin(std::f64::consts::PI / f64::from(corners));
        let corner = |i| center + radius * unit_vector_at(degrees + 360.0 * f64::from(i) / f64::from(corners));
        self.with_polygon(kind, &(0..corners).map(corner).collect::<Vec<_>>())
    }

    /// Adds several rectangles to the tiling: x, z, width, height.
    fn with_rectangles(self, kind: usize, xz_sizes: &[[f64; 4]]) -> Self {
        xz_sizes.iter().fold(self, |plan, &[x, z, w, h]| {
            plan.with_polygon(kind, &to_points(&[(x, z), (x + w, z), (x + w, z + h), (x, z + h)]))
        })
    }

    /// Adds triangles to the tiling that point up or down.
    fn with_triangles(self, kind: usize, up: bool, centers: &[(f64, f64)]) -> Self {
        let angle = if up { 90.0 } else { -90.0 };
        centers.iter().fold(self, |plan, &(x, z)| plan.with_regular_polygon(kind, 3, DVec2::new(x, z), angle))
    }

    /// Returns the periodic tiling with this number in a scene, 1 to 24.
    fn tiling_plan(number: usize) -> Self {
        let center = |x, z| DVec2::new(x, z);
        match number {
            2 => Self::new([(1.5, H), (0.0, 2.0 * H)], 1, H).with_regular_polygon(0, 6, center(0.5, H), 0.0),
            3 => Self::new([(1.0, 0.0), (0.5, H)], 2, H / 3.0)
                .with_triangles(0, true, &[(0.5, H / 3.0)])
                .with_triangles(1, false, &[(1.0, H * 2.0 / 3.0)]),
            4 => Self::new([(1.0, 0.0), (0.5, H)], 1, H / 2.0)
                .with_polygon(0, &to_points(&[(0.0, 0.0), (1.0, 0.0), (1.5, H), (0.5, H)])),
            5 => Self::rhomb_tiling(),
            6 => Self::new([(1.0, 1.0), (2.0, -2.0)], 2, 0.5)
                .with_rectangles(0, &[[0.0, 3.0, 2.0, 1.0]])
                .with_rectangles(1, &[[1.0, 1.0, 1.0, 2.0]]),
            7 => {
                let c = 1.0 + SQRT_2;
                Self::new([(c, 0.0), (0.0, c)], 2, 0.5)
                    .with_regular_polygon(1, 8, DVec2::ZERO, 22.5)
                    .with_regular_polygon(0, 4, DVec2::splat(c / 2.0), 0.0)
            }
            8 => Self::new([(1.0, 0.0), (0.5, 1.0 + H)], 3, H / 3.0)
                .with_rectangles(2, &[[0.0, 0.0, 1.0, 1.0]])
                .with_triangles(0, true, &[(0.5, 1.0 + H / 3.0)])
                .with_triangles(1, false, &[(1.0, 1.0 + H * 2.0 / 3.0)]),
            9 => Self::new([(2.0, 0.0), (1.0, 2.0 * H)], 3, H / 3.0)
                .with_regular_polygon(2, 6, center(0.5, H), 0.0)
                .with_triangles(1, false, &[(1.5, H * 5.0 / 3.0)])
                .with_triangles(0, true, &[(1.5, H / 3.0)]),
            10 => Self::new([(1.0, 0.0), (0.5, 1.0)], 1, 0.5).with_rectangles(0, &[[0.0, 0.0, 1.0, 1.0]]),
            11 => Self::new([(3.0, 0.0), (0.0, 3.0)], 3, 0.5)
                .with_rectangles(0, &[[1.0, 1.0, 1.0, 1.0]])
                .with_rectangles(1, &[[1.0, 0.0, 2.0, 1.0], [0.0, 2.0, 2.0, 1.0]])
                .with_rectangles(2, &[[0.0, 0.0, 1.0, 2.0], [2.0, 1.0, 1.0, 2.0]]),
            12 => Self::new([(3.0, -3.0), (3.0, 3.0)], 3, 0.5)
                .with_rectangles(0, &[[1.0, 1.0, 1.0, 1.0], [4.0, 1.0, 1.0, 1.0]])
                .with_rectangles(1, &[[-2.0, 2.0, 2.0, 1.0], [0.0, 2.0, 2.0, 1.0]])
                .with_rectangles(1, &[[-2.0, 3.0, 2.0, 1.0], [0.0, 3.0, 2.0, 1.0]])
                .with_rectangles(2, &[[2.0, 1.0, 1.0, 2.0], [3.0, 1.0, 1.0, 2.0]])
                .with_rectangles(2, &[[2.0, 3.0, 1.0, 2.0], [3.0, 3.0, 1.0, 2.0]]),
            13 => Self::frame_tiling(3, [0, 2, 2, 1, 1]),
            14 => Self::frame_tiling(5, [4, 0, 1, 2, 3]),
            15 => Self::new([(2.0, 1.0), (-1.0, 2.0)], 2, 0.5)
                .with_rectangles(1, &[[0.0, 1.0, 2.0, 2.0]])
                .with_rectangles(0, &[[2.0, 1.0, 1.0, 1.0]]),
            16 => Self::hexagon_and_square_tiling(3, [2, 0, 0, 0, 1, 1]),
            17 => Self::hexagon_and_square_tiling(6, [5, 1, 0, 2, 4, 3]),
            18 => Self::new([(2.0, 2.0), (2.0, -2.0)], 2, 0.5)
                .with_rectangles(0, &[[2.0, 0.0, 2.0, 1.0], [2.0, 1.0, 2.0, 1.0]])
                .with_rectangles(1, &[[0.0, 0.0, 1.0, 2.0], [1.0, 0.0, 1.0, 2.0]]),
            19 => Self::snub_hexagon_tiling(-1.0, center(-1.5, 3.0 * H)),
            20 => Self::snub_hexagon_tiling(1.0, center(1.0, 2.0 * H)),
            21 => Self::snub_square_tiling(),
            22 => Self::dodecagon_and_triangle_tiling(),
            23 => Self::dodecagon_tiling(3, [2, 0, 0, 1, 1, 1]),
            24 => Self::dodecagon_tiling(5, [4, 0, 0, 1, 2, 3]),
            _ => Self::new([(1.0, 0.0), (0.0, 1.0)], 1, 0.5).with_rectangles(0, &[[0.0, 0.0, 1.0, 1.0]]),
        }
    }

    /// Returns a tiling of hexagons cut into three rhombs that look like cubes.
    fn rhomb_tiling() -> Self {
        let middle = DVec2::new(0.5, H);
        let corner = |i: u32| middle + unit_vector_at(60.0 * f64::from(i));
        let plan = Self::new([(1.5, H), (0.0, 2.0 * H)], 3, H / 2.0);
        (0..3).fold(plan, |plan, i| {
            plan.with_polygon(2 - i as usize, &[middle, corner(2 * i), corner(2 * i + 1), corner(2 * i + 2)])
        })
    }

    /// Returns a tiling of squares in mitred frames of four boards.
    fn frame_tiling(kind_count: usize, kind_of_tile: [usize; 5]) -> Self {
        let s = FRAC_1_SQRT_2;
        let board = |corners: [(f64, f64); 4]| to_points(&corners.map(|(x, z)| (x * s, z * s)));
        Self::new([(4.0 * s, 0.0), (0.0, 4.0 * s)], kind_count, s / 2.0)
            .with_rectangles(kind_of_tile[0], &[[s, s, 2.0 * s, 2.0 * s]])
            .with_polygon(kind_of_tile[1], &board([(4.0, 0.0), (4.0, 4.0), (3.0, 3.0), (3.0, 1.0)]))
            .with_polygon(kind_of_tile[2], &board([(4.0, 0.0), (5.0, 1.0), (5.0, 3.0), (4.0, 4.0)]))
            .with_polygon(kind_of_tile[3], &board([(0.0, 0.0), (4.0, 0.0), (3.0, 1.0), (1.0, 1.0)]))
            .with_polygon(kind_of_tile[4], &board([(0.0, 0.0), (1.0, -1.0), (3.0, -1.0), (4.0, 0.0)]))
    }

    /// Returns a tiling of hexagons with squares at their sides and triangles at their corners.
    fn hexagon_and_square_tiling(kind_count: usize, kind_of_tile: [usize; 6]) -> Self {
        let apart = 1.0 + 2.0 * H;
        let middle = DVec2::splat(apart / 2.0);
        let mut plan = Self::new([(apart * H, apart / 2.0), (0.0, apart)], kind_count, H / 3.0);
        plan = plan.with_regular_polygon(kind_of_tile[0], 6, middle, 0.0);
        for i in 0..3 {
            let angle = 30.0 + 60.0 * i as f64;
            plan = plan.with_regular_polygon(
                kind_of_tile[1 + i],
                4,
                middle + apart / 2.0 * unit_vector_at(angle),
                angle + 45.0,
            );
        }
        for i in 0..2 {
            let angle = 60.0 * i as f64;
            let far = 1.0 + 0.5 / H;
            plan =
                plan.with_regular_polygon(kind_of_tile[4 + i], 3, middle + far * unit_vector_at(angle), angle + 180.0);
        }
        plan
    }

    /// Returns a tiling of hexagons with a ring of triangles each, in one of two orientations.
    fn snub_hexagon_tiling(hand: f64, middle: DVec2) -> Self {
        // centres of triangles: x, and z in thirds of their height
        let at = |x: f64, thirds: f64| (middle.x + hand * x, middle.y + thirds * H / 3.0);
        Self::new([(hand * 2.5, H), (hand * 0.5, 3.0 * H)], 3, H / 3.0)
            .with_regular_polygon(2, 6, middle, 0.0)
            .with_triangles(0, true, &[at(-5.5, -11.0), at(-4.0, -2.0), at(-3.5, 1.0), at(-3.0, 4.0)])
            .with_triangles(1, false, &[at(-5.0, -10.0), at(-4.0, -4.0), at(-3.5, -1.0), at(-3.0, 2.0)])
    }

    /// Returns a tiling of alternating pairs of squares and triangles around each corner.
    fn snub_square_tiling() -> Self {
        let half = (1.0 + 2.0 * H) / 2.0;
        let third = 1.0 / (2.0 * H);
        Self::new([(half, half), (-half, half)], 6, H / 3.0)
            .with_regular_polygon(4, 4, DVec2::splat(half / 2.0), 15.0)
            .with_regular_polygon(5, 4, DVec2::new(half / 2.0, half * 1.5), 75.0)
            .with_regular_polygon(1, 3, DVec2::new(0.0, 0.5 + third), 30.0)
            .with_regular_polygon(2, 3, DVec2::new(-third / 2.0, 0.0), 60.0)
            .with_regular_polygon(0, 3, DVec2::new(third / 2.0, 0.0), 0.0)
            .with_regular_polygon(3, 3, DVec2::new(0.0, 0.5 + 2.0 * third), 90.0)
    }

    /// Returns a tiling of dodecagons side by side, and the triangles between them.
    fn dodecagon_and_triangle_tiling() -> Self {
        let apart = 2.0 + 2.0 * H;
        let middle = DVec2::splat(apart / 2.0);
        let gap = DVec2::new(apart / 2.0, apart * H / 3.0);
        let mut plan =
            Self::new([(apart, 0.0), (apart / 2.0, apart * H)], 3, H / 3.0).with_regular_polygon(2, 12, middle, 15.0);
        // Three of the sides have a deeper bevel: right, left and lower (quirk: tiling_bevels).
        for side in [11, 5, 8] {
            let edge = &mut plan.tiles[0].edges[side];
            (edge.a, edge.b) = (edge.a * H, edge.b * H);
        }
        plan.with_regular_polygon(1, 3, middle + gap, -90.0).with_regular_polygon(0, 3, middle + 2.0 * gap, 90.0)
    }

    /// Returns a tiling of dodecagons with squares between them, and hexagons in the gaps.
    fn dodecagon_tiling(kind_count: usize, kind_of_tile: [usize; 6]) -> Self {
        let apart = 3.0 + 2.0 * H;
        let middle = DVec2::new(apart / 2.0, 1.0 + 2.0 * H);
        let gap = DVec2::new(apart / 2.0, apart * H / 3.0);
        let plan = Self::new([(apart, 0.0), (apart / 2.0, apart * H)], kind_count, 0.5)
            .with_regular_polygon(kind_of_tile[0], 12, middle, 15.0)
            .with_regular_polygon(kind_of_tile[1], 6, middle + gap, 0.0)
            .with_regular_polygon(kind_of_tile[2], 6, middle + 2.0 * gap, 0.0);
        (0..3).fold(plan, |plan, i| {
            let angle = 60.0 * i as f64;
            plan.with_regular_polygon(
                kind_of_tile[3 + i],
                4,
                middle + apart / 2.0 * unit_vector_at(angle),
                angle + 45.0,
            )
        })
    }

    /// Returns the kind of the tile at a point, and the point's position in its bevel: 0 at the edge, 1 at the bevel's
    /// end and beyond.
    fn kind_and_bevel_position(&self, p: DVec2) -> (usize, f64) {
        let [a, b] = self.steps;
        // in steps along a and b, without their whole parts
        let across = a.perp_dot(b);
        let (i, j) = ((p.perp_dot(b) / across).floor(), (a.perp_dot(p) / across).floor());
        let p = p - i * a - j * b + LEAN;
        let mut best = (0, f64::NEG_INFINITY);
        for tile in &self.tiles {
            let within = tile.position_in_bevel(p);
            if within > best.1 {
                best = (tile.kind, within);
                if within > 0.0 {
                    break;
                }
            }
        }
        (best.0, best.1.clamp(0.0, 1.0))
    }
}

impl Tile {
    /// Returns the point's position in the tile's bevel: 0 at the edge, 1 at the bevel's end; negative outside the
    /// tile.
    fn position_in_bevel(&self, p: DVec2) -> f64 {
        self.edges.iter().map(|edge| edge.b - edge.a.dot(p)).fold(f64::INFINITY, f64::min)
    }
}

/// Returns the unit vector at an angle in degrees from x towards z.
fn unit_vector_at(degrees: f64) -> DVec2 {
    let (sin, cos) = fp::sin_cos(degrees.to_radians());
    DVec2::new(cos, sin)
}

fn bounding_box(points: &[DVec2]) -> [DVec2; 2] {
    let far = DVec2::splat(f64::INFINITY);
    points.iter().fold([far, -far], |[low, high], &p| [low.min(p), high.max(p)])
}

fn to_points(corners: &[(f64, f64)]) -> Vec<DVec2> {
    corners.iter().map(|&(x, z)| DVec2::new(x, z)).collect()
}

impl Readable for Tiling {
    const SPEC: Spec = Spec {
        name: "tiling",
        summary: "ways to tile the xz plane; a tile of kind i of n has numbers from i/n in its middle to (i + 1)/n at its edges",
        params: &[Param { name: "number", kind: ValueKind::Float, summary: "which tiling, 1 to 27" }],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let (span, number) = (r.span(), r.float()?.trunc());
        if !(1.0..=TILINGS).contains(&number) {
            return Diagnostic::err(
                codes::BAD_ARGUMENT,
                span,
                format!("there are tilings 1 to 27, but none with the number {number}"),
            );
        }
        Ok(Self::tiling_of_number(number as usize))
    }
}

impl Tiling {
    fn tiling_of_number(number: usize) -> Self {
        let periodic = || Tiles::Plan(Arc::new(Plan::tiling_plan(number).with_copies()));
        Self { number, tiles: Penrose::penrose_tiling(number).map_or_else(periodic, Tiles::Penrose) }
    }
}

impl Field for Tiling {
    fn value(&self, at: &TextureContext) -> f64 {
        let p = DVec2::new(at.p.x, at.p.z);
        let ((kind, within), kinds) = match &self.tiles {
            Tiles::Plan(plan) => (plan.kind_and_bevel_position(p), plan.kinds),
            Tiles::Penrose(penrose) => (penrose.kind_and_bevel_position(p), penrose.tile_kind_count()),
        };
        let value = (kind as f64 + 1.0 - within) / kinds as f64;
        value_on_seam(self.number, p, value).unwrap_or(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;
    use crate::pattern::extreme_points;

    #[test]
    fn every_tiling_reaches_everywhere() {
        for number in 1..=27 {
            let tiling = Tiling::tiling_of_number(number);
            for p in extreme_points() {
                let value = tiling.value(&TextureContext::without_surface(p, Default::default()));
                // (A seam may give a larger number.)
                assert!(value.is_nan() || (0.0..=7.0 / 3.0).contains(&value), "{number} {p}: {value}");
            }
        }
    }

    #[test]
    fn seams_match_povray() {
        // POV-Ray 3.7's numbers at <x, 0, z>
        for (number, x, z, shown) in [
            (3, -8.0, -7.5, 0.5048),
            (3, -8.0, 3.5, 0.4689),
            (3, -8.0, 0.0, 0.5),
            (12, -2.924, 0.0, 7.0 / 3.0),
            (12, -6.0, 0.5, 7.0 / 3.0),
            (13, 0.3, 0.0, 0.0),
            (14, -4.0, 0.0, 0.0),
            (19, 2.01, 0.0, 1.0 / 3.0),
            (19, 2.51, 0.0, 2.0 / 3.0),
            (19, 3.01, 0.0, 1.0),
            (19, -2.99, 0.0, 2.0 / 3.0),
            (20, -0.04, 0.0, 2.0 / 3.0),
            (20, 5.01, 0.0, 2.0 / 3.0),
        ] {
            let value = Tiling::tiling_of_number(number)
                .value(&TextureContext::without_surface(DVec3::new(x, 0.3, z), Default::default()));
            assert!((value - shown).abs() < 1e-4, "{number} <{x}, {z}>: {value} instead of {shown}");
        }
    }

    #[test]
    fn joints_belong_to_one_side() {
        // POV-Ray 3.7's numbers at x = 0, 1/2 … 5/2 and z = 0, 1/2, 1, 3/2, times 180
        const SHOWN: [(usize, [u8; 24]); 6] = [
            (
                5,
                [
                    120, 85, 69, 104, 60, 35, 171, 148, 60, 25, 161, 164, 60, 95, 111, 76, 180, 145, 41, 44, 180, 155,
                    51, 28,
                ],
            ),
            (6, [180, 180, 180, 180, 180, 90, 90, 90, 90, 90, 180, 180, 90, 0, 180, 90, 90, 0, 90, 90, 90, 0, 90, 0]),
            (
                9,
                [
                    180, 128, 120, 156, 180, 120, 120, 132, 180, 128, 120, 156, 60, 22, 106, 72, 180, 128, 120, 156,
                    180, 120, 120, 132,
                ],
            ),
            (
                11,
                [
                    180, 180, 180, 180, 180, 120, 120, 120, 120, 120, 60, 60, 120, 60, 60, 0, 120, 60, 180, 180, 120,
                    60, 180, 120,
                ],
            ),
            (15, [90, 90, 180, 180, 90, 0, 180, 90, 180, 180, 180, 90, 90, 90, 180, 90, 90, 90, 90, 90, 90, 90, 90, 0]),
            (
                18,
                [
                    180, 180, 180, 180, 180, 90, 90, 90, 180, 180, 180, 180, 180, 90, 90, 90, 90, 90, 90, 90, 90, 0,
                    90, 0,
                ],
            ),
        ];
        for (number, shown) in SHOWN {
            let tiling = Tiling::tiling_of_number(number);
            for (i, shown) in shown.into_iter().enumerate() {
                let p = DVec3::new((i / 4) as f64 / 2.0, 0.0, (i % 4) as f64 / 2.0);
                let value = tiling.value(&TextureContext::without_surface(p, Default::default()));
                assert!((value * 180.0 - f64::from(shown)).abs() < 0.51, "{number} {p}: {value}");
            }
        }
    }
}
