//! M and M⁻¹ side by side (lecture, "Ray – transformed object intersection").

use super::{Aabb, DMat3, DVec3, Ray, fp};
use glam::DAffine3;
use serde::Serialize;

/// An affine transform and its inverse. Both are composed step by step, so that M·M⁻¹ = 1 to rounding.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Transform {
    /// Matrix M from the object's space to the space around it.
    pub m: DAffine3,
    /// Matrix M⁻¹ from the surrounding space to the object's space.
    pub inv: DAffine3,
}

/// Error of a transform whose matrix has no inverse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Singular;

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Transform {
    /// The transform that leaves every point unchanged.
    pub const IDENTITY: Transform = Transform { m: DAffine3::IDENTITY, inv: DAffine3::IDENTITY };

    /// Returns the translation by `v`.
    pub fn translate(v: DVec3) -> Self {
        Self { m: DAffine3::from_translation(v), inv: DAffine3::from_translation(-v) }
    }

    /// Returns the scaling by these factors along the axes.
    ///
    /// # Errors
    /// If a factor is zero, or too small to be inverted.
    pub fn scale(v: DVec3) -> Result<Self, Singular> {
        if v.cmpeq(DVec3::ZERO).any() || !v.is_finite() || !v.recip().is_finite() {
            return Err(Singular);
        }
        Ok(Self { m: DAffine3::from_scale(v), inv: DAffine3::from_scale(v.recip()) })
    }

    /// Rotation by `degrees.x` about x, then `degrees.y` about y, then `degrees.z` about z. In POV-Ray's left-handed
    /// system a positive angle turns y towards z, z towards x, x towards y (manual, "rotate"), which is the same matrix
    /// as the right-handed one.
    pub fn rotate(degrees: DVec3) -> Self {
        let r = DVec3::new(degrees.x.to_radians(), degrees.y.to_radians(), degrees.z.to_radians());
        let about = |axis: usize| {
            let (s, c) = fp::sin_cos(r[axis]);
            match axis {
                0 => DMat3::from_cols(DVec3::X, DVec3::new(0.0, c, s), DVec3::new(0.0, -s, c)),
                1 => DMat3::from_cols(DVec3::new(c, 0.0, -s), DVec3::Y, DVec3::new(s, 0.0, c)),
                _ => DMat3::from_cols(DVec3::new(c, s, 0.0), DVec3::new(-s, c, 0.0), DVec3::Z),
            }
        };
        // Rz·Ry·Rx; most rotations are about one axis.
        let turns = [2, 1, 0].into_iter().filter(|axis| r[*axis] != 0.0).map(about);
        let m = turns.reduce(|m, turn| m * turn).unwrap_or(DMat3::IDENTITY);
        Self { m: DAffine3::from_mat3(m), inv: DAffine3::from_mat3(m.transpose()) }
    }

    /// Rotation by `degrees` about `axis`, which need not have length 1.
    pub fn rotate_about(axis: DVec3, degrees: f64) -> Self {
        // Rodrigues' formula: column i is eᵢ·cos + (a × eᵢ)·sin + a·(a·eᵢ)·(1 - cos).
        let a = axis.normalize_or(DVec3::Y);
        let (sin, cos) = fp::sin_cos(degrees.to_radians());
        let column = |i: usize| DVec3::AXES[i] * cos + a.cross(DVec3::AXES[i]) * sin + a * (a[i] * (1.0 - cos));
        let m = DMat3::from_cols(column(0), column(1), column(2));
        Self { m: DAffine3::from_mat3(m), inv: DAffine3::from_mat3(m.transpose()) }
    }

    /// Returns the transform with these images of the three axes and this translation: `matrix <v00 … v32>` lists them
    /// in this order (manual, "matrix": row vectors).
    ///
    /// # Errors
    /// If the matrix can't be inverted.
    pub fn from_rows(rows: [DVec3; 4]) -> Result<Self, Singular> {
        let m = DAffine3::from_cols(rows[0], rows[1], rows[2], rows[3]);
        Self::from_affine(m)
    }

    /// Creates a transform from its matrix.
    ///
    /// # Errors
    /// If the matrix can't be inverted.
    pub fn from_affine(m: DAffine3) -> Result<Self, Singular> {
        let inv = m.inverse();
        let fine = m.is_finite() && inv.is_finite() && m.matrix3.determinant() != 0.0;
        if fine { Ok(Self { m, inv }) } else { Err(Singular) }
    }

    /// Composes two transforms to `next.m * self.m`: first `self`, then `next`.
    pub fn then(&self, next: &Transform) -> Self {
        if next.m.matrix3 == DMat3::IDENTITY {
            // Translations alone are common, and far cheaper.
            let (m, inv) = (&self.m, &self.inv);
            let back = inv.transform_vector3(next.inv.translation) + inv.translation;
            return Self {
                m: DAffine3 { translation: m.translation + next.m.translation, ..*m },
                inv: DAffine3 { translation: back, ..*inv },
            };
        }
        Self { m: next.m * self.m, inv: self.inv * next.inv }
    }

    /// Returns the inverse transform.
    pub fn inverse(&self) -> Self {
        Self { m: self.inv, inv: self.m }
    }

    /// True if the transform is exactly the identity.
    pub fn is_identity(&self) -> bool {
        self.m == DAffine3::IDENTITY
    }

    /// Transforms a point: M·p (w = 1).
    pub fn transform_point(&self, p: DVec3) -> DVec3 {
        self.m.transform_point3(p)
    }

    /// Transforms a vector: M·v (w = 0).
    pub fn transform_vector(&self, v: DVec3) -> DVec3 {
        self.m.transform_vector3(v)
    }

    /// Transforms a normal: M⁻ᵀ·n, which stays perpendicular to the surface; not normalised.
    pub fn transform_normal(&self, n: DVec3) -> DVec3 {
        // (M⁻¹)ᵀ·n without building the transpose: the dot products with the columns of M⁻¹.
        let inv = &self.inv.matrix3;
        DVec3::new(inv.x_axis.dot(n), inv.y_axis.dot(n), inv.z_axis.dot(n))
    }

    /// Transforms a normal by Mᵀ·n, the inverse of [`Self::transform_normal`]; not normalised.
    pub fn inverse_transform_normal(&self, n: DVec3) -> DVec3 {
        let m = &self.m.matrix3;
        DVec3::new(m.x_axis.dot(n), m.y_axis.dot(n), m.z_axis.dot(n))
    }

    /// Transforms a point by the inverse: M⁻¹·p (w = 1).
    pub fn inverse_transform_point(&self, p: DVec3) -> DVec3 {
        self.inv.transform_point3(p)
    }

    /// Transforms a vector by the inverse: M⁻¹·v (w = 0).
    pub fn inverse_transform_vector(&self, v: DVec3) -> DVec3 {
        self.inv.transform_vector3(v)
    }

    /// Transforms a ray by the inverse, M⁻¹·ray: the origin as a point, the direction as a vector, not renormalised.
    pub fn inverse_transform_ray(&self, ray: &Ray) -> Ray {
        Ray { origin: self.inverse_transform_point(ray.origin), dir: self.inverse_transform_vector(ray.dir) }
    }

    /// Returns the smallest axis-aligned box around the transformed box, M·box; infinite where the box is.
    pub fn transform_aabb(&self, b: &Aabb) -> Aabb {
        if b.is_empty() {
            return Aabb::EMPTY;
        }
        let mut out = Aabb { min: self.m.translation, max: self.m.translation };
        let cols = [self.m.matrix3.x_axis, self.m.matrix3.y_axis, self.m.matrix3.z_axis];
        for (axis, col) in cols.iter().enumerate() {
            for row in 0..3 {
                // 0·∞ counts as 0: an axis that does not contribute to this row adds nothing.
                let product = |x: f64| if col[row] == 0.0 { 0.0 } else { col[row] * x };
                let (a, b) = (product(b.min[axis]), product(b.max[axis]));
                out.min[row] += a.min(b);
                out.max[row] += a.max(b);
            }
        }
        out
    }
}
