//! Scenes that a command line names: files, and folders of scenes.

use super::exit::{Result, usage_error};
use super::session;
use crate::diagnostic::file;
use crate::source::{Disk, scenes_below};
use std::path::PathBuf;

/// Scenes that a command renders or checks.
#[derive(Clone, Debug, PartialEq)]
pub struct Inputs {
    /// All scenes in the order of the command line, without duplicates. Scenes of a folder are sorted by name.
    pub all: Vec<PathBuf>,
    /// True if the command line names several inputs or a folder, so that each scene gets its own line of output.
    pub several: bool,
}

impl Inputs {
    /// Collects the scenes that a command line names, also those in folders. A folder without scenes is an error; missing
    /// files are reported later.
    pub fn collect(named: &[PathBuf]) -> Result<Self> {
        let mut all = Vec::new();
        for input in named {
            let input = session::existing_scene_path(input);
            if !input.is_dir() {
                all.push(input);
                continue;
            }
            if input.canonicalize().is_ok_and(|folder| folder.parent().is_none()) {
                // Refuse the root folder: nobody means all files of the machine.
                session::check_input(&input)?;
            }
            let scenes =
                scenes_below(&Disk, &input).map_err(|e| Box::new(file::unreadable(&Disk, &input, &e.into())))?;
            if scenes.is_empty() {
                return usage_error(format!("no file in `{}` ends in `.scene` or `.pov`", input.display()));
            }
            all.extend(scenes);
        }
        let mut seen = std::collections::HashSet::new();
        all.retain(|input| seen.insert(input.clone()));
        let several = named.len() > 1 || named.iter().any(|input| input.is_dir());
        Ok(Self { all, several })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_are_replaced_by_their_scenes() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        std::fs::create_dir_all(at("b/.hidden")).unwrap();
        std::fs::create_dir_all(at("empty")).unwrap();
        for name in ["z.scene", "a.pov", "a.inc", "b/c.scene", "b/.hidden/d.scene"] {
            std::fs::write(at(name), "").unwrap();
        }
        let found = Inputs::collect(&[at("z.scene"), folder.path().into()]).unwrap();
        assert_eq!(found.all, [at("z.scene"), at("a.pov"), at("b/c.scene")]);
        assert!(
            found.several
                && Inputs::collect(&[at("b")]).unwrap().several
                && !Inputs::collect(&[at("a")]).unwrap().several
        );
        assert!(Inputs::collect(&[at("empty")]).is_err());
    }
}
