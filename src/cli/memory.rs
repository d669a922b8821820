//! Checks whether memory suffices for a picture.

use super::args::values::Size;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::render::{self, Region};
use crate::source::Span;
use std::path::Path;

/// Maximum number of pixels of a picture; more would take years.
const MAX_PIXELS: u128 = 1 << 36;

/// Refuses a picture with more than [`MAX_PIXELS`] (E0006).
pub fn check_pixel_count(size: Size) -> Result<()> {
    check_pixel_limit(size, MAX_PIXELS)
}

/// Refuses a picture with more than `max_pixels` pixels (E0006).
pub fn check_pixel_limit(size: Size, max_pixels: u128) -> Result<()> {
    if size.width as u128 * size.height as u128 <= max_pixels {
        return Ok(());
    }
    let text = format!("a picture of {}x{} is too large: {max_pixels} pixels are the most", size.width, size.height);
    Diagnostic::new(codes::PICTURE_TOO_LARGE, Span::NONE, text).help("make it smaller with `--size`").into()
}

/// Refuses a picture, or a part of it, that needs more memory in bytes than `limit` (`--max-memory`), or without a limit
/// than is free, or more than the system can allocate (E0006). Each pixel of the whole picture occupies `bytes_per_pixel`
/// bytes until the file is finished.
pub fn check_memory(size: Size, part: Option<Region>, bytes_per_pixel: usize, limit: Option<u64>) -> Result<()> {
    check_pixel_count(size)?;
    let Size { width, height } = size;
    let rendered = part.unwrap_or(Region { x: 0, y: 0, width, height });
    let needed =
        (width as u128 * height as u128 * bytes_per_pixel as u128).saturating_add(render::memory_bytes(rendered));
    let fault = |rest: String| {
        let text = format!("a picture of {}x{} takes {} of memory; {rest}", size.width, size.height, in_words(needed));
        let help = "make it smaller with `--size`, or render a part of it with `--region`";
        Diagnostic::new(codes::PICTURE_TOO_LARGE, Span::NONE, text).help(help).into()
    };
    if let Some(limit) = limit {
        if needed > u128::from(limit) {
            return fault(format!("`--max-memory` allows {}", in_words(limit.into())));
        }
    } else if let Some(free) = free_memory().filter(|&free| needed > u128::from(free)) {
        return fault(format!("{} are free", in_words(free.into())));
    }
    match usize::try_from(needed).map(|bytes| Vec::<u8>::new().try_reserve_exact(bytes)) {
        Ok(Ok(())) => Ok(()),
        _ => fault("the system refuses to allocate it".into()),
    }
}

/// Returns the memory limit without `--max-memory`, in bytes: most of the free memory, so that a runaway scene ends with
/// a message before the system kills the process. `None` if the system does not report the free memory.
pub fn default_memory_limit() -> Option<u64> {
    let most = free_memory().map(|free| free / 10 * 9);
    // A growing list is copied: in a limited address space the old and the new copy both count.
    let limited = free_address_space().map(|free| free / 3);
    most.into_iter().chain(limited).min()
}

/// Returns the memory in bytes above which the process ends at once, whatever it is doing: more than the interpreter's
/// limit, whose messages have a position in the text. Without `--max-memory`, most of the free memory.
pub fn hard_memory_limit_bytes(limit: Option<u64>) -> Option<u64> {
    limit.map(|bytes| bytes.saturating_add(HARD_LIMIT_MARGIN)).or_else(|| free_memory().map(|free| free / 20 * 19))
}

/// Number of bytes by which the process may exceed `--max-memory` before it ends at once.
const HARD_LIMIT_MARGIN: u64 = 32 << 20;

/// Returns the address space that `ulimit -v` leaves, in bytes; `None` without such a limit.
fn free_address_space() -> Option<u64> {
    let limits = std::fs::read_to_string("/proc/self/limits").ok()?;
    let line = limits.lines().find_map(|line| line.strip_prefix("Max address space"))?;
    let limit: u64 = line.split_whitespace().next()?.parse().ok()?;
    Some(limit.saturating_sub(read_kilobytes_as_bytes("/proc/self/status", "VmSize:")?))
}

/// Returns the free memory of the machine and the process's control groups, in bytes; `None` if it is not reported.
fn free_memory() -> Option<u64> {
    let groups = std::fs::read_to_string("/proc/self/cgroup").unwrap_or_default();
    let in_groups = groups.lines().filter_map(|line| line.strip_prefix("0::")).flat_map(|group| {
        Path::new("/sys/fs/cgroup")
            .join(group.trim_start_matches('/'))
            .ancestors()
            .map(Path::to_path_buf)
            .collect::<Vec<_>>()
    });
    let limits = in_groups.filter_map(|group| {
        let number = |name: &str| std::fs::read_to_string(group.join(name)).ok()?.trim().parse::<u64>().ok();
        Some(number("memory.max")?.saturating_sub(number("memory.current")?))
    });
    limits.chain(read_kilobytes_as_bytes("/proc/meminfo", "MemAvailable:")).min()
}

/// Returns the largest memory of this process so far, in bytes; `None` if the system does not report it.
pub fn peak_memory() -> Option<u64> {
    read_kilobytes_as_bytes("/proc/self/status", "VmHWM:")
}

fn read_kilobytes_as_bytes(file: &str, key: &str) -> Option<u64> {
    let text = std::fs::read_to_string(file).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(key))?;
    Some(line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()? * 1024)
}

fn in_words(bytes: u128) -> String {
    let units = ["bytes", "KB", "MB", "GB", "TB", "PB", "EB", "ZB", "YB"];
    let (mut x, mut unit) = (bytes as f64, 0);
    while x >= 999.5 && unit + 1 < units.len() {
        (x, unit) = (x / 1000.0, unit + 1);
    }
    if x >= 999.5 { "more than there is in the world".into() } else { format!("{x:.0} {}", units[unit]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_that_are_too_large_are_refused() {
        let fits = |width, height, bytes_per_pixel, limit| {
            check_memory(Size { width, height }, None, bytes_per_pixel, limit).is_ok()
        };
        assert!(fits(640, 480, 0, None) && !fits(640, 480, 0, Some(1000)));
        assert!(!fits(100_000, 100_000, 16, Some(100_000_000_000)));
        assert!(!fits(1_000_000, 1_000_000, 0, None));
        assert!(!fits(usize::MAX, usize::MAX, 16, None) && !fits(usize::MAX, usize::MAX, 0, Some(u64::MAX)));
    }

    #[test]
    fn rows_that_are_written_at_once_need_no_memory() {
        let size = Size { width: 8000, height: 8000 };
        let fits = |bytes_per_pixel, limit| check_memory(size, None, bytes_per_pixel, Some(limit)).is_ok();
        assert!(fits(0, 40 << 20) && !fits(16, 1_000_000_000) && fits(16, 1_100_000_000));
    }

    #[test]
    fn sizes_have_units() {
        assert_eq!([0, 999, 1000, 32_000_000_000_000].map(in_words), ["0 bytes", "999 bytes", "1 KB", "32 TB"]);
    }
}
