//! Behaviour of single shapes that a clean model would not have, as constants beside their kernels (see [`crate::quirks`]).

use crate::math::tolerance;

/// Departures of POV-Ray 3.7 from the model for one kind of shape. Each kernel states its own: `const QUIRKS: Quirks =
/// Quirks { … ..Quirks::NONE }`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quirks {
    /// Minimum distance of a hit on this kind of shape from the ray's origin, in world units (quirk:
    /// `blob_min_distance`).
    pub min_distance: f64,
    /// Effect of `bounded_by` on an object that is this kind of shape alone.
    pub bounding: Bounding,
    /// True if `clipped_by` has no effect on this kind of shape (quirk: `patch_never_clipped`).
    pub ignores_clipping: bool,
    /// True if a shadow of this kind of shape depends on the outer texture alone, whatever `interior_texture` transmits
    /// (quirk: `shadow_by_outside`).
    pub shadow_by_outside: bool,
    /// True if `inverse` does not exchange the outer and the inner texture of this kind of shape (quirk:
    /// `quadric_keeps_sides`).
    pub keeps_texture_sides: bool,
    /// True if embedded textures show on the inside too, whatever `interior_texture` says (quirk:
    /// `blob_textures_on_both_sides`).
    pub embedded_textures_on_both_sides: bool,
    /// True if embedded textures move with the shape even under `uv_mapping` (quirk: `blob_textures_move`).
    pub moves_embedded_textures: bool,
    /// True if the hits on this kind of shape depend on the ray's origin (quirk: `isosurface_csg_shadows`).
    pub hits_depend_on_origin: bool,
}

/// Effect of `bounded_by` on a single shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bounding {
    /// A single shape is bounded by the bounding box of the objects in `bounded_by` (quirk: `bounded_by_box`).
    Box,
    /// A single shape is bounded by the objects in `bounded_by` themselves (quirk: `bounded_by_exact`).
    Exact,
    /// A single shape is not bounded by `bounded_by` at all (quirk: `bounded_by_ignored`).
    Ignored,
}

impl Quirks {
    /// Quirks of a kind of shape that has none.
    pub const NONE: Self = Self {
        min_distance: tolerance::SURFACE,
        bounding: Bounding::Box,
        ignores_clipping: false,
        shadow_by_outside: false,
        keeps_texture_sides: false,
        embedded_textures_on_both_sides: false,
        moves_embedded_textures: false,
        hits_depend_on_origin: false,
    };
}
