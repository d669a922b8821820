//! All tolerances of the program.

/// Minimum hit distance along a ray, in world units, for every shape (quirk: `blob_min_distance`).
pub const SURFACE: f64 = 1e-4;

/// Minimum hit distance for tori, superellipsoids, cubics, quartics and polynomials, in units of their own space
/// (quirk: `own_space_min_distance`).
pub const OWN_SURFACE: f64 = 1e-4;

/// Minimum hit distance for blobs, in world units, also in CSG and under any scale (quirk: `blob_min_distance`).
pub const BLOB_SURFACE: f64 = 1e-2;

/// Minimum distance of an occluder from both ends of a shadow ray, in world units (quirk: `shadow_min_distance`).
pub const SHADOW: f64 = 1e-3;

/// Maximum hit distance of a plane, in world units (quirk: `plane_max_distance`).
pub const PLANE_ENDS: f64 = 1e7;

/// Distance from a flat face or a round wall within which a point changes sides, in units of the shape's own space
/// (quirk: `inside_margins`): a plane contains points this far beyond its surface, closed cylinders and cones end this
/// much before theirs, open ones this much beyond their ends. Coincident surfaces are thus consistent.
pub const INSIDE: f64 = 1e-10;

/// A polynomial surface contains points where the polynomial is less than this (quirk: `polynomial_inside_margin`).
pub const POLYNOMIAL_INSIDE: f64 = 1e-4;

/// Maximum distance of a polygon's points from its plane, in units of its own space; POV-Ray draws 1e-11 and drops
/// 1e-9.
pub const FLAT: f64 = 1e-10;

/// Tolerance in every coordinate to which a polygon's point equals the first point of its sub-polygon, which ends
/// there.
pub const SAME_POINT: f64 = 1e-10;

/// Growth of an object's box, relative to its largest coordinate or 1, so that rounding in its kernel never puts a hit
/// outside.
pub const BOUNDS: f64 = 1e-9;

/// Rounding of a polynomial's value, as a multiple of the sum of its terms' absolute values: a smaller value counts as
/// zero.
pub const POLYNOMIAL: f64 = 1e-15;
