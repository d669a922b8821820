//! `density_file`: numbers from a file in the unit cube (manual, "Density File Pattern").

use super::{Field, TextureContext};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::image_io::Voxels;
use crate::math::DVec3;
use crate::value::words::{Row, set, specs, word};
use crate::value::{Param, Readable, Reader, ReaderExt, Spec, ValueKind};
use serde::{Serialize, Serializer};
use std::sync::Arc;

/// Pattern `density_file`: a grid of numbers from <0, 0, 0> to <1, 1, 1>; 0 outside.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DensityFile {
    /// Grid of the density file's numbers.
    #[serde(serialize_with = "serialize_size")]
    pub voxels: Arc<Voxels>,
    /// Interpolation between the density file's numbers.
    pub between: Voxel,
}

/// Interpolation between the numbers of a density file.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Voxel {
    /// Density file without interpolation: each number fills a box.
    Nearest,
    /// Linear interpolation of a density file along each axis.
    Linear,
    /// Cubic interpolation of a density file along each axis.
    Cubic,
}

fn serialize_size<S: Serializer>(voxels: &Arc<Voxels>, s: S) -> std::result::Result<S::Ok, S::Error> {
    voxels.size.serialize(s)
}

impl Voxel {
    fn from_interpolation_number(n: f64) -> Self {
        match n as i64 {
            i64::MIN..=0 => Voxel::Nearest,
            1 => Voxel::Linear,
            _ => Voxel::Cubic,
        }
    }
}

impl Readable for DensityFile {
    const SPEC: Spec = Spec {
        name: "density_file",
        summary: "numbers from a file, in the cube from <0, 0, 0> to <1, 1, 1>",
        params: &[
            Param { name: "df3", kind: ValueKind::Nothing, summary: "the word `df3`, the only format" },
            Param { name: "file", kind: ValueKind::Text, summary: "the file's name" },
        ],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] =
        &[word("interpolate", ValueKind::Float, "0", "between the numbers: 0 nothing, 1 straight lines, 2 curves")
            .sets(|s, r| set(&mut s.between, r.float().map(Voxel::from_interpolation_number)))];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        if !r.accept("df3")? {
            return Err(r.unexpected("`df3`").into());
        }
        let (at, name) = (r.span(), r.text()?);
        let Some(path) = r.find_file(&name, at)? else {
            let d = Diagnostic::new(codes::MISSING_INCLUDE, at, format!("the density file `{name}` was not found"));
            return d
                .help("density files are searched in the same folders as included files; -I DIR adds a folder")
                .into();
        };
        let voxels = Arc::new(Voxels::read(r.files(), &path).map_err(|fault| fault.at(at))?);
        Ok(Self { voxels, between: Voxel::Nearest })
    }
}

impl DensityFile {
    /// Returns the weighted sum of the density file's numbers from `first_cell` on, with `weights` for each axis; the grid
    /// repeats.
    fn weighted_sum<const N: usize>(&self, first_cell: [i64; 3], weights: [[f64; N]; 3]) -> f64 {
        let mut sum = 0.0;
        for k in 0..N {
            for j in 0..N {
                for i in 0..N {
                    let step = [i, j, k];
                    let place =
                        std::array::from_fn(|a| wrap_index(first_cell[a] + step[a] as i64, self.voxels.size[a]));
                    sum += weights[0][i] * weights[1][j] * weights[2][k] * self.voxels.density_at(place);
                }
            }
        }
        sum
    }
}

/// Wraps an index into the grid of a density file. Negative indices wrap like POV-Ray's unsigned 64-bit integers
/// (quirk: `density_file_wraps`).
fn wrap_index(index: i64, size: usize) -> usize {
    (index as u64 % size as u64) as usize
}

/// Weights of the four numbers of a density file around position `t` between the middle two (Catmull and Rom 1974).
fn catmull_rom_weights(t: f64) -> [f64; 4] {
    let near = |d: f64| (1.5 * d - 2.5) * d * d + 1.0;
    let far = |d: f64| ((2.5 - 0.5 * d) * d - 4.0) * d + 2.0;
    [far(1.0 + t), near(t), near(1.0 - t), far(2.0 - t)]
}

impl Field for DensityFile {
    fn value(&self, at: &TextureContext) -> f64 {
        let p = at.p.to_array();
        if !p.iter().all(|x| (0.0..1.0).contains(x)) {
            return 0.0;
        }
        let grid = at.p * DVec3::from_array(self.voxels.size.map(|n| n as f64));
        let floor = grid.floor();
        let (cell, part) = (floor.to_array().map(|x| x as i64), (grid - floor).to_array());
        match self.between {
            Voxel::Nearest => self.weighted_sum(cell, [[1.0]; 3]),
            Voxel::Linear => self.weighted_sum(cell, part.map(|t| [1.0 - t, t])),
            Voxel::Cubic => self.weighted_sum(cell.map(|i| i - 1), part.map(catmull_rom_weights)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(between: Voxel, x: f64) -> f64 {
        let bytes = [0, 4, 0, 1, 0, 1, 0, 255, 51, 0];
        let voxels = Arc::new(Voxels::decode_df3(&bytes).unwrap());
        DensityFile { voxels, between }
            .value(&TextureContext::without_surface(DVec3::new(x, 0.5, 0.5), Default::default()))
    }

    #[test]
    fn numbers_begin_their_boxes() {
        assert_eq!(
            [value(Voxel::Nearest, 0.25), value(Voxel::Nearest, 0.49), value(Voxel::Nearest, 1.0)],
            [1.0, 1.0, 0.0]
        );
        assert_eq!(value(Voxel::Linear, 0.25), 1.0);
        assert!((value(Voxel::Linear, 0.375) - 0.6).abs() < 1e-12);
        // weights -1/16 and 9/16 of the four numbers
        assert!((value(Voxel::Cubic, 0.375) - (9.0 + 9.0 * 0.2) / 16.0).abs() < 1e-12);
        // the last is followed by the first
        assert!((value(Voxel::Linear, 0.125) - 0.5).abs() < 1e-12);
    }
}
