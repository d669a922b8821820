//! Emacs's lists of words; `povray-mode.el` assigns their colours.

use super::{File, GENERATED, lines};
use durer::reference::Sorts;

pub fn files(sorts: &Sorts, options: &[&str]) -> Vec<File> {
    let list = |name: &str, about: &str, words: &[&str]| {
        let quoted: Vec<_> = words.iter().map(|word| format!("\"{word}\"")).collect();
        let quoted: Vec<&str> = quoted.iter().map(String::as_str).collect();
        format!("(defconst povray-words-{name}\n  '({})\n  \"{about}\")\n\n", lines(&quoted, " ").join("\n    "))
    };
    let lists = [
        list("objects", "Objects.", &sorts.objects),
        list("blocks", "What else has braces.", &sorts.blocks),
        list("functions", "What takes arguments in parentheses.", &sorts.functions),
        list("constants", "Values.", &sorts.constants),
        list("others", "All other words of scenes.", &sorts.words),
        list("directives", "What stands behind #.", &sorts.directives),
        list("openers", "Directives that an #end closes.", &sorts.openers),
        list("continuers", "Directives between such a one and its #end.", &sorts.continuers),
        list("options", "Names in INI files.", options),
    ];
    let head = ";;; povray-words.el --- Words of POV-Ray's scene language  -*- lexical-binding: t -*-";
    let comment = format!(";;; Commentary:\n;; {GENERATED}\n\n;;; Code:\n");
    let tail = "(provide 'povray-words)\n;;; povray-words.el ends here\n";
    vec![("emacs/povray-words.el", format!("{head}\n\n{comment}\n{}{tail}", lists.concat()))]
}
