//! Manual pages about directives, functions and constants.

use super::{in_backticks, table};
use crate::function::numeric;
use crate::interpreter;
use crate::interpreter::directives::TABLE;
use crate::syntax::word::CONSTANTS;

pub(super) fn directives_page() -> String {
    let intro = "A directive may stand anywhere between two things. All examples run.\n\n";
    let each = TABLE.iter().map(|entry| {
        let names = entry.names.iter().map(|name| format!("#{name}")).collect::<Vec<_>>().join(", ");
        let (form, summary, example) = (entry.form, entry.summary, entry.example);
        format!("## {names}\n\n`{form}`: {summary}.\n\n```pov\n{example}\n```\n\n")
    });
    intro.to_string() + &each.collect::<String>()
}

pub(super) fn functions_page() -> String {
    let numbers = numeric::TABLE.iter().map(|row| {
        let usage = match row.kernel {
            numeric::Kernel::One(_) => "A",
            numeric::Kernel::Two(_) => "A, B",
            numeric::Kernel::Many(_) => "A, B, …",
        };
        [in_backticks(&format!("{}({usage})", row.name)), row.summary.to_string()]
    });
    let others = interpreter::script_only_functions()
        .map(|(name, usage, summary)| [in_backticks(&format!("{name}{usage}")), summary.into()]);
    let head = ["function", "gives"];
    format!(
        "## Of numbers\n\nIn scripts and in `function {{ }}` alike. Angles are in radians.\n\n{}\
         ## Of vectors, texts, arrays, objects and files\n\nIn scripts only, but for `select`.\n\n{}",
        table(head, numbers),
        table(head, others)
    )
}

pub(super) fn constants_page() -> String {
    let intro = "Names that durer sets. No scene can declare them anew.\n\n";
    intro.to_string()
        + &table(["name", "is"], CONSTANTS.iter().map(|(name, what)| [in_backticks(name), what.to_string()]))
}
