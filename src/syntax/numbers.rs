//! Literal numbers, scanned by hand: a mesh is mostly these.

use super::ast::{NumberList, Widths};

/// Scans what the grammar's `numbers` rule matched: numbers and `< >` vectors with commas or blanks between.
pub fn scan_list(text: &str) -> NumberList {
    let bytes = text.as_bytes();
    // A number takes at least two bytes with its separator; typical ones take eight.
    let mut data = Vec::with_capacity(bytes.len() / 8 + 2);
    let mut widths = WidthsBuilder::default();
    let (mut at, mut vector_start) = (0, None);
    while at < bytes.len() {
        match bytes[at] {
            b'<' => {
                vector_start = Some(data.len());
                at += 1;
            }
            b'>' => {
                let start = vector_start.take().unwrap_or(data.len());
                widths.push((data.len() - start) as u16);
                at += 1;
            }
            b'0'..=b'9' | b'.' | b'-' | b'+' => {
                let end = at + 1 + bytes[at + 1..].iter().take_while(|b| is_number_byte(**b)).count();
                let end = split_sign(bytes, at, end);
                data.push(parse(&text[at..end]));
                if vector_start.is_none() {
                    widths.push(1);
                }
                at = end;
            }
            _ => at += 1,
        }
    }
    NumberList { data: data.into_boxed_slice(), widths: widths.finish() }
}

/// The value of a literal; the grammar has seen that it is one.
pub fn parse(text: &str) -> f64 {
    text.parse().unwrap_or(f64::NAN)
}

fn is_number_byte(b: u8) -> bool {
    matches!(b, b'0'..=b'9' | b'.' | b'e' | b'E' | b'-' | b'+')
}

/// A sign inside a number belongs to it only right after the exponent's letter.
fn split_sign(bytes: &[u8], start: usize, end: usize) -> usize {
    let sign = |i: &usize| matches!(bytes[*i], b'-' | b'+') && !matches!(bytes[i - 1], b'e' | b'E');
    (start + 1..end).find(sign).unwrap_or(end)
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

    fn finish(self) -> Widths {
        match self.mixed {
            Some(mixed) => Widths::Mixed(mixed.into_boxed_slice()),
            None => Widths::Uniform(self.first.unwrap_or(1)),
        }
    }
}

impl NumberList {
    /// How many items there are.
    pub fn len(&self) -> usize {
        match &self.widths {
            Widths::Uniform(width) => self.data.len() / (*width).max(1) as usize,
            Widths::Mixed(widths) => widths.len(),
        }
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.data.is_empty()
    }

    /// How many numbers item `i` has.
    pub fn width(&self, i: usize) -> usize {
        match &self.widths {
            Widths::Uniform(width) => *width as usize,
            Widths::Mixed(widths) => widths[i] as usize,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_every_kind() {
        let list = scan_list("<1, -2.5e1 ,+.5>,\n<4 5 6>, 7, 1e-3,<1,2>");
        assert_eq!(&*list.data, &[1.0, -25.0, 0.5, 4.0, 5.0, 6.0, 7.0, 1e-3, 1.0, 2.0]);
        assert!(matches!(&list.widths, Widths::Mixed(w) if **w == [3, 3, 1, 1, 2]));
        assert!(matches!(scan_list("1,2,3").widths, Widths::Uniform(1)));
    }
}
