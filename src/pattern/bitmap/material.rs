//! `material_map`: the numbers of a picture's palette choose among textures (manual, "Material Maps").

use super::{Bitmap, Mapping, Texels, bitmap_word_names};
use crate::color::{Color, Rgb};
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::pattern::Cells;
use crate::value::{Next, Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Picture of a `material_map`, whose palette indices choose textures.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MaterialMap {
    /// Pixels of a `material_map`, whose palette indices or red channels select the textures.
    pub texels: Texels,
    /// Projection of the `material_map`'s picture.
    pub mapping: Mapping,
    /// Number of textures of the `material_map`; larger indices wrap around.
    pub count: usize,
}

impl Readable for MaterialMap {
    const SPEC: Spec = Spec {
        name: "material_map",
        summary: "the numbers of a picture's palette choose among textures; all stand in its braces",
        params: &[Param { name: "file", kind: ValueKind::Text, summary: "a picture file's name" }],
        ..Spec::EMPTY
    };

    /// Reads a `material_map` up to its first texture; the block stays open.
    fn read(r: &mut dyn Reader) -> Result<Self> {
        let mut bitmap = Bitmap::read_picture(r)?;
        loop {
            match r.peek_next()? {
                Next::Block("texture") | Next::Thing("texture") | Next::End => break,
                next if bitmap.read_bitmap_word(r, next)? => {}
                _ => {
                    let words: Vec<_> = bitmap_word_names().chain(["texture"]).collect();
                    return Err(r.unknown_word("material_map", &words).into());
                }
            }
        }
        Ok(Self { texels: bitmap.number_texels(), mapping: bitmap.mapping, count: 256 })
    }
}

impl Cells for MaterialMap {
    fn cell_kind_count(&self) -> usize {
        self.count
    }

    fn cell_kind(&self, p: DVec3) -> usize {
        let Some(place) = self.mapping.project_to_unit_square(p) else { return 0 };
        let pixels = self.mapping.weighted_pixels(place, self.texels.width(), self.texels.height());
        // In a picture without a palette, red is the index.
        let number = |i| self.texels.palette_index(i).map_or_else(|| self.texels.rgba(i)[0] * 255.0, f64::from);
        let number: f64 = pixels.iter().map(|(i, weight)| weight * number(*i)).sum();
        number.max(0.0) as usize % self.count.max(1)
    }

    fn default_color(&self, cell: usize) -> Color {
        Color::opaque(Rgb::splat((cell % 2) as f64))
    }
}
