//! `tiling` 25 to 27: Penrose's tilings of pentagons, of kites and darts, and of rhombs, which have no period.
//!
//! All three come from triangles with the golden ratio's proportions (R. M. Robinson; B. Grünbaum and G. C. Shephard,
//! *Tilings and Patterns*, 1987, § 10.3): an acute one, with angles of 36°, 72°, 72°, and an obtuse one, with 108°,
//! 36°, 36°. Each can be cut into smaller ones of both kinds. Ten acute ones around a point, cut repeatedly and
//! enlarged as often, tile the plane. A point is located from the outside inwards: in one of the ten, then in one of
//! its pieces, and so on, in a number of steps proportional to the logarithm of its distance. POV-Ray 3.7 shows these
//! tilings with the origin as their centre (quirk: `penrose_bevels`, also for size, direction and bevel).

use crate::math::{DVec2, fp};

/// The golden ratio.
const PHI: f64 = 1.618_033_988_749_895;

// Sines and cosines of 18° and 36°.
const S18: f64 = 0.309_016_994_374_947_4;
const C18: f64 = 0.951_056_516_295_153_5;
const S36: f64 = 0.587_785_252_292_473_1;
const C36: f64 = 0.809_016_994_374_947_4;

/// Unit vectors at 0°, 36°, 72°, … from x towards z.
const TOWARDS: [DVec2; 10] = [
    DVec2::new(1.0, 0.0),
    DVec2::new(C36, S36),
    DVec2::new(S18, C18),
    DVec2::new(-S18, C18),
    DVec2::new(-C36, S36),
    DVec2::new(-1.0, 0.0),
    DVec2::new(-C36, -S36),
    DVec2::new(-S18, -C18),
    DVec2::new(S18, -C18),
    DVec2::new(C36, -S36),
];

/// Width of the bevels of Penrose's kites and darts; then that of pentagons and rhombs.
const KITE_DEPTH: f64 = 1.0 / 4.46;
const DEPTH: f64 = PHI / 5.55;
/// Difference between a Penrose tiling's number at a bevel's end and the next kind's first number.
const MARGIN: f64 = 1e-6;

/// Distance between the centres of two pentagons of a Penrose tiling with a common side of length 1; also from the
/// centre of a star to its tips.
const APART: f64 = 1.376_381_920_471_173_5;
/// Length of the legs of the triangles that contain the same piece of the Penrose tiling with pentagons: `APART` φ².
const LEG: f64 = 3.603_414_649_294_386_6;

/// Aperiodic tiling by Penrose, with its number in a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Penrose {
    /// Penrose tiling 25: three kinds of pentagons, stars, boats and diamonds, with sides of length 1.
    Pentagons,
    /// Penrose tiling 26: kites and darts with sides of length 1 and 1/φ.
    Kites,
    /// Penrose tiling 27: thick and thin rhombs with sides of length 1.
    Rhombs,
}

/// A point in a triangle of a Penrose tiling, as barycentric weights of its corners A, where its equal legs meet, B and
/// C.
#[derive(Clone, Copy, Debug)]
struct Place {
    obtuse: bool,
    a: f64,
    b: f64,
    c: f64,
}

impl Place {
    /// Locates a point in a Penrose tiling's triangles, given the legs of the smallest triangles and the least number
    /// of cuts, which grows by four until the first triangles reach far enough: after four cuts all positions repeat,
    /// scaled by φ⁻⁴.
    fn locate_in_triangle(p: DVec2, smallest_leg: f64, min_cuts: u32) -> Self {
        // By fivefold symmetry and a mirror, one of the ten triangles is enough, with B at 36° and C at 0°.
        let p = DVec2::new(p.x, p.y.abs());
        let (x, z) = along_and_across(p, nearest_direction(p, &[0, 2, 4]));
        let (x, z) = (x, z.abs());
        let (mut cuts, mut long) = (min_cuts, smallest_leg * fp::integer_power(PHI, min_cuts));
        while long * C18 < fp::hypot(x, z) {
            (cuts, long) = (cuts + 4, long * fp::integer_power(PHI, 4));
        }
        let b = z / (long * S36);
        let c = x / long - b * C36;
        (0..cuts).fold(Self { obtuse: false, a: 1.0 - b - c, b, c }, |place, _| place.cut_triangle())
    }

    /// Cuts the triangle of a Penrose tiling and returns the piece that contains the point.
    fn cut_triangle(self) -> Self {
        let Self { obtuse, a, b, c } = self;
        let inverse = PHI - 1.0;
        if !obtuse {
            // cut from C to the point that divides AB in the golden ratio, nearer to B
            return if b >= PHI * a {
                Self { obtuse: false, a: c, b: (PHI + 1.0) * a, c: b - PHI * a }
            } else {
                Self { obtuse: true, a: PHI * b, b: c, c: a - inverse * b }
            };
        }
        // cut from A to the point R that divides BC, nearer to C; then the part at B from R to the point that divides
        // AB, nearer to A
        if c >= PHI * b {
            return Self { obtuse: true, a: (PHI + 1.0) * b, b: c - PHI * b, c: a };
        }
        let (b, r) = (b - inverse * c, PHI * c);
        if b >= inverse * a {
            Self { obtuse: true, a: PHI * a, b: r, c: b - inverse * a }
        } else {
            Self { obtuse: false, a: r, b: (PHI + 1.0) * b, c: a - PHI * b }
        }
    }
}

impl Penrose {
    /// Returns the Penrose tiling of a number from 25 to 27.
    pub fn penrose_tiling(number: usize) -> Option<Self> {
        [Self::Pentagons, Self::Kites, Self::Rhombs].get(number.checked_sub(25)?).copied()
    }

    /// Number of kinds of tiles in the Penrose tiling.
    pub fn tile_kind_count(self) -> usize {
        if self == Self::Pentagons { 6 } else { 2 }
    }

    /// Returns the kind of the Penrose tile at a point, and the point's position in its bevel: 0 at the edge, just
    /// below 1 at the bevel's end and beyond (quirk: `penrose_bevels`), so that no number equals that of the next
    /// kind's edges.
    pub fn kind_and_bevel_position(self, p: DVec2) -> (usize, f64) {
        let (kind, within) = match self {
            Self::Pentagons => {
                let (kind, distance) = pentagon_kind_and_distance(Place::locate_in_triangle(p, LEG, 4));
                (kind, distance / DEPTH)
            }
            Self::Kites => kite_kind_and_bevel_position(Place::locate_in_triangle(p, 1.0, 2)),
            Self::Rhombs => rhomb_kind_and_bevel_position(Place::locate_in_triangle(p, 1.0, 3)),
        };
        let most = if kind == 0 { 1.0 } else { 1.0 - MARGIN * self.tile_kind_count() as f64 };
        (kind, within.clamp(0.0, most))
    }
}

/// Evaluates the Penrose tiling of rhombs, which consist of two triangles with the common side BC.
fn rhomb_kind_and_bevel_position(place: Place) -> (usize, f64) {
    let height = if place.obtuse { C18 } else { S36 };
    (usize::from(!place.obtuse), place.b.min(place.c) * height / DEPTH)
}

/// Evaluates the Penrose tiling of kites and darts, which consist of two triangles with the common side AB: the acute
/// ones unchanged, and the obtuse ones cut from A to the point R that divides BC.
fn kite_kind_and_bevel_position(place: Place) -> (usize, f64) {
    let Place { obtuse, a, b, c } = place;
    let inverse = PHI - 1.0;
    let (dart, distance) = match obtuse {
        false => (false, (a * C18).min(b * S36)),
        true if c >= PHI * b => (true, ((PHI + 1.0) * b * S36).min((c - PHI * b) * C18) * inverse),
        true => (false, ((b - inverse * c) * C18).min(a * S36)),
    };
    (usize::from(dart), distance / KITE_DEPTH)
}

/// Evaluates the Penrose tiling of pentagons: returns the kind of the tile and the distance from its edge.
fn pentagon_kind_and_distance(place: Place) -> (usize, f64) {
    // A is at the origin, B at <LEG, 0>.
    let tip = TOWARDS[if place.obtuse { 3 } else { 1 }] * LEG;
    let (end, p) = (DVec2::X * LEG, DVec2::X * (LEG * place.b) + tip * place.c);
    let (left, right) = if place.obtuse { (1, 2) } else { (2, 1) };
    let mut best = diamond_kind_and_distance(p - end / 2.0);
    let mut tile = |kind, center: DVec2, mirrored: bool| {
        let distance = depth_in_pentagon(if mirrored { center - p } else { p - center });
        if distance > best.1 {
            best = (kind, distance);
        }
    };
    tile(0, DVec2::ZERO, false);
    tile(0, end, true);
    tile(left, TOWARDS[1] * APART, true);
    tile(right, end + TOWARDS[4] * APART, false);
    if place.obtuse {
        tile(2, TOWARDS[3] * APART, true);
        tile(1, tip + TOWARDS[9] * APART, false);
    }
    if best.1 >= 0.0 {
        return best;
    }
    let middle = end + TOWARDS[4] * LEG;
    if place.obtuse && p.distance_squared(middle) < p.distance_squared(tip) {
        boat_kind_and_distance(p - middle)
    } else {
        star_kind_and_distance(p - tip)
    }
}

/// Distance of a point from the edge of a pentagon around the origin, with a corner at 0°; negative outside.
fn depth_in_pentagon(p: DVec2) -> f64 {
    APART / 2.0 - [1, 3, 5, 7, 9].map(|k| TOWARDS[k].dot(p)).into_iter().fold(f64::NEG_INFINITY, f64::max)
}

/// Kind of a Penrose tile and distance from its edge, for a rhomb around the origin, with its acute corners at 0° and
/// 180°.
fn diamond_kind_and_distance(p: DVec2) -> (usize, f64) {
    (5, S18 * C18 - p.x.abs() * S18 - p.y.abs() * C18)
}

/// Kind of a Penrose tile and distance from its edge, for a star around the origin, with a tip at 0°.
fn star_kind_and_distance(p: DVec2) -> (usize, f64) {
    (3, depth_in_star_arm(along_and_across(p, nearest_direction(p, &[0, 2, 4, 6, 8]))))
}

/// Kind of a Penrose tile and distance from its edge, for a boat: three arms of a star, the middle one at -36°, and a
/// side across the missing two.
fn boat_kind_and_distance(p: DVec2) -> (usize, f64) {
    let across = (S18 * S18 / S36) + p.dot(TOWARDS[9]);
    let k = nearest_direction(p, &[9, 1, 7, 3, 5]);
    (4, if matches!(k, 3 | 5) { across } else { across.min(depth_in_star_arm(along_and_across(p, k))) })
}

/// Distance of a point from the edges of a star's arm at 0°, 36° wide at its tip; negative outside.
fn depth_in_star_arm((x, z): (f64, f64)) -> f64 {
    (APART - x) * S18 - z.abs() * C18
}

/// Returns the direction among `among` that is nearest to the point, as an index of [`TOWARDS`].
fn nearest_direction(p: DVec2, among: &[usize]) -> usize {
    let farther = |best: usize, &k: &usize| if TOWARDS[k].dot(p) > TOWARDS[best].dot(p) { k } else { best };
    among.iter().fold(among[0], farther)
}

/// Returns the point's coordinates along and across the direction with index `k`.
fn along_and_across(p: DVec2, k: usize) -> (f64, f64) {
    (TOWARDS[k].dot(p), TOWARDS[k].perp_dot(p))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const ALL: [Penrose; 3] = [Penrose::Pentagons, Penrose::Kites, Penrose::Rhombs];

    #[test]
    fn thick_tiles_are_the_golden_ratio_of_thin_ones() {
        // The numbers of the two kinds of tiles have the same proportion in any Penrose tiling.
        for (tiling, area) in [(Penrose::Kites, PHI), (Penrose::Rhombs, PHI)] {
            let (mut first, mut all) = (0.0, 0.0);
            for i in 0..400_000 {
                // a low-discrepancy sequence (R2) over a square
                let t = f64::from(i);
                let p = DVec2::new(t * 0.754_877_666_246_693, t * 0.569_840_290_998_053_3).fract();
                first += f64::from(u8::from(tiling.kind_and_bevel_position((p - 0.5) * 4000.0).0 == 0));
                all += 1.0;
            }
            // φ : 1 by number, and by area φ times more
            let expected = PHI * area / (PHI * area + 1.0);
            assert!((first / all - expected).abs() < 2e-3, "{tiling:?}: {}", first / all);
        }
    }

    proptest! {
        #[test]
        fn there_is_fivefold_symmetry(x in -50.0..50.0f64, z in -50.0..50.0f64) {
            let p = DVec2::new(x, z);
            for tiling in ALL {
                let (kind, within) = tiling.kind_and_bevel_position(p);
                let (along, across) = along_and_across(p, 2);
                let turned = tiling.kind_and_bevel_position(DVec2::new(along, across));
                prop_assert!((turned.1 - within).abs() < 1e-10 && (turned.0 == kind || within < 1e-10));
                prop_assert_eq!(tiling.kind_and_bevel_position(DVec2::new(x, -z)), (kind, within));
            }
        }

        #[test]
        fn bevels_have_no_jumps(x in -50.0..50.0f64, z in -50.0..50.0f64, dx in -1e-4..1e-4f64, dz in -1e-4..1e-4f64) {
            for tiling in ALL {
                let [(_, one), (_, other)] = [(x, z), (x + dx, z + dz)].map(|(x, z)| tiling.kind_and_bevel_position(DVec2::new(x, z)));
                prop_assert!((one - other).abs() < 1e-3, "{tiling:?}");
            }
        }
    }
}
