//! Sends a page the changes of the screen (WHATWG HTML, "Server-sent events"), as events `state` and
//! `picture`.

use super::http;
use super::screen::{Cursor, Image, Screen, Update, to_srgb_bytes};
use base64::prelude::{BASE64_STANDARD, Engine};
use serde_json::json;
use std::io::{self, Write};
use std::net::TcpStream;
use std::time::Duration;

/// Interval of empty messages, which detect a closed page.
const IDLE: Duration = Duration::from_secs(5);
/// Time in which changes are collected for one update.
const PAUSE: Duration = Duration::from_millis(16);

/// Sends updates until the page is closed.
///
/// # Errors
/// Always, when the connection is closed.
pub fn send_until_closed(stream: &mut TcpStream, screen: &Screen) -> io::Result<()> {
    http::begin_events(stream)?;
    let mut cursor = Cursor::default();
    loop {
        match screen.wait(&mut cursor, IDLE) {
            Some(update) => {
                stream.write_all(events(&update).as_bytes())?;
                std::thread::sleep(PAUSE);
            }
            None => stream.write_all(b":\n\n")?,
        }
    }
}

fn events(update: &Update) -> String {
    let mut text = String::new();
    if let Some(state) = &update.state {
        text += &event("state", &json!({"run": update.run, "before": update.has_previous, "state": **state}));
    }
    // Left, top, width, height, and the bytes red, green, blue and alpha of each pixel.
    let tile = |x: usize, y: usize, image: &Image| {
        json!([x, y, image.width, image.height, BASE64_STANDARD.encode(to_srgb_bytes(image))])
    };
    let picture = json!({
        "run": update.run,
        "size": update.new_size,
        "coarse": update.coarse.as_ref().map(|image| tile(0, 0, image)),
        "tiles": update.tiles.iter().map(|(x, y, image)| tile(*x, *y, image)).collect::<Vec<_>>(),
        "progress": update.progress,
        "done": update.done,
    });
    text + &event("picture", &picture)
}

fn event(name: &str, data: &serde_json::Value) -> String {
    format!("event: {name}\ndata: {data}\n\n")
}
