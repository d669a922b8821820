//! The option `--stats`: times, numbers of rays and memory of each picture.

use super::pass_times::PassTime;
use crate::cli::args::values::Stats;
use crate::cli::console::Console;
use crate::cli::exit::Result;
use crate::cli::memory;
use crate::diagnostic::file;
use crate::render::{self, RayCounts};
use crate::source::{Disk, Files};
use serde::Serialize;
use std::time::Duration;

/// Measurements of one rendered picture: times and counters.
#[derive(Serialize, Debug)]
pub struct Report {
    times: Times,
    /// Passes before the picture, such as the emission of photons.
    passes: Vec<PassTime>,
    rays: RayCounts,
    /// Largest memory of the process so far, in bytes; null if the system does not report it.
    peak_memory: Option<u64>,
    threads: usize,
    width: usize,
    height: usize,
}

/// Durations of a render's phases in seconds.
#[derive(Serialize, Debug)]
struct Times {
    /// Time of parsing the text into a scene, in seconds.
    parse: f64,
    /// Time of building a world from the scene, in seconds.
    build: f64,
    /// Time of tracing the world into pixels, in seconds.
    trace: f64,
    /// Time of encoding the pixels into a file, in seconds. The pieces of a PNG file that the threads of the render compress
    /// belong to `trace`.
    encode: f64,
    total: f64,
}

impl Report {
    /// Creates a report. The durations are those of parsing, building, tracing and encoding, and of the whole work, which is
    /// more than their sum.
    pub fn new(
        parse_build_trace_encode_total: [Duration; 5],
        passes: Vec<PassTime>,
        rays: RayCounts,
        options: &render::Options,
    ) -> Self {
        let [parse, build, trace, encode, total] = parse_build_trace_encode_total.map(|t| t.as_secs_f64());
        let processors = || std::thread::available_parallelism().map_or(1, usize::from);
        Self {
            times: Times { parse, build, trace, encode, total },
            passes,
            rays,
            peak_memory: memory::peak_memory(),
            threads: if options.threads == 0 { processors() } else { options.threads },
            width: options.width,
            height: options.height,
        }
    }
}

/// Writes the last report to standard output, or all reports to a file: one line for each picture.
pub fn write(reports: &[Report], console: &Console, stats: &Stats) -> Result<()> {
    match stats {
        Stats::Json => reports.last().map_or(Ok(()), |report| console.write_json_to_stdout(report)),
        Stats::File(path) => {
            let text: String = reports.iter().filter_map(|r| serde_json::to_string(r).ok()).map(|r| r + "\n").collect();
            Ok(Disk.write(path, text.as_bytes()).map_err(|e| Box::new(file::unwritable(&Disk, path, &e)))?)
        }
    }
}
