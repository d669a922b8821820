//! Seeded mutations of a text.

use durer::syntax::word;

/// SplitMix64 (Steele et al. 2014): the same numbers for the same seed everywhere.
pub struct Rng(u64);

impl Rng {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `n`; 0 for 0.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }

    pub fn pick<'a, T: ?Sized>(&mut self, from: &[&'a T]) -> &'a T {
        from[self.below(from.len())]
    }
}

/// Punctuation of scenes.
#[rustfmt::skip]
const MARKS: &[&str] = &[
    "{", "}", "(", ")", "[", "]", "<", ">", ",", ";", "+", "-", "*", "/", "=", "!=", "<=", ">=", "!", "?", ":", "&", "|",
    ".", "\"", "//", "/*", "*/", "#", "@", "\\", "\n", "\r", "é", "\u{feff}", "\u{0}", "∞",
];

#[rustfmt::skip]
const DIRECTIVES: &[&str] = &[
    "#declare A =", "#local A =", "#if (1)", "#if (0)", "#end", "#else", "#elseif (1)", "#ifdef (A)", "#ifndef (A)", "#while (0)",
    "#for (I, 0, 2)", "#macro M(A, B)", "#switch (1)", "#case (1)", "#range (0, 2)", "#break", "#include \"a.inc\"", "#version 3.7;",
    "#debug", "#warning", "#error", "#default {", "#undef A", "#fopen F \"x\" read", "#fclose F", "#read (F, A)", "#write (F, A)",
    "M(", "A", "I", "function {", "array[2]", "array {", "object { A }", "union {", "transform {", "texture {", "pigment {",
];

/// Numbers at which arithmetic fails.
const NUMBERS: &[&str] = &[
    "0",
    "-1",
    "1e308",
    "1e-308",
    "-1e308",
    "1e999",
    "(0/0)",
    "(1/0)",
    "65536",
    "-0",
    "1e-11",
    ".5",
    "4294967296",
    "1e20",
];

/// A random token of the language.
fn token(rng: &mut Rng) -> &'static str {
    match rng.below(8) {
        0 | 1 => rng.pick(word::KEYWORDS),
        2 => rng.pick(word::FUNCTIONS),
        3 => rng.pick(&word::CONSTANTS.iter().map(|c| c.0).collect::<Vec<_>>()),
        4 => rng.pick(NUMBERS),
        5 => rng.pick(DIRECTIVES),
        _ => rng.pick(MARKS),
    }
}

/// A text after one to three mutations; `other` is a second one, to be spliced.
pub fn mutate(text: &str, other: &str, rng: &mut Rng) -> String {
    let mut text = text.to_string();
    for _ in 0..1 + rng.below(3) {
        text = step(&text, other, rng);
    }
    text
}

fn step(text: &str, other: &str, rng: &mut Rng) -> String {
    let spans = tokens(text);
    let mut at = || rng.below(spans.len() + 1);
    let (a, b) = (at(), at());
    let (a, b) = (a.min(b), a.max(b));
    let start = |i: usize| spans.get(i).map_or(text.len(), |s| s.0);
    // Mostly few tokens, so that much of the text stays valid.
    let few = a + rng.below(8).min(b - a);
    let (lo, hi, far) = (start(a), start(few), start(b));
    match rng.below(12) {
        0 | 1 => cut(text, lo, hi, ""),
        2 => cut(text, lo, hi, &text[lo..hi].repeat(2 + rng.below(3))),
        3 => [&text[..lo], &text[hi..far.max(hi)], &text[lo..hi], &text[far.max(hi)..]].concat(),
        4..=6 => {
            let inserted: Vec<_> = (0..1 + rng.below(3)).map(|_| token(rng)).collect();
            cut(text, lo, lo, &format!(" {} ", inserted.join(" ")))
        }
        7 | 8 => another_number(text, &spans, rng),
        9 => text[..char_floor(text, rng.below(text.len() + 1))].to_string(),
        10 => {
            let from = char_floor(other, rng.below(other.len() + 1));
            let upto = char_floor(other, (from + rng.below(400)).min(other.len()));
            cut(text, lo, lo, &other[from..upto])
        }
        _ => {
            let (from, upto) =
                (char_floor(text, rng.below(text.len() + 1)), char_floor(other, rng.below(other.len() + 1)));
            [&text[..from], &other[upto..]].concat()
        }
    }
}

/// The text with a range replaced.
fn cut(text: &str, lo: usize, hi: usize, new: &str) -> String {
    [&text[..lo], new, &text[hi..]].concat()
}

fn another_number(text: &str, spans: &[(usize, usize)], rng: &mut Rng) -> String {
    let numbers: Vec<_> = spans.iter().filter(|s| text.as_bytes()[s.0].is_ascii_digit()).collect();
    match numbers.get(rng.below(numbers.len())) {
        Some(&&(lo, hi)) => cut(text, lo, hi, rng.pick(NUMBERS)),
        None => text.to_string(),
    }
}

fn char_floor(text: &str, at: usize) -> usize {
    (0..=at).rev().find(|&i| text.is_char_boundary(i)).unwrap_or(0)
}

/// Words, numbers, and single characters, without the blanks between them.
fn tokens(text: &str) -> Vec<(usize, usize)> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let (mut spans, mut at) = (vec![], 0);
    while let Some(c) = text[at..].chars().next() {
        let len = match c {
            c if is_word(c) => text[at..].find(|c| !is_word(c)).unwrap_or(text.len() - at),
            _ => c.len_utf8(),
        };
        if !c.is_whitespace() {
            spans.push((at, at + len));
        }
        at += len;
    }
    spans
}
