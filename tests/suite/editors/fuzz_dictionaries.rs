//! libFuzzer's dictionaries: words that a fuzzer inserts into its inputs.

use super::{File, GENERATED};
use clap::CommandFactory;
use durer::reference::WordsByKind;

/// Signs of the language that are hard to find by chance, and openings of common constructs.
const SIGNS: [&str; 12] =
    ["/*", "*/", "//", "<0, 0, 0>", "<1, 2, 3>", "[0 ", "] ", " { ", " } ", "= function {", "#end\n", "!="];

pub fn files(by_kind: &WordsByKind, options: &[&str]) -> Vec<File> {
    let words = [&by_kind.objects, &by_kind.blocks, &by_kind.functions, &by_kind.constants, &by_kind.words]
        .into_iter()
        .flatten();
    let directives = by_kind.directives.iter().map(|name| format!("#{name} "));
    let language = words.map(|word| format!("{word} ")).chain(directives).chain(SIGNS.map(String::from));
    let ini_names = options.iter().map(|name| format!("{name}="));
    vec![
        ("../fuzz/dictionaries/language.dict", dictionary(language)),
        ("../fuzz/dictionaries/options.dict", dictionary(ini_names.chain(flags()))),
    ]
}

/// Returns the commands and long flags of durer's command line.
fn flags() -> impl Iterator<Item = String> {
    let command = durer::cli::Cli::command();
    let named = |command: &clap::Command| {
        let flags = command.get_arguments().filter_map(|argument| argument.get_long().map(|name| format!("--{name}=")));
        std::iter::once(command.get_name().to_string()).chain(flags).collect::<Vec<_>>()
    };
    let all: std::collections::BTreeSet<_> =
        std::iter::once(&command).chain(command.get_subcommands()).flat_map(named).collect();
    all.into_iter()
}

fn dictionary(words: impl Iterator<Item = String>) -> String {
    let quoted = words.map(|word| format!("\"{}\"\n", word.replace('\n', "\\x0a")));
    std::iter::once(format!("# {GENERATED}\n")).chain(quoted).collect()
}
