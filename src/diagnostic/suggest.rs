//! Suggestions of the form "did you mean …?" for misspelt words.

use strsim::osa_distance;

/// Maximum length of compared words, in bytes. The time is proportional to the product of both lengths.
const LONGEST: usize = 200;

/// Returns the word of `known`, other than `word` itself, with the least edit distance to `word`, if at most a third of the
/// letters (and at most three) differ. Letter case is ignored; a candidate with another first letter counts as half an
/// edit more.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if word.len() > LONGEST {
        return None;
    }
    let lower = word.to_lowercase();
    let limit = (word.chars().count().max(3) / 3).min(3);
    let score = |candidate: &str| match osa_distance(&lower, &candidate.to_lowercase()) {
        0 => 0,
        // No letter in common.
        d if d >= lower.chars().count() => usize::MAX,
        d => 2 * d + usize::from(!candidate.starts_with(word.chars().next().unwrap_or(' '))),
    };
    known
        .into_iter()
        .filter(|candidate| *candidate != word && candidate.chars().count().abs_diff(word.chars().count()) <= limit)
        .map(|candidate| (score(candidate), candidate))
        .min_by_key(|&(score, candidate)| (score, candidate))
        .filter(|&(score, _)| score <= 2 * limit + 1)
        .map(|(_, candidate)| candidate)
}

/// Returns the sentence "did you mean …?" for a help line; `None` if no known word is similar.
pub fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<String> {
    nearest(word, known).map(|found| format!("did you mean `{found}`?"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn typos_are_found() {
        let words = ["sphere", "rotate", "translate", "radius", "phong", "phong_size"];
        assert_eq!(nearest("shpere", words), Some("sphere"));
        assert_eq!(nearest("Sphere", words), Some("sphere"));
        assert_eq!(nearest("traslate", words), Some("translate"));
        assert_eq!(nearest("box", words), None);
        assert_eq!(nearest("banana", words), None);
    }
}
