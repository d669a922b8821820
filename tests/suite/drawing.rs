//! Pictures of scenes that a test writes.

use durer::{BuildOptions, Frame, Memory, RayCounts, RenderOptions, Sources, Unwatched};
use std::sync::Arc;

/// Renders a scene into memory. The text must have no errors.
#[track_caller]
pub fn draw(text: &str, options: &RenderOptions) -> (Frame, RayCounts) {
    let sources = Sources::new(Arc::new(Memory::default()));
    let file = durer::load_bytes(&sources, "main.scene", text.as_bytes()).unwrap();
    let build = BuildOptions { size: (options.width, options.height), ..BuildOptions::default() };
    let built = durer::build(&sources, file, &build, &mut |_| {});
    let world = built.world.unwrap_or_else(|| panic!("{:?}\n{text}", built.diagnostics));
    durer::render(&world, options, &Unwatched).unwrap()
}

/// Asserts that a scene has the same bytes with 1, 2 and 7 threads, and that a region is a part of the whole picture.
#[track_caller]
pub fn is_independent_of_threads_and_region(text: &str, width: usize, height: usize) {
    let whole = draw(text, &RenderOptions::new(width, height)).0;
    for threads in [2, 7] {
        let options = RenderOptions { threads, ..RenderOptions::new(width, height) };
        assert!(draw(text, &options).0.pixels == whole.pixels, "{threads} threads give other bytes than 1");
    }
    let part = durer::Region { x: width / 6, y: height / 4, width: width / 2, height: height / 2 };
    let region = draw(text, &RenderOptions { region: Some(part), ..RenderOptions::new(width, height) }).0;
    for y in part.y..part.y + part.height {
        let row = y * width + part.x..y * width + part.x + part.width;
        assert!(region.pixels[row.clone()] == whole.pixels[row], "row {y} of a region differs from the whole picture");
    }
}

/// Returns the mean of the red channel.
pub fn mean(frame: &Frame) -> f64 {
    frame.pixels.iter().map(|pixel| f64::from(pixel[0])).sum::<f64>() / frame.pixels.len() as f64
}

/// Asserts that two numbers differ by less than the relative `tolerance`.
#[track_caller]
pub fn is_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found}, expected {expected}");
}
