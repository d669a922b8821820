//! `cubic`, `quartic`, `poly` and `polynomial`: where a polynomial in x, y and z is 0.
//!
//! The four say the same in four ways: `cubic { <20 numbers> }` is of order 3, `quartic { <35 numbers> }` of order 4, `poly { order,
//! <numbers> }` of any order from 2 to 35. Their numbers belong to the powers in falling order: x³, x²y, x²z, x², xy², xyz, xy … `polynomial
//! { order, xyz(2, 0, 0): 1, xyz(0, 0, 0): -1 }` names the powers instead, and leaves out those whose number is 0. The
//! inside is where the sum is negative. `sturm` chooses a slower, more exact method in POV-Ray; here the method is always exact.
//!
//! ```pov
//! polynomial {
//!   4, xyz(4, 0, 0): 1, xyz(0, 4, 0): 1, xyz(0, 0, 4): 1, xyz(2, 0, 0): -1.4, xyz(0, 2, 0): -1.4, xyz(0, 0, 2): -1.4, xyz(0, 0, 0): 0.6
//!   translate y pigment { color rgb <0.9, 0.2, 0.2> }
//! }
//! ```

use super::{Bounding, HUGE, Hit, Hits, Kernel, Quirks};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec3, MAX_DEGREE, Range, Ray, Transform, polynomial_roots_between, tolerance};
use crate::source::Span;
use crate::value::words::{Row, word};
use crate::value::{Param, Readable, Reader, Spec, ValueKind, WordSpec};
use serde::Serialize;

/// Algebraic surface `cubic { <…> }`.
pub type Cubic = Algebraic<0>;
/// Algebraic surface `quartic { <…> }`.
pub type Quartic = Algebraic<1>;
/// Algebraic surface `poly { order, <…> }`.
pub type Poly = Algebraic<2>;
/// Algebraic surface `polynomial { order, xyz(…): … }`.
pub type Polynomial = Algebraic<3>;

const FORMS: [&str; 4] = ["cubic", "quartic", "poly", "polynomial"];

/// Algebraic surface in one of POV-Ray's four notations.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Algebraic<const FORM: usize> {
    /// Order of the surface's polynomial: the maximum sum of exponents.
    pub order: usize,
    /// Coefficients of all monomials of the surface's polynomial, in falling order.
    pub coefficients: Vec<f64>,
    /// Terms of the surface's polynomial with coefficients other than 0.
    #[serde(skip)]
    rows: Vec<PowersOfZ>,
}

/// Terms xⁱ·yʲ·(c₀ + c₁·z + …) of a polynomial, which are evaluated together.
#[derive(Clone, Debug, PartialEq)]
struct PowersOfZ {
    i: usize,
    j: usize,
    /// Coefficients of the powers of z in these terms; the last is not 0.
    c: Vec<f64>,
}

/// Number of coefficients of a polynomial in x, y and z of this order.
fn coefficient_count(order: usize) -> usize {
    (order + 1) * (order + 2) * (order + 3) / 6
}

/// Index of the coefficient of xⁱ·yʲ·zᵏ in a polynomial of this order.
fn coefficient_index(order: usize, [i, j, k]: [usize; 3]) -> usize {
    // Before it are all monomials with a higher power of x, then those with the same power of x and a higher one of y.
    let (of_yz, of_z) = (order - i, order - i - j);
    let more_x = if i == order { 0 } else { coefficient_count(order - i - 1) };
    let more_y = of_z * (of_z + 1) / 2;
    debug_assert!(j <= of_yz && k <= of_z);
    more_x + more_y + (of_z - k)
}

/// A polynomial in one variable with up to N coefficients, lowest first.
struct Univariate<const N: usize> {
    c: [f64; N],
    len: usize,
}

impl<const N: usize> Univariate<N> {
    const ZERO: Self = Self { c: [0.0; N], len: 0 };

    /// Multiplies the polynomial by (o + v·s)ⁿ.
    fn multiply_by_power(&mut self, o: f64, v: f64, n: usize) {
        for _ in 0..n {
            if self.len == 0 {
                return;
            }
            self.c[self.len] = self.c[self.len - 1] * v;
            for i in (1..self.len).rev() {
                self.c[i] = self.c[i] * o + self.c[i - 1] * v;
            }
            self.c[0] *= o;
            self.len += 1;
        }
    }

    fn add(&mut self, other: &Self) {
        for (c, more) in self.c.iter_mut().zip(&other.c[..other.len]) {
            *c += more;
        }
        self.len = self.len.max(other.len);
    }
}

/// Value of a polynomial and its derivatives by x, y and z.
#[derive(Clone, Copy, Default)]
struct ValueAndGradient {
    value: f64,
    by: DVec3,
}

impl ValueAndGradient {
    /// Multiplies a polynomial's value and derivatives by the n-th power of the coordinate along an axis.
    fn times_coordinate_power(mut self, p: DVec3, axis: usize, n: usize) -> Self {
        for _ in 0..n {
            self.by *= p[axis];
            self.by[axis] += self.value;
            self.value *= p[axis];
        }
        self
    }

    fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, by: self.by + other.by }
    }
}

impl<const FORM: usize> Algebraic<FORM> {
    /// Creates the surface of a polynomial of an order up to 35, with a coefficient for each monomial.
    pub fn new(order: usize, coefficients: Vec<f64>) -> Self {
        let mut rows = vec![];
        for i in (0..=order).rev() {
            for j in (0..=order - i).rev() {
                let powers = 0..=order - i - j;
                let mut c: Vec<f64> = powers.map(|k| coefficients[coefficient_index(order, [i, j, k])]).collect();
                c.truncate(c.iter().rposition(|c| *c != 0.0).map_or(0, |last| last + 1));
                if !c.is_empty() {
                    rows.push(PowersOfZ { i, j, c });
                }
            }
        }
        Self { order, coefficients, rows }
    }

    /// Returns the polynomial along the line o + s·v, by Horner's rule in x, in y and in z.
    fn along_line<const N: usize>(&self, o: DVec3, v: DVec3) -> Univariate<N> {
        let (mut of_x, mut of_y) = (Univariate::<N>::ZERO, Univariate::<N>::ZERO);
        let (mut i, mut j) = (self.order, self.order);
        for row in &self.rows {
            if row.i < i {
                of_y.multiply_by_power(o.y, v.y, j);
                of_x.add(&of_y);
                of_x.multiply_by_power(o.x, v.x, i - row.i);
                (of_y, i, j) = (Univariate::ZERO, row.i, row.j);
            }
            of_y.multiply_by_power(o.y, v.y, j - row.j);
            j = row.j;
            let mut of_z = Univariate::<N>::ZERO;
            for c in row.c.iter().rev() {
                of_z.multiply_by_power(o.z, v.z, 1);
                of_z.c[0] += c;
                of_z.len = of_z.len.max(1);
            }
            of_y.add(&of_z);
        }
        of_y.multiply_by_power(o.y, v.y, j);
        of_x.add(&of_y);
        of_x.multiply_by_power(o.x, v.x, i);
        of_x
    }

    /// Returns the polynomial and its gradient at a point.
    fn value_and_gradient(&self, p: DVec3) -> ValueAndGradient {
        let (mut of_x, mut of_y) = (ValueAndGradient::default(), ValueAndGradient::default());
        let (mut i, mut j) = (self.order, self.order);
        for row in &self.rows {
            if row.i < i {
                of_x = of_x.plus(of_y.times_coordinate_power(p, 1, j)).times_coordinate_power(p, 0, i - row.i);
                (of_y, i, j) = (ValueAndGradient::default(), row.i, row.j);
            }
            let more = row.c.iter().rev().fold(ValueAndGradient::default(), |sum, c| {
                let mut sum = sum.times_coordinate_power(p, 2, 1);
                sum.value += c;
                sum
            });
            of_y = of_y.times_coordinate_power(p, 1, j - row.j).plus(more);
            j = row.j;
        }
        of_x.plus(of_y.times_coordinate_power(p, 1, j)).times_coordinate_power(p, 0, i)
    }

    /// Calls `stops_at` with each hit of a ray on the algebraic surface in the range, ascending, until `stops_at` returns
    /// true.
    fn search_hits(&self, ray: &Ray, range: Range, stops_at: &mut dyn FnMut(f64) -> bool) {
        // Start from the ray's point nearest to the origin, so that a distant eye costs no digits.
        let length = ray.dir.length();
        let range = range.raised_to_min_distance(tolerance::OWN_SURFACE / length);
        let v = ray.dir / length;
        let middle = -ray.origin.dot(v);
        let o = ray.origin + middle * v;
        let (lo, hi) = (range.min * length - middle, range.max * length - middle);
        let mut report_root = |s: f64| {
            let t = (s + middle) / length;
            range.contains(t) && t.is_finite() && stops_at(t)
        };
        if self.order <= 4 {
            polynomial_roots_between(&self.along_line::<5>(o, v).c, lo, hi, &mut report_root);
        } else {
            polynomial_roots_between(&self.along_line::<{ MAX_DEGREE + 1 }>(o, v).c, lo, hi, &mut report_root);
        }
    }

    /// Reads a term of a `polynomial`: `xyz(i, j, k): number`.
    fn read_term(&mut self, r: &mut dyn Reader) -> Result<()> {
        let span = r.span();
        let powers = r.numbers_in_parentheses(3)?;
        r.read_colon()?;
        let value = r.float()?;
        let sum: f64 = powers.iter().map(|p| p.floor()).sum();
        if powers.iter().any(|p| *p < 0.0) || sum > self.order as f64 {
            let message = format!(
                "a `polynomial` of order {} has no `xyz({}, {}, {})`",
                self.order, powers[0], powers[1], powers[2]
            );
            let help = "no power is negative, and the three together are at most the order";
            return Err(Diagnostic::new(codes::BAD_ORDER, span, message).help(help).into());
        }
        let at = coefficient_index(self.order, [powers[0] as usize, powers[1] as usize, powers[2] as usize]);
        self.coefficients[at] = value;
        Ok(())
    }
}

const ORDER: Param = Param { name: "order", kind: ValueKind::Float, summary: "the highest power, 2 to 35" };
const COEFFICIENTS: Param =
    Param { name: "<coefficients>", kind: ValueKind::Vectors, summary: "a number for each power, in falling order" };

/// Reads the order of a polynomial, from 2 to 35.
fn read_order(form: &str, r: &mut dyn Reader) -> Result<usize> {
    let (span, order) = (r.span(), r.float()?.floor());
    if (2.0..=MAX_DEGREE as f64).contains(&order) {
        return Ok(order as usize);
    }
    let message = format!("the order of a `{form}` is 2 to {MAX_DEGREE}, this one is {order}");
    let help = "a polynomial of order 1 is a `plane`".to_string();
    Err(Diagnostic::new(codes::BAD_ORDER, span, message).maybe_help((order == 1.0).then_some(help)).into())
}

impl<const FORM: usize> Readable for Algebraic<FORM> {
    const SPEC: Spec = Spec {
        name: FORMS[FORM],
        summary: [
            "where a polynomial of order 3 in x, y and z is 0",
            "where a polynomial of order 4 in x, y and z is 0",
            "where a polynomial in x, y and z is 0",
            "where a polynomial in x, y and z is 0, its powers named one by one",
        ][FORM],
        params: [&[COEFFICIENTS] as &[Param], &[COEFFICIENTS], &[ORDER, COEFFICIENTS], &[ORDER]][FORM],
        words: if FORM == 3 { &[TERM, STURM] } else { &[STURM] },
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = if FORM == 3 { Self::TERMS } else { Self::STURM };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let order = match FORM {
            0 => 3,
            1 => 4,
            _ => read_order(FORMS[FORM], r)?,
        };
        let coefficients = if FORM == 3 {
            vec![0.0; coefficient_count(order)]
        } else {
            r.numbers_in_angle_brackets(coefficient_count(order))?
        };
        Ok(Self::new(order, coefficients))
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        *self = Self::new(self.order, std::mem::take(&mut self.coefficients));
        if self.rows.iter().all(|row| row.i + row.j == 0 && row.c.len() == 1) {
            let message =
                format!("a `{}` with these numbers has no surface: the sum is the same everywhere", FORMS[FORM]);
            r.report(Diagnostic::new(codes::NO_SURFACE, span, message));
        }
        Ok(())
    }
}

impl<const FORM: usize> Algebraic<FORM> {
    const STURM: &'static [Row<Self>; 1] = &[STURM.sets(|_, r| r.flag().map(drop))];
    const TERMS: &'static [Row<Self>; 2] = &[TERM.sets(Self::read_term), STURM.sets(|_, r| r.flag().map(drop))];
}

const TERM: WordSpec = word("xyz", ValueKind::Block, "", "`xyz(i, j, k): c` adds c·xⁱ·yʲ·zᵏ");
/// The word `sturm`, which has no effect: durer always solves polynomials exactly.
pub(super) const STURM: WordSpec =
    word("sturm", ValueKind::Flag, "off", "a more exact method in POV-Ray; changes nothing here");

impl<const FORM: usize> Kernel for Algebraic<FORM> {
    const QUIRKS: Quirks = Quirks { bounding: Bounding::Exact, ..Quirks::NONE };

    fn bounds(&self) -> Aabb {
        Aabb::INFINITE
    }

    fn pov_bounds(&self, _: &Transform) -> Aabb {
        HUGE
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.search_hits(ray, range, &mut |t| {
            out.push(Hit::on_single_piece(t));
            false
        });
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut first = None;
        self.search_hits(ray, range, &mut |t| {
            first = Some(Hit::on_single_piece(t));
            true
        });
        first
    }

    fn inside(&self, p: DVec3) -> bool {
        self.value_and_gradient(p).value < tolerance::POLYNOMIAL_INSIDE
    }

    fn normal(&self, p: DVec3, _: &Hit) -> DVec3 {
        let n = self.value_and_gradient(p).by;
        if n.length_squared() > 0.0 { n } else { DVec3::X }
    }

    /// Returns false: POV-Ray defines no uv mapping for algebraic surfaces.
    fn has_uv_mapping(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::fp;
    use crate::shape::testing::{all_hits, assert_hits, read_shape};

    /// A torus with radii √40 and √12, as in the manual.
    const RING: &str = "<1,0,0,0,2,0,0,2,0,-104,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,56,0,0,0,0,1,0,-104,0,784>";

    #[test]
    fn powers_in_falling_order() {
        // A1 … A10 of order 2: x², xy, xz, x, y², yz, y, z², z, 1
        let powers = [
            [2, 0, 0],
            [1, 1, 0],
            [1, 0, 1],
            [1, 0, 0],
            [0, 2, 0],
            [0, 1, 1],
            [0, 1, 0],
            [0, 0, 2],
            [0, 0, 1],
            [0, 0, 0],
        ];
        assert_eq!(powers.map(|p| coefficient_index(2, p)), [0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
        assert_eq!([2, 3, 4, 35].map(coefficient_count), [10, 20, 35, 8436]);
        // A31 of order 4 is z⁴, A120 of order 7 the constant.
        assert_eq!((coefficient_index(4, [0, 0, 4]), coefficient_index(7, [0, 0, 0])), (30, 119));
    }

    #[test]
    fn value_and_gradient() {
        let c: Vec<f64> =
            (0..coefficient_count(5)).map(|k| fp::sin(k as f64) * f64::from(u8::from(k % 3 != 0))).collect();
        let shape = Poly::new(5, c.clone());
        let p = DVec3::new(0.7, -1.3, 0.4);
        let direct = |p: DVec3| {
            let mut sum = 0.0;
            for i in 0..=5 {
                for j in 0..=5 - i {
                    for k in 0..=5 - i - j {
                        sum += c[coefficient_index(5, [i, j, k])]
                            * p.x.powi(i as i32)
                            * p.y.powi(j as i32)
                            * p.z.powi(k as i32);
                    }
                }
            }
            sum
        };
        assert!((shape.value_and_gradient(p).value - direct(p)).abs() < 1e-12);
        for axis in 0..3 {
            let step = DVec3::AXES[axis] * 1e-5;
            let slope = (direct(p + step) - direct(p - step)) / 2e-5;
            assert!((shape.value_and_gradient(p).by[axis] - slope).abs() < 1e-7);
        }
        let (o, v) = (DVec3::new(0.2, 0.5, -0.3), DVec3::new(0.6, -0.1, 0.9));
        let line = shape.along_line::<36>(o, v).c;
        for s in [-1.5, 0.0, 0.3, 2.0] {
            let sum = line.iter().rev().fold(0.0, |sum, c| sum * s + c);
            assert!((sum - direct(o + v * s)).abs() < 1e-11);
        }
    }

    #[test]
    fn one_ring_in_four_ways() {
        let ring = read_shape::<Quartic>(RING).0.unwrap();
        let (major, minor) = (40.0_f64.sqrt(), 12.0_f64.sqrt());
        let x = DVec3::X * -30.0;
        let want = [-major - minor, minor - major, major - minor, major + minor].map(|x| x + 30.0);
        let hits = all_hits(&ring, &Ray::new(x, DVec3::X));
        assert!(hits.len() == 4 && hits.iter().zip(want).all(|(h, t)| (h.t - t).abs() < 1e-12), "{hits:?}");
        let same = read_shape::<Poly>(&format!("4 {RING}")).0.unwrap();
        assert_eq!(all_hits(&same, &Ray::new(x, DVec3::X)), hits);
        let terms = [([4, 0, 0], 1), ([2, 2, 0], 2), ([2, 0, 2], 2), ([2, 0, 0], -104), ([0, 4, 0], 1), ([0, 2, 2], 2)];
        let terms = terms.iter().chain(&[([0, 2, 0], 56), ([0, 0, 4], 1), ([0, 0, 2], -104), ([0, 0, 0], 784)]);
        let named: String = terms.map(|([i, j, k], c)| format!(" xyz <{i},{j},{k}> {c}")).collect();
        assert_eq!(read_shape::<Polynomial>(&format!("4{named} sturm")).0.unwrap().coefficients, ring.coefficients);
        assert_eq!(read_shape::<Polynomial>("4 xyz <3,2,0> 1").0.unwrap_err().code, codes::BAD_ORDER);
        assert_eq!(read_shape::<Polynomial>("4 xyz <-1,0,0> 1").0.unwrap_err().code, codes::BAD_ORDER);
        assert!(ring.inside(DVec3::X * major) && !ring.inside(DVec3::ZERO));
        // From a distance of a million.
        let far = all_hits(&ring, &Ray::new(DVec3::new(-1e6, 0.5, 1.0), DVec3::X));
        let near = all_hits(&ring, &Ray::new(DVec3::new(0.0, 0.5, 1.0), DVec3::X));
        assert!(
            far.len() == 4 && far.iter().zip(&near).all(|(f, n)| (f.t - 1e6 - n.t).abs() < 1e-9),
            "{far:?} {near:?}"
        );
    }

    #[test]
    fn cubic_and_its_inside() {
        // x³ + y³ + z³ = 1
        let shape = read_shape::<Cubic>("<1,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,1,0,0,-1>").0.unwrap();
        assert_hits(&all_hits(&shape, &Ray::new(DVec3::Z * -9.0, DVec3::Z)), &[(10.0, 0)]);
        assert!(shape.inside(DVec3::ZERO) && !shape.inside(DVec3::splat(2.0)));
        assert!(shape.normal(DVec3::Z, &Hit::on_single_piece(0.0)).normalize().distance(DVec3::Z) < 1e-15);
        // The inside extends a ten-thousandth of the value beyond the surface, as in POV-Ray.
        assert!(shape.inside(DVec3::Z * 1.00003) && !shape.inside(DVec3::Z * 1.00004));
    }

    #[test]
    fn of_order_35() {
        let mut c = vec![0.0; coefficient_count(35)];
        (
            c[coefficient_index(35, [35, 0, 0])],
            c[coefficient_index(35, [0, 34, 1])],
            c[coefficient_index(35, [0, 0, 0])],
        ) = (1.0, 0.5, -1.0);
        let shape = Poly::new(35, c);
        assert_hits(&all_hits(&shape, &Ray::new(DVec3::X * -3.0, DVec3::X)), &[(4.0, 0)]);
    }

    #[test]
    fn reading() {
        assert_eq!(read_shape::<Poly>("36 0").0.unwrap_err().code, codes::BAD_ORDER);
        assert_eq!(read_shape::<Poly>("1 0").0.unwrap_err().code, codes::BAD_ORDER);
        assert!(read_shape::<Cubic>("<1,2,3>").0.is_err());
        assert_eq!(read_shape::<Poly>("2.9 <0,0,0,0,0,0,0,0,0,1> sturm").1[0].code, codes::NO_SURFACE);
    }
}
