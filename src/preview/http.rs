//! A subset of HTTP/1.1 (RFC 9112): one request for each connection.

use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::{Duration, Instant};

/// Largest head of a request, in bytes.
const MAX_HEAD: usize = 16 << 10;
/// Largest body of a request, in bytes.
const MAX_BODY: usize = 64 << 10;
/// Time in which a client must send its whole request.
const REQUEST_TIME: Duration = Duration::from_secs(2);
/// Timeout of writing to an HTTP client.
const WRITE_TIME: Duration = Duration::from_secs(10);
/// Time in which input is discarded after the refusal of a request.
const DISCARD_TIME: Duration = Duration::from_millis(500);

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
    /// Of the kind [`io::ErrorKind::InvalidData`] with the reason, for a request that is invalid, too long or too slow;
    /// otherwise if the connection fails.
    pub fn read(stream: &mut TcpStream) -> io::Result<Self> {
        stream.set_write_timeout(Some(WRITE_TIME))?;
        stream.set_nodelay(true)?;
        let mut input = Input { stream, bytes: vec![], deadline: Instant::now() + REQUEST_TIME };
        let (mut request, head) = loop {
            if let Some(complete) = Self::parse(&input.bytes)? {
                break complete;
            }
            if input.bytes.len() > MAX_HEAD {
                return Err(invalid(format!("the head of the request is longer than {} KB", MAX_HEAD >> 10)));
            }
            input.receive()?;
        };
        let length = request.body_length()?;
        while input.bytes.len() < head + length {
            input.receive()?;
        }
        request.body = input.bytes[head..head + length].to_vec();
        Ok(request)
    }

    /// Parses the head of a request, and returns the request with the length of its head; `None` if the head is
    /// incomplete.
    fn parse(bytes: &[u8]) -> io::Result<Option<(Self, usize)>> {
        let mut headers = [httparse::EMPTY_HEADER; 64];
        let mut request = httparse::Request::new(&mut headers);
        match request.parse(bytes) {
            Ok(httparse::Status::Complete(head)) => Ok(Some((Self::from_head(&request), head))),
            Ok(httparse::Status::Partial) => Ok(None),
            Err(error) => Err(invalid(format!("the request is not HTTP/1.1: {error}"))),
        }
    }

    /// Returns the length of the HTTP request's body in bytes, from `Content-Length`; 0 without that header.
    fn body_length(&self) -> io::Result<usize> {
        if !self.header("transfer-encoding").is_empty() {
            return Err(invalid("the request has a body of unknown length"));
        }
        let length = match &self.header("content-length")[..] {
            [] => 0,
            [length] if length.bytes().all(|byte| byte.is_ascii_digit()) => length.parse().unwrap_or(usize::MAX),
            _ => return Err(invalid("the request has no valid `Content-Length`")),
        };
        if length > MAX_BODY {
            return Err(invalid(format!("the body of the request is longer than {} KB", MAX_BODY >> 10)));
        }
        Ok(length)
    }

    /// Copies a parsed request head into a request without a body.
    fn from_head(request: &httparse::Request) -> Self {
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

    /// Returns all values of the header with this name, which is written in lower case.
    pub fn header(&self, lowercase_name: &str) -> Vec<String> {
        self.headers.iter().filter(|(name, _)| name == lowercase_name).map(|(_, value)| value.clone()).collect()
    }

    /// Returns the number `name=…` in the query of the HTTP request; `None` if it is absent or not a whole number.
    pub fn query_number(&self, name: &str) -> Option<usize> {
        let pairs = self.query.split('&').filter_map(|pair| pair.split_once('='));
        pairs.filter(|(n, _)| *n == name).find_map(|(_, value)| value.parse().ok())
    }
}

/// Returns the error of a request that is answered with status 400.
fn invalid(text: impl Into<String>) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, text.into())
}

/// Connection of an HTTP client, with the bytes of the request that have arrived so far.
struct Input<'a> {
    stream: &'a mut TcpStream,
    bytes: Vec<u8>,
    /// Time at which the whole request must have arrived.
    deadline: Instant,
}

impl Input<'_> {
    /// Waits for more bytes of the HTTP request, and appends them.
    fn receive(&mut self) -> io::Result<()> {
        let slow = || invalid(format!("the request did not arrive within {} seconds", REQUEST_TIME.as_secs()));
        let left = self.deadline.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Err(slow());
        }
        self.stream.set_read_timeout(Some(left))?;
        let mut chunk = [0; 4096];
        match self.stream.read(&mut chunk) {
            Ok(0) if self.bytes.is_empty() => Err(io::ErrorKind::UnexpectedEof.into()),
            Ok(0) => Err(invalid("the request ended too early")),
            Ok(count) => {
                self.bytes.extend_from_slice(&chunk[..count]);
                Ok(())
            }
            Err(error) if matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut) => Err(slow()),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => Ok(()),
            Err(error) => Err(error),
        }
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

/// Sends an HTTP response with a status, a `content_type` and a body.
///
/// # Errors
/// If the client is gone.
pub fn answer(stream: &mut TcpStream, status: &str, content_type: &str, body: &[u8]) -> io::Result<()> {
    let length = body.len();
    let head =
        format!("HTTP/1.1 {status}\r\nContent-Type: {content_type}\r\nContent-Length: {length}\r\n{HEADERS}\r\n");
    stream.write_all(&[head.as_bytes(), body].concat())
}

/// Sends a response that refuses a request, and discards the rest of the input for a short time: the system would
/// otherwise reset the connection, and the client might lose the response.
///
/// # Errors
/// If the client is gone.
pub fn refuse(stream: &mut TcpStream, status: &str, reason: &str) -> io::Result<()> {
    stream.set_write_timeout(Some(WRITE_TIME))?;
    answer(stream, status, "text/plain; charset=utf-8", format!("{reason}\n").as_bytes())?;
    stream.shutdown(Shutdown::Write)?;
    let deadline = Instant::now() + DISCARD_TIME;
    let mut chunk = [0; 4096];
    loop {
        let left = deadline.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Ok(());
        }
        stream.set_read_timeout(Some(left))?;
        if stream.read(&mut chunk)? == 0 {
            return Ok(());
        }
    }
}

/// Starts a response that is an endless sequence of events.
///
/// # Errors
/// If the client is gone.
pub fn begin_events(stream: &mut TcpStream) -> io::Result<()> {
    stream.write_all(format!("HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\n{HEADERS}\r\n").as_bytes())
}
