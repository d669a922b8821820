//! `--stats`: times, rays and memory of one picture.

use super::args::RenderArgs;
use super::console::Console;
use super::exit::Result;
use super::memory;
use super::values::Stats;
use crate::diagnostic::file;
use crate::render::RayCounts;
use crate::source::{Disk, Files};
use serde::Serialize;
use std::time::Duration;

/// Everything measured.
#[derive(Serialize, Debug)]
pub struct Report {
    /// In seconds.
    times: Times,
    rays: RayCounts,
    /// The most that was used at once, in bytes; null where the system doesn't tell.
    peak_memory: Option<u64>,
    threads: usize,
    width: usize,
    height: usize,
}

/// In seconds.
#[derive(Serialize, Debug)]
struct Times {
    /// Text to Scene.
    parse: f64,
    /// Scene to World.
    build: f64,
    /// World to Frame.
    trace: f64,
    /// Frame to file.
    encode: f64,
    total: f64,
}

impl Report {
    /// From the times of parsing, building, tracing, encoding and all together.
    pub fn new(times: [Duration; 5], rays: RayCounts, args: &RenderArgs) -> Self {
        let [parse, build, trace, encode, total] = times.map(|t| t.as_secs_f64());
        let size = args.scene.size();
        let processors = || std::thread::available_parallelism().map_or(1, usize::from);
        Self {
            times: Times { parse, build, trace, encode, total },
            rays,
            peak_memory: memory::peak(),
            threads: args.threads.map_or_else(processors, usize::from),
            width: size.width,
            height: size.height,
        }
    }
}

/// The last report to standard output, or all of them to a file: one line for each picture.
pub fn give(reports: &[Report], console: &Console, stats: &Stats) -> Result<()> {
    match stats {
        Stats::Json => reports.last().map_or(Ok(()), |report| console.json(report)),
        Stats::File(path) => {
            let text: String = reports.iter().filter_map(|r| serde_json::to_string(r).ok()).map(|r| r + "\n").collect();
            Ok(Disk.write(path, text.as_bytes()).map_err(|e| Box::new(file::unwritable(&Disk, path, &e)))?)
        }
    }
}
