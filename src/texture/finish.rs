//! `finish`: reflection, highlights and other reactions of a surface to light (manual, "Finish").

use super::words::{FINISH, FINISH_ROWS, IRID, IRID_ROWS, REFLECTION, REFLECTION_ROWS, SUBSURFACE, SUBSURFACE_ROWS};
use crate::color::Rgb;
use crate::diagnostic::Result;
use crate::math::noise::{NoiseGenerator, Turbulence, turbulence};
use crate::math::{DVec3, fp};
use crate::value::words::{read_row, set};
use crate::value::{Next, Reader, ReaderExt, SharedDefault, StaticDefault};
use serde::Serialize;
use std::f64::consts::TAU;

/// Finish of a texture: how the surface reflects and emits light.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finish {
    /// Factor of `global_settings { ambient_light }` in the ambient light that the finish reflects.
    pub ambient: Rgb,
    /// Factor of the pigment's colour in the light that the finish emits.
    pub emission: Rgb,
    /// Fraction of incident light that the finish scatters diffusely back to the side that the light comes from.
    pub diffuse: f64,
    /// Fraction of light on the far side that the finish scatters through the surface.
    pub diffuse_back: f64,
    /// True for `diffuse albedo` of a finish: `diffuse` is the total of scattered light.
    pub diffuse_albedo: bool,
    /// Exponent of the cosine in the finish's diffuse light.
    pub brilliance: f64,
    /// Strength of the finish's Phong highlight, about the mirrored ray.
    pub phong: f64,
    /// True for `phong albedo` of a finish: `phong` is the total of light in the highlight.
    pub phong_albedo: bool,
    /// Exponent of the finish's Phong highlight.
    pub phong_size: f64,
    /// Strength of the finish's specular highlight, about the half-way vector.
    pub specular: f64,
    /// True for `specular albedo` of a finish: `specular` is the total of light in the highlight.
    pub specular_albedo: bool,
    /// Inverse of the exponent of the finish's specular highlight.
    pub roughness: f64,
    /// Share of the pigment's colour in the finish's highlights, 0 to 1.
    pub metallic: f64,
    /// Random darkening of the finish's diffuse light.
    pub crand: f64,
    /// Strength and colour of the finish's mirror reflection.
    pub reflection: SharedDefault<Reflection>,
    /// Thin-film interference of the finish; `None` without `irid`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub irid: Option<Box<Irid>>,
    /// True if the transmitted light is reduced by the reflected light.
    pub conserve_energy: bool,
    /// Parameters that few finishes set.
    #[serde(flatten)]
    pub uncommon: SharedDefault<Uncommon>,
}

/// Parameters of a finish that few scenes set.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Uncommon {
    /// Index of refraction in the finish of an old scene. In the topmost layer it has priority over that of the
    /// interior (quirk: `finish_ior_first`).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ior: Option<f64>,
    /// Caustics in the finish of an old scene, converted to the unit of `interior { caustics }`: 1/45 of the number in
    /// the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub caustics: Option<f64>,
    /// Factor of the transmitted light in the finish of an old scene, if the layer is the topmost.
    pub refraction: f64,
    /// Subsurface light transport of the finish; `None` without `subsurface`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub subsurface: Option<Subsurface>,
}

/// Subsurface light transport of a finish, from `subsurface` (manual, "Subsurface Light Transport").
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Subsurface {
    /// Mean free path of light inside the solid between two changes of direction, in millimetres.
    pub translucency: Rgb,
}

/// Thin-film interference of a finish, from `irid` (manual, "Iridescence").
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Irid {
    /// Strength of the thin film's interference colours.
    pub amount: f64,
    /// Thickness of the film, in the units of `irid_wavelength`.
    pub thickness: f64,
    /// Random variation of the thin film's thickness.
    pub turbulence: f64,
}

/// Mirror reflection of a finish.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Reflection {
    /// Reflectance of the mirror at perpendicular incidence.
    pub min: Rgb,
    /// Reflectance of the mirror at grazing incidence.
    pub max: Rgb,
    /// True if the mirror's reflectance follows Fresnel's equations, false for a power of the cosine.
    pub fresnel: bool,
    /// Exponent of the cosine in the mirror's reflectance.
    pub falloff: f64,
    /// Exponent that is applied to the light that the mirror reflects.
    pub exponent: f64,
    /// Share of the pigment's colour in the mirror reflection, 0 to 1.
    pub metallic: f64,
}

impl Default for Finish {
    fn default() -> Self {
        Self {
            ambient: Rgb::splat(0.1),
            emission: Rgb::ZERO,
            diffuse: 0.6,
            diffuse_back: 0.0,
            diffuse_albedo: false,
            brilliance: 1.0,
            phong: 0.0,
            phong_albedo: false,
            phong_size: 40.0,
            specular: 0.0,
            specular_albedo: false,
            roughness: 0.05,
            metallic: 0.0,
            crand: 0.0,
            reflection: SharedDefault::DEFAULT,
            irid: None,
            conserve_energy: false,
            uncommon: SharedDefault::DEFAULT,
        }
    }
}

impl StaticDefault for Uncommon {
    fn static_default() -> &'static Self {
        static NOTHING: Uncommon = Uncommon { ior: None, caustics: None, refraction: 1.0, subsurface: None };
        &NOTHING
    }
}

impl Default for Reflection {
    fn default() -> Self {
        Self::NONE
    }
}

impl Finish {
    /// Reads the items of a `finish` block, on top of `base` (the default finish).
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read(r: &mut dyn Reader, base: &Finish) -> Result<Self> {
        let mut f = base.with_albedo_folded_in();
        loop {
            match r.peek_next()? {
                Next::End => return Ok(f),
                Next::Thing(_) => match r.take_declared::<Finish>()? {
                    Some(declared) => f = declared.with_albedo_folded_in(),
                    None => return Err(r.unknown_word_in(&FINISH)),
                },
                Next::Block("reflection") => {
                    r.take_token()?;
                    f.reflection = Reflection::read(r, &f.reflection)?.into();
                    r.leave_block()?;
                }
                Next::Block("irid") => {
                    r.take_token()?;
                    f.irid = Some(Box::new(Irid::read(r)?));
                    r.leave_block()?;
                }
                Next::Block("subsurface") => {
                    r.take_token()?;
                    f.uncommon.subsurface = Some(Subsurface::read(r)?);
                    r.leave_block()?;
                }
                next if f.read_word(next, r)? => {}
                _ => return Err(r.unknown_word_in(&FINISH)),
            }
        }
    }

    /// Returns the finish without `albedo`: each lobe is divided by its integral over the hemisphere instead. A finish
    /// on top of another begins with these numbers (quirk: `albedo_stays`).
    pub fn with_albedo_folded_in(&self) -> Self {
        let scaled = |amount: f64, albedo: bool, factor: f64| if albedo { amount * factor } else { amount };
        let diffuse = |amount| scaled(amount, self.diffuse_albedo, (self.brilliance + 1.0) / 2.0);
        let n = 1.0 / self.roughness;
        Self {
            diffuse: diffuse(self.diffuse),
            diffuse_back: diffuse(self.diffuse_back),
            phong: scaled(self.phong, self.phong_albedo, (self.phong_size + 1.0) / 2.0),
            specular: scaled(self.specular, self.specular_albedo, (n + 2.0) / (4.0 * (2.0 - fp::exp2(-n / 2.0)))),
            diffuse_albedo: false,
            phong_albedo: false,
            specular_albedo: false,
            ..self.clone()
        }
    }

    /// Reads one of the finish's words that need no braces, if it comes next; before version 3.1, textures could
    /// contain them too.
    pub(super) fn read_word(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        match next {
            Next::Word(word) if FINISH.ignores(word) => {
                r.take_token()?;
                r.float().map(|_| true)
            }
            _ => read_row(FINISH_ROWS, self, next, r),
        }
    }

    /// Reads the word `diffuse [albedo] front [back]` of a finish. Once given, `albedo` stays, here and for the
    /// highlights (quirk: `albedo_stays`).
    pub(super) fn read_diffuse(&mut self, r: &mut dyn Reader) -> Result<()> {
        self.diffuse_albedo |= r.accept("albedo")?;
        self.diffuse = r.float()?;
        set(&mut self.diffuse_back, r.optional_float().map(|x| x.unwrap_or(0.0)))
    }

    /// Reads `reflection colour`, without braces; it switches `fresnel` off (quirk: `reflection_again`).
    pub(super) fn read_plain_reflection(&mut self, r: &mut dyn Reader) -> Result<()> {
        let color = r.color()?.rgb;
        let reflection = &mut *self.reflection;
        (reflection.min, reflection.max, reflection.fresnel) = (color, color, false);
        Ok(())
    }
}

impl Irid {
    /// Reads the block `irid { amount … }` of a finish.
    fn read(r: &mut dyn Reader) -> Result<Self> {
        let mut out = Self { amount: r.float()?, thickness: 0.0, turbulence: 0.0 };
        loop {
            match r.peek_next()? {
                Next::End => return Ok(out),
                next if read_row(IRID_ROWS, &mut out, next, r)? => {}
                _ => return Err(r.unknown_word_in(&IRID)),
            }
        }
    }

    /// Returns the interference factor of the thin film for light at these cosines of incidence and view: 1 +
    /// a·cos(2π·path/λ) (quirk: `irid_formula`).
    pub fn interference_factor(&self, p: DVec3, cosine_sum: f64, wavelength: Rgb, noise: NoiseGenerator) -> Rgb {
        let mut thickness = self.thickness;
        if self.turbulence != 0.0 {
            let series = Turbulence::new(2.0, 0.5, 5.0);
            thickness *= 1.0 + self.turbulence * (2.0 * turbulence(p, series, noise) - 1.0);
        }
        wavelength.map(|lambda| 1.0 + self.amount * fp::cos(TAU * thickness * cosine_sum / lambda))
    }
}

impl Subsurface {
    /// Reads the block `subsurface { translucency … }` of a finish.
    fn read(r: &mut dyn Reader) -> Result<Self> {
        let mut out = Self::default();
        loop {
            match r.peek_next()? {
                Next::End => return Ok(out),
                next if read_row(SUBSURFACE_ROWS, &mut out, next, r)? => {}
                _ => return Err(r.unknown_word_in(&SUBSURFACE)),
            }
        }
    }
}

impl StaticDefault for Reflection {
    fn static_default() -> &'static Self {
        &Self::NONE
    }
}

impl Reflection {
    /// Reflection of a finish that mirrors nothing.
    pub const NONE: Self =
        Self { min: Rgb::ZERO, max: Rgb::ZERO, fresnel: false, falloff: 1.0, exponent: 1.0, metallic: 0.0 };

    /// Reads the block `reflection { [min,] max … }`. Fresnel, metallic, falloff and exponent of an earlier reflection
    /// in the same finish stay (quirk: `reflection_again`).
    fn read(r: &mut dyn Reader, before: &Self) -> Result<Self> {
        let first = r.color()?.rgb;
        let mut out = Self { min: Rgb::ZERO, max: first, ..before.clone() };
        let mut said_fresnel = false;
        let two = r.may_be_at_color()?;
        if two {
            (out.min, out.max) = (first, r.color()?.rgb);
        }
        loop {
            match r.peek_next()? {
                Next::End => break,
                next if read_row(REFLECTION_ROWS, &mut out, next, r)? => said_fresnel |= next == Next::Word("fresnel"),
                _ => return Err(r.unknown_word_in(&REFLECTION)),
            }
        }
        // One colour is the same at every angle; with `fresnel` in the same block it begins at 0 instead.
        if !(two || said_fresnel && out.fresnel) {
            out.min = out.max;
        }
        Ok(out)
    }

    /// True if the finish has no mirror reflection. (Negative amounts are not traced.)
    pub fn is_without_reflection(&self) -> bool {
        self.min.max(self.max).cmple(Rgb::ZERO).all()
    }
}
