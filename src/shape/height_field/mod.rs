//! `height_field { "file.png" … }`: a landscape over the square from 0 to 1 in x and z, whose heights are the brightness of a picture's
//! pixels.
//!
//! Black is 0 and white is 1; the picture's upper edge lies at z = 1. Each square between four pixels is two triangles. The surface is a
//! sheet without walls or a bottom; its inside is what lies below it, without end. `function W, H { … }` in place of the file gives W by H
//! heights, for x and y from 0 to 1, y on top being 0; `smooth` lets the surface look round, `water_level` leaves out what is below it.
//!
//! ```pov
//! height_field {
//!   function 60, 60 { 0.3 + 0.2*sin(9*x)*cos(7*y) } smooth translate <-0.5, 0, -0.5> scale 6
//!   pigment { color rgb <0.4, 0.7, 0.3> }
//! }
//! ```

mod grid;
mod heights;
mod line;
mod normals;
mod packet;

use super::{Bounding, Hit, Hits, Kernel, PacketHits, Quirks, Shape, nearest_hit};
use crate::color::Gamma;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::{Function, ResultType};
use crate::image_io::{Picture, scale_and_wrap_to_u16};
use crate::math::packet::{Numbers, RayPacket};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform};
use crate::source::Span;
use crate::value::words::{Row, set, specs, word};
use crate::value::{Next, Param, Readable, Reader, ReaderExt, Spec, ValueKind, downcast};
use grid::{Grid, Place, STEPS};
use serde::Serialize;
use std::ops::ControlFlow;
use std::sync::Arc;

/// Words of a height field's file formats. The format is recognised by the file's bytes; only `pot` changes the meaning
/// of the pixels.
const FORMATS: &[&str] = &["exr", "gif", "hdr", "iff", "jpeg", "pgm", "png", "ppm", "sys", "tga", "tiff", "pot", "bmp"];

/// Depth below a height field's `water_level`, in steps, from which on the surface is removed (quirk:
/// `water_level_depth`).
const SHALLOW: f64 = 0.001;

/// Height field: a terrain from the pixels of a picture or from a function.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HeightField {
    /// Number of the field's heights along x and z.
    pub size: [usize; 2],
    /// True if the height field's normals are interpolated.
    pub smooth: bool,
    /// Height below which a height field's surface is removed.
    pub water_level: f64,
    /// Relation between the numbers of the height field's file and heights, from `gamma`.
    #[serde(skip)]
    gamma: Option<Gamma>,
    /// True if the height field's picture is a `pot`, whose right half holds the lower bytes of its left half.
    #[serde(skip)]
    is_pot: bool,
    #[serde(skip)]
    picture: Option<Arc<Picture>>,
    /// Grid of the field's heights; `None` for a field without any cell.
    #[serde(skip)]
    grid: Option<Arc<Grid>>,
    /// Transform of the height field from object to world space, for normals at corners.
    #[serde(skip)]
    place: Option<Box<Transform>>,
}

impl HeightField {
    /// Creates a height field with `width` heights in each row, from z = 0 on; 65535 is (nearly) 1.
    pub fn new(width: usize, heights: Vec<u16>, smooth: bool, water_level: f64) -> Self {
        let size = [width, heights.len().checked_div(width).unwrap_or(0)];
        let is_there = size[0] > 1 && size[1] > 1;
        let grid = is_there.then(|| Arc::new(Grid::new(width, heights)));
        Self { size, smooth, water_level, gamma: None, is_pot: false, picture: None, grid, place: None }
    }

    /// Height below which the height field's surface is removed; a flat field exactly at `water_level` is visible.
    fn waterline(&self) -> f64 {
        self.water_level - SHALLOW / STEPS
    }

    /// Calls `visit` with each hit of a ray, ascending, until it breaks.
    fn visit_hits(&self, ray: &Ray, range: Range, visit: &mut dyn FnMut(Hit) -> ControlFlow<()>) {
        let Some(grid) = &self.grid else { return };
        let scale = grid.grid_from_object_scale();
        // Start where the ray enters the box, so that a distant eye costs no digits.
        let Some((enter, leave)) = self.search_box().slabs(ray, Range::ALL) else { return };
        if !(enter <= range.max && leave >= range.min && enter.is_finite()) {
            return;
        }
        let start = enter;
        let local = Ray::new(ray.at(start) * scale, ray.dir * scale);
        let moved = Range { min: range.min - start, max: range.max - start };
        grid.visit_hits(&local, moved, &mut |t, place| {
            let (y, t) = (local.origin.y + local.dir.y * t, t + start);
            match self.is_visible(y, t, range) {
                true => visit(Hit::on_piece(t, grid.number_of_triangle(place))),
                false => ControlFlow::Continue(()),
            }
        });
    }

    /// Box in which rays search the field: a little larger than the field's own.
    fn search_box(&self) -> Aabb {
        self.bounds().grown(1e-4)
    }

    /// True if a hit at the height `y`, in steps, and the distance `t` counts: it is in the range, and not below the water.
    fn is_visible(&self, y: f64, t: f64, range: Range) -> bool {
        y / STEPS >= self.waterline() && range.contains(t)
    }

    /// Interpolates the normals of a height field's cell from its four corners, where they have length 1 in world
    /// space.
    fn smooth_normal(&self, grid: &Grid, place: Place, position_in_cell: DVec2) -> DVec3 {
        let (m, scale) = (self.place.as_deref().unwrap_or(&Transform::IDENTITY), grid.grid_from_object_scale());
        let corner = |i: usize, k: usize| {
            m.transform_normal(grid.unnormalized_corner_normal(place.i + i, place.k + k) * scale).normalize_or_zero()
        };
        let [n00, n10, n01, n11] = [corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)];
        let n = n00.lerp(n10, position_in_cell.x).lerp(n01.lerp(n11, position_in_cell.x), position_in_cell.y);
        m.inverse_transform_normal(n)
    }
}

/// Reads a height field from `function W, H { … }`, row by row from z = 0 on.
fn read_function(r: &mut dyn Reader) -> Result<HeightField> {
    let at = r.span();
    let Some(([width, height], thing)) = r.read_function_if_sized()? else {
        return Diagnostic::new(codes::WRONG_TYPE, at, "a function that gives heights needs a size")
            .help("`function 200, 200 { … }`")
            .into();
    };
    let Some(function) = downcast::<Function>(&thing).filter(|f| f.arity() == 3) else {
        return Diagnostic::err(codes::WRONG_TYPE, at, "expected a function of x and y");
    };
    let colored = function.result_type() == ResultType::Color;
    let step = |i: usize, n: usize| i as f64 / (n.max(2) - 1) as f64;
    let mut all = Vec::with_capacity(width * height);
    for j in (0..height).rev() {
        all.extend((0..width).map(|i| {
            let [r, g, b, ..] = function.call(&[step(i, width), step(j, height), 0.0]);
            // quirk: height_field_function_precision
            let kept = |x: f64| heights::unit_to_wrapping_u16(f64::from(x as f32));
            if colored { heights::brightness_u16([r, g, b].map(kept)) } else { scale_and_wrap_to_u16(r as f32) }
        }));
    }
    Ok(HeightField::new(width, all, false, 0.0))
}

impl Readable for HeightField {
    const SPEC: Spec = Spec {
        name: "height_field",
        summary: "a landscape over the square from 0 to 1, with a picture's brightness for heights",
        params: &[Param {
            name: "file",
            kind: ValueKind::Text,
            summary: "a picture file's name, or `function W, H { … }` with the numbers of heights across and deep",
        }],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        word("smooth", ValueKind::Flag, "off", "its triangles look like one round surface")
            .sets(|s, r| set(&mut s.smooth, r.flag())),
        word("water_level", ValueKind::Float, "0", "what is lower than this is left out")
            .sets(|s, r| set(&mut s.water_level, r.float())),
        word("hierarchy", ValueKind::Flag, "on", "changes nothing: durer always passes over what a ray can't meet")
            .sets(|_, r| r.flag().map(|_| ())),
        word("gamma", ValueKind::Float, "1", "heights are the picture's numbers to the power of this; or `srgb`")
            .sets(|s, r| set(&mut s.gamma, read_gamma(r).map(Some))),
        word("premultiplied", ValueKind::Flag, "off", "changes nothing: the picture's alpha does not count")
            .sets(|_, r| r.flag().map(|_| ())),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let mut format = None;
        while let Next::Word(word) = r.peek_next()?
            && FORMATS.contains(&word)
        {
            r.take_token()?;
            format = Some(word);
        }
        match r.peek_next()? {
            Next::Function => read_function(r),
            _ => {
                let (at, name) = (r.span(), r.text()?);
                let picture = r.open_picture(&name, at, format)?;
                let is_pot = format == Some("pot") && picture.indices.is_some();
                let width = picture.pixels.width / if is_pot { 2 } else { 1 };
                let size = [width, picture.pixels.height];
                Ok(Self { size, is_pot, picture: Some(picture), ..Self::new(0, vec![], false, 0.0) })
            }
        }
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        let [width, height] = self.size;
        if let Some(picture) = self.picture.take()
            && width > 1
            && height > 1
        {
            let all = heights::picture_heights_bottom_up(&picture, self.gamma);
            let heights = if self.is_pot { heights::heights_of_pot_picture(&all, picture.pixels.width) } else { all };
            self.grid = Some(Arc::new(Grid::new(width, heights)));
        }
        if self.grid.is_none() {
            let message = format!("a `height_field` of {width} by {height} heights has no surface");
            r.report(Diagnostic::new(codes::NO_SURFACE, span, message).help("it needs two in each direction"));
        } else if self.bounds().is_empty() {
            let message = format!("all of this `height_field` is below its `water_level` of {}", self.water_level);
            r.report(Diagnostic::new(codes::NO_SURFACE, span, message));
        }
        Ok(())
    }
}

/// Reads the `gamma` of a height field: `srgb` or a number.
fn read_gamma(r: &mut dyn Reader) -> Result<Gamma> {
    if r.accept("srgb")? { Ok(Gamma::Srgb) } else { r.float().map(Gamma::Power) }
}

impl Kernel for HeightField {
    const QUIRKS: Quirks = Quirks { bounding: Bounding::Ignored, ..Quirks::NONE };

    const TRACES_PACKETS: bool = true;

    fn closest_of_packet(&self, rays: &RayPacket, min: f64, max: &Numbers) -> PacketHits {
        packet::closest_of_packet(self, rays, min, max)
    }

    fn bounds(&self) -> Aabb {
        let Some(grid) = &self.grid else { return Aabb::EMPTY };
        let [lo, hi] = grid.height_range().map(|h| h / STEPS);
        let lo = lo.max(self.waterline());
        if lo > hi { Aabb::EMPTY } else { Aabb { min: DVec3::Y * lo, max: DVec3::new(1.0, hi, 1.0) } }
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.visit_hits(ray, range, &mut |hit| {
            out.push(hit);
            ControlFlow::Continue(())
        });
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut all = Hits::new();
        self.visit_hits(ray, range, &mut |hit| {
            all.push(hit);
            ControlFlow::Break(())
        });
        nearest_hit(&all)
    }

    /// True if a point is below the height field's surface or the water; there is no bottom (quirk:
    /// `height_field_inside`).
    fn inside(&self, p: DVec3) -> bool {
        let Some(grid) = &self.grid else { return false };
        if !(0.0..=1.0).contains(&p.x) || !(0.0..=1.0).contains(&p.z) {
            return false;
        }
        let (place, rest) = grid.triangle_and_position_at(p.x * grid.across as f64, p.z * grid.deep as f64);
        p.y < self.water_level || p.y * STEPS < grid.triangle_height(place, rest)
    }

    fn solid_bounds(&self) -> Option<Aabb> {
        let b = self.grid.as_ref()?.height_range().map(|h| h / STEPS);
        Some(Aabb { min: DVec3::new(0.0, f64::NEG_INFINITY, 0.0), max: DVec3::new(1.0, b[1], 1.0) })
    }

    fn is_solid_unbounded(&self) -> bool {
        true
    }

    /// Returns the height field with normals that are averaged in world space, as in POV-Ray.
    fn adapted_to_transform(&self, m: &Transform) -> Option<Shape> {
        self.smooth.then(|| Self { place: Some(Box::new(*m)), ..self.clone() }.into())
    }

    fn normal(&self, p: DVec3, hit: &Hit) -> DVec3 {
        let Some(grid) = &self.grid else { return DVec3::Y };
        let place = grid.triangle_with_number(hit.part);
        let scale = grid.grid_from_object_scale();
        if self.smooth {
            let rest = DVec2::new(p.x * scale.x - place.i as f64, p.z * scale.z - place.k as f64);
            let n = self.smooth_normal(grid, place, rest.clamp(DVec2::ZERO, DVec2::ONE));
            if n != DVec3::ZERO {
                return n;
            }
        }
        let slope = grid.triangle_slope(place);
        DVec3::new(-slope.x, 1.0, -slope.y) * scale
    }

    fn uv(&self, p: DVec3, _: &Hit) -> DVec2 {
        DVec2::new(p.x, p.z)
    }

    fn has_uv_mapping(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests;
