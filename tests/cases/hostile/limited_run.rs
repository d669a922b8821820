//! Where a case is run: the command in an empty folder, with little memory and little time.

use libtest_mimic::Failed;
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// Whoever takes longer hangs.
const PATIENCE: Duration = Duration::from_secs(20);
/// Kilobytes of address space; 512 MB of them are the stack that is set aside for nested text.
const MEMORY: u32 = 2_000_000;
/// What stands in the picture's file before the run.
const OLD: &[u8] = b"an older picture";

/// One hostile input, and how the command has to end.
pub struct Case {
    pub name: &'static str,
    /// `a.scene`; without it there is none.
    scene: Option<Vec<u8>>,
    /// Other files.
    files: Vec<(&'static str, Vec<u8>)>,
    args: &'static str,
    exit: i32,
    told: &'static [&'static str],
}

/// A scene and what is told of it; drawn small, into `out.png`.
pub fn case(name: &'static str, scene: impl Into<Vec<u8>>, exit: i32, told: &'static [&'static str]) -> Case {
    let args = "render a.scene -o out.png --size 8x6 --threads 2";
    Case { name, scene: Some(scene.into()), files: vec![], args, exit, told }
}

/// The same with a camera and a light behind it.
pub fn drawn(name: &'static str, scene: impl Into<String>, exit: i32, told: &'static [&'static str]) -> Case {
    case(
        name,
        scene.into() + "\ncamera { location <0, 0, -5> look_at 0 }\nlight_source { <3, 4, -5> rgb 1 }\n",
        exit,
        told,
    )
}

impl Case {
    /// A file beside the scene.
    pub fn with(mut self, name: &'static str, bytes: impl Into<Vec<u8>>) -> Self {
        self.files.push((name, bytes.into()));
        self
    }

    /// Another command line.
    pub fn args(self, args: &'static str) -> Self {
        Self { args, ..self }
    }

    /// Without `a.scene`.
    pub fn absent(self) -> Self {
        Self { scene: None, ..self }
    }

    /// Runs the command and judges how it ends.
    pub fn run(&self) -> Result<(), Failed> {
        let arena = Arena::new()?;
        for (name, bytes) in &self.files {
            arena.put(name, bytes)?;
        }
        self.scene.iter().try_for_each(|scene| arena.put("a.scene", scene))?;
        arena.put("out.png", OLD)?;
        let before = arena.names()?;
        let ended = arena.run(self.args, Stdio::null())?;
        ended.judge(self.exit, self.told)?;
        let picture = std::fs::read(arena.path().join("out.png"))?;
        let draws = self.args.contains("-o out.png");
        if (self.exit != 0 || !draws) && picture != OLD {
            return Err("the older picture was touched".into());
        }
        if self.exit == 0 && draws && !is_whole_png(&picture) {
            return Err("no whole picture was written".into());
        }
        let after = arena.names()?;
        if before == after { Ok(()) } else { Err(format!("files before: {before:?}, after: {after:?}").into()) }
    }
}

fn is_whole_png(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x89PNG") && bytes.ends_with(b"IEND\xaeB`\x82")
}

/// An empty folder.
pub struct Arena(tempfile::TempDir);

/// How a command ended.
pub struct Ended {
    pub status: ExitStatus,
    pub stderr: String,
}

impl Arena {
    pub fn new() -> Result<Self, Failed> {
        Ok(Self(tempfile::tempdir()?))
    }

    pub fn path(&self) -> &Path {
        self.0.path()
    }

    pub fn put(&self, name: &str, bytes: impl AsRef<[u8]>) -> Result<(), Failed> {
        Ok(std::fs::write(self.path().join(name), bytes)?)
    }

    pub fn names(&self) -> Result<Vec<String>, Failed> {
        let entries = std::fs::read_dir(self.path())?;
        let mut names: Vec<_> = entries.flatten().map(|e| e.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        Ok(names)
    }

    /// The command with a shell around it that rations memory, where there is one.
    fn command(&self, line: &str) -> Command {
        let exe = env!("CARGO_BIN_EXE_durer");
        let mut command = match cfg!(unix) {
            true => Command::new("sh"),
            false => Command::new(exe),
        };
        if cfg!(unix) {
            command.args(["-c", &format!("ulimit -c 0; ulimit -v {MEMORY}; exec \"$0\" \"$@\""), exe]);
        }
        command.args(line.split_whitespace()).current_dir(self.path()).env_remove("DURER_INCLUDE");
        command
    }

    /// Runs it to its end, or for as long as anybody waits.
    pub fn run(&self, line: &str, stdin: Stdio) -> Result<Ended, Failed> {
        let mut command = self.command(line);
        let child = command.stdin(stdin).stdout(Stdio::null()).stderr(Stdio::piped()).spawn()?;
        finish(child)
    }

    /// Starts it with its standard output open.
    pub fn start(&self, line: &str, stdout: Stdio) -> Result<Child, Failed> {
        Ok(self.command(line).stdin(Stdio::null()).stdout(stdout).stderr(Stdio::piped()).spawn()?)
    }
}

/// Waits for the end.
pub fn finish(mut child: Child) -> Result<Ended, Failed> {
    let mut pipe = child.stderr.take().ok_or("no stderr")?;
    let reader = std::thread::spawn(move || {
        let mut bytes = vec![];
        pipe.read_to_end(&mut bytes).map(|_| String::from_utf8_lossy(&bytes).into_owned())
    });
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if start.elapsed() > PATIENCE {
            child.kill()?;
            child.wait()?;
            return Err(format!("hangs: killed after {PATIENCE:?}").into());
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    let stderr = reader.join().map_err(|_| "the reader of stderr failed")??;
    Ok(Ended { status, stderr })
}

impl Ended {
    /// The right exit code, no signal, no panic, and all that has to be told.
    pub fn judge(&self, exit: i32, told: &[&str]) -> Result<(), Failed> {
        let stderr: String = self.stderr.chars().take(4000).collect();
        if std::env::var_os("HOSTILE_SHOW").is_some() {
            println!("--- {:?}\n{stderr}", self.status);
        }
        let Some(code) = self.status.code() else {
            return Err(format!("ended by a signal: {}\n{stderr}", self.status).into());
        };
        if self.stderr.contains("panicked") {
            return Err(format!("panicked\n{stderr}").into());
        }
        let missing: Vec<_> = told.iter().filter(|text| !self.stderr.contains(**text)).collect();
        if code != exit || !missing.is_empty() {
            return Err(format!("exit code {code} (expected {exit}); not told: {missing:?}\n{stderr}").into());
        }
        // Whoever fails says why.
        if code != 0 && self.stderr.trim().is_empty() {
            return Err("failed without a word".into());
        }
        // A message about a line of a million letters is still a message.
        if self.stderr.len() > 200_000 {
            return Err(format!("{} bytes of messages", self.stderr.len()).into());
        }
        Ok(())
    }
}

/// Text that is repeated.
pub fn nested(open: &str, inner: &str, close: &str, depth: usize) -> String {
    open.repeat(depth) + inner + &close.repeat(depth)
}
