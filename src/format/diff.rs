//! What formatting changes, for a person.

/// Lines around each change.
const AROUND: usize = 3;

/// Both texts side by side as `diff -u` shows them; nothing where they are the same. Formatting moves lines but a little, so
/// the next pair of equal lines is looked for nearby.
pub fn diff(name: &str, old: &str, new: &str) -> String {
    let (a, b): (Vec<_>, Vec<_>) = (old.split_inclusive('\n').collect(), new.split_inclusive('\n').collect());
    let mut out = String::new();
    let changes = changes(&a, &b);
    let mut i = 0;
    while i < changes.len() {
        let mut last = i;
        while last + 1 < changes.len() && changes[last + 1].0.start - changes[last].0.end <= 2 * AROUND {
            last += 1;
        }
        if out.is_empty() {
            out = format!("--- {name}\n+++ {name} (formatted)\n");
        }
        out += &hunk(&a, &b, &changes[i..=last]);
        i = last + 1;
    }
    out
}

type Change = (std::ops::Range<usize>, std::ops::Range<usize>);

/// How far an equal line is looked for.
const FAR: usize = 400;

fn changes(a: &[&str], b: &[&str]) -> Vec<Change> {
    let (mut i, mut j, mut out) = (0, 0, vec![]);
    while i < a.len() || j < b.len() {
        if i < a.len() && j < b.len() && a[i] == b[j] {
            (i, j) = (i + 1, j + 1);
            continue;
        }
        // The nearest pair of equal lines, by the sum of both distances; blank ones say little.
        let meets = |sum: usize| {
            (0..=sum)
                .map(move |k| (i + k, j + sum - k))
                .find(|&(p, q)| p < a.len() && q < b.len() && a[p] == b[q] && !a[p].trim().is_empty())
        };
        let (mut p, mut q) = (1..FAR).find_map(meets).unwrap_or((a.len(), b.len()));
        while p > i && q > j && a[p - 1] == b[q - 1] {
            (p, q) = (p - 1, q - 1);
        }
        out.push((i..p, j..q));
        (i, j) = (p, q);
    }
    out
}

fn hunk(a: &[&str], b: &[&str], changes: &[Change]) -> String {
    let [first, ..] = changes else { return String::new() };
    let last = &changes[changes.len() - 1];
    let before = first.0.start.min(AROUND).min(first.1.start);
    let after = (a.len() - last.0.end).min(AROUND).min(b.len() - last.1.end);
    let (from, to) = (first.0.start - before, last.0.end + after);
    let (new_from, new_to) = (first.1.start - before, last.1.end + after);
    let place = |from: usize, to: usize| format!("{},{}", if from < to { from + 1 } else { from }, to - from);
    let mut out = format!("@@ -{} +{} @@\n", place(from, to), place(new_from, new_to));
    let mut put = |sign: char, lines: &[&str]| {
        for line in lines {
            let end = if line.ends_with('\n') { "" } else { "\n\\ No newline at end of file\n" };
            out.push_str(&format!("{sign}{line}{end}"));
        }
    };
    let mut at = from;
    for (old, new) in changes {
        put(' ', &a[at..old.start]);
        put('-', &a[old.clone()]);
        put('+', &b[new.clone()]);
        at = old.end;
    }
    put(' ', &a[at..to]);
    out
}
