//! Every tolerance of the program, in one table.

/// A ray ignores hits nearer than this, in world units (measured on POV-Ray 3.7: absolute, for every shape).
pub const SURFACE: f64 = 1e-4;

/// The same for tori, superellipsoids, cubics, quartics and polynomials, but in units of their own space (measured on POV-Ray 3.7).
pub const OWN_SURFACE: f64 = 1e-4;

/// The same for blobs, in world units (measured on POV-Ray 3.7: absolute, also in CSG and under any scale).
pub const BLOB_SURFACE: f64 = 1e-2;

/// A shadow ray ignores hits nearer than this to either of its ends, in world units (measured on POV-Ray 3.7).
pub const SHADOW: f64 = 1e-3;

/// No ray meets a plane farther away than this, in world units (measured on POV-Ray 3.7, which draws other shapes there or not, as their
/// transforms have it).
pub const PLANE_ENDS: f64 = 1e7;

/// How far from a flat face or a round wall a point may be and still change sides, in units of the shape's own space.
/// Seen in what POV-Ray's `inside()` answers: a plane reaches this much beyond its surface, closed cylinders and cones
/// end this much before theirs, open ones this much behind their ends. So surfaces that lie in one another come out alike.
pub const INSIDE: f64 = 1e-10;

/// A polynomial surface holds points where the polynomial is less than this; seen in what POV-Ray's `inside()` answers.
pub const POLYNOMIAL_INSIDE: f64 = 1e-4;

/// A polygon's points may be this far from its plane (units of its own space); POV-Ray draws 1e-11 and drops 1e-9.
pub const FLAT: f64 = 1e-10;

/// Sub-polygons end where a point comes back to the first one: this near, in every coordinate.
pub const SAME_POINT: f64 = 1e-10;

/// Growth of an object's box, relative to its largest coordinate or 1, so that rounding in its kernel never puts a hit outside.
pub const BOUNDS: f64 = 1e-9;

/// Rounding in a polynomial's value, as a multiple of the sum of its terms' sizes: below it, a value counts as zero.
pub const POLYNOMIAL: f64 = 1e-15;
