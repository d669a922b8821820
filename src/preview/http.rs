//! A subset of HTTP/1.1 (RFC 9112): one request for each connection.

use std::io::{self, Read, Write};
use std::net::TcpStream;
use std::time::Duration;

/// Largest head of a request, in bytes.
const MAX_HEAD: usize = 16 << 10;
/// Largest body of a request, in bytes.
const MAX_BODY: usize = 64 << 10;
/// Timeout of reading from and writing to an HTTP client.
const TIMEOUT: Duration = Duration::from_secs(10);

/// An HTTP request of a client.
#[derive(Debug)]
pub struct Request {
    /// Method of the HTTP request, such as `GET`.
    pub method: String,
    /// Path of the HTTP request with its first `/`, without the query.
    pub path: String,
    /// Query after `?` in the HTTP request's address.
    pub query: String,
    headers: Vec<(String, String)>,
    /// Body of the HTTP request.
    pub body: Vec<u8>,
}

impl Request {
    /// Reads a request.
    ///
    /// # Errors
    /// After the timeout, and for an invalid or too long request.
    pub fn read(stream: &mut TcpStream) -> io::Result<Self> {
        stream.set_read_timeout(Some(TIMEOUT))?;
        stream.set_write_timeout(Some(TIMEOUT))?;
        stream.set_nodelay(true)?;
        let invalid = |text: &str| io::Error::new(io::ErrorKind::InvalidData, text);
        let (mut bytes, mut chunk) = (vec![], [0; 4096]);
        loop {
            let mut headers = [httparse::EMPTY_HEADER; 64];
            let mut request = httparse::Request::new(&mut headers);
            let status = request.parse(&bytes).map_err(io::Error::other)?;
            if let httparse::Status::Complete(head) = status {
                let mut read = Self::of(&request);
                read.body = bytes.split_off(head);
                let length = match &read.header("content-length")[..] {
                    [] => 0,
                    [length] => length.parse().map_err(io::Error::other)?,
                    _ => return Err(invalid("two lengths")),
                };
                if length > MAX_BODY {
                    return Err(invalid("too long"));
                }
                while read.body.len() < length {
                    let count = stream.read(&mut chunk)?;
                    if count == 0 {
                        return Err(io::ErrorKind::UnexpectedEof.into());
                    }
                    read.body.extend_from_slice(&chunk[..count]);
                }
                read.body.truncate(length);
                return Ok(read);
            }
            let count = stream.read(&mut chunk)?;
            if count == 0 || bytes.len() > MAX_HEAD {
                return Err(io::ErrorKind::UnexpectedEof.into());
            }
            bytes.extend_from_slice(&chunk[..count]);
        }
    }

    fn of(request: &httparse::Request) -> Self {
        let (path, query) =
            request.path.unwrap_or_default().split_once('?').unwrap_or((request.path.unwrap_or_default(), ""));
        let header =
            |h: &httparse::Header| (h.name.to_ascii_lowercase(), String::from_utf8_lossy(h.value).into_owned());
        Self {
            method: request.method.unwrap_or_default().to_string(),
            path: path.to_string(),
            query: query.to_string(),
            headers: request.headers.iter().map(header).collect(),
            body: vec![],
        }
    }

    /// All values of a header; `name` is in lower case.
    pub fn header(&self, name: &str) -> Vec<String> {
        self.headers.iter().filter(|(n, _)| n == name).map(|(_, value)| value.clone()).collect()
    }

    /// Returns a number in the query of the HTTP request.
    pub fn number(&self, name: &str) -> Option<usize> {
        let pairs = self.query.split('&').filter_map(|pair| pair.split_once('='));
        pairs.filter(|(n, _)| *n == name).find_map(|(_, value)| value.parse().ok())
    }
}

/// Headers of every response: no caching, no frames, no guessing of the content type, no referrer; and the page
/// loads nothing from other hosts.
const HEADERS: &str = "Cache-Control: no-store\r\n\
    Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; \
    base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n\
    Cross-Origin-Opener-Policy: same-origin\r\n\
    Cross-Origin-Resource-Policy: same-origin\r\n\
    Referrer-Policy: no-referrer\r\n\
    X-Content-Type-Options: nosniff\r\n\
    Connection: close\r\n";

/// Sends a response.
///
/// # Errors
/// If the client is gone.
pub fn answer(stream: &mut TcpStream, status: &str, kind: &str, body: &[u8]) -> io::Result<()> {
    let length = body.len();
    let head = format!("HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\n{HEADERS}\r\n");
    stream.write_all(&[head.as_bytes(), body].concat())
}

/// Starts a response that is an endless sequence of events.
///
/// # Errors
/// If the client is gone.
pub fn begin_events(stream: &mut TcpStream) -> io::Result<()> {
    stream.write_all(format!("HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\n{HEADERS}\r\n").as_bytes())
}
