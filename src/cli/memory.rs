//! Is there memory for the picture?

use super::values::Size;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::render::Region;
use crate::source::Span;

/// Bytes a pixel takes while it is drawn: in its tile, in the picture of all tiles, and in the frame. (Measured with
/// `/usr/bin/time -v` on pictures of 3 to 48 million pixels, as is the next.)
const ONCE: u128 = 49;
/// The same with anti-aliasing, which keeps the picture of the first pass.
const TWICE: u128 = 57;
/// A pixel that is not drawn (`--region`) takes room in the file alone.
const UNDRAWN: u128 = 4;

/// E0006 if a picture of this size, or a part of it, has no room in what `--max-memory` allows, or in what is free.
pub fn check_drawing(size: Size, part: Option<Region>, antialias: bool, limit: Option<u64>) -> Result<()> {
    let pixels = |width: usize, height: usize| (width as u128).saturating_mul(height as u128);
    let whole = pixels(size.width, size.height);
    let drawn = part.map_or(whole, |part| pixels(part.width, part.height).min(whole));
    let needed = drawn
        .saturating_mul(if antialias { TWICE } else { ONCE })
        .saturating_add((whole - drawn).saturating_mul(UNDRAWN));
    let fault = |rest: String| {
        let text = format!("a picture of {}x{} takes {} of memory; {rest}", size.width, size.height, in_words(needed));
        let help = "draw it smaller with `--size`, or a part of it with `--region`";
        Diagnostic::new(codes::PICTURE_TOO_LARGE, Span::NONE, text).help(help).into()
    };
    if let Some(limit) = limit {
        if needed > u128::from(limit) {
            return fault(format!("`--max-memory` allows {}", in_words(limit.into())));
        }
    } else if let Some(free) = available().filter(|&free| needed > u128::from(free)) {
        return fault(format!("{} are free", in_words(free.into())));
    }
    match usize::try_from(needed).map(|bytes| Vec::<u8>::new().try_reserve_exact(bytes)) {
        Ok(Ok(())) => Ok(()),
        _ => fault("the system doesn't give so much".into()),
    }
}

/// What a scene may use if nothing else is said: most of what is free, so that a run-away scene ends in a message before the
/// system ends it.
pub fn default_limit() -> Option<u64> {
    let most = available().map(|free| free / 10 * 9);
    // A list that grows needs new room beside the old; in a rationed address space both count.
    let rationed = address_space().map(|free| free / 3);
    most.into_iter().chain(rationed).min()
}

/// What is left in bytes where `ulimit -v` rations addresses.
fn address_space() -> Option<u64> {
    let limits = std::fs::read_to_string("/proc/self/limits").ok()?;
    let line = limits.lines().find_map(|line| line.strip_prefix("Max address space"))?;
    let limit: u64 = line.split_whitespace().next()?.parse().ok()?;
    Some(limit.saturating_sub(kilobytes("/proc/self/status", "VmSize:")?))
}

/// Free memory in bytes, where the system tells.
fn available() -> Option<u64> {
    kilobytes("/proc/meminfo", "MemAvailable:")
}

/// The most memory this process ever used, in bytes, where the system tells.
pub fn peak() -> Option<u64> {
    kilobytes("/proc/self/status", "VmHWM:")
}

fn kilobytes(file: &str, key: &str) -> Option<u64> {
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
    fn what_is_too_large_is_refused() {
        assert!(check_drawing(Size { width: 640, height: 480 }, None, true, None).is_ok());
        assert!(check_drawing(Size { width: 640, height: 480 }, None, true, Some(1000)).is_err());
        assert!(check_drawing(Size { width: 1_000_000, height: 1_000_000 }, None, true, None).is_err());
        assert!(check_drawing(Size { width: usize::MAX, height: usize::MAX }, None, true, None).is_err());
        assert!(check_drawing(Size { width: usize::MAX, height: usize::MAX }, None, true, Some(u64::MAX)).is_err());
    }

    #[test]
    fn less_is_needed_for_a_part_and_without_anti_aliasing() {
        let size = Size { width: 1000, height: 1000 };
        let half = Some(Region { x: 0, y: 0, width: 1000, height: 500 });
        let fits = |part, antialias, limit| check_drawing(size, part, antialias, Some(limit)).is_ok();
        assert!(fits(None, true, 57_000_000) && !fits(None, true, 56_999_999));
        assert!(fits(None, false, 49_000_000) && !fits(None, false, 48_999_999));
        assert!(fits(half, false, 26_500_000) && !fits(half, false, 26_499_999));
    }

    #[test]
    fn sizes_in_words() {
        assert_eq!([0, 999, 1000, 32_000_000_000_000].map(in_words), ["0 bytes", "999 bytes", "1 KB", "32 TB"]);
    }
}
