//! The option `--dump`: prints a Scene or a World as JSON with one item per line and positions `file:line:column`.

use crate::source::{Sources, Span};
use serde::Serialize;
use serde_json::Value;

/// Maximum length of an item that is written on one line, in bytes.
const WIDTH: usize = 100;

/// Formats a stage of the scene, which `--dump` prints, as JSON with a line ending at the end.
pub fn to_json(sources: &Sources, stage: &impl Serialize) -> String {
    let mut value = serde_json::to_value(stage).unwrap_or_default();
    replace_spans_by_positions(sources, &mut value);
    let mut out = String::new();
    write_json(&value, 0, 0, &mut out);
    out + "\n"
}

/// Replaces spans by positions in the text.
fn replace_spans_by_positions(sources: &Sources, value: &mut Value) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(|item| replace_spans_by_positions(sources, item)),
        Value::Object(fields) => match as_span(fields) {
            Some(span) => *value = sources.place(span).map_or(Value::Null, |place| place.to_string().into()),
            None => fields.values_mut().for_each(|field| replace_spans_by_positions(sources, field)),
        },
        _ => {}
    }
}

fn as_span(fields: &serde_json::Map<String, Value>) -> Option<Span> {
    let number = |name| fields.get(name)?.as_u64().map(|n| n as usize);
    if fields.len() == 2 { Some(Span::new(number("lo")?, number("hi")?)) } else { None }
}

/// Writes a value after `used_columns` bytes of a line that is indented by `depth` steps.
fn write_json(value: &Value, depth: usize, used_columns: usize, out: &mut String) {
    let room = WIDTH.saturating_sub(2 * depth + used_columns);
    let is_short = |text: &String| text.len() <= room;
    match value {
        Value::Array(items) if !items.is_empty() => match Some(cut_one_line_json(value, room)).filter(is_short) {
            Some(text) => out.push_str(&text),
            None => write_block(out, depth, ['[', ']'], items, |item, out| write_json(item, depth + 1, 0, out)),
        },
        Value::Object(fields) if !fields.is_empty() => match Some(cut_one_line_json(value, room)).filter(is_short) {
            Some(text) => out.push_str(&text),
            None => write_block(out, depth, ['{', '}'], fields, |(name, field), out| {
                let name = format!("{}: ", Value::from(name.as_str()));
                out.push_str(&name);
                write_json(field, depth + 1, name.len(), out);
            }),
        },
        other => out.push_str(&other.to_string()),
    }
}

fn write_block<T>(
    out: &mut String,
    depth: usize,
    [open, close]: [char; 2],
    items: impl IntoIterator<Item = T>,
    each: impl Fn(T, &mut String),
) {
    out.push(open);
    for (i, item) in items.into_iter().enumerate() {
        out.push_str(if i > 0 { ",\n" } else { "\n" });
        out.push_str(&"  ".repeat(depth + 1));
        each(item, out);
    }
    out.push('\n');
    out.push_str(&"  ".repeat(depth));
    out.push(close);
}

/// Formats a value on one line. A text longer than `max_bytes` bytes is incomplete.
fn cut_one_line_json(value: &Value, max_bytes: usize) -> String {
    let mut out = String::new();
    write_one_line_json(value, max_bytes, &mut out);
    out
}

fn write_one_line_json(value: &Value, max_bytes: usize, out: &mut String) {
    if out.len() > max_bytes {
        return;
    }
    match value {
        Value::Array(items) => {
            out.push('[');
            for (i, item) in items.iter().enumerate().take_while(|(i, _)| *i <= max_bytes) {
                out.push_str(if i > 0 { ", " } else { "" });
                write_one_line_json(item, max_bytes, out);
            }
            out.push(']');
        }
        Value::Object(fields) => {
            out.push('{');
            for (i, (name, field)) in fields.iter().enumerate() {
                out.push_str(if i > 0 { ", " } else { "" });
                out.push_str(&format!("{}: ", Value::from(name.as_str())));
                write_one_line_json(field, max_bytes, out);
            }
            out.push('}');
        }
        other => out.push_str(&other.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn positions_are_named_and_long_items_take_several_lines() {
        let sources = Sources::default();
        let file = sources.add("a.scene", None, "sphere\n  { }".into()).unwrap();
        let base = sources.base(file);
        let long = vec![1.5; 40];
        let value = json!({
            "at": {"lo": base + 9, "hi": base + 10}, "none": {"lo": 0, "hi": 0}, "point": [1, 2], "other": {"lo": 0.5, "hi": 1},
            "long": [long, []],
        });
        let text = to_json(&sources, &value);
        let start = "{\n  \"at\": \"a.scene:2:3\",\n  \"none\": null,\n  \"point\": [1, 2],\n  \"other\": {\"lo\": 0.5, \"hi\": 1},\n";
        assert!(text.starts_with(start) && text.contains("\n      1.5,\n"), "{text}");
        let read: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(read["long"], value["long"]);
    }
}
