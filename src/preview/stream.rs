//! Sends a page what it has not seen (WHATWG HTML, "Server-sent events"): `told` and `picture`.

use super::http;
use super::screen::{Cursor, Image, News, Screen, on_screen};
use base64::prelude::{BASE64_STANDARD, Engine};
use serde_json::json;
use std::io::{self, Write};
use std::net::TcpStream;
use std::time::Duration;

/// So often somebody who has left is noticed.
const IDLE: Duration = Duration::from_secs(5);
/// What happens within this time is sent at once.
const PAUSE: Duration = Duration::from_millis(16);

/// Sends until the page has left.
///
/// # Errors
/// That is how it ends.
pub fn send(stream: &mut TcpStream, screen: &Screen) -> io::Result<()> {
    http::begin_events(stream)?;
    let mut cursor = Cursor::default();
    loop {
        match screen.wait(&mut cursor, IDLE) {
            Some(news) => {
                stream.write_all(events(&news).as_bytes())?;
                std::thread::sleep(PAUSE);
            }
            None => stream.write_all(b":\n\n")?,
        }
    }
}

fn events(news: &News) -> String {
    let mut text = String::new();
    if let Some(told) = &news.told {
        text += &event("told", &json!({"run": news.run, "before": news.before, "told": **told}));
    }
    // Left, top, width, height, and red, green, blue and alpha of each pixel.
    let tile = |x: usize, y: usize, image: &Image| {
        json!([x, y, image.width, image.height, BASE64_STANDARD.encode(on_screen(image))])
    };
    let picture = json!({
        "run": news.run,
        "size": news.begins,
        "coarse": news.coarse.as_ref().map(|image| tile(0, 0, image)),
        "tiles": news.tiles.iter().map(|(x, y, image)| tile(*x, *y, image)).collect::<Vec<_>>(),
        "progress": news.progress,
        "done": news.done,
    });
    text + &event("picture", &picture)
}

fn event(name: &str, data: &serde_json::Value) -> String {
    format!("event: {name}\ndata: {data}\n\n")
}
