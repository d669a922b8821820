//! The server of the page.

use super::guard::Guard;
use super::http::{self, Request};
use super::screen::Screen;
use super::{Backend, stream};
use crate::diagnostic::INTERNAL_FAILURE;
use crate::image_io::{Encoding, Format, encode};
use serde_json::json;
use std::io;
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::SeqCst};
use std::time::Duration;

/// Largest number of simultaneous connections to the preview server.
const MAX_CONNECTIONS: usize = 64;
/// Time without new connections after the system has refused one.
const ACCEPT_PAUSE: Duration = Duration::from_millis(50);

const PAGE: &[u8] = include_bytes!("page/index.html");
const STYLE: &[u8] = include_bytes!("page/page.css");
const ICON: &[u8] = include_bytes!("page/icon.svg");
const SCRIPT: &[u8] = include_bytes!("page/page.js");

/// Serves the page on threads of its own, and returns its address. Port 0 means a free port.
///
/// # Errors
/// If the port is taken, or the system refuses.
pub fn serve(port: u16, backend: Arc<dyn Backend>, screen: Arc<Screen>) -> io::Result<String> {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
    let guard = Guard::new(listener.local_addr()?.port())?;
    let address = guard.address();
    let (server, count) = (Arc::new(Server { guard, backend, screen }), Arc::new(AtomicUsize::new(0)));
    let accept = move || {
        for stream in listener.incoming() {
            let Ok(mut stream) = stream else {
                // The process has too many open files: wait until some are closed.
                std::thread::sleep(ACCEPT_PAUSE);
                continue;
            };
            let (server, connection) = (server.clone(), Connection(count.clone()));
            if connection.0.fetch_add(1, SeqCst) >= MAX_CONNECTIONS {
                // The short response fits into the socket's buffer: the write does not block.
                let _ = http::answer(&mut stream, "503 Service Unavailable", TEXT, b"too many connections\n");
                continue;
            }
            let _ = std::thread::Builder::new().name("page".into()).spawn(move || {
                let _connection = connection;
                // A failed response means that the client is gone.
                let _ = server.answer(&mut stream);
            });
        }
    };
    std::thread::Builder::new().name("pages".into()).spawn(accept)?;
    Ok(address)
}

/// Guard that counts an open connection to the preview server; dropping the guard decrements the shared count.
struct Connection(Arc<AtomicUsize>);

impl Drop for Connection {
    fn drop(&mut self) {
        self.0.fetch_sub(1, SeqCst);
    }
}

struct Server {
    guard: Guard,
    backend: Arc<dyn Backend>,
    screen: Arc<Screen>,
}

/// Paths of the server after the token, and the method of each.
const METHODS: [(&str, &str); 10] = [
    ("", "GET"),
    ("page.css", "GET"),
    ("page.js", "GET"),
    ("icon.svg", "GET"),
    ("events", "GET"),
    ("before.png", "GET"),
    ("pick", "GET"),
    ("change", "POST"),
    ("open", "POST"),
    ("save", "POST"),
];

const TEXT: &str = "text/plain; charset=utf-8";
const JSON: &str = "application/json";

impl Server {
    /// Reads a request and responds to it.
    fn answer(&self, to: &mut TcpStream) -> io::Result<()> {
        let request = match Request::read(to) {
            Ok(request) => request,
            Err(error) if error.kind() == io::ErrorKind::InvalidData => {
                return http::refuse(to, "400 Bad Request", &error.to_string());
            }
            Err(error) => return Err(error),
        };
        let rest = match self.guard.path_after_token(&request.path, |name| request.header(name)) {
            Ok(rest) => rest,
            Err((status, reason)) => return http::refuse(to, status, reason),
        };
        let Some((_, method)) = METHODS.iter().find(|(name, _)| *name == rest) else {
            return http::refuse(to, "404 Not Found", "not found");
        };
        if request.method != *method {
            return http::refuse(to, "405 Method Not Allowed", &format!("this address takes `{method}` only"));
        }
        match catch_unwind(AssertUnwindSafe(|| self.respond_to(to, rest, &request))) {
            Ok(sent) => sent,
            Err(_) => http::refuse(to, "500 Internal Server Error", INTERNAL_FAILURE),
        }
    }

    /// Responds to a request for one of the addresses in [`METHODS`].
    fn respond_to(&self, to: &mut TcpStream, address: &str, request: &Request) -> io::Result<()> {
        match address {
            "" => http::answer(to, "200 OK", "text/html; charset=utf-8", PAGE),
            "page.css" => http::answer(to, "200 OK", "text/css; charset=utf-8", STYLE),
            "page.js" => http::answer(to, "200 OK", "text/javascript; charset=utf-8", SCRIPT),
            "icon.svg" => http::answer(to, "200 OK", "image/svg+xml", ICON),
            "events" => stream::send_until_closed(to, &self.screen),
            "before.png" => self.send_previous_picture(to),
            "pick" => {
                let (x, y) = (request.query_number("x").unwrap_or(0), request.query_number("y").unwrap_or(0));
                http::answer(to, "200 OK", JSON, self.backend.pick(x, y).to_string().as_bytes())
            }
            "change" => match serde_json::from_slice(&request.body) {
                Ok(change) => {
                    self.backend.change(change);
                    http::answer(to, "200 OK", JSON, b"{}")
                }
                Err(_) => refuse_as_json(to, "this is not a change of the settings"),
            },
            "open" => match serde_json::from_slice(&request.body) {
                Ok(position) => respond_as_json(to, self.backend.open(&position).map(|()| String::new())),
                Err(_) => refuse_as_json(to, "this is not a position"),
            },
            "save" => respond_as_json(to, self.backend.save()),
            _ => http::refuse(to, "404 Not Found", "not found"),
        }
    }

    fn send_previous_picture(&self, to: &mut TcpStream) -> io::Result<()> {
        let image = self.screen.previous_picture();
        let encoding = Encoding { alpha: true, ..Encoding::new(Format::Png) };
        match image.and_then(|image| encode(&image, &encoding).ok()) {
            Some(png) => http::answer(to, "200 OK", "image/png", &png),
            None => http::answer(to, "404 Not Found", TEXT, b"there is no previous picture\n"),
        }
    }
}

fn refuse_as_json(to: &mut TcpStream, why: &str) -> io::Result<()> {
    http::answer(to, "400 Bad Request", JSON, json!({"error": why}).to_string().as_bytes())
}

fn respond_as_json(to: &mut TcpStream, done: Result<String, String>) -> io::Result<()> {
    match done {
        Ok(text) => http::answer(to, "200 OK", JSON, json!({"text": text}).to_string().as_bytes()),
        Err(why) => refuse_as_json(to, &why),
    }
}
