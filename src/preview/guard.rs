//! Access control of the page's server: only clients that know the page's address are admitted.
//!
//! The server listens on the loopback address, but scripts of other pages in the author's browser can reach it, by its
//! number or by a name that resolves to it (DNS rebinding). A request must therefore start with the token, be addressed
//! to this host, and come from no other origin (Fetch Standard, `Origin`; W3C, "Fetch Metadata Request Headers").

use std::io;

/// Status and reason of a refused request.
pub type Refusal = (&'static str, &'static str);

/// Address and secret token of the preview page.
#[derive(Clone, Debug)]
pub struct Guard {
    port: u16,
    token: String,
}

impl Guard {
    /// Creates a guard with a random token.
    ///
    /// # Errors
    /// If the system has no random numbers.
    pub fn new(port: u16) -> io::Result<Self> {
        let mut bytes = [0; 16];
        getrandom::fill(&mut bytes).map_err(io::Error::other)?;
        Ok(Self { port, token: bytes.map(|byte| format!("{byte:02x}")).concat() })
    }

    /// Returns the address of the preview page with its token.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/{}/", self.port, self.token)
    }

    /// Returns the rest of a path after the token. Refuses a request without the token, to another host or from another
    /// page. `header` returns all values of a header by its name in lower case.
    ///
    /// # Errors
    /// The status and the reason of a refusal.
    pub fn path_after_token<'p>(
        &self,
        path: &'p str,
        header: impl Fn(&str) -> Vec<String>,
    ) -> Result<&'p str, Refusal> {
        const FORBIDDEN: &str = "403 Forbidden";
        let hosts = [format!("127.0.0.1:{}", self.port), format!("localhost:{}", self.port)];
        match &header("host")[..] {
            [host] if hosts.contains(host) => {}
            [_] => return Err((FORBIDDEN, "this server answers only to its own address")),
            // RFC 9112, section 3.2.
            _ => return Err(("400 Bad Request", "a request needs exactly one header `Host`")),
        }
        let own = |origin: &String| origin.strip_prefix("http://").is_some_and(|host| hosts.iter().any(|h| h == host));
        let near = |site: &String| site == "same-origin" || site == "none";
        if !header("origin").iter().all(own) || !header("sec-fetch-site").iter().all(near) {
            return Err((FORBIDDEN, "other pages get no answer here"));
        }
        let rest = path.strip_prefix('/').and_then(|path| path.split_once('/'));
        match rest {
            Some((token, rest)) if self.is_token(token) => Ok(rest),
            _ => Err((FORBIDDEN, "the address has a token; `durer watch` prints it")),
        }
    }

    /// Compares a token with the page's token in constant time.
    fn is_token(&self, token: &str) -> bool {
        let differ = |all, (a, b): (u8, u8)| all | (a ^ b);
        token.len() == self.token.len() && token.bytes().zip(self.token.bytes()).fold(0, differ) == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn requests_without_token_or_from_other_origins_are_refused() {
        let guard = Guard { port: 4000, token: "abcd".into() };
        let ask = |path: &'static str, headers: &[(&str, &str)]| {
            let get = |name: &str| headers.iter().filter(|(n, _)| *n == name).map(|(_, v)| v.to_string()).collect();
            guard.path_after_token(path, get).ok()
        };
        let host = ("host", "127.0.0.1:4000");
        assert_eq!(ask("/abcd/", &[host]), Some(""));
        assert_eq!(ask("/abcd/page.js", &[("host", "localhost:4000")]), Some("page.js"));
        assert_eq!(ask("/abcd/ask", &[host, ("origin", "http://127.0.0.1:4000")]), Some("ask"));
        assert_eq!(ask("/abcd/", &[host, ("sec-fetch-site", "none")]), Some(""));
        for path in ["/", "/abc/", "/abcd", "/abcde/", "//abcd/", "/ABCD/", "/../abcd/", "abcd/"] {
            assert_eq!(ask(path, &[host]), None, "{path}");
        }
        let wrong: [&[(&str, &str)]; 9] = [
            &[],
            &[("host", "127.0.0.1")],
            &[("host", "evil.example:4000")],
            &[host, host],
            &[host, ("origin", "http://evil.example")],
            &[host, ("origin", "null")],
            &[host, ("origin", "https://127.0.0.1:4000")],
            &[host, ("origin", "http://127.0.0.1:4001")],
            &[host, ("sec-fetch-site", "cross-site")],
        ];
        for headers in wrong {
            assert_eq!(ask("/abcd/", headers), None, "{headers:?}");
        }
    }

    #[test]
    fn tokens_differ() {
        let [a, b] = [Guard::new(1), Guard::new(1)].map(|guard| guard.unwrap().token);
        assert_eq!(a.len(), 32);
        assert_ne!(a, b);
    }
}
