//! "Did you mean …?"

/// Nobody types longer names by hand, and comparing two takes the product of their lengths.
const LONGEST: usize = 200;

/// The nearest of some words, if it is near enough to be a slip of the fingers: at most a third of
/// the letters differ. Letter case counts little.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if word.len() > LONGEST {
        return None;
    }
    let lower = word.to_lowercase();
    let limit = (word.chars().count().max(3) / 3).min(3);
    let score = |candidate: &str| match distance(&lower, &candidate.to_lowercase()) {
        0 => 0,
        // Nothing in common.
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

/// The sentence for the help line.
pub fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<String> {
    nearest(word, known).map(|found| format!("did you mean `{found}`?"))
}

/// Optimal string alignment distance: insertions, deletions, substitutions, swaps of neighbours.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let change = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                let mut best = change.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
                if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                    best = best.min(rows[i - 2][j - 2] + 1);
                }
                best
            };
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_are_found() {
        let words = ["sphere", "rotate", "translate", "radius", "phong", "phong_size"];
        assert_eq!(nearest("shpere", words), Some("sphere"));
        assert_eq!(nearest("Sphere", words), Some("sphere"));
        assert_eq!(nearest("traslate", words), Some("translate"));
        assert_eq!(nearest("box", words), None);
        assert_eq!(nearest("banana", words), None);
    }
}
