//! `aperture`, `blur_samples`, `focal_point` …: depth of field (manual, "Focal Blur").

use super::Bokeh;
use super::povray::PovrayCamera;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{DVec2, DVec3, Ray, fp, statistics};
use crate::value::Reader;
use crate::value::ValueKind::{Float, Vector};
use crate::value::words::{Row, set, word};
use serde::Serialize;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use std::sync::Arc;

/// Settings of a camera's focal blur before lowering, adjusted to their valid ranges; a setting that the scene does not
/// give has its default.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FocalBlur {
    /// Four times the radius of the lens (quirk: `aperture_is_four_radii`); 0 for no blur.
    pub aperture: f64,
    /// Point whose distance from the camera's `location` is that of the plane in focus (quirk: `focal_distance`).
    pub focal_point: DVec3,
    /// Distance of the plane in focus; `None` if the final `location` decides.
    pub distance: Option<f64>,
    /// Minimum and maximum number of rays a pixel for focal blur. A minimum of 0 requests the default minimum, a maximum
    /// of 0 no blur.
    pub samples: [u32; 2],
    /// Confidence, from 0 to 1, that a pixel's variance is below `variance` when no more rays are cast.
    pub confidence: f64,
    /// Acceptable variance of the mean of a pixel's rays after the maximum number of rays; after fewer rays, a
    /// proportionally smaller variance is required. 0 to cast all rays.
    pub variance: f64,
}

/// Default variance of focal blur (quirk: `focal_blur_defaults`; the manual says 1/128).
const USUAL_VARIANCE: f64 = 1e-4;
/// Default minimum number of rays a pixel with focal blur (quirk: `focal_blur_defaults`).
const USUAL_LEAST: u32 = 7;

impl Default for FocalBlur {
    fn default() -> Self {
        Self {
            aperture: 0.0,
            focal_point: DVec3::ZERO,
            distance: None,
            samples: [0, 0],
            confidence: 0.9,
            variance: USUAL_VARIANCE,
        }
    }
}

/// Words of focal blur in a camera block, and how each is read.
pub(super) const BLUR_ROWS: &[Row<PovrayCamera>] = &[
    word(
        "aperture",
        Float,
        "0",
        "with `blur_samples`, how much is blurred that is not in focus: four times the lens's radius",
    )
    .sets(|s, r| set(&mut s.blur.aperture, r.float())),
    word(
        "focal_point",
        Vector,
        "<0, 0, 0>",
        "what is in focus, and all that lies ahead at the distance of this point from `location`",
    )
    .sets(|s, r| set(&mut s.blur.focal_point, r.vector())),
    word("blur_samples", Float, "0", "how many rays a pixel, or two numbers: at least and at most; 0 blurs nothing")
        .sets(|s, r| s.blur.read_sample_range(r)),
    word("confidence", Float, "0.9", "how sure it has to be that a pixel is as exact as `variance` says, from 0 to 1")
        .sets(|s, r| set(&mut s.blur.confidence, r.float().map(|c| c.clamp(0.0, 0.999_999)))),
    word(
        "variance",
        Float,
        "1/10000",
        "how exact a pixel has to be: the variance of its mean, less where few rays show it; 0 casts all rays",
    )
    .sets(|s, r| set(&mut s.blur.variance, r.float().map(f64::abs))),
];

/// Maximum number of rays a pixel that a scene may ask for in focal blur.
const MOST: f64 = 1e6;

impl FocalBlur {
    fn read_sample_range(&mut self, r: &mut dyn Reader) -> Result<()> {
        let at = r.span();
        let first = r.float()?;
        let second = r.optional_float()?;
        let (least, most) = second.map_or((0.0, first), |second| (first.min(second), first.max(second)));
        if !(0.0..=MOST).contains(&least) || !(0.0..=MOST).contains(&most) {
            let message = format!(
                "`blur_samples` takes 0 to {MOST} rays a pixel, found {}",
                if least < 0.0 { least } else { most }
            );
            return Err(Diagnostic::new(codes::BAD_CAMERA, at, message).help("20 is a draft, 200 is smooth").into());
        }
        self.samples = [least as u32, most as u32];
        Ok(())
    }

    /// Lowers the settings of focal blur; `None` without blur. `location` is the camera's, before its transforms
    /// (quirk: `focal_distance`).
    pub(super) fn lower_lens(&self, location: DVec3) -> Option<Lens> {
        let distance = self.distance.unwrap_or_else(|| self.focal_point.distance(location));
        if self.aperture == 0.0 || self.samples[1] == 0 || distance == 0.0 || !distance.is_finite() {
            return None;
        }
        let [least, most] = self.samples;
        let least = if least == 0 { USUAL_LEAST } else { least };
        Some(Lens {
            radius: self.aperture.abs() / 4.0,
            distance,
            samples: [least.min(most), most],
            variance: self.variance,
            quantile: statistics::normal_quantile(1.0 - self.confidence),
            bokeh: None,
        })
    }
}

/// Lowered lens of focal blur.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Lens {
    /// Radius of the lens in world units.
    pub radius: f64,
    /// Distance of the plane in focus from the lens, in world units.
    pub distance: f64,
    /// Minimum and maximum number of rays a pixel through the lens.
    pub samples: [u32; 2],
    /// Acceptable variance of the mean of a pixel's rays; 0 to cast all rays.
    pub variance: f64,
    /// Quantile of the normal distribution for 1 minus the confidence that focal blur requires.
    pub quantile: f64,
    /// Transmittance of a square lens, whose sides are twice the radius; `None` for a disc.
    #[serde(skip)]
    pub bokeh: Option<Arc<Bokeh>>,
}

impl Lens {
    /// True if `ray_count` rays are enough, one channel of which has this sum of squares about its mean (quirk:
    /// `focal_blur_convergence`): the variance of the mean must be as small a part of the acceptable variance as the
    /// rays are of the maximum. The confidence is √(χ²/n).
    pub fn has_converged(&self, ray_count: u32, sum_of_squared_deviations: f64) -> bool {
        let n = f64::from(ray_count);
        let sure = (statistics::chi_square_quantile(n, self.quantile) / n).sqrt();
        self.variance > 0.0
            && sum_of_squared_deviations * f64::from(self.samples[1]) <= self.variance * sure * n * n * (n + 1.0)
    }

    /// Returns the ray through a point of the lens that meets `ray` in the plane in focus; `unit_square_sample` in [0, 1)²
    /// selects the point, `axes` are the camera's unit vectors right, up and ahead.
    pub fn ray_through_lens(&self, ray: &Ray, unit_square_sample: DVec2, axes: &[DVec3; 3]) -> Ray {
        let [right, up, ahead] = *axes;
        let focus = ray.at(self.distance / ray.dir.dot(ahead));
        let at = self.bokeh.as_ref().map_or_else(
            || unit_square_to_disc(unit_square_sample),
            |bokeh| bokeh.sample_signed_lens_square(unit_square_sample),
        ) * self.radius;
        let origin = ray.origin + right * at.x + up * at.y;
        Ray::new(origin, (focus - origin).normalize_or(ray.dir))
    }
}

/// Maps the unit square to the unit disc; preserves areas and neighbours (Shirley and Chiu 1997).
fn unit_square_to_disc(square: DVec2) -> DVec2 {
    let p = square * 2.0 - 1.0;
    if p == DVec2::ZERO {
        return p;
    }
    let (r, angle) =
        if p.x.abs() > p.y.abs() { (p.x, FRAC_PI_4 * (p.y / p.x)) } else { (p.y, FRAC_PI_2 - FRAC_PI_4 * (p.x / p.y)) };
    let (sin, cos) = fp::sin_cos(angle);
    DVec2::new(cos, sin) * r
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_meet_in_focus_and_fill_the_lens() {
        let lens = Lens { radius: 0.5, distance: 4.0, samples: [1, 1], variance: 0.0, quantile: 0.0, bokeh: None };
        let ray = Ray::new(DVec3::ZERO, DVec3::new(0.6, 0.0, 0.8));
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let mut second_moment = 0.0;
        for i in 0..10_000 {
            let place = DVec2::new(f64::from(i % 100) + 0.5, f64::from(i / 100) + 0.5) / 100.0;
            let bent = lens.ray_through_lens(&ray, place, &axes);
            let t = (4.0 - bent.origin.z) / bent.dir.z;
            assert!(bent.at(t).distance(DVec3::new(3.0, 0.0, 4.0)) < 1e-12);
            second_moment += bent.origin.length_squared() / 10_000.0;
        }
        // ∫r²·2r/R² = R²/2
        assert!((second_moment - 0.125).abs() < 1e-4, "{second_moment}");
    }

    #[test]
    fn stops_where_pov_ray_does() {
        // POV-Ray with `confidence 0.975 variance 1/255`: one white ray is enough of 23, but not of 19; half of them
        // not of 35.
        let blur = FocalBlur {
            aperture: 1.0,
            confidence: 0.975,
            variance: 1.0 / 255.0,
            samples: [0, 37],
            ..FocalBlur::default()
        };
        let lens = blur.lower_lens(DVec3::NEG_Z).unwrap();
        let squares = |n: f64, white: f64| white * (n - white) / n;
        assert!(lens.has_converged(23, squares(23.0, 1.0)) && !lens.has_converged(19, squares(19.0, 1.0)));
        assert!(!lens.has_converged(35, squares(35.0, 17.0)) && lens.has_converged(7, 0.0));
        // Half of the rays are of one gray, half of another, for which POV-Ray's pixels have this mean number of rays
        // (tested at intervals, so durer casts a few more).
        for (most, confidence, variance, difference, seen) in [
            (1000, 0.9, 0.01 / 64.0, 0.2, 258.5),
            (1000, 0.99, 0.01 / 64.0, 0.2, 266.2),
            (1000, 0.9, 0.01 / 16.0, 0.2, 134.9),
            (200, 0.9, 1e-4, 0.1, 75.2),
            (200, 0.9, 1e-4, 0.2, 142.9),
            (200, 0.1, 0.01 / 16.0, 0.2, 54.7),
        ] {
            let blur = FocalBlur { confidence, variance, samples: [0, most], ..blur };
            let lens = blur.lower_lens(DVec3::NEG_Z).unwrap();
            let needed =
                (1..=most).find(|n| lens.has_converged(*n, f64::from(*n) * difference * difference / 4.0)).unwrap();
            assert!((f64::from(needed) - seen).abs() < 0.05 * seen, "{most} {confidence}: {needed}, not {seen}");
        }
        // With 0 even a uniform pixel takes all rays (2000 rays a pixel: 0.78 s, and 0.01 s with 1/100000).
        assert!(!Lens { variance: 0.0, ..lens }.has_converged(7, 0.0));
    }
}
