//! `--dump`: a Scene or a World as JSON that a person can read: one thing a line, and places as `file:line:column`.

use crate::source::{Sources, Span};
use serde::Serialize;
use serde_json::Value;

/// What is not longer stands on one line.
const WIDTH: usize = 100;

/// As text, with the end of its last line.
pub fn text(sources: &Sources, thing: &impl Serialize) -> String {
    let mut value = serde_json::to_value(thing).unwrap_or_default();
    name_places(sources, &mut value);
    let mut out = String::new();
    write(&value, 0, 0, &mut out);
    out + "\n"
}

/// A span means nothing to a person.
fn name_places(sources: &Sources, value: &mut Value) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(|item| name_places(sources, item)),
        Value::Object(fields) => match as_span(fields) {
            Some(span) => *value = sources.place(span).map_or(Value::Null, |place| place.to_string().into()),
            None => fields.values_mut().for_each(|field| name_places(sources, field)),
        },
        _ => {}
    }
}

fn as_span(fields: &serde_json::Map<String, Value>) -> Option<Span> {
    let number = |name| fields.get(name)?.as_u64().map(|n| n as usize);
    if fields.len() == 2 { Some(Span::new(number("lo")?, number("hi")?)) } else { None }
}

/// Behind `before` letters of a line that is indented by so many steps.
fn write(value: &Value, depth: usize, before: usize, out: &mut String) {
    let room = WIDTH.saturating_sub(2 * depth + before);
    let is_short = |text: &String| text.len() <= room;
    match value {
        Value::Array(items) if !items.is_empty() => match Some(brief(value, room)).filter(is_short) {
            Some(text) => out.push_str(&text),
            None => block(out, depth, ['[', ']'], items, |item, out| write(item, depth + 1, 0, out)),
        },
        Value::Object(fields) if !fields.is_empty() => match Some(brief(value, room)).filter(is_short) {
            Some(text) => out.push_str(&text),
            None => block(out, depth, ['{', '}'], fields, |(name, field), out| {
                let name = format!("{}: ", Value::from(name.as_str()));
                out.push_str(&name);
                write(field, depth + 1, name.len(), out);
            }),
        },
        other => out.push_str(&other.to_string()),
    }
}

fn block<T>(
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

/// On one line, with blanks; what becomes longer than `room` is not finished.
fn brief(value: &Value, room: usize) -> String {
    let mut out = String::new();
    brief_to(value, room, &mut out);
    out
}

fn brief_to(value: &Value, room: usize, out: &mut String) {
    if out.len() > room {
        return;
    }
    match value {
        Value::Array(items) => {
            out.push('[');
            for (i, item) in items.iter().enumerate().take_while(|(i, _)| *i <= room) {
                out.push_str(if i > 0 { ", " } else { "" });
                brief_to(item, room, out);
            }
            out.push(']');
        }
        Value::Object(fields) => {
            out.push('{');
            for (i, (name, field)) in fields.iter().enumerate() {
                out.push_str(if i > 0 { ", " } else { "" });
                out.push_str(&format!("{}: ", Value::from(name.as_str())));
                brief_to(field, room, out);
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
    fn places_are_named_and_long_things_take_lines() {
        let sources = Sources::default();
        let file = sources.add("a.scene", None, "sphere\n  { }".into()).unwrap();
        let base = sources.base(file);
        let long = vec![1.5; 40];
        let value = json!({
            "at": {"lo": base + 9, "hi": base + 10}, "none": {"lo": 0, "hi": 0}, "point": [1, 2], "other": {"lo": 0.5, "hi": 1},
            "long": [long, []],
        });
        let text = text(&sources, &value);
        let start = "{\n  \"at\": \"a.scene:2:3\",\n  \"none\": null,\n  \"point\": [1, 2],\n  \"other\": {\"lo\": 0.5, \"hi\": 1},\n";
        assert!(text.starts_with(start) && text.contains("\n      1.5,\n"), "{text}");
        let read: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(read["long"], value["long"]);
    }
}
