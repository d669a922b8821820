//! Shards of a picture: files with the blocks that one of several processes has rendered. `durer merge` combines the
//! shards of a picture.
//!
//! A shard is a line that names the format, a line of JSON ([`Header`]) and a sequence of records: block, pixels and a
//! checksum that is keyed by the header. The blocks of a shard follow from its header, so that a missing or foreign
//! record is found.

mod identity;
pub mod merge;
mod parts;
mod reader;
pub mod scheduler;
mod writer;

pub use identity::Identity;
pub use reader::ShardFile;
pub use writer::ShardWriter;

use crate::image_io::Encoding;
use crate::render::{self, Region, Shard, shard_blocks};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// First line of a shard file, with the version of the format.
pub const MAGIC: &[u8] = b"durer shard 1\n";

/// Description of a shard: its picture and its share of the picture.
#[derive(Serialize, Deserialize, Clone, Debug, PartialEq)]
pub struct Header {
    /// Everything that determines the picture's pixels.
    pub identity: Identity,
    /// Size of the picture, region that is rendered, and division into blocks.
    pub layout: Layout,
    /// Format and options of the merged picture.
    pub encoding: Encoding,
    /// Number of this shard, and the number of all.
    pub shard: Shard,
}

/// Size of a picture, the region that is rendered, and the division of the region into blocks.
#[derive(Serialize, Deserialize, Clone, Debug, PartialEq)]
pub struct Layout {
    /// Width of the whole picture in pixels.
    pub width: usize,
    /// Height of the whole picture in pixels.
    pub height: usize,
    /// Part of the picture that is rendered.
    pub region: Region,
    /// Alpha of the black pixels outside of `region`.
    pub outside_alpha: f32,
    /// Edge of the blocks in pixels.
    pub edge: usize,
}

impl Layout {
    /// Returns the layout of a picture in `n_shards` shards.
    pub fn new(options: &render::Options, n_shards: usize) -> Self {
        Self {
            width: options.width,
            height: options.height,
            region: options.rendered_region(),
            outside_alpha: options.outside_alpha,
            edge: render::block_edge(options, n_shards),
        }
    }

    /// Returns the blocks of a shard in the order of its records.
    pub fn blocks(&self, shard: Shard) -> Vec<Region> {
        shard_blocks([self.width, self.height], self.region, self.edge, shard)
    }
}

/// Returns the path of a picture's shard: the picture's path and `.shard-3-of-16`.
pub fn path_beside(picture: &Path, shard: Shard) -> PathBuf {
    let mut name = picture.as_os_str().to_os_string();
    name.push(format!(".shard-{}-of-{}", shard.index, shard.count));
    name.into()
}

/// Returns the shard (its number and the number of all) that the file name of a picture's shard states; `None` for the
/// name of another file. `picture_name` is the picture's file name.
pub fn shard_of_name(name: &str, picture_name: &str) -> Option<Shard> {
    let (index, count) = name.strip_prefix(picture_name)?.strip_prefix(".shard-")?.split_once("-of-")?;
    let (index, count) = (index.parse().ok()?, count.parse().ok()?);
    (1..=count).contains(&index).then_some(Shard { index, count })
}

/// True if a file with these first bytes is a shard of any version.
pub fn begins_like_a_shard(start: &[u8]) -> bool {
    start.starts_with(b"durer shard ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_shards_are_read_back() {
        let shard = Shard { index: 3, count: 16 };
        let path = path_beside(Path::new("a/big.png"), shard);
        assert_eq!(path, Path::new("a/big.png.shard-3-of-16"));
        assert_eq!(shard_of_name("big.png.shard-3-of-16", "big.png"), Some(shard));
        for name in ["big.png", "big.png.shard-0-of-16", "big.png.shard-17-of-16", "x.png.shard-3-of-16"] {
            assert_eq!(shard_of_name(name, "big.png"), None);
        }
    }
}
