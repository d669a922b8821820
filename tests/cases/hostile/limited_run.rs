//! Runs the command in an empty folder, with limits on memory and time.

use libtest_mimic::Failed;
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// Time after which a command counts as hanging.
const PATIENCE: Duration = Duration::from_secs(20);
/// Maximum address space in kilobytes; 512 MB of it are the stack that is reserved for nested text.
const MEMORY: u32 = 2_000_000;
/// Contents of the picture's file before the run.
const OLD: &[u8] = b"\x89PNG\r\n\x1a\n of an older picture";

/// A hostile input, and the expected end of the command.
pub struct Case {
    pub name: &'static str,
    /// `a.scene`, if it exists.
    scene: Option<Vec<u8>>,
    /// Other files.
    files: Vec<(&'static str, Vec<u8>)>,
    args: &'static str,
    exit: i32,
    told: &'static [&'static str],
}

/// A scene and its expected messages; rendered small, into `out.png`.
pub fn case(name: &'static str, scene: impl Into<Vec<u8>>, exit: i32, told: &'static [&'static str]) -> Case {
    let args = "render a.scene -o out.png --size 8x6 --threads 2";
    Case { name, scene: Some(scene.into()), files: vec![], args, exit, told }
}

/// [`case`] with a camera and a light appended.
pub fn drawn(name: &'static str, scene: impl Into<String>, exit: i32, told: &'static [&'static str]) -> Case {
    case(
        name,
        scene.into() + "\ncamera { location <0, 0, -5> look_at 0 }\nlight_source { <3, 4, -5> rgb 1 }\n",
        exit,
        told,
    )
}

impl Case {
    /// Adds a file beside the scene.
    pub fn with(mut self, name: &'static str, bytes: impl Into<Vec<u8>>) -> Self {
        self.files.push((name, bytes.into()));
        self
    }

    /// Replaces the command line.
    pub fn args(self, args: &'static str) -> Self {
        Self { args, ..self }
    }

    /// Removes `a.scene`.
    pub fn absent(self) -> Self {
        Self { scene: None, ..self }
    }

    /// Runs the command and checks its end.
    pub fn run(&self) -> Result<(), Failed> {
        let folder = ScratchFolder::new()?;
        for (name, bytes) in &self.files {
            folder.put(name, bytes)?;
        }
        self.scene.iter().try_for_each(|scene| folder.put("a.scene", scene))?;
        folder.put("out.png", OLD)?;
        let before = folder.names()?;
        let ended = folder.run(self.args, Stdio::null())?;
        ended.judge(self.exit, self.told)?;
        let picture = std::fs::read(folder.path().join("out.png"))?;
        let draws = self.args.contains("-o out.png");
        if (self.exit != 0 || !draws) && picture != OLD {
            return Err("the older picture was touched".into());
        }
        if self.exit == 0 && draws && !is_whole_png(&picture) {
            return Err("no whole picture was written".into());
        }
        let after = folder.names()?;
        if before == after { Ok(()) } else { Err(format!("files before: {before:?}, after: {after:?}").into()) }
    }
}

fn is_whole_png(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x89PNG") && bytes.ends_with(b"IEND\xaeB`\x82")
}

/// An empty folder.
pub struct ScratchFolder(tempfile::TempDir);

/// Result of a command.
pub struct Ended {
    pub status: ExitStatus,
    pub stderr: String,
}

impl ScratchFolder {
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

    /// The command in a shell that limits memory, where there is a shell.
    pub fn command(&self, line: &str) -> Command {
        let exe = env!("CARGO_BIN_EXE_durer");
        let mut command = match cfg!(unix) {
            true => Command::new("sh"),
            false => Command::new(exe),
        };
        if cfg!(unix) {
            command.args(["-c", &format!("ulimit -c 0; ulimit -v {MEMORY}; exec \"$0\" \"$@\""), exe]);
        }
        command.args(line.split_whitespace()).current_dir(self.path()).env_remove("DURER_INCLUDE");
        command.env("XDG_STATE_HOME", std::env::temp_dir().join("durer-tests"));
        command
    }

    /// Runs the command until it ends or hangs.
    pub fn run(&self, line: &str, stdin: Stdio) -> Result<Ended, Failed> {
        let mut command = self.command(line);
        let child = command.stdin(stdin).stdout(Stdio::null()).stderr(Stdio::piped()).spawn()?;
        finish(child)
    }

    /// Starts the command with piped output.
    pub fn start(&self, line: &str, stdout: Stdio) -> Result<Child, Failed> {
        Ok(self.command(line).stdin(Stdio::null()).stdout(stdout).stderr(Stdio::piped()).spawn()?)
    }
}

/// Waits for the command's end.
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
    /// Checks the exit code and the messages, and that there was no signal or panic.
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
        // A failure needs a message.
        if code != 0 && self.stderr.trim().is_empty() {
            return Err("failed without a word".into());
        }
        // A message about a line of a million characters must be short.
        if self.stderr.len() > 200_000 {
            return Err(format!("{} bytes of messages", self.stderr.len()).into());
        }
        Ok(())
    }
}

/// `inner` inside `depth` openers and closers.
pub fn nested(open: &str, inner: &str, close: &str, depth: usize) -> String {
    open.repeat(depth) + inner + &close.repeat(depth)
}
