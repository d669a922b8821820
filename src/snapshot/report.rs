//! HTML page that shows expected and rendered pictures and their differences.

use super::difference_map;
use crate::diagnostic::Result;
use crate::image_io::{Encoding, Format, Frame, encode};

/// One scene on the page that reports snapshot tests.
#[derive(Clone, Debug)]
pub struct Entry<'a> {
    /// Path of the tested scene.
    pub name: String,
    /// True if the rendered picture agrees with its snapshot.
    pub fine: bool,
    /// Path of the snapshot: the expected picture of the scene.
    pub snapshot: String,
    /// Result of the snapshot test as text.
    pub text: String,
    /// The command that accepts the rendered picture as the snapshot; `None` if it agrees, or none was rendered.
    pub accept: Option<String>,
    /// Expected picture, with which the rendered picture is compared; `None` without a snapshot or a rendered picture.
    pub expected: Option<&'a Frame>,
    /// Picture that the test rendered of the scene; `None` if the scene could not be rendered.
    pub rendered: Option<&'a Frame>,
}

/// Files of a snapshot report: names and contents.
pub type Report = Vec<(String, Vec<u8>)>;

/// Returns the page `index.html` and its pictures. Scenes with differences come first.
///
/// # Errors
/// E0008 for pictures that PNG can't hold.
pub fn report(entries: &[Entry<'_>]) -> Result<Report> {
    let mut files = Report::new();
    let (mut good, mut bad) = (String::new(), String::new());
    for entry in entries {
        let pictures = pictures_as_html(entry, &mut files)?;
        let (class, list) = if entry.fine { ("ok", &mut good) } else { ("bad", &mut bad) };
        let (title, text) = (escape_html(&entry.name), escape_html(&entry.text));
        let snapshot = format!("<small>{}</small>", escape_html(&entry.snapshot));
        let accept =
            entry.accept.as_ref().map(|command| format!("<p>Is it right? <code>{}</code></p>", escape_html(command)));
        let accept = accept.unwrap_or_default();
        *list += &format!(
            "<section class={class}><h2>{title}</h2>{snapshot}<p>{text}</p>{accept}<div>{pictures}</div></section>\n"
        );
    }
    let fine = entries.iter().filter(|e| e.fine).count();
    let summary = format!("{fine} of {} pictures are as expected", entries.len());
    let page = PAGE.replace("SUMMARY", &summary).replace("BAD", &bad).replace("GOOD", &good);
    files.push(("index.html".into(), page.into_bytes()));
    Ok(files)
}

/// Returns the pictures of one scene as HTML, and adds their files to the report.
fn pictures_as_html(entry: &Entry<'_>, files: &mut Report) -> Result<String> {
    let stem: String =
        entry.name.chars().map(|c| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' }).collect();
    let map = entry.expected.zip(entry.rendered).map(|(expected, rendered)| difference_map(expected, rendered));
    let shown = match entry.fine {
        true => [("rendered", entry.rendered), ("expected", None), ("difference", None)],
        false => [("expected", entry.expected), ("rendered", entry.rendered), ("difference", map.as_ref())],
    };
    let mut html = String::new();
    for (name, frame) in shown {
        let Some(frame) = frame else { continue };
        let file = format!("{stem}.{name}.png");
        html += &format!("<figure><a href=\"{file}\"><img src=\"{file}\" alt=\"{name}\"></a>");
        html += &format!("<figcaption>{name}</figcaption></figure>");
        files.push((file, encode(frame, &Encoding { alpha: true, ..Encoding::new(Format::Png) })?));
    }
    Ok(html)
}

fn escape_html(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

const PAGE: &str = r#"<!doctype html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>durer test: SUMMARY</title>
<style>
:root { color-scheme: light dark; --line: light-dark(#ddd, #444); --soft: light-dark(#666, #aaa) }
body { font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 1200px; padding: 0 1rem }
h1 { font-size: 1.4rem; font-weight: 600 }
h2 { font: 600 .95rem ui-monospace, monospace; margin: 0; overflow-wrap: anywhere }
section { border: 1px solid var(--line); border-left: 5px solid #2a9d5c; border-radius: 6px; padding: .8rem 1rem; margin: .8rem 0 }
section.bad { border-left-color: #d1403c }
section small { color: var(--soft); font: .8rem ui-monospace, monospace; overflow-wrap: anywhere }
code { user-select: all; background: light-dark(#eee, #333); padding: .1rem .3rem; border-radius: 3px }
section p { margin: .2rem 0 .6rem; color: var(--soft); white-space: pre-wrap }
section div { display: grid; grid-template-columns: repeat(auto-fit, minmax(200px, 1fr)); gap: 1rem }
figure { margin: 0 } figcaption { color: var(--soft); font-size: .85rem }
img { width: 100%; image-rendering: pixelated; border-radius: 3px;
      background: repeating-conic-gradient(#999 0 25%, #bbb 0 50%) 0 0 / 16px 16px }
#good { display: grid; grid-template-columns: repeat(auto-fill, minmax(220px, 1fr)); gap: .8rem }
#good section { margin: 0 }
</style>
<h1>SUMMARY</h1>
BAD
<div id="good">
GOOD
</div>
</html>
"#;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differing_scenes_have_three_pictures_and_others_one() {
        let frame = Frame::new(2, 2);
        let entry = |name: &str, fine| Entry {
            name: name.into(),
            fine,
            snapshot: name.replace("scene", "snapshot.png"),
            text: "1 < 2".into(),
            accept: (!fine).then(|| format!("durer test --accept {name}")),
            expected: Some(&frame),
            rendered: Some(&frame),
        };
        let files = report(&[entry("a/<b>.scene", false), entry("c.scene", true)]).unwrap();
        let names: Vec<_> = files.iter().map(|(name, _)| name.as_str()).collect();
        let bad = ["expected", "rendered", "difference"].map(|name| format!("a__b_.scene.{name}.png"));
        assert_eq!(names, [&bad[0], &bad[1], &bad[2], "c.scene.rendered.png", "index.html"]);
        let page = String::from_utf8(files[4].1.clone()).unwrap();
        assert!(page.contains("a/&lt;b&gt;.scene") && page.contains("1 &lt; 2") && page.contains("1 of 2 pictures"));
        assert!(page.matches("<code>durer test --accept a/&lt;b&gt;.scene</code>").count() == 1);
        assert!(page.contains("<small>c.snapshot.png</small>") && !page.contains("--accept c.scene"));
    }
}
