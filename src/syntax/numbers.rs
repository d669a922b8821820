//! Scans literal numbers with own code for speed, since a mesh consists mostly of numbers.

use super::ast::{NumberList, Numbers, Widths};
use crate::math::fork;
use crate::source::Span;
use std::sync::Arc;

/// Scans an unsigned number that starts at the offset `at`. Returns its value and end; `None` without a number.
pub(super) fn number_and_end(bytes: &[u8], at: usize) -> Option<(f64, usize)> {
    let (mut mantissa, mut i) = digits_and_end(bytes, at, 0);
    let (mut digits, mut scale) = (i - at, 0i32);
    if bytes.get(i) == Some(&b'.') {
        let start = i + 1;
        (mantissa, i) = digits_and_end(bytes, start, mantissa);
        digits += i - start;
        scale = -((i - start) as i32);
    }
    if digits == 0 {
        return None;
    }
    let (exponent, end) = exponent_and_end(bytes, i);
    scale = scale.saturating_add(exponent);
    // Both factors are exact, so that their product or quotient is rounded once (Clinger 1990).
    if digits <= 19 && mantissa < 1 << 53 && scale.unsigned_abs() <= 22 {
        let power = POWERS[scale.unsigned_abs() as usize];
        let value = if scale < 0 { mantissa as f64 / power } else { mantissa as f64 * power };
        return Some((value, end));
    }
    let text = std::str::from_utf8(&bytes[at..end]).ok()?;
    Some((text.parse().ok()?, end))
}

/// Appends the decimal digits from the offset `at` on to those of `value` (modulo 2⁶⁴), and returns the new value and
/// the end. Eight bytes are tested together, without unpredictable branches (Muła, SIMD-ized parsing of numbers, 2016,
/// in a word instead of a register).
#[inline]
fn digits_and_end(bytes: &[u8], at: usize, mut value: u64) -> (u64, usize) {
    let mut i = at;
    while let Some(&eight) = bytes.get(i..).and_then(|rest| rest.first_chunk::<8>()) {
        // Digits become numbers below 10, all else becomes larger; the first character is the lowest byte.
        let word = u64::from_le_bytes(eight) ^ 0x3030_3030_3030_3030;
        let others = (word.wrapping_add(0x7676_7676_7676_7676) | word) & 0x8080_8080_8080_8080;
        let count = others.trailing_zeros() / 8;
        if count == 0 {
            return (value, i);
        }
        // Shift in zeros to get eight digits: then combine neighbours to pairs, pairs to fours, fours to all.
        let ones = word << (64 - 8 * count);
        let pairs = (ones.wrapping_mul(10 << 8 | 1) >> 8) & 0x00ff_00ff_00ff_00ff;
        let fours = (pairs.wrapping_mul(100 << 16 | 1) >> 16) & 0x0000_ffff_0000_ffff;
        let all = fours.wrapping_mul(10_000 << 32 | 1) >> 32;
        value = value.wrapping_mul(SMALL_POWERS[count as usize]).wrapping_add(all);
        i += count as usize;
        if count < 8 {
            return (value, i);
        }
    }
    while let Some(d) = digit(bytes, i) {
        value = value.wrapping_mul(10).wrapping_add(d);
        i += 1;
    }
    (value, i)
}

/// Powers of ten as integers, for converting decimal literals.
const SMALL_POWERS: [u64; 9] = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];

fn digit(bytes: &[u8], i: usize) -> Option<u64> {
    bytes.get(i).map(|b| b.wrapping_sub(b'0')).filter(|d| *d < 10).map(u64::from)
}

/// Scans an exponent such as `e-5`. Returns its value and end; 0 without an exponent.
fn exponent_and_end(bytes: &[u8], at: usize) -> (i32, usize) {
    let none = (0, at);
    if !matches!(bytes.get(at), Some(b'e' | b'E')) {
        return none;
    }
    let negative = bytes.get(at + 1) == Some(&b'-');
    let mut i = at + 1 + usize::from(matches!(bytes.get(at + 1), Some(b'-' | b'+')));
    if digit(bytes, i).is_none() {
        return none;
    }
    let mut exponent = 0i32;
    while let Some(d) = digit(bytes, i) {
        exponent = exponent.saturating_mul(10).saturating_add(d as i32);
        i += 1;
    }
    (if negative { -exponent } else { exponent }, i)
}

/// Powers of ten that `f64` represents exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// True for bytes that are whitespace in the scene language.
pub(super) fn is_blank(b: u8) -> bool {
    b <= b' '
}

fn skip_blanks(bytes: &[u8], mut at: usize) -> usize {
    while bytes.get(at).is_some_and(|b| is_blank(*b)) {
        at += 1;
    }
    at
}

/// Minimum length of a list of numbers that is moved instead of copied.
const LONG: usize = 1 << 12;
/// Number of numbers of a list after which several threads scan the rest of it.
const ENOUGH_FOR_THREADS: usize = if cfg!(test) { 1 << 8 } else { 1 << 16 };
/// Number of bytes of a piece of a list that one thread scans.
const PIECE: usize = if cfg!(test) { 1 << 10 } else { 1 << 20 };

/// Scans the bytes of a text for literal vectors and lists of literals, which become one token each, and collects their
/// values as [`NumberList`]s.
#[derive(Default)]
pub(super) struct ListScanner {
    data: Vec<f64>,
    widths: WidthsBuilder,
}

impl ListScanner {
    /// Scans the longest list of literals that starts at the offset `at`: numbers and vectors with commas between them.
    /// The first may have a sign if `sign_allowed` is true. An item that is an operand of an operator is left out. Returns the
    /// number of items, which [`Self::take_items`] yields, and their end.
    pub(super) fn scan_count_and_end(&mut self, bytes: &[u8], at: usize, sign_allowed: bool) -> Option<(usize, usize)> {
        self.data.clear();
        self.widths = WidthsBuilder::default();
        let (mut i, mut end, mut divided_from) = (at, None, ENOUGH_FOR_THREADS);
        loop {
            let (start, first) = (self.data.len(), end.is_none());
            let Some(after) = self.scan_item_returning_end(bytes, i, sign_allowed || !first) else { break };
            let next = skip_blanks(bytes, after);
            let comma = bytes.get(next) == Some(&b',');
            if !comma && has_operator_or_index_at(bytes, next) {
                self.data.truncate(start);
                break;
            }
            self.widths.push((self.data.len() - start) as u16);
            end = Some(after);
            if !comma {
                break;
            }
            i = skip_blanks(bytes, next + 1);
            if self.data.len() >= divided_from {
                let scanned = self.scan_vectors_by_threads(bytes, i, 2 + (i - at) / PIECE);
                let is_whole = scanned.as_ref().is_some_and(|scanned| scanned.is_whole);
                divided_from = self.data.len() + if is_whole { 0 } else { ENOUGH_FOR_THREADS };
                if let Some(scanned) = scanned {
                    (i, end) = (scanned.next, Some(scanned.end));
                }
            }
        }
        end.map(|end| (self.widths.count, end))
    }

    /// Scans vectors from the offset `at` on, each followed by a comma, in pieces of the text: one for each thread, at
    /// most `max_pieces`. `None` without such a vector, or if there is one thread. (A piece begins at a `<`. Whether that
    /// belongs to the list is known once the piece before it is scanned; if that one ends elsewhere, the piece is
    /// dropped. So `max_pieces` bounds the work that is in vain after the end of the list.)
    fn scan_vectors_by_threads(&mut self, bytes: &[u8], at: usize, max_pieces: usize) -> Option<ScannedVectors> {
        let n_pieces = if bytes.get(at) == Some(&b'<') { fork::threads().min(max_pieces) } else { 1 };
        if n_pieces < 2 {
            return None;
        }
        let start_of_piece = |k: usize| {
            let from = bytes.len().min(at.saturating_add(k * PIECE));
            let near = &bytes[from..bytes.len().min(from + PIECE)];
            from + near.iter().position(|b| *b == b'<').unwrap_or(near.len())
        };
        let starts: Vec<usize> = (0..=n_pieces).map(start_of_piece).collect();
        let pieces = fork::map(n_pieces, 1, |k| {
            let mut piece = Self::default();
            let scanned = piece.scan_vectors_before(bytes, starts[k], starts[k + 1]);
            (piece, scanned)
        });
        let mut all: Option<ScannedVectors> = None;
        for (piece, scanned) in pieces {
            let Some(scanned) = scanned.filter(|_| all.as_ref().is_none_or(|before| before.is_whole)) else { break };
            self.data.extend_from_slice(&piece.data);
            self.widths.append(piece.widths);
            all = Some(scanned);
        }
        all
    }

    /// Scans vectors that start before the offset `limit`, each followed by a comma, from the offset `at` on; `None`
    /// without such a vector.
    fn scan_vectors_before(&mut self, bytes: &[u8], at: usize, limit: usize) -> Option<ScannedVectors> {
        let (mut next, mut end) = (at, None);
        while next < limit && bytes.get(next) == Some(&b'<') {
            let start = self.data.len();
            let Some(after) = self.scan_angle_vector_end(bytes, next) else { break };
            let comma = skip_blanks(bytes, after);
            if bytes.get(comma) != Some(&b',') {
                self.data.truncate(start);
                break;
            }
            self.widths.push((self.data.len() - start) as u16);
            (next, end) = (skip_blanks(bytes, comma + 1), Some(after));
        }
        end.map(|end| ScannedVectors { end, next, is_whole: next == limit })
    }

    /// Returns the number of components of the first scanned item.
    pub(super) fn first_item_width(&self) -> usize {
        self.widths.first.map_or(0, usize::from)
    }

    /// Returns the items of the last scan.
    pub(super) fn take_items(&mut self) -> NumberList {
        let widths = std::mem::take(&mut self.widths).into_widths();
        // (Copying a short list keeps the buffer for the next.)
        let data = match self.data.len() {
            ..LONG => Numbers::Short(self.data.as_slice().into()),
            _ => {
                self.data.shrink_to_fit();
                Numbers::Long(Arc::new(std::mem::take(&mut self.data)))
            }
        };
        NumberList { data, widths }
    }

    /// Scans one literal vector that starts at the offset `at`, and returns its end.
    pub(super) fn scan_vector_returning_end(&mut self, bytes: &[u8], at: usize) -> Option<usize> {
        self.data.clear();
        self.widths = WidthsBuilder::default();
        let end = self.scan_angle_vector_end(bytes, at)?;
        self.widths.push(self.data.len() as u16);
        Some(end)
    }

    fn scan_item_returning_end(&mut self, bytes: &[u8], at: usize, sign_allowed: bool) -> Option<usize> {
        if bytes.get(at) == Some(&b'<') {
            return self.scan_angle_vector_end(bytes, at);
        }
        self.scan_signed_returning_end(bytes, at, sign_allowed)
    }

    fn scan_signed_returning_end(&mut self, bytes: &[u8], at: usize, sign_allowed: bool) -> Option<usize> {
        let negative = bytes.get(at) == Some(&b'-');
        let signed = negative || bytes.get(at) == Some(&b'+');
        if signed && !sign_allowed {
            return None;
        }
        let (value, end) = number_and_end(bytes, at + usize::from(signed))?;
        self.data.push(if negative { -value } else { value });
        Some(end)
    }

    /// Scans a vector such as `<1, -2 3>`: commas are optional, but a sign without a comma before it subtracts.
    fn scan_angle_vector_end(&mut self, bytes: &[u8], at: usize) -> Option<usize> {
        let start = self.data.len();
        let mut i = skip_blanks(bytes, at + 1);
        let mut sign_allowed = true;
        loop {
            let Some(after) = self.scan_signed_returning_end(bytes, i, sign_allowed) else {
                self.data.truncate(start);
                return None;
            };
            i = skip_blanks(bytes, after);
            match bytes.get(i) {
                Some(b',') => {
                    i = skip_blanks(bytes, i + 1);
                    sign_allowed = true;
                }
                Some(b'>') if self.data.len() - start > 1 => return Some(i + 1),
                Some(b'0'..=b'9' | b'.') if i > after => sign_allowed = false,
                _ => {
                    self.data.truncate(start);
                    return None;
                }
            }
        }
    }
}

/// Result of scanning the vectors of a piece of text.
struct ScannedVectors {
    /// End of the last vector.
    end: usize,
    /// Offset of what follows the comma after that vector.
    next: usize,
    /// True if the whole piece was scanned: `next` is the start of the next piece.
    is_whole: bool,
}

/// True if an operator, component or index at the offset `at` continues the literal before it. True for a comment too,
/// so that the grammar decides.
fn has_operator_or_index_at(bytes: &[u8], at: usize) -> bool {
    matches!(
        bytes.get(at),
        Some(b'+' | b'-' | b'*' | b'/' | b'.' | b'(' | b'[' | b'=' | b'!' | b'&' | b'|' | b'?' | b'<' | b'>' | b':')
    )
}

#[derive(Default)]
struct WidthsBuilder {
    first: Option<u16>,
    count: usize,
    mixed: Option<Vec<u16>>,
}

impl WidthsBuilder {
    fn push(&mut self, width: u16) {
        let first = *self.first.get_or_insert(width);
        if width != first && self.mixed.is_none() {
            self.mixed = Some(vec![first; self.count]);
        }
        if let Some(mixed) = &mut self.mixed {
            mixed.push(width);
        }
        self.count += 1;
    }

    /// Appends the widths of items that follow.
    fn append(&mut self, other: Self) {
        let Some(width) = other.first else { return };
        let is_uniform = self.mixed.is_none() && other.mixed.is_none() && self.first.is_none_or(|first| first == width);
        match other.mixed {
            _ if is_uniform => {
                self.first = Some(width);
                self.count += other.count;
            }
            Some(mixed) => mixed.into_iter().for_each(|width| self.push(width)),
            None => (0..other.count).for_each(|_| self.push(width)),
        }
    }

    fn into_widths(self) -> Widths {
        match self.mixed {
            Some(mixed) => Widths::Mixed(mixed.into()),
            None => Widths::Uniform(self.first.unwrap_or(1)),
        }
    }
}

/// Finds the spans of a number list's items by scanning the text again. Spans are not stored, because a mesh has
/// millions of items. Each search continues from the last item found.
#[derive(Default)]
pub struct ItemSpans {
    list: Span,
    item: usize,
    at: usize,
    scanner: ListScanner,
}

impl ItemSpans {
    /// Returns the span of the last item of the number list with the span `list`; `list_text` is the list's own text.
    pub fn span_of_last_item(list_text: &str, list: Span) -> Span {
        let bytes = list_text.as_bytes();
        let start = match bytes.last() {
            Some(b'>') => list_text.rfind('<').unwrap_or(0),
            _ => skip_blanks(bytes, list_text.rfind(',').map_or(0, |comma| comma + 1)),
        };
        Span { lo: list.lo + start as u32, ..list }
    }

    /// Returns the span of item `item` of the number list with the span `list`; `list_text` is the list's own text.
    pub fn find(&mut self, list_text: &str, list: Span, item: usize) -> Option<Span> {
        let bytes = list_text.as_bytes();
        if self.list != list || item < self.item {
            (self.list, self.item, self.at) = (list, 0, 0);
        }
        loop {
            let end = self.scanner.scan_item_returning_end(bytes, self.at, true)?;
            self.scanner.data.clear();
            if self.item == item {
                return Some(Span::new(list.lo as usize + self.at, list.lo as usize + end));
            }
            self.at = skip_blanks(bytes, skip_blanks(bytes, end) + 1);
            self.item += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn scan(text: &str) -> Option<(NumberList, usize)> {
        let mut scanner = ListScanner::default();
        let (_, end) = scanner.scan_count_and_end(text.as_bytes(), 0, true)?;
        Some((scanner.take_items(), end))
    }

    #[test]
    fn lists_of_every_kind() {
        let (list, _) = scan("<1, -2.5e1 ,+.5>,\n<4 5 6>, 7, 1e-3,<1,2>").unwrap();
        assert_eq!(&*list.data, &[1.0, -25.0, 0.5, 4.0, 5.0, 6.0, 7.0, 1e-3, 1.0, 2.0]);
        assert!(matches!(&list.widths, Widths::Mixed(w) if **w == [3, 3, 1, 1, 2]));
        assert!(matches!(scan("1,2,3").unwrap().0.widths, Widths::Uniform(1)));
    }

    #[test]
    fn spans_of_items() {
        for text in ["<1, -2> ,\n<4 5>", "1, 2,\t-3.5", "<1,2>, 7", "7, <1, 2>", "5"] {
            let (list, end) = scan(text).unwrap();
            assert_eq!(end, text.len(), "{text}");
            let span = Span::new(100, 100 + end);
            let all: Vec<Span> = NumberList::item_spans(text, span).collect();
            assert_eq!(all.len(), list.len(), "{text}");
            assert_eq!(all.last(), Some(&ItemSpans::span_of_last_item(text, span)), "{text}");
        }
    }

    #[test]
    fn continued_items_end_a_list() {
        assert_eq!(scan("<1,2,3>, 2*x").unwrap().1, 7);
        assert!(scan("<1,2,3>*x").is_none());
        assert!(scan("<1, a>").is_none());
        assert!(scan("<1 -2>").is_none());
    }

    /// A text of so many vectors that several threads scan it, and then `rest`.
    fn long_list(count: usize, width_of: impl Fn(usize) -> usize, rest: &str) -> String {
        let vector = |i: usize| {
            let numbers: Vec<String> = (0..width_of(i)).map(|k| format!("{}.{k}", i * 7)).collect();
            format!("<{}>,\n", numbers.join(", "))
        };
        (0..count).map(vector).chain([rest.to_owned()]).collect()
    }

    #[test]
    fn threads_scan_long_lists_as_one_thread_does() {
        let uniform = |_| 3;
        let late = |i| if i == 1500 { 2 } else { 3 };
        let mixed = |i| 2 + i % 3;
        for (width_of, rest) in [
            (&uniform as &dyn Fn(usize) -> usize, "<1, 2, 3> }"),
            (&uniform, "<1, 2, 3>*2, <4, 5, 6>"),
            (&uniform, "<1, 2, x>, <4, 5, 6>, <7, 8, 9>"),
            (&uniform, "/* <1, 2, 3>, */ <4, 5, 6>"),
            (&uniform, "5, <4, 5, 6>"),
            (&uniform, ""),
            (&late, "<1, 2, 3>"),
            (&mixed, "<1, 2, 3>"),
        ] {
            let text = long_list(2000, width_of, rest);
            let (one, end) = scan(&text).unwrap();
            for threads in [2, 3, 7] {
                let (list, same_end) = fork::with_threads(threads, || scan(&text)).unwrap();
                assert_eq!(same_end, end, "{rest}");
                assert!(list.data == one.data && (0..one.len()).all(|i| list.width(i) == one.width(i)), "{rest}");
                assert_eq!(list.len(), one.len(), "{rest}");
            }
        }
    }

    proptest! {
        #[test]
        fn numbers_are_read_as_the_standard_library_reads_them(text in "[0-9]{0,22}\\.?[0-9]{1,22}([eE][+-]?[0-9]{1,3})?") {
            let (value, end) = number_and_end(text.as_bytes(), 0).unwrap();
            prop_assert_eq!(end, text.len());
            prop_assert_eq!(value.to_bits(), text.parse::<f64>().unwrap().to_bits());
        }
    }
}
