//! Emacs's lists of words; `povray-mode.el` assigns their colours.

use super::{File, GENERATED, lines};
use durer::reference::WordsByKind;

pub fn files(by_kind: &WordsByKind, options: &[&str]) -> Vec<File> {
    let list = |name: &str, about: &str, words: &[&str]| {
        let quoted: Vec<_> = words.iter().map(|word| format!("\"{word}\"")).collect();
        let quoted: Vec<&str> = quoted.iter().map(String::as_str).collect();
        format!("(defconst povray-words-{name}\n  '({})\n  \"{about}\")\n\n", lines(&quoted, " ").join("\n    "))
    };
    let lists = [
        list("objects", "Objects.", &by_kind.objects),
        list("blocks", "What else has braces.", &by_kind.blocks),
        list("functions", "What takes arguments in parentheses.", &by_kind.functions),
        list("constants", "Values.", &by_kind.constants),
        list("others", "All other words of scenes.", &by_kind.words),
        list("directives", "What stands behind #.", &by_kind.directives),
        list("openers", "Directives that an #end closes.", &by_kind.openers),
        list("continuers", "Directives between such a one and its #end.", &by_kind.continuers),
        list("options", "Names in INI files.", options),
    ];
    let head = ";;; povray-words.el --- Words of POV-Ray's scene language  -*- lexical-binding: t -*-";
    let comment = format!(";;; Commentary:\n;; {GENERATED}\n\n;;; Code:\n");
    let tail = "(provide 'povray-words)\n;;; povray-words.el ends here\n";
    vec![("emacs/povray-words.el", format!("{head}\n\n{comment}\n{}{tail}", lists.concat()))]
}
