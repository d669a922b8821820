//! `normal`: bumps that only light sees (manual, "Normal").

use super::Texture;
use super::blend::{self, Blend, Entry, Map};
use super::pigment::read_uv_mapping;
use super::words::NORMAL;
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::pattern::{CellPattern, FieldPattern, ImagePattern, Kind, Pattern, TextureContext};
use crate::value::{Next, Reader, ReaderExt};
use serde::Serialize;
use std::f64::consts::SQRT_2;
use std::sync::Arc;

/// A height and a slope, as a `slope_map` has them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Slope {
    /// How high the surface seems to be.
    pub height: f64,
    /// How fast it rises.
    pub slope: f64,
}

impl Slope {
    /// The curve to another height, by both slopes (cubic Hermite spline).
    fn curve_to(&self, other: &Slope, t: f64) -> f64 {
        let (t2, t3) = (t * t, t * t * t);
        (2.0 * t3 - 3.0 * t2 + 1.0) * self.height
            + (t3 - 2.0 * t2 + t) * self.slope
            + (3.0 * t2 - 2.0 * t3) * other.height
            + (t3 - t2) * other.slope
    }
}

/// The corners of a regular tetrahedron, of length 1.
const TETRAHEDRON: [DVec3; 4] = [
    DVec3::new(2.0 * SQRT_2 / 3.0, -1.0 / 3.0, 0.0),
    DVec3::new(0.0, 1.0, 0.0),
    DVec3::new(-SQRT_2 / 3.0, -1.0 / 3.0, 0.816_496_580_927_726),
    DVec3::new(-SQRT_2 / 3.0, -1.0 / 3.0, -0.816_496_580_927_726),
];

/// Heights and slopes at numbers.
pub type SlopeMap = Map<Slope>;

/// What makes the bumps.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Relief {
    /// The pattern's number is the height.
    #[default]
    Own,
    /// A map from the pattern's numbers to heights.
    Slopes(Arc<SlopeMap>),
    /// Other normals, which move along.
    Normals(Blend<Normal>),
}

/// A normal in its own space.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Normal {
    /// What tells points apart, and where it lies.
    pub pattern: Pattern,
    /// What makes the bumps.
    pub relief: Relief,
    /// `bump_size`, or the number behind the pattern's name: how deep the bumps seem.
    pub amount: f64,
    /// Half the distance of the points that are compared.
    pub accuracy: f64,
    /// `uv_mapping` stands in the normal itself: then bumps do not turn with the object (measured on POV-Ray 3.7).
    pub stays: bool,
    /// `no_bump_scale` switches it off: bumps that are scaled get deeper too.
    pub bump_scale: bool,
}

impl Default for Normal {
    fn default() -> Self {
        Self {
            pattern: Pattern::default(),
            relief: Relief::Own,
            amount: 0.5,
            accuracy: 0.02,
            stays: false,
            bump_scale: true,
        }
    }
}

impl Normal {
    /// Reads what stands between the braces, on top of `base`; normals inside of it begin with the default one.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read(r: &mut dyn Reader, base: Option<&Normal>, defaults: &Texture) -> Result<Self> {
        let uv = read_uv_mapping(r)?;
        let mut out = match r.thing::<Normal>()? {
            Some(declared) => (*declared).clone(),
            None => base.cloned().unwrap_or_default(),
        };
        if let Some(on) = uv {
            (out.pattern.uv, out.stays) = (on, out.stays || on);
        }
        loop {
            match r.next()? {
                Next::End => return Ok(out),
                next => out.read_element(r, next, defaults)?,
            }
        }
    }

    fn read_element(&mut self, r: &mut dyn Reader, next: Next, defaults: &Texture) -> Result<()> {
        if self.pattern.read_element(next, r)? {
            self.stays |= next == Next::Word("uv_mapping") && self.pattern.uv;
            let is_name = |word| FieldPattern::is_name(word) || CellPattern::is_name(word);
            if matches!(next, Next::Word(word) | Next::Block(word) if is_name(word)) || next == Next::Function {
                self.read_amount(r)?;
            }
            // Cells without a list make bumps of their own, where their numbers jump.
            let listed = matches!(r.next()?, Next::Block(Self::BLOCK) | Next::Thing(Self::BLOCK));
            let list = blend::read_list(r, next, &self.pattern, defaults, &|_, _| Normal::default())?;
            if let (Some(list), true) = (list, listed) {
                self.relief = Relief::Normals(list);
            }
            return Ok(());
        }
        match next {
            Next::Word("bump_size") => {
                r.take()?;
                self.amount = r.float()?;
            }
            Next::Word("accuracy") => {
                r.take()?;
                self.accuracy = r.float()?;
            }
            Next::Word("no_bump_scale") => {
                r.take()?;
                self.bump_scale = !r.flag()?;
            }
            Next::Block("bump_map") => {
                r.take()?;
                let amount = &mut self.amount;
                let image = ImagePattern::read_words(r, "bump_map", &mut |r, next| {
                    let sized = next == Next::Word("bump_size");
                    if sized {
                        r.take()?;
                        *amount = r.float()?;
                    }
                    Ok(sized)
                })?;
                self.relief = Relief::Own;
                self.pattern.kind = Kind::Field(FieldPattern::ImagePattern(ImagePattern { bumps: true, ..image }));
                r.leave()?;
            }
            Next::Block("slope_map") => {
                r.take()?;
                self.relief = Relief::Slopes(Arc::new(Map::read_entries(r, defaults, false)?));
                r.leave()?;
            }
            Next::Block("normal_map") => {
                r.take()?;
                self.relief =
                    Relief::Normals(Blend::Map(Arc::new(Map::read_entries(r, defaults, self.pattern.averages())?)));
                r.leave()?;
            }
            _ => return Err(r.unknown_word("normal", &NORMAL.names()).into()),
        }
        Ok(())
    }

    /// The number behind the pattern's name.
    fn read_amount(&mut self, r: &mut dyn Reader) -> Result<()> {
        self.relief = Relief::Own;
        if let Some(amount) = r.optional_float()? {
            self.amount = amount;
        }
        Ok(())
    }

    /// Does it ask where the point lies on its shape?
    pub fn asks_uv(&self) -> bool {
        let inner = matches!(&self.relief, Relief::Normals(parts) if parts.iter().any(Normal::asks_uv));
        self.pattern.uv || inner
    }

    /// The normal with its bumps, at a point in the space around; `n` in the same space, of any length. Each space turns it by
    /// the transpose of its matrix, so that what is stretched gets flatter bumps (all measured on POV-Ray 3.7).
    pub fn perturb(&self, ctx: &TextureContext, n: DVec3) -> DVec3 {
        self.perturb_as(ctx, n, !self.bump_scale)
    }

    /// `keep_length` is `no_bump_scale`, of this normal or of one around it.
    fn perturb_as(&self, ctx: &TextureContext, n: DVec3, keep_length: bool) -> DVec3 {
        let space = &self.pattern.space;
        let inside = space.normal_inside(n);
        let n = if keep_length { inside } else { inside.normalize_or(inside) };
        let inner = self.pattern.enter(ctx);
        let bumped = match &self.relief {
            Relief::Normals(parts) => self.blended(parts, &inner, n, keep_length),
            _ => match self.pattern.bumped(&inner, n, self.amount) {
                Some(bumped) => bumped,
                None => n + self.slant(&inner),
            },
        };
        space.normal_outside(bumped)
    }

    /// What the entries make of it together.
    fn blended(&self, parts: &Blend<Normal>, inner: &TextureContext, n: DVec3, keep_length: bool) -> DVec3 {
        let average = self.pattern.averages();
        let number = if average { 0.0 } else { self.pattern.number(inner) };
        let mut sum = DVec3::ZERO;
        for (entry, share) in parts.shares(number, average) {
            let keep = keep_length || !entry.bump_scale;
            let one = entry.perturb_as(inner, n, keep);
            sum += share * if keep { one } else { one.normalize_or(one) };
        }
        sum
    }

    /// How heights slant around a point: they are compared at the corners of a tetrahedron around it.
    fn slant(&self, inner: &TextureContext) -> DVec3 {
        if let Kind::Plain | Kind::Average = self.pattern.kind {
            return DVec3::ZERO;
        }
        let h = self.accuracy;
        let sum: DVec3 = TETRAHEDRON.iter().map(|&d| self.height(&inner.at(inner.p + h * d)) * d).sum();
        sum * (-self.amount * 0.1 / h)
    }

    /// The height of the surface as it seems.
    fn height(&self, inner: &TextureContext) -> f64 {
        let number = self.pattern.number(inner);
        match &self.relief {
            Relief::Slopes(map) => match map.around(number) {
                (only, None) => only.height,
                (below, Some((above, t))) => below.curve_to(above, t),
            },
            _ => number,
        }
    }

    /// Does it change no normal at all?
    pub fn is_flat(&self) -> bool {
        match &self.relief {
            Relief::Normals(parts) => parts.iter().all(Normal::is_flat),
            _ => matches!(self.pattern.kind, Kind::Plain) || self.amount == 0.0,
        }
    }
}

impl Entry for Normal {
    const MAP: &'static str = "normal_map";
    const BLOCK: &'static str = "normal";

    fn read_entry(r: &mut dyn Reader, defaults: &Texture) -> Result<Self> {
        Self::read(r, defaults.layers[0].normal.as_deref(), defaults)
    }

    fn declared(r: &mut dyn Reader) -> Result<Option<Self>> {
        Ok(r.thing::<Normal>()?.map(|normal| (*normal).clone()))
    }
}

impl Entry for Slope {
    const MAP: &'static str = "slope_map";
    const BLOCK: &'static str = "<height, slope>";

    fn read_entry(r: &mut dyn Reader, _: &Texture) -> Result<Self> {
        let pair = r.vector2()?;
        Ok(Self { height: pair.x, slope: pair.y })
    }

    fn declared(_: &mut dyn Reader) -> Result<Option<Self>> {
        Ok(None)
    }
}
