//! Components of a blob: spheres and cylinders whose fields end at their radius.

use crate::diagnostic::Result;
use crate::math::{Aabb, DQuat, DVec3, Ray, Transform, solve_quadratic};
use crate::shape::{Kernel, Paints, Sphere, check_finite};
use crate::source::Span;
use crate::value::{Next, Reader};
use serde::Serialize;
use smallvec::SmallVec;

/// Component of a blob: a sphere or cylinder.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Component {
    /// Centre of a blob's sphere, or one end of its cylinder's axis.
    pub base: DVec3,
    /// Vector to the other end of a blob's cylinder; zero for a sphere.
    pub axis: DVec3,
    /// Distance at which the field of a blob's component ends.
    pub radius: f64,
    /// Strength of a blob's component at its centre; can be negative.
    pub strength: f64,
    /// Transform from component space to blob space, if the component is transformed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<Box<Transform>>,
    /// Number of the texture of a blob's component (see [`Paints`]); 0 for the texture of the whole blob.
    #[serde(rename = "slot")]
    pub texture_number_or_0: u32,
    /// Half width of a blob's component in radii, for [`Component::pov_bounds`].
    #[serde(skip)]
    widening: f64,
}

/// The unit cube around a blob's sphere, for [`Component::pov_bounds`]: a sphere stays a sphere under translations,
/// rotations and uniform scales; any other transform makes it the image of its cube, which a cylinder is from the start
/// (quirk: `blob_component_boxes`).
struct Cube {
    is_ball: bool,
    /// Images of the three axes under the component's transforms.
    columns: [DVec3; 3],
}

impl Cube {
    fn cube_around_axis(axis: DVec3) -> Self {
        let turn = DQuat::from_rotation_arc(DVec3::Z, axis.normalize_or(DVec3::Z));
        Self { is_ball: axis == DVec3::ZERO, columns: DVec3::AXES.map(|side| turn * side) }
    }

    /// Updates the cube around a blob's component for one of its transforms.
    fn apply_transform(&mut self, keyword: Next, step: &Transform) {
        let scale = step.transform_vector(DVec3::ONE);
        let even = scale.min_element() == scale.max_element();
        self.columns = match keyword {
            Next::Word("translate" | "rotate") if self.is_ball => return,
            Next::Word("scale") if self.is_ball && even => self.columns.map(|side| side * scale.x),
            _ => self.columns.map(|side| step.transform_vector(side)),
        };
        self.is_ball &= even && keyword == Next::Word("scale");
    }

    /// Half width of the cube's image along its widest axis.
    fn widest_half_width(&self) -> f64 {
        self.columns.iter().map(|side| side.abs()).sum::<DVec3>().max_element()
    }
}

/// Field of a blob's component along a stretch of a ray: s·(1 - (a·t² + b·t + c))².
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    pub from: f64,
    pub to: f64,
    strength: f64,
    squared_distance: [f64; 3],
}

pub(super) type Stretches = SmallVec<[Stretch; 16]>;

impl Component {
    fn to_component_space(&self, p: DVec3) -> DVec3 {
        self.place.as_ref().map_or(p, |m| m.inverse_transform_point(p))
    }

    /// Vector to `p` from the nearest point of the component's axis or centre, in radii.
    fn offset_in_radii(&self, p: DVec3) -> DVec3 {
        let from_base = self.to_component_space(p) - self.base;
        let along = from_base.dot(self.axis) / self.axis.length_squared().max(f64::MIN_POSITIVE);
        (from_base - self.axis * along.clamp(0.0, 1.0)) / self.radius
    }

    pub(super) fn field_at(&self, p: DVec3) -> f64 {
        let u = 1.0 - self.offset_in_radii(p).length_squared();
        if u > 0.0 { self.strength * u * u } else { 0.0 }
    }

    /// Gradient of the field of a blob's component: s·2u·(-2d/r²), where d is the vector from the axis; transformed by
    /// M⁻ᵀ as a normal.
    pub(super) fn field_gradient(&self, p: DVec3) -> DVec3 {
        let d = self.offset_in_radii(p);
        let u = 1.0 - d.length_squared();
        if u <= 0.0 {
            return DVec3::ZERO;
        }
        let local = d * (-4.0 * self.strength * u / self.radius);
        self.place.as_ref().map_or(local, |m| m.transform_normal(local))
    }

    /// Bounding box of a blob's component: that of the spheres at both ends.
    pub(super) fn bounds(&self) -> Aabb {
        self.blob_bounds_of_sphere(self.base, self.radius)
            .union(self.blob_bounds_of_sphere(self.base + self.axis, self.radius))
    }

    /// Bounding box in blob space of a sphere in component space.
    fn blob_bounds_of_sphere(&self, center: DVec3, radius: f64) -> Aabb {
        let ball = Sphere { center, radius };
        self.place.as_ref().map_or(ball.bounds(), |m| ball.bounds_under(m))
    }

    /// POV-Ray's box of a blob's component: cubes around the spheres, as wide as the longest side of the image of a
    /// cube; a cylinder without its ends is in a sphere too (quirk: `blob_component_boxes`).
    pub(super) fn pov_bounds(&self) -> Aabb {
        let cube = |center: DVec3, radius: f64| {
            let center = self.place.as_ref().map_or(center, |m| m.transform_point(center));
            Aabb::from_corners(center, center).grown(radius * self.widening)
        };
        let half = self.axis / 2.0;
        let around = (half.length_squared() + self.radius * self.radius).sqrt();
        let ends = cube(self.base, self.radius).union(cube(self.base + self.axis, self.radius));
        if self.axis == DVec3::ZERO { ends } else { ends.union(cube(self.base + half, around)) }
    }

    /// Appends the stretches of a ray within reach of the blob's component, with the squared distance from its axis or
    /// centre.
    pub(super) fn add_stretches(&self, ray: &Ray, out: &mut Stretches) {
        let local = self.place.as_ref().map_or(*ray, |m| m.inverse_transform_ray(ray));
        let (o, d) = ((local.origin - self.base) / self.radius, local.dir / self.radius);
        let mut push = |o: DVec3, d: DVec3, within: [f64; 2]| {
            let [a, b, c] = [d.length_squared(), 2.0 * o.dot(d), o.length_squared()];
            let Some((t1, t2)) = solve_quadratic(a, b, c - 1.0) else { return };
            let (from, to) = (t1.max(within[0]), t2.min(within[1]));
            if from < to {
                out.push(Stretch { from, to, strength: self.strength, squared_distance: [a, b, c] });
            }
        };
        if self.axis == DVec3::ZERO {
            return push(o, d, [f64::NEG_INFINITY, f64::INFINITY]);
        }
        let axis = self.axis / self.radius;
        let length = axis.length_squared();
        // Position along the axis, from 0 to 1 between the ends.
        let (start, speed) = (o.dot(axis) / length, d.dot(axis) / length);
        let (at_base, at_cap) = (-start / speed, (1.0 - start) / speed);
        let (before, behind) = match speed {
            0.0 if start < 0.0 => return push(o, d, [f64::NEG_INFINITY, f64::INFINITY]),
            0.0 if start > 1.0 => return push(o - axis, d, [f64::NEG_INFINITY, f64::INFINITY]),
            0.0 => return push(o - axis * start, d, [f64::NEG_INFINITY, f64::INFINITY]),
            s if s > 0.0 => ((o, at_base), (o - axis, at_cap)),
            _ => ((o - axis, at_cap), (o, at_base)),
        };
        push(before.0, d, [f64::NEG_INFINITY, before.1]);
        push(o - axis * start, d - axis * speed, [before.1, behind.1]);
        push(behind.0, d, [behind.1, f64::INFINITY]);
    }
}

impl Component {
    pub(super) fn new(span: Span, base: DVec3, axis: DVec3, radius: f64, strength: f64) -> Result<Self> {
        check_finite(span, &[base, axis], &[radius, strength])?;
        // A component of radius 0 adds nothing.
        let (radius, strength) = if radius == 0.0 { (1.0, 0.0) } else { (radius.abs(), strength) };
        Ok(Self { base, axis, radius, strength, place: None, texture_number_or_0: 0, widening: 1.0 })
    }

    /// Reads the transforms and the textures of a blob's component, up to the closing brace, which is not consumed. `kind`
    /// is the component's keyword, for messages.
    pub(super) fn read_modifiers(&mut self, kind: &str, r: &mut dyn Reader, paints: &mut dyn Paints) -> Result<()> {
        let mut cube = Cube::cube_around_axis(self.axis);
        loop {
            let next = r.peek_next()?;
            match next {
                Next::End => {
                    self.widening = cube.widest_half_width();
                    return Ok(());
                }
                next if next.is_transform() => {
                    if let Some(step) = r.transform()? {
                        cube.apply_transform(next, &step);
                        paints.transform(&mut self.texture_number_or_0, &step);
                        let place = self.place.as_deref().map_or(*step, |place| place.then(&step));
                        self.place = Some(Box::new(place));
                    }
                }
                next if paints.read_embedded_texture(&mut self.texture_number_or_0, next, r)? => {}
                _ => {
                    let words = ["texture", "pigment", "normal", "finish", "translate", "rotate", "scale", "matrix"];
                    return Err(r.unknown_word(kind, &words).into());
                }
            }
        }
    }
}

impl Stretch {
    /// Adds the field of a blob's component to a polynomial of t - middle, whose coefficients start with that of the
    /// fourth power.
    pub fn add_to_polynomial(&self, middle: f64, descending_coefficients: &mut [f64; 5]) {
        let [a, b, c] = self.squared_distance;
        // u = 1 - (a·t² + b·t + c), then s·u²
        let (u2, u1, u0) = (-a, -(2.0 * a * middle + b), 1.0 - ((a * middle + b) * middle + c));
        let s = self.strength;
        descending_coefficients[0] += s * u2 * u2;
        descending_coefficients[1] += s * 2.0 * u2 * u1;
        descending_coefficients[2] += s * (u1 * u1 + 2.0 * u2 * u0);
        descending_coefficients[3] += s * 2.0 * u1 * u0;
        descending_coefficients[4] += s * u0 * u0;
    }
}
