//! Examples and pictures on the reference pages: those at the head of the files of shapes and patterns, and
//! `docs/src/examples/reference/`.

use super::{Block, STAGE, world_of};
use durer::world::World;
use libtest_mimic::Failed;
use std::collections::BTreeMap;
use std::path::Path;

/// A snapshot's size.
pub const SIZE: (usize, usize) = (128, 96);

/// Pages of which every heading has a picture, or is one of these exceptions.
const PAGES: &[&str] = &[
    "scene.md",
    "shapes.md",
    "objects.md",
    "cameras.md",
    "lights.md",
    "atmosphere.md",
    "pigments.md",
    "finishes.md",
    "settings.md",
];
const TEXT: &[&str] = &["What counts of a pixel", "Words of all patterns of numbers", "Warps", "Pictures"];

/// A page with its examples.
pub struct Illustrated {
    pub text: String,
    /// Name of each picture, and its scene.
    pub pictures: Vec<(String, String)>,
}

/// Inserts an example and its picture after the first paragraph below each heading.
pub fn illustrated(file: &str, page: &str, source: &Path, examples: &[(String, Block)]) -> Result<Illustrated, Failed> {
    let mut out = Illustrated { text: String::new(), pictures: vec![] };
    if !PAGES.contains(&file) {
        out.text = page.into();
        return Ok(out);
    }
    let (mut due, mut said, mut seen) = (None, false, BTreeMap::<&str, usize>::new());
    for line in page.lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            let count = seen.entry(heading).or_default();
            *count += 1;
            due = (!TEXT.contains(&heading)).then_some((heading, *count));
            said = false;
        } else if line.is_empty()
            && said
            && let Some((heading, count)) = due.take()
        {
            // (A pattern has this name too.)
            let more = if (file, heading) == ("shapes.md", "cubic") { "_shape" } else { "" };
            let name = format!("{}{}{more}", slug(heading), if count > 1 { "_warp" } else { "" });
            let scene = example(heading, &name, count, source, examples)?;
            let shown = scene.strip_prefix(STAGE).unwrap_or(&scene).trim_end();
            out.text += &format!("\n```pov\n{shown}\n```\n\n![{heading}](../pictures/reference/{name}.png)\n");
            out.pictures.push((name, scene));
        } else {
            said |= !line.is_empty();
        }
        out.text += line;
        out.text.push('\n');
    }
    Ok(out)
}

/// `POV-Ray's camera` → `pov_ray_s_camera`
fn slug(heading: &str) -> String {
    heading.chars().map(|c| if c.is_alphanumeric() { c.to_ascii_lowercase() } else { '_' }).collect()
}

/// The scene for a heading, with the name of its picture; the second heading of a name is a warp.
fn example(
    heading: &str,
    name: &str,
    count: usize,
    source: &Path,
    examples: &[(String, Block)],
) -> Result<String, Failed> {
    let path = source.join("examples/reference").join(format!("{name}.pov"));
    if let Ok(text) = std::fs::read_to_string(path) {
        return Ok(if text.starts_with("#version") { text } else { format!("{STAGE}{text}") });
    }
    let is_word = |text: &str| text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == heading);
    let is_warp = |text: &str| text.split("warp {").skip(1).any(|inside| inside.trim_start().starts_with(heading));
    let fits = examples.iter().filter(|(_, block)| is_word(&block.text));
    let best = fits.min_by_key(|(place, block)| {
        let stem = Path::new(place.rsplit_once(':').map_or("", |p| p.0)).file_stem().unwrap_or_default();
        (is_warp(&block.text) != (count > 1), stem != heading)
    });
    Ok(best
        .ok_or_else(|| format!("no example of `{heading}`: write docs/src/examples/reference/{name}.pov"))?
        .1
        .text
        .clone())
}

/// The world of a picture's scene.
pub fn world(source: &Path, scene: &str) -> Result<World, Failed> {
    world_of(source, scene, SIZE)
}
