//! The command `durer explain CODE`: explains a message and its remedy.

use super::args::ExplainArgs;
use super::console::Console;
use super::exit::{Exit, Result, usage_error};
use crate::diagnostic::codes::{self, Explanation};

/// Explains one diagnostic code, or lists all codes.
pub fn run(console: &Console, args: &ExplainArgs) -> Result {
    let Some(wanted) = &args.code else {
        let list: String = codes::ALL.iter().map(|e| format!("{}  {}\n", e.code, e.title)).collect();
        console.write_to_stdout(list)?;
        return Ok(Exit::Fine);
    };
    let found = explanations_named_in(wanted);
    if found.is_empty() {
        let near = code_of_nearest_number(wanted).map(|e| format!("the nearest is `{}` ({}); ", e.code, e.title));
        return usage_error(format!(
            "there is no code `{wanted}`; {}`durer explain` lists all codes",
            near.unwrap_or_default()
        ));
    }
    let texts: Vec<_> = found.iter().map(|e| format!("{}: {}\n\n{}\n", e.code, e.title, e.text)).collect();
    console.write_to_stdout(texts.join("\n"))?;
    Ok(Exit::Fine)
}

/// Returns the explanations of the codes that a text names: `E0203`, or for a number without a letter both the error and
/// the warning. Leading zeros are optional, and the code may be in brackets: `error[E0203]`. Empty if no such code exists.
fn explanations_named_in(wanted: &str) -> Vec<&'static Explanation> {
    let wanted = wanted.trim();
    let wanted = wanted.split_once('[').map_or(wanted, |(_, code)| code.trim_end_matches([':', ']']));
    let digits = wanted.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    let letter = &wanted[..wanted.len() - digits.len()];
    let Ok(number) = digits.parse::<u32>() else { return vec![] };
    let letters = if letter.is_empty() { vec!["E", "W"] } else { vec![letter] };
    letters.into_iter().filter_map(|letter| codes::find_explanation(&format!("{letter}{number:04}"))).collect()
}

/// Returns the code with the nearest number, among those of the same letter if there are any; `None` if the text has no
/// number.
fn code_of_nearest_number(wanted: &str) -> Option<&'static Explanation> {
    let number = |code: &str| code.trim_matches(|c: char| !c.is_ascii_digit()).parse::<i64>().ok();
    let (letter, wanted) = (wanted.chars().next()?.to_ascii_uppercase(), number(wanted)?);
    codes::ALL
        .iter()
        .filter_map(|e| {
            let distance = number(e.code.0)?.saturating_sub(wanted).abs();
            Some(((!e.code.0.starts_with(letter), distance), e))
        })
        .min_by_key(|(key, _)| *key)
        .map(|(_, e)| e)
}
