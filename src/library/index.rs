//! Which of the standard include files declares which name: for messages, looked up when there is a fault.

/// Written by `tests/library/index.py`: a file a line, and behind its name what it declares.
const INDEX: &str = include_str!("index.txt");

/// The files, each with the names that it declares.
fn files() -> impl Iterator<Item = (&'static str, std::str::SplitWhitespace<'static>)> {
    let lines = INDEX.lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(|line| {
        let mut words = line.split_whitespace();
        words.next().map(|file| (file, words))
    })
}

/// The file that declares a name. Where several do, the one to include.
pub fn declared_in(name: &str) -> Option<&'static str> {
    files().find(|(_, names)| names.clone().any(|n| n == name)).map(|(file, _)| file)
}

/// Does this file declare the name?
pub fn declares(file: &str, name: &str) -> bool {
    files().any(|(f, mut names)| f == file && names.any(|n| n == name))
}

/// Is it the name of a standard include file?
pub fn is_standard(file: &str) -> bool {
    files().any(|(f, _)| f == file)
}

/// All names of all files.
pub fn index_names() -> impl Iterator<Item = &'static str> {
    files().flat_map(|(_, names)| names)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found() {
        assert_eq!(declared_in("T_Wood10"), Some("woods.inc"));
        assert_eq!(declared_in("Red"), Some("colors.inc"));
        assert_eq!(declared_in("F_MetalA"), Some("metals.inc"));
        assert_eq!(declared_in("No_Such_Name"), None);
        assert!(declares("shapes.inc", "Round_Box") && is_standard("textures.inc"));
    }
}
