//! The command `durer merge PICTURE [SHARD…]`: combines the shards of a picture.

use super::{Layout, ShardFile, parts, shard_of_name};
use crate::cli::args::MergeArgs;
use crate::cli::console::Console;
use crate::cli::exit::{Exit, Failure, Result, usage_error};
use crate::cli::render::target::Target;
use crate::diagnostic::{Diagnostic, codes};
use crate::image_io::{Format, Rows, SIGNATURE_BYTES, begins_like_a_picture};
use crate::render::{Region, Shard};
use crate::source::Span;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Combines the shards of a picture, after proving that they are of one picture, complete and whole; or pictures of parts
/// of it.
pub fn run(console: &Console, args: &MergeArgs) -> Result {
    if args.shards.first().is_some_and(|path| is_picture(path)) {
        return parts::merge(console, &args.picture, &args.shards);
    }
    let paths = if args.shards.is_empty() { shards_beside(&args.picture)? } else { args.shards.clone() };
    let shards = checked_shards(&paths)?;
    let Some(first) = shards.values().next() else { return usage_error("no shard was named") };
    let (layout, encoding) = (first.header.layout.clone(), first.header.encoding);
    let format = Format::from_path(&args.picture)?;
    if format != encoding.format {
        let (named, stored) = (format.name(), encoding.format.name());
        return usage_error(format!(
            "the shards were rendered for a {stored} file, and the picture's name asks for {named}"
        ));
    }
    let target = Target::of_file(&args.picture, encoding);
    target.check_file_writable()?;
    let mut draft = target.start_draft()?;
    let mut writer = target.writer(draft.as_mut(), (layout.width, layout.height))?;
    write_rows(&layout, &shards, &mut writer)?;
    writer.finish()?;
    if let Some(draft) = &mut draft {
        draft.make_durable();
    }
    target.commit(console, draft)?;
    console.info(&format!("{}: {} shards merged\n", args.picture.display(), shards.len()));
    Ok(Exit::Fine)
}

/// True for a file that begins like a picture.
fn is_picture(path: &Path) -> bool {
    let mut start = Vec::with_capacity(SIGNATURE_BYTES);
    let read = File::open(path).and_then(|file| file.take(SIGNATURE_BYTES as u64).read_to_end(&mut start));
    read.is_ok() && begins_like_a_picture(&start)
}

/// Returns the failure of a file that cannot be merged.
pub(super) fn unusable(path: &Path, reason: &str) -> Failure {
    let text = format!("`{}` can't be merged: {reason}", path.display());
    Failure::Fault(Box::new(Diagnostic::new(codes::FILE_UNREADABLE, Span::NONE, text)))
}

/// Finds the shards of a picture in the picture's folder, in the order of their numbers. An error if there are none, or if
/// they are of different numbers of shards.
fn shards_beside(picture: &Path) -> Result<Vec<PathBuf>> {
    let folder = picture.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    let name = picture.file_name().unwrap_or_default().to_string_lossy();
    let entries = std::fs::read_dir(folder).map_err(|error| unusable(folder, &error.to_string()))?;
    let mut found: Vec<(Shard, PathBuf)> = entries
        .filter_map(|entry| {
            let file = entry.ok()?.file_name();
            let shard = shard_of_name(&file.to_string_lossy(), &name)?;
            Some((shard, picture.with_file_name(&file)))
        })
        .collect();
    found.sort();
    let counts: Vec<usize> = found.chunk_by(|a, b| a.0.count == b.0.count).map(|same| same[0].0.count).collect();
    let picture = picture.display();
    let mut different = counts.clone();
    different.sort_unstable();
    different.dedup();
    match &different[..] {
        [] => usage_error(format!("there are no shards of `{picture}`: no file is named `{picture}.shard-1-of-…`")),
        [_] => Ok(found.into_iter().map(|(_, path)| path).collect()),
        [a, b, ..] => usage_error(format!(
            "there are shards of `{picture}` out of {a} and out of {b}; name those to merge: `durer merge {picture} {picture}.shard-*-of-{b}`"
        )),
    }
}

/// Opens all shards, checks that they are of one picture and that none is missing, and returns them by their numbers,
/// which begin at 1.
fn checked_shards(paths: &[PathBuf]) -> Result<BTreeMap<usize, ShardFile>> {
    let mut shards: BTreeMap<usize, ShardFile> = BTreeMap::new();
    for path in paths {
        let shard = ShardFile::open(path).map_err(|reason| unusable(path, &reason))?;
        if let Some(other) = shards.values().next() {
            let (mine, first) = (&shard.header, &other.header);
            let reason = if mine.layout != first.layout || mine.encoding != first.encoding {
                Some("it has another size, region or format than the shards before".into())
            } else if mine.shard.count != first.shard.count {
                Some(format!("it is one of {} shards, and the others are of {}", mine.shard.count, first.shard.count))
            } else {
                mine.identity.difference_reason(&first.identity)
            };
            if let Some(reason) = reason {
                return Err(unusable(path, &reason));
            }
        }
        // The same share twice has the same pixels.
        shards.insert(shard.header.shard.index, shard);
    }
    let count = shards.values().next().map_or(0, |shard| shard.header.shard.count);
    let missing: Vec<String> = (1..=count)
        .filter(|index| !shards.contains_key(index))
        .take(MAX_NAMED)
        .map(|index| index.to_string())
        .collect();
    let n_missing = count - shards.len();
    if n_missing > 0 {
        let more = if n_missing > missing.len() { ", …" } else { "" };
        let text = format!("{n_missing} of {count} shards are missing: {}{more}", missing.join(", "));
        return Err(Failure::Fault(Box::new(Diagnostic::new(codes::FILE_NOT_FOUND, Span::NONE, text))));
    }
    Ok(shards)
}

/// Number of missing shards that a message names.
const MAX_NAMED: usize = 20;

/// Passes the rows of the picture to `rows`, from the top, one row of blocks at a time.
fn write_rows(layout: &Layout, shards: &BTreeMap<usize, ShardFile>, rows: &mut dyn Rows) -> Result<()> {
    let Layout { width, height, region, outside_alpha, edge } = *layout;
    let outside = [0.0, 0.0, 0.0, outside_alpha];
    let count = shards.len();
    let mut owners = BTreeMap::new();
    for index in 1..=count {
        for block in layout.blocks(Shard { index, count }) {
            owners.insert([block.y, block.x], (block, index));
        }
    }
    let mut next_row = 0;
    while next_row < height {
        // Rows outside of the region are passed on one by one.
        let is_inside = region.width > 0 && (region.y..region.y + region.height).contains(&next_row);
        let end = if is_inside { (next_row / edge + 1) * edge } else { next_row + 1 };
        let end = if is_inside { end.min(region.y + region.height) } else { end };
        let mut band = vec![outside; width * (end - next_row)];
        for (block, index) in owners.range([next_row, 0]..[end, 0]).map(|(_, owner)| owner) {
            copy_block(&mut band, width, next_row, *block, &shards[index])?;
        }
        rows.write_rows(&band)?;
        next_row = end;
    }
    Ok(())
}

/// Copies the pixels of a block from its shard into a band that begins at the row `top`.
fn copy_block(band: &mut [[f32; 4]], width: usize, top: usize, block: Region, shard: &ShardFile) -> Result<()> {
    let unreadable = |reason: String| {
        let text = format!("a shard can't be read any more: {reason}");
        Failure::Fault(Box::new(Diagnostic::new(codes::FILE_UNREADABLE, Span::NONE, text)))
    };
    let pixels = shard.read_block(block).map_err(unreadable)?.ok_or_else(|| unreadable("it has changed".into()))?;
    for (row, pixels) in (block.y - top..).zip(pixels.chunks(block.width)) {
        let start = row * width + block.x;
        band[start..start + block.width].copy_from_slice(pixels);
    }
    Ok(())
}
