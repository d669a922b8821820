//! Answers what the page asks.

use super::guard::Guard;
use super::http::{self, Request};
use super::screen::Screen;
use super::{Studio, stream};
use crate::image_io::{Encoding, Format, encode};
use serde_json::json;
use std::io;
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::SeqCst};

/// So many are served at once.
const MAX_CONNECTIONS: usize = 64;

const PAGE: &[u8] = include_bytes!("page/index.html");
const STYLE: &[u8] = include_bytes!("page/page.css");
const ICON: &[u8] = include_bytes!("page/icon.svg");
const SCRIPT: &[u8] = include_bytes!("page/page.js");

/// Serves the page from threads of its own, and tells its address. Port 0 is any that is free.
///
/// # Errors
/// If the port is taken, or the system refuses.
pub fn serve(port: u16, studio: Arc<dyn Studio>, screen: Arc<Screen>) -> io::Result<String> {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
    let guard = Guard::new(listener.local_addr()?.port())?;
    let address = guard.address();
    let (desk, count) = (Arc::new(Desk { guard, studio, screen }), Arc::new(AtomicUsize::new(0)));
    let accept = move || {
        for stream in listener.incoming().flatten() {
            let (desk, held) = (desk.clone(), Held(count.clone()));
            if held.0.fetch_add(1, SeqCst) < MAX_CONNECTIONS {
                let _ = std::thread::Builder::new().name("page".into()).spawn(move || {
                    let _held = held;
                    // Whoever has left needs no answer.
                    let _ = desk.answer(stream);
                });
            }
        }
    };
    std::thread::Builder::new().name("pages".into()).spawn(accept)?;
    Ok(address)
}

/// One connection, as long as it lives.
struct Held(Arc<AtomicUsize>);

impl Drop for Held {
    fn drop(&mut self) {
        self.0.fetch_sub(1, SeqCst);
    }
}

struct Desk {
    guard: Guard,
    studio: Arc<dyn Studio>,
    screen: Arc<Screen>,
}

const TEXT: &str = "text/plain; charset=utf-8";
const JSON: &str = "application/json";

impl Desk {
    fn answer(&self, mut stream: TcpStream) -> io::Result<()> {
        let to = &mut stream;
        let request = match Request::read(to) {
            Ok(request) => request,
            Err(e) if e.kind() == io::ErrorKind::InvalidData => {
                return http::answer(to, "400 Bad Request", TEXT, b"no\n");
            }
            Err(e) => return Err(e),
        };
        let rest = match self.guard.admit(&request.path, |name| request.header(name)) {
            Ok(rest) => rest,
            Err(why) => return http::answer(to, "403 Forbidden", TEXT, format!("{why}\n").as_bytes()),
        };
        match (&request.method[..], rest) {
            ("GET", "") => http::answer(to, "200 OK", "text/html; charset=utf-8", PAGE),
            ("GET", "page.css") => http::answer(to, "200 OK", "text/css; charset=utf-8", STYLE),
            ("GET", "page.js") => http::answer(to, "200 OK", "text/javascript; charset=utf-8", SCRIPT),
            ("GET", "icon.svg") => http::answer(to, "200 OK", "image/svg+xml", ICON),
            ("GET", "events") => stream::send(to, &self.screen),
            ("GET", "before.png") => self.before(to),
            ("GET", "pick") => {
                let (x, y) = (request.number("x").unwrap_or(0), request.number("y").unwrap_or(0));
                http::answer(to, "200 OK", JSON, self.studio.pick(x, y).to_string().as_bytes())
            }
            ("POST", "change") => match serde_json::from_slice(&request.body) {
                Ok(change) => {
                    self.studio.change(change);
                    http::answer(to, "200 OK", JSON, b"{}")
                }
                Err(_) => refuse(to, "this is no change of the settings"),
            },
            ("POST", "open") => match serde_json::from_slice(&request.body) {
                Ok(place) => tell(to, self.studio.open(&place).map(|()| String::new())),
                Err(_) => refuse(to, "this is no place"),
            },
            ("POST", "save") => tell(to, self.studio.save()),
            _ => http::answer(to, "404 Not Found", TEXT, b"nothing is here\n"),
        }
    }

    fn before(&self, to: &mut TcpStream) -> io::Result<()> {
        let image = self.screen.before();
        let encoding = Encoding { alpha: true, ..Encoding::new(Format::Png) };
        match image.and_then(|image| encode(&image, &encoding).ok()) {
            Some(png) => http::answer(to, "200 OK", "image/png", &png),
            None => http::answer(to, "404 Not Found", TEXT, b"there was no picture before\n"),
        }
    }
}

fn refuse(to: &mut TcpStream, why: &str) -> io::Result<()> {
    http::answer(to, "400 Bad Request", JSON, json!({"error": why}).to_string().as_bytes())
}

fn tell(to: &mut TcpStream, done: Result<String, String>) -> io::Result<()> {
    match done {
        Ok(text) => http::answer(to, "200 OK", JSON, json!({"text": text}).to_string().as_bytes()),
        Err(why) => refuse(to, &why),
    }
}
