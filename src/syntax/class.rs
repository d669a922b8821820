//! Classes of tokens: the characters that the grammar reads, their names in `grammar/scene.pest`, and the directives
//! that have a body. A test compares the grammar with this table.
//!
//! A directive without a body (`#debug`, `#include` …) is a [`PLAIN`] token; the interpreter knows these by name.

/// Effect of a directive on the nesting of directives' bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// Assigns the value that follows to a name, and has no body.
    Declares,
    /// Opens a body that `#end` closes.
    Opens,
    /// Ends the body of a directive of one of these classes, and begins its next body.
    Continues(&'static [u8]),
    /// Ends the innermost open body.
    Ends,
}

macro_rules! classes {
    ($($name:ident $class:literal $doc:literal,)*) => {
        $(#[doc = $doc] pub(super) const $name: u8 = $class;)*

        /// Each class of tokens and its name in the grammar.
        #[cfg(test)]
        const CLASSES: &[(u8, &str)] = &[$(($class, stringify!($name)),)*];
    };
}

classes! {
    KEYWORD b'k' "`sphere`, `color`, `translate` …",
    NAME b'n' "A name that an author chose, or a constant: `x`, `pi`, `clock`.",
    BUILTIN b'f' "`sin`, `vlength` …",
    HEAD b'b' "A word followed by its complete block.",
    FUNCTION b'u' "`function`",
    DEPRECATED b'd' "`deprecated`, after `#declare`.",
    NUMBER b'1' "A number without a sign.",
    STRING b'"' "A text in its quotes.",
    LITERAL b'2' "`<1, 2, 3>`: a vector of numbers.",
    NUMBERS b'3' "Two or more numbers and literal vectors with commas between them: a mesh is one token.",
    PLUS b'+' "`+`",
    MINUS b'-' "`-`",
    TIMES b'*' "`*`",
    OVER b'/' "`/`",
    NOT b'!' "`!`",
    LESS b'<' "A `<` that compares, or that has no `>` in the same brackets.",
    GREATER b'>' "A `>` that compares.",
    LESS_EQUAL b'4' "`<=`",
    GREATER_EQUAL b'5' "`>=`",
    EQUAL b'=' "`=`",
    NOT_EQUAL b'6' "`!=`",
    AND b'&' "`&`",
    OR b'|' "`|`",
    DOT b'.' "`.`",
    COMMA b',' "`,`",
    SEMICOLON b';' "`;`",
    BRACE b'{' "A `{` whose `}` is in the same body.",
    BRACE_END b'}' "The `}` of a `BRACE`.",
    PAREN b'(' "A `(` whose `)` is in the same body.",
    PAREN_END b')' "The `)` of a `PAREN`.",
    BRACKET b'[' "A `[` whose `]` is in the same body.",
    BRACKET_END b']' "The `]` of a `BRACKET`.",
    VECTOR b'0' "A `<` that opens a vector.",
    VECTOR_END b'9' "The `>` of a `VECTOR`.",
    CHOICE b'?' "A `?` whose `:` is in the same brackets.",
    CHOICE_ELSE b':' "The `:` of a `CHOICE`.",
    LOOSE b'~' "A bracket without its partner in this body, or a character without meaning.",
    DECLARE b'D' "`#declare`, `#local`",
    IF b'I' "`#if`",
    IFDEF b'J' "`#ifdef`",
    IFNDEF b'K' "`#ifndef`",
    ELSEIF b'G' "`#elseif`",
    ELSE b'L' "`#else`",
    WHILE b'W' "`#while`",
    FOR b'R' "`#for`",
    SWITCH b'S' "`#switch`",
    CASE b'C' "`#case`",
    RANGE b'T' "`#range`",
    MACRO b'M' "`#macro`",
    END b'E' "`#end`",
    PLAIN b'#' "`#` and any other word.",
}

const BRANCHES: &[u8] = &[IF, IFDEF, IFNDEF];

/// Name, token class and role of each directive that the grammar handles.
const DIRECTIVES: &[(&str, u8, Role)] = &[
    ("declare", DECLARE, Role::Declares),
    ("local", DECLARE, Role::Declares),
    ("if", IF, Role::Opens),
    ("ifdef", IFDEF, Role::Opens),
    ("ifndef", IFNDEF, Role::Opens),
    ("elseif", ELSEIF, Role::Continues(BRANCHES)),
    ("else", ELSE, Role::Continues(&[IF, IFDEF, IFNDEF, SWITCH])),
    ("while", WHILE, Role::Opens),
    ("for", FOR, Role::Opens),
    ("switch", SWITCH, Role::Opens),
    ("case", CASE, Role::Continues(&[SWITCH])),
    ("range", RANGE, Role::Continues(&[SWITCH])),
    ("macro", MACRO, Role::Opens),
    ("end", END, Role::Ends),
];

/// Returns the class and role of the directive of this name; `None` for a [`PLAIN`] one such as `#include`.
pub(super) fn directive_class_and_role(word: &str) -> Option<(u8, Role)> {
    DIRECTIVES.iter().find(|(name, ..)| *name == word).map(|&(_, class, role)| (class, role))
}

/// Returns the names of the directives that open, continue or end a body, and `declare` and `local`.
pub fn structural_directives() -> impl Iterator<Item = &'static str> {
    DIRECTIVES.iter().map(|(name, ..)| *name)
}

/// True if the directive of this name opens a body that `#end` closes.
pub fn directive_opens_body(word: &str) -> bool {
    DIRECTIVES.iter().any(|row| row.0 == word && row.2 == Role::Opens)
}

/// True if the directive of this name begins a further body before the `#end`, as `#else` does.
pub fn directive_continues_body(word: &str) -> bool {
    DIRECTIVES.iter().any(|row| row.0 == word && matches!(row.2, Role::Continues(_)))
}

/// True if a directive of this class opens a body.
pub(super) fn class_opens_body(class: u8) -> bool {
    DIRECTIVES.iter().any(|row| row.1 == class && row.2 == Role::Opens)
}

/// True if a token of this class begins with `#`.
pub(super) fn is_directive(class: u8) -> bool {
    class == PLAIN || class.is_ascii_uppercase()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    /// Returns the tokens that the grammar defines as `NAME = { "n" }` or `NAME = _{ "n" }`.
    fn named_in_grammar() -> BTreeMap<String, u8> {
        let grammar = include_str!("../../grammar/scene.pest");
        let rule = |line: &str| {
            let (name, body) = line.split_once('=')?;
            let body = body.trim().trim_start_matches('_').strip_prefix('{')?.split_once('}').map_or(body, |b| b.0);
            let text = body.trim().strip_prefix('"')?.strip_suffix('"')?;
            let class = *text.trim_start_matches('\\').as_bytes().first()?;
            name.trim().chars().all(|c| c.is_ascii_uppercase() || c == '_').then(|| (name.trim().to_string(), class))
        };
        // (The quoted braces would end the body too early.)
        let lines = grammar.lines().map(|line| line.replace("\"{\"", "\"\u{1}\"").replace("\"}\"", "\"\u{2}\""));
        let found = lines.filter_map(|line| rule(&line)).map(|(name, class)| {
            (
                name,
                match class {
                    1 => b'{',
                    2 => b'}',
                    class => class,
                },
            )
        });
        found.collect()
    }

    #[test]
    fn classes_match_the_grammar() {
        let table: BTreeMap<String, u8> = CLASSES.iter().map(|(class, name)| (name.to_string(), *class)).collect();
        assert_eq!(named_in_grammar(), table);
    }

    #[test]
    fn directives_have_classes_of_their_own() {
        for (class, name) in CLASSES {
            assert_eq!(is_directive(*class), *class == PLAIN || DIRECTIVES.iter().any(|row| row.1 == *class), "{name}");
        }
    }

    #[test]
    fn no_two_classes_share_a_character() {
        let mut all: Vec<u8> = CLASSES.iter().map(|c| c.0).collect();
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), CLASSES.len());
    }
}
