//! Frames and messages of the protocol on byte streams (Language Server Protocol 3.17, "Base Protocol"; JSON-RPC 2.0).
//!
//! Not the reader of the crate `lsp-server`: that reader allocates whatever a header announces, and ends the connection
//! at the first message that it cannot parse. The crate's types of messages and their writer are used.

use lsp_server::{ErrorCode, Message, Notification, Request, RequestId, Response};
use serde_json::{Value, json};
use std::io::{self, BufRead, Read, Write};

/// Largest length of a message, in bytes.
const MAX_BODY: usize = 64 << 20;
/// Largest length of a message's header, in bytes.
const MAX_HEADER: u64 = 4 << 10;
/// Name of the header that gives the length of a message, in lower case.
const LENGTH: &[u8] = b"content-length:";

/// Part of the input that [`Reader::read`] returns.
#[derive(Debug)]
pub enum Incoming {
    /// A request or a notification.
    Message(Message),
    /// Input that is no valid message. The reader continues after that input.
    Refused(Refusal),
    /// The editor's response to a request of the server, which the server ignores.
    Response,
    /// The regular end of the input.
    End,
}

/// Error response to invalid input.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Identity of the refused request; `None` if the input has none.
    id: Option<RequestId>,
    /// Error code of JSON-RPC.
    code: i32,
    /// Reason of the refusal.
    text: String,
}

impl Refusal {
    fn new(code: ErrorCode, text: impl Into<String>) -> Self {
        Self { id: None, code: code as i32, text: text.into() }
    }

    /// Writes the error response, whose `id` is null for input without identity.
    ///
    /// # Errors
    /// If the editor is gone.
    pub fn write(self, to: &mut impl Write) -> io::Result<()> {
        let Self { id, code, text } = self;
        if let Some(id) = id {
            return Message::Response(Response::new_err(id, code, text)).write(to);
        }
        let error = json!({"code": code, "message": text});
        let body = json!({"jsonrpc": "2.0", "id": null, "error": error}).to_string();
        write!(to, "Content-Length: {}\r\n\r\n{body}", body.len())?;
        to.flush()
    }
}

/// Reader of messages that continues after invalid input.
pub struct Reader<R> {
    from: R,
    /// True after a message whose length is unknown: the next message starts at the next header [`LENGTH`].
    is_lost: bool,
}

impl<R: BufRead> Reader<R> {
    /// Creates a reader at the beginning of a frame.
    pub fn new(from: R) -> Self {
        Self { from, is_lost: false }
    }

    /// Reads the next message.
    ///
    /// # Errors
    /// If reading fails, or the input ends within a message.
    pub fn read(&mut self) -> io::Result<Incoming> {
        let length = match self.read_header()? {
            Header::Length(length) => length,
            Header::End => return Ok(Incoming::End),
            Header::Invalid(text) => {
                self.is_lost = true;
                return Ok(Incoming::Refused(Refusal::new(ErrorCode::InvalidRequest, text)));
            }
        };
        // The body grows as it arrives: the header alone reserves no memory.
        let mut body = vec![];
        (&mut self.from).take(length as u64).read_to_end(&mut body)?;
        if body.len() < length {
            return Err(io::Error::new(io::ErrorKind::UnexpectedEof, "the input ended within a message"));
        }
        Ok(parse(&body))
    }

    /// Reads the header of the next message from the editor, which gives the length of the message.
    fn read_header(&mut self) -> io::Result<Header> {
        let mut from = (&mut self.from).take(MAX_HEADER);
        let (mut line, mut length) = (vec![], None);
        if std::mem::take(&mut self.is_lost) {
            if !skip_past_length_header(from.get_mut())? {
                return Ok(Header::End);
            }
            line.extend_from_slice(LENGTH);
        }
        let mut is_first = line.is_empty();
        loop {
            from.read_until(b'\n', &mut line)?;
            let Some(text) = line.strip_suffix(b"\n") else {
                return Ok(match (from.limit(), &line[..]) {
                    (0, _) => Header::Invalid(format!("the header is longer than {MAX_HEADER} bytes")),
                    (_, []) if is_first => Header::End,
                    _ => Header::Invalid("the input ended within a header".into()),
                });
            };
            let text = String::from_utf8_lossy(text.strip_suffix(b"\r").unwrap_or(text)).into_owned();
            (is_first, line) = (false, vec![]);
            if text.is_empty() {
                break;
            }
            let Some((name, value)) = text.split_once(':') else {
                return Ok(Header::Invalid(format!("`{}` is no header", shortened(&text))));
            };
            if name.eq_ignore_ascii_case("content-length") {
                length = Some(value.trim().to_string());
            }
        }
        Ok(match length {
            None => Header::Invalid("the header has no `Content-Length`".into()),
            Some(text) if text.is_empty() || !text.bytes().all(|byte| byte.is_ascii_digit()) => {
                Header::Invalid(format!("`Content-Length: {}` is no length in bytes", shortened(&text)))
            }
            Some(text) => match text.parse() {
                Ok(length) if length <= MAX_BODY => Header::Length(length),
                _ => Header::Invalid(format!(
                    "`Content-Length: {}` is more than the {} MB that a message may have",
                    shortened(&text),
                    MAX_BODY >> 20
                )),
            },
        })
    }
}

/// Result of reading the header of a frame.
enum Header {
    /// Length of the message in bytes.
    Length(usize),
    /// Reason for which the length of the message is unknown, or the message too long.
    Invalid(String),
    /// The end of the input.
    End,
}

/// Returns the beginning of a text for a message.
fn shortened(text: &str) -> String {
    text.chars().take(40).collect()
}

/// Consumes the input including the next [`LENGTH`]; false at the end of the input.
fn skip_past_length_header(from: &mut impl BufRead) -> io::Result<bool> {
    let mut n_matched = 0;
    loop {
        let bytes = from.fill_buf()?;
        if bytes.is_empty() {
            return Ok(false);
        }
        let mut n_used = 0;
        for byte in bytes.iter().map(u8::to_ascii_lowercase) {
            n_used += 1;
            // The first byte of the name occurs in the name only once.
            n_matched = if byte == LENGTH[n_matched] { n_matched + 1 } else { usize::from(byte == LENGTH[0]) };
            if n_matched == LENGTH.len() {
                break;
            }
        }
        from.consume(n_used);
        if n_matched == LENGTH.len() {
            return Ok(true);
        }
    }
}

/// Parses the body of a message from the editor as JSON-RPC; a refusal if it is invalid.
fn parse(body: &[u8]) -> Incoming {
    let parsed = serde_json::from_slice(body)
        .or_else(|error| without_lone_surrogates(body).ok_or(error).and_then(|body| serde_json::from_slice(&body)));
    let mut value: Value = match parsed {
        Ok(value) => value,
        Err(error) => return Incoming::Refused(Refusal::new(ErrorCode::ParseError, format!("invalid JSON: {error}"))),
    };
    let id = value.get("id").map(|id| serde_json::from_value::<RequestId>(id.clone()).ok());
    let method = value.get("method").and_then(Value::as_str).map(String::from);
    let params = value.get_mut("params").map(Value::take).unwrap_or_default();
    match (method, id) {
        (Some(method), Some(Some(id))) => Incoming::Message(Message::Request(Request { id, method, params })),
        (Some(method), None) => Incoming::Message(Message::Notification(Notification { method, params })),
        (None, Some(_)) if value.get("result").or(value.get("error")).is_some() => Incoming::Response,
        (Some(_), Some(None)) => {
            let text = "the `id` of the request is neither a text nor a whole number of 32 bits";
            Incoming::Refused(Refusal::new(ErrorCode::InvalidRequest, text))
        }
        (None, id) => {
            let refusal = Refusal::new(ErrorCode::InvalidRequest, "the message is no request: it has no `method`");
            Incoming::Refused(Refusal { id: id.flatten(), ..refusal })
        }
    }
}

/// Replaces escapes of lone UTF-16 surrogates, which JavaScript writes, by U+FFFD, which also counts as one unit of a
/// position. `None` if there are no such escapes.
fn without_lone_surrogates(body: &[u8]) -> Option<Vec<u8>> {
    let unit = |at: usize| {
        let digits = body.get(at..at + 6)?.strip_prefix(b"\\u")?;
        u16::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok()
    };
    let (mut out, mut at, mut has_lone) = (Vec::with_capacity(body.len()), 0, false);
    while at < body.len() {
        let (length, is_lone) = match (unit(at), unit(at + 6)) {
            (Some(0xd800..=0xdbff), Some(0xdc00..=0xdfff)) => (12, false),
            (Some(0xd800..=0xdfff), _) => (6, true),
            _ if body[at] == b'\\' => (2, false),
            _ => (1, false),
        };
        let end = (at + length).min(body.len());
        out.extend_from_slice(if is_lone { b"\\ufffd" } else { &body[at..end] });
        (at, has_lone) = (end, has_lone || is_lone);
    }
    has_lone.then_some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns a frame with this body.
    fn frame(body: &str) -> String {
        format!("Content-Length: {}\r\n\r\n{body}", body.len())
    }

    /// Returns the methods of all messages, and the codes of all refusals.
    fn read_all(input: &str) -> Vec<String> {
        let (mut reader, mut out) = (Reader::new(input.as_bytes()), vec![]);
        loop {
            out.push(match reader.read() {
                Ok(Incoming::Message(Message::Request(request))) => request.method,
                Ok(Incoming::Message(Message::Notification(note))) => note.method,
                Ok(Incoming::Message(Message::Response(_)) | Incoming::Response) => "response".into(),
                Ok(Incoming::Refused(refusal)) => refusal.code.to_string(),
                Ok(Incoming::End) => return out,
                Err(error) => {
                    out.push(error.kind().to_string());
                    return out;
                }
            });
        }
    }

    #[test]
    fn the_reader_goes_on_after_invalid_input() {
        let note = frame(r#"{"jsonrpc": "2.0", "method": "after"}"#);
        let long = "x".repeat(10_000);
        for header in ["99999999999", "99999999999999999999999", "-5", "", "x", "1e3", "+7", "67108865"] {
            let input = format!("Content-Length: {header}\r\n\r\n{{\"method\": \"lost\"}}{note}{note}");
            assert_eq!(read_all(&input), ["-32600", "after", "after"], "{header}");
        }
        for header in ["\r\n{}", "Content-Type: a\r\n\r\n{}", "{}\r\n\r\n", &long, "GET / HTTP/1.1\r\n\r\n"] {
            assert_eq!(read_all(&format!("{header}{note}")), ["-32600", "after"], "{header}");
        }
        for body in ["", "{", "\u{0}", "nul", "{\"method\": \"a\"} {}", &"[".repeat(100_000)] {
            assert_eq!(read_all(&format!("{}{note}", frame(body))), ["-32700", "after"], "{body}");
        }
        for body in ["1", "null", "[]", "{}", r#"{"id": 1}"#, r#"{"method": 1}"#, r#"{"method": "a", "id": 1.5}"#] {
            assert_eq!(read_all(&format!("{}{note}", frame(body))), ["-32600", "after"], "{body}");
        }
        assert_eq!(read_all(&frame(r#"{"id": 1, "result": null}"#)), ["response"]);
        assert_eq!(read_all("Content-Length: 5\n\n{}"), ["unexpected end of file"]);
        assert_eq!(read_all("Content-Len"), ["-32600"]);
        assert!(read_all("").is_empty());
    }

    #[test]
    fn lone_surrogates_are_replaced() {
        let replaced = |body: &str| without_lone_surrogates(body.as_bytes()).map(|b| String::from_utf8(b).unwrap());
        assert_eq!(replaced(r#""\ud83d\ude00 \ud83d \ude00""#).unwrap(), r#""\ud83d\ude00 \ufffd \ufffd""#);
        assert_eq!(replaced(r#""\ud83d\ude00 \\ud83d \u""#), None);
        assert_eq!(read_all(&frame(r#"{"method": "a", "params": "\ud83d"}"#)), ["a"]);
    }
}
