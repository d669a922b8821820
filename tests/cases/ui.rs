//! Messages on stderr: runs `durer check` on each `tests/ui/NAME.scene` (or `.pov`) in that folder, and compares stderr
//! and the exit code with `NAME.stderr`. The file's first line may name another command, with `{}` for the file: `// $
//! durer pick {} 1000,0`. `UPDATE_UI=1 cargo test --test cases ui::` updates the `.stderr` files.

use crate::Group;
use libtest_mimic::{Failed, Trial};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

pub fn group() -> Group {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ui");
    let entries = std::fs::read_dir(&folder).into_iter().flatten().flatten();
    let mut scenes: Vec<PathBuf> = entries.map(|e| e.path()).filter(|p| is_scene(p)).collect();
    scenes.sort();
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let mut trials: Vec<_> =
        scenes.into_iter().map(|path| Trial::test(format!("ui::{}", name(&path)), move || run(&path))).collect();
    trials.push(Trial::test("ui::every_code_has_a_case", move || every_code(&folder)));
    Group { tests: trials, at_least: 190 }
}

fn is_scene(path: &Path) -> bool {
    path.extension().is_some_and(|e| e == "scene" || e == "pov")
}

/// The arguments of the command for this file.
fn command(scene: &Path) -> Result<Vec<String>, Failed> {
    let bytes = std::fs::read(scene)?;
    let name = scene.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let first = bytes.split(|b| *b == b'\n' || *b == b'\r').next().unwrap_or_default();
    let first = String::from_utf8_lossy(first);
    let line = first.strip_prefix("// $ durer ").unwrap_or("check {}");
    Ok(line.split_whitespace().map(|word| word.replace("{}", &name)).collect())
}

fn run(scene: &Path) -> Result<(), Failed> {
    let output = Command::new(env!("CARGO_BIN_EXE_durer"))
        .args(command(scene)?)
        .current_dir(scene.parent().unwrap_or(Path::new(".")))
        .env_remove("DURER_INCLUDE")
        .env("DURER_FONTS", "fonts")
        .stdin(Stdio::null())
        .output()?;
    let exit = output.status.code().map_or("killed".into(), |code| code.to_string());
    let actual = format!("{}exit: {exit}\n", String::from_utf8_lossy(&output.stderr));
    let expectation = scene.with_extension("stderr");
    if std::env::var_os("UPDATE_UI").is_some() {
        return Ok(std::fs::write(expectation, actual)?);
    }
    let expected = std::fs::read_to_string(&expectation).unwrap_or_default().replace("\r\n", "\n");
    if actual == expected {
        return Ok(());
    }
    Err(format!("--- expected\n{expected}\n--- actual\n{actual}\n(UPDATE_UI=1 accepts it)").into())
}

fn every_code(folder: &Path) -> Result<(), Failed> {
    let mut reported = String::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|e| e == "stderr") {
            reported += &std::fs::read_to_string(path)?;
        }
    }
    let codes = durer::diagnostic::codes::ALL.iter().map(|e| e.code.0);
    let missing: Vec<_> = codes.filter(|code| !reported.contains(&format!("[{code}]"))).collect();
    if missing.is_empty() { Ok(()) } else { Err(format!("no case in tests/ui for {}", missing.join(", ")).into()) }
}
