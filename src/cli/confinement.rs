//! Confinement of the process by Landlock, a security module of Linux. With `--untrusted`, the process can open only
//! the files of its command and no network connection, so a fault in a decoder cannot reach anything else.
//!
//! The scene itself is restricted by [`Sandbox`](crate::source::Sandbox); Landlock is the second line of defence.

use super::args::{Command, SceneArgs, environment_is_untrusted, values::Stats};
use super::console::Console;
use super::session;
use std::path::{Path, PathBuf};

/// Files and folders that a command opens.
#[derive(Debug, Default, PartialEq)]
struct FileAccess {
    read: Vec<PathBuf>,
    /// Folders in which the command creates, replaces and reads files.
    write: Vec<PathBuf>,
}

/// Confines this thread, and all threads that it starts, to the files of an untrusted command; does nothing for a trusted
/// one. `durer watch` is never confined, since it serves a page and starts an editor. Prints a note if Linux has no
/// Landlock.
pub fn confine(console: &Console, command: &Command) {
    let Some(access) = untrusted_file_access(command) else { return };
    if !restrict_thread_at_least_partly(access) && cfg!(target_os = "linux") {
        console.info("this system has no Landlock: only durer's own rules confine the untrusted scene\n");
    }
}

/// Returns the files of an untrusted command; `None` if the command is trusted, or is never confined, as `durer watch`.
fn untrusted_file_access(command: &Command) -> Option<FileAccess> {
    let scene_access = |scene: &SceneArgs, inputs: &[PathBuf]| {
        let mut access = FileAccess::default();
        access.read.extend(inputs.iter().flat_map(|input| paths_readable_for_input(input)));
        access.read.extend(scene.include.iter().chain(&scene.allow_read).cloned());
        scene.is_untrusted().then_some(access)
    };
    match command {
        Command::Render(args) => {
            let mut access = scene_access(&args.scene, &args.inputs)?;
            let stats = match &args.stats {
                Some(Stats::File(path)) => Some(path),
                _ => None,
            };
            access.read.extend(args.prepared.iter().chain(&args.load_radiosity).cloned());
            let files = args.output.iter().chain(&args.deps).chain(stats).chain(&args.save_radiosity);
            access.write = files.map(|path| folder_written_to(path)).collect();
            if args.output.is_none() {
                access.write.push(".".into());
            }
            Some(access)
        }
        Command::Prepare(args) => {
            let mut access = scene_access(&args.scene, std::slice::from_ref(&args.input))?;
            access.write.push(args.output.as_deref().map_or(PathBuf::from("."), folder_written_to));
            Some(access)
        }
        Command::Check(args) => scene_access(&args.scene, &args.inputs),
        Command::Pick(args) => scene_access(&args.scene, std::slice::from_ref(&args.input)),
        Command::Query(args) => scene_access(&args.scene, std::slice::from_ref(&args.input)),
        Command::Test(args) => {
            let here = [PathBuf::from(".")];
            let paths = if args.paths.is_empty() { &here[..] } else { &args.paths };
            let read = paths
                .iter()
                .flat_map(|path| paths_readable_for_input(path))
                .chain(args.include.iter().cloned())
                .collect();
            let snapshots = paths.iter().filter(|_| args.accept).map(|path| folder_written_to(path));
            let write = snapshots.chain(args.report.iter().map(|folder| parent_or_current_folder(folder))).collect();
            environment_is_untrusted().then_some(FileAccess { read, write })
        }
        _ => None,
    }
}

/// Returns the paths that an input makes readable: a folder itself, or the folder of a scene. The scene's own path is
/// added for pipes such as `/dev/fd/63`.
fn paths_readable_for_input(input: &Path) -> Vec<PathBuf> {
    let input = session::existing_scene_path(input);
    let folder = if input.is_dir() { input.clone() } else { parent_or_current_folder(&input) };
    vec![folder, input]
}

/// Returns the folder that a file is written into; `path` itself if it is a folder.
fn folder_written_to(path: &Path) -> PathBuf {
    if path.is_dir() { path.into() } else { parent_or_current_folder(path) }
}

fn parent_or_current_folder(path: &Path) -> PathBuf {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new(".")).into()
}

/// Restricts this thread, and those that it starts later, by Landlock, as far as the kernel supports Landlock. Returns true
/// if the kernel enforces at least a part of the rules.
#[cfg(target_os = "linux")]
fn restrict_thread_at_least_partly(access: FileAccess) -> bool {
    try_restrict_thread(access).is_ok_and(|status| status != landlock::RulesetStatus::NotEnforced)
}

/// Restricts the thread as far as the kernel's version of Landlock can: files; since Linux 6.7 connections; since 6.12
/// signals and sockets without a file.
#[cfg(target_os = "linux")]
fn try_restrict_thread(access: FileAccess) -> Result<landlock::RulesetStatus, landlock::RulesetError> {
    use landlock::{ABI, Access, AccessFs, AccessNet, Ruleset, RulesetAttr, RulesetCreatedAttr, Scope};
    let abi = ABI::V6;
    let read = AccessFs::ReadFile | AccessFs::ReadDir;
    let write = read
        | AccessFs::WriteFile
        | AccessFs::Truncate
        | AccessFs::MakeReg
        | AccessFs::MakeDir
        | AccessFs::RemoveFile
        | AccessFs::Refer;
    // What the memory limit and the journal's identity of the program need.
    let system = ["/proc/self/limits", "/proc/self/status", "/proc/self/cgroup", "/proc/meminfo", "/sys/fs/cgroup"];
    let of_process = system.into_iter().map(PathBuf::from).chain(std::env::current_exe());
    let status = Ruleset::default()
        .handle_access(AccessFs::from_all(abi))?
        .handle_access(AccessNet::from_all(abi))?
        .scope(Scope::from_all(abi))?
        .create()?
        .add_rules(landlock::path_beneath_rules(access.read.into_iter().chain(of_process), read))?
        .add_rules(landlock::path_beneath_rules(access.write, write))?
        .restrict_self()?;
    Ok(status.ruleset)
}

#[cfg(not(target_os = "linux"))]
fn restrict_thread_at_least_partly(_: FileAccess) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Cli;
    use clap::Parser;

    fn access(line: &str) -> Option<(Vec<String>, Vec<String>)> {
        let command = Cli::try_parse_from(line.split(' ')).unwrap().command;
        let texts = |paths: Vec<PathBuf>| paths.iter().map(|path| path.display().to_string()).collect();
        untrusted_file_access(&command).map(|access| (texts(access.read), texts(access.write)))
    }

    #[test]
    fn commands_open_the_folders_that_they_name() {
        let (read, write) =
            access("durer render a/b.pov -o c/d.png -I lib --allow-read e --untrusted --deps f/g --stats h/i").unwrap();
        assert_eq!(read, ["a", "a/b.pov", "lib", "e"]);
        assert_eq!(write, ["c", "f", "h"]);
        assert_eq!(access("durer render b.pov --untrusted").unwrap().1, ["."]);
        let light = "durer render b.pov -o b.png --untrusted --prepared d/e --load-radiosity f/g --save-radiosity h/i";
        let (read, write) = access(light).unwrap();
        assert_eq!(
            (&read[2..], &write[..]),
            (&["d/e", "f/g"].map(String::from)[..], &[".", "h"].map(String::from)[..])
        );
        assert_eq!(access("durer prepare b.pov --untrusted -o j/k").unwrap().1, ["j"]);
        assert_eq!(access("durer check b.pov --untrusted").unwrap(), (vec![".".into(), "b.pov".into()], vec![]));
        assert_eq!(access("durer check b.pov"), None);
        assert_eq!(access("durer watch b.pov --untrusted"), None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_confined_thread_opens_nothing_else() {
        let (inner, outer) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        let (seen, secret) = (inner.path().join("a"), outer.path().join("b"));
        std::fs::write(&seen, "1").unwrap();
        std::fs::write(&secret, "2").unwrap();
        let access = FileAccess { read: vec![inner.path().into()], write: vec![] };
        let confined = std::thread::spawn(move || {
            restrict_thread_at_least_partly(access).then(|| {
                let reads = [&seen, &secret].map(|path| std::fs::read(path).is_ok());
                (reads, std::fs::write(&seen, "3").is_ok())
            })
        });
        // (`None` on a kernel without Landlock.)
        if let Some(opened) = confined.join().unwrap() {
            assert_eq!(opened, ([true, false], false));
        }
    }
}
