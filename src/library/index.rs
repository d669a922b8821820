//! Which of the standard include files declares which name: for messages, looked up when there is a fault.

/// Written by `tests/library/index.py`: a file a line, and behind its name what it declares. `stones1.inc=stones.inc` is a part of
/// another file, which people include in its place.
const INDEX: &str = include_str!("index.txt");

/// A file, and the names that it declares.
struct Row {
    file: &'static str,
    /// The file to include for its names: itself, or what it is a part of.
    whole: &'static str,
    names: std::str::SplitWhitespace<'static>,
}

impl Row {
    fn declares(&self, name: &str) -> bool {
        self.names.clone().any(|n| n == name)
    }
}

fn rows() -> impl Iterator<Item = Row> {
    let lines = INDEX.lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(|line| {
        let mut names = line.split_whitespace();
        let head = names.next()?;
        let (file, whole) = head.split_once('=').unwrap_or((head, head));
        Some(Row { file, whole, names })
    })
}

/// The file to include for a name.
pub fn declared_in(name: &str) -> Option<&'static str> {
    rows().find(|row| row.declares(name)).map(|row| row.whole)
}

/// Does this file declare the name, or a part of it?
pub fn declares(file: &str, name: &str) -> bool {
    rows().any(|row| (row.file == file || row.whole == file) && row.declares(name))
}

/// Is it the name of a standard include file?
pub fn is_standard(file: &str) -> bool {
    rows().any(|row| row.file == file)
}

/// All names of all files.
pub fn index_names() -> impl Iterator<Item = &'static str> {
    rows().flat_map(|row| row.names)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found() {
        assert_eq!(declared_in("T_Wood10"), Some("woods.inc"));
        assert_eq!(declared_in("Red"), Some("colors.inc"));
        assert_eq!(declared_in("F_MetalA"), Some("metals.inc"));
        assert_eq!(declared_in("T_Stone5"), Some("stones.inc"));
        assert_eq!(declared_in("T_Glass3"), Some("glass.inc"));
        assert_eq!(declared_in("No_Such_Name"), None);
        assert!(declares("shapes.inc", "Round_Box") && is_standard("textures.inc"));
    }
}
