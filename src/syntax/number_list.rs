//! Lists of literal numbers and vectors in the syntax tree: a mesh has millions of them.

use super::numbers::ItemSpans;
use crate::source::Span;
use std::ops::Deref;
use std::sync::Arc;

/// A list of literal numbers and vectors, stored compactly.
#[derive(Clone, Debug)]
pub struct NumberList {
    /// Numbers of all items of the list, one after another.
    pub data: Numbers,
    /// Number of components of each item of the list.
    pub widths: Widths,
}

/// Numbers that the copies of a list share.
#[derive(Clone, Debug, PartialEq)]
pub enum Numbers {
    /// Numbers of a short list.
    Short(Arc<[f64]>),
    /// Numbers of a long list, such as one of a mesh, in the vector that the scanner filled. (A slice would be a copy, which takes
    /// as much memory again.)
    Long(Arc<Vec<f64>>),
}

impl Deref for Numbers {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        match self {
            Self::Short(numbers) => numbers,
            Self::Long(numbers) => numbers,
        }
    }
}

/// Number of components of each item of a list; 1 is a plain number.
#[derive(Clone, Debug)]
pub enum Widths {
    /// Width that all items of a number list share.
    Uniform(u16),
    /// Width of each item of a number list.
    Mixed(Arc<[u16]>),
}

impl NumberList {
    /// Returns the number of items in the number list.
    pub fn len(&self) -> usize {
        match &self.widths {
            Widths::Uniform(width) => self.data.len() / (*width).max(1) as usize,
            Widths::Mixed(widths) => widths.len(),
        }
    }

    /// True if the number list is empty.
    pub fn is_empty(&self) -> bool {
        self.data.is_empty()
    }

    /// Returns the spans of the items of a number list that has the text `list_text` and the span `list_span`.
    pub fn item_spans(list_text: &str, list_span: Span) -> impl Iterator<Item = Span> + '_ {
        let mut spans = ItemSpans::default();
        (0..).map_while(move |item| spans.find(list_text, list_span, item))
    }

    /// Returns the number of components of item `i` of the list.
    pub fn width(&self, i: usize) -> usize {
        match &self.widths {
            Widths::Uniform(width) => *width as usize,
            Widths::Mixed(widths) => widths[i] as usize,
        }
    }
}
