//! Functions of isosurfaces and parametric surfaces, and the container that bounds them.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::{Function, Interval, Replacements, ResultType, Slope};
use crate::math::{Aabb, DVec3, Range, Ray};
use crate::shape::{Cuboid, Kernel, Sphere};
use crate::value::{Next, Readable, Reader, downcast};
use serde::{Serialize, Serializer};
use std::sync::Arc;

/// Function with one value that defines an isosurface or a parametric surface.
#[derive(Clone, Debug)]
pub struct Formula(Arc<Function>);

impl PartialEq for Formula {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || self.0.is_alike(&other.0)
    }
}

impl Serialize for Formula {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.parameters.iter())
    }
}

impl Formula {
    /// Reads a function of three parameters. `expected_parameters` lists them for the error messages only, as in `x, y
    /// and z`.
    ///
    /// # Errors
    /// A diagnostic for anything but such a function.
    pub fn read(r: &mut dyn Reader, expected_parameters: &str) -> Result<Self> {
        if !matches!(r.peek_next()?, Next::Function | Next::Thing("function")) {
            return Err(r.unexpected(&format!("`function {{ … }}` of {expected_parameters}")).into());
        }
        let (thing, at) = r.take_thing()?;
        let Some(function) = downcast::<Function>(&thing) else {
            return Diagnostic::err(
                codes::WRONG_TYPE,
                at,
                format!("expected `function {{ … }}` of {expected_parameters}"),
            );
        };
        if function.result_type() != ResultType::Number {
            return Diagnostic::new(codes::WRONG_TYPE, at, "this function does not give a number")
                .help("declare it, and take a part of what it gives: `function { F(x, y, z).gray }`")
                .into();
        }
        // The default parameters are x, y and z; those of a surface are called u and v.
        match function.arity() {
            3 => Ok(Self(function)),
            n => {
                let message =
                    format!("this function shall have the parameters {expected_parameters}; it takes {n} of its own");
                Diagnostic::new(codes::WRONG_COUNT, at, message)
                    .help("leave the parameters out: `function { … }`")
                    .into()
            }
        }
    }

    /// Wraps a function of three numbers.
    pub fn new(function: Function) -> Self {
        Self(Arc::new(function))
    }

    /// Value of the formula's function at a point.
    pub fn value_at(&self, p: DVec3) -> f64 {
        self.0.call_component(0, &[p.x, p.y, p.z])
    }

    /// Bounds of the value and gradient of the formula's function in a box; `scratch` is scratch memory.
    pub fn value_and_slope_in(&self, b: &Aabb, scratch: &mut Vec<Slope>) -> Slope {
        self.0.slope_over_box(&sides(b), scratch)
    }

    /// True if pruning in some box can change the formula's function.
    pub fn can_be_pruned(&self) -> bool {
        self.0.can_be_pruned()
    }

    /// Finds the operations of the formula's function that are decided in a box. `scratch` is the scratch memory of
    /// [`Self::value_and_slope_in`] after its call with the same box.
    pub fn find_replacements(&self, b: &Aabb, scratch: &[Slope]) -> Replacements {
        self.0.find_replacements(&sides(b), scratch)
    }

    /// Returns the formula without the operations that the replacements make superfluous: in their box it gives the
    /// same bits.
    pub fn pruned(&self, replacements: &Replacements) -> Option<Self> {
        self.0.pruned(replacements).map(Self::new)
    }

    /// Approximate cost of an evaluation, in instructions of compiled functions.
    pub fn cost(&self) -> usize {
        self.0.cost()
    }
}

/// Intervals of the coordinates in a box.
fn sides(b: &Aabb) -> [Interval; 3] {
    [0, 1, 2].map(|axis| Interval { lo: b.min[axis], hi: b.max[axis] })
}

/// Container of an isosurface or parametric surface: the solid that bounds it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Container {
    /// Container that is a `box`, whose edges are parallel to the axes.
    Box(Cuboid),
    /// Container that is a `sphere` with any centre and radius.
    Sphere(Sphere),
}

impl Default for Container {
    fn default() -> Self {
        Self::Box(Cuboid::new(DVec3::NEG_ONE, DVec3::ONE))
    }
}

impl Container {
    /// Reads a container, `{ box { … } }` or `{ sphere { … } }`, from the opening brace on.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read(r: &mut dyn Reader) -> Result<Self> {
        r.take_token()?;
        let container = match r.peek_next()? {
            Next::Block("box") => {
                r.take_token()?;
                Self::Box(Cuboid::read_finite(r)?)
            }
            Next::Block("sphere") => {
                r.take_token()?;
                Self::Sphere(Sphere::read(r)?)
            }
            _ => return Err(r.unexpected("`sphere { … }` or `box { … }`").into()),
        };
        r.leave_block()?;
        r.leave_block()?;
        Ok(container)
    }

    /// Bounding box of a surface's container.
    pub fn bounds(&self) -> Aabb {
        match self {
            Self::Box(b) => b.bounds(),
            Self::Sphere(s) => s.bounds(),
        }
    }

    /// True if the point is inside the surface's container.
    pub fn contains(&self, p: DVec3) -> bool {
        match self {
            Self::Box(b) => b.bounds().contains(p),
            Self::Sphere(s) => p.distance_squared(s.center) <= s.radius * s.radius,
        }
    }

    /// Interval of a line inside the surface's container; `None` for a line that misses it.
    pub fn interval_inside(&self, ray: &Ray) -> Option<(f64, f64)> {
        match self {
            Self::Box(b) => b.bounds().slabs(ray, Range::ALL).filter(|(near, far)| near.is_finite() && far.is_finite()),
            Self::Sphere(s) => {
                let d2 = ray.dir.length_squared();
                let middle = (s.center - ray.origin).dot(ray.dir) / d2;
                let half = (s.radius * s.radius - ray.at(middle).distance_squared(s.center)) / d2;
                (half >= 0.0).then(|| (middle - half.sqrt(), middle + half.sqrt()))
            }
        }
    }

    /// Outward normal at a point of the container's surface.
    pub fn normal(&self, p: DVec3) -> DVec3 {
        match self {
            Self::Box(b) => {
                // Select the face that is nearest in units of the box's size.
                let b = b.bounds();
                let place = (p - b.center()) / b.size();
                let axis =
                    [0, 1, 2].into_iter().max_by(|&i, &j| place[i].abs().total_cmp(&place[j].abs())).unwrap_or(1);
                DVec3::AXES[axis] * place[axis].signum()
            }
            Self::Sphere(s) => p - s.center,
        }
    }
}

/// Reads a number above 0; any other number is reported and selects the default, as in POV-Ray.
pub fn read_default_unless_positive(r: &mut dyn Reader, word: &str, default: f64) -> Result<f64> {
    let (at, x) = (r.span(), r.float()?);
    if x > 0.0 {
        return Ok(x);
    }
    let message = format!("`{word}` must be more than 0, found {x}: it is {default}, as without it");
    r.report(Diagnostic::new(codes::NOT_POSITIVE, at, message));
    Ok(default)
}
