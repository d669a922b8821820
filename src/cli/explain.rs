//! `durer explain CODE`: what a message means and what to do about it.

use super::args::ExplainArgs;
use super::console::Console;
use super::exit::{Exit, Result};
use crate::diagnostic::{codes, did_you_mean};

/// Explains one code, or lists all.
pub fn run(console: &Console, args: &ExplainArgs) -> Result {
    let Some(wanted) = &args.code else {
        let list: String = codes::ALL.iter().map(|e| format!("{}  {}\n", e.code, e.title)).collect();
        console.data(list)?;
        return Ok(Exit::Fine);
    };
    match codes::find(wanted) {
        Some(found) => {
            console.data(format!("{}: {}\n\n{}\n", found.code, found.title, found.text))?;
            Ok(Exit::Fine)
        }
        None => {
            let near = did_you_mean(&wanted.to_uppercase(), codes::ALL.iter().map(|e| e.code.0));
            let help = near.unwrap_or("`durer explain` lists all codes".into());
            super::exit::usage(format!("there is no code `{wanted}`; {help}"))
        }
    }
}
