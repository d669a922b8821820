//! Finds names that are declared and never used, and names that hide others (`--warn`). The text alone is examined,
//! including branches that do not run.

use super::lex::lex;
use super::outline::{Declaration, DeclarationKind, Outline};
use super::tokens::Tokens;
use super::{Names, portable};
use crate::diagnostic::{Diagnostic, codes};
use crate::source::{FileId, Sources, Span};
use rustc_hash::{FxHashMap, FxHashSet};

/// Switches that enable lints of a scene's text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lints {
    /// W0209: a name is declared in the scene's own file and used in no file.
    pub unused: bool,
    /// W0210: a `#local` or a parameter in a macro of the scene's own file hides a name declared outside of macros.
    pub shadow: bool,
    /// W0420: text in the scene's own file that POV-Ray 3.7 would reject.
    pub portable: bool,
}

/// Returns the lints of a scene's own file, `scene_and_includes[0]`. The other files are its includes: they are read
/// for the names that they declare and use.
pub fn lint_scene(sources: &Sources, scene_and_includes: &[FileId], lints: Lints) -> Vec<Diagnostic> {
    let outline = |(i, &file): (usize, &FileId)| {
        let (text, base_in_sources) = (sources.text(file), sources.base(file));
        // Rules about commas need each number of the scene's own file as a token.
        let lists = i > 0 || !lints.portable;
        Outline::new(text, &Tokens::new(lex(text, base_in_sources, &Names::default(), lists), base_in_sources))
    };
    let outlines: Vec<Outline> = scene_and_includes.iter().enumerate().map(outline).collect();
    let Some(own) = outlines.first() else { return vec![] };
    let mut out = vec![];
    if lints.unused {
        out.extend(unused_name_warnings(own, &outlines));
    }
    if lints.shadow {
        out.extend(locals_hiding_globals(own, &outlines));
    }
    if lints.portable {
        out.extend(portable::lint_portability(own, &outlines));
    }
    out
}

fn unused_name_warnings(own_file: &Outline, all_files: &[Outline]) -> Vec<Diagnostic> {
    let mut used: FxHashSet<&str> = FxHashSet::default();
    for outline in all_files {
        let read = outline.uses.iter().filter(|one| one.is_read);
        used.extend(read.map(|one| outline.slice(&one.range)));
        // A loop's counter may be a declared name.
        let counters = outline.declarations.iter().filter(|d| d.kind == DeclarationKind::Counter);
        used.extend(counters.map(|d| d.name.as_str()));
    }
    use DeclarationKind::{Declare, Local, Macro};
    let mut reported = FxHashSet::default();
    let mut out = vec![];
    for d in own_file.declarations.iter().filter(|d| matches!(d.kind, Declare | Local | Macro)) {
        let name = d.name.as_str();
        // A leading `_` marks an intentionally unused name.
        if !used.contains(name) && !name.starts_with('_') && reported.insert(name) {
            let kind = if d.kind == Macro { "the macro " } else { "" };
            let message = format!("{kind}`{name}` is declared and never used");
            let help = format!("remove it, or call it `_{name}` if that is meant");
            out.push(Diagnostic::new(codes::UNUSED_NAME, own_file.span(&d.range), message).help(help));
        }
    }
    out
}

/// Returns a warning for each parameter and `#local` of a macro in `own_file` that has the name of a global declaration
/// in any outline.
fn locals_hiding_globals(own_file: &Outline, all_files: &[Outline]) -> Vec<Diagnostic> {
    let mut globals: FxHashMap<&str, Span> = FxHashMap::default();
    for outline in all_files {
        let global = |d: &&Declaration| d.scope.is_none() && d.kind != DeclarationKind::Counter;
        for d in outline.declarations.iter().filter(global) {
            globals.entry(&d.name).or_insert_with(|| outline.span(&d.range));
        }
    }
    let hides = |d: &Declaration| {
        let kind = match d.kind {
            DeclarationKind::Local if d.scope.is_some() => "`#local`",
            DeclarationKind::Parameter => "parameter",
            _ => return None,
        };
        let (name, outer) = (&d.name, *globals.get(d.name.as_str())?);
        let message = format!("the {kind} `{name}` hides a name that is declared outside of the macro");
        let d = Diagnostic::new(codes::HIDDEN_NAME, own_file.span(&d.range), message)
            .label("from here on, this one is meant");
        Some(d.also(outer, "not this one").help("give it another name"))
    };
    own_file.declarations.iter().filter_map(hides).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(text: &str, include: &str) -> Vec<String> {
        let sources = Sources::default();
        let files = [text, include].map(|text| sources.add("a", None, text.into()).unwrap());
        let lints = Lints { unused: true, shadow: true, portable: false };
        let line = |d: &Diagnostic| format!("{} {}", d.code, sources.snippet(d.span()));
        lint_scene(&sources, &files, lints).iter().map(line).collect()
    }

    #[test]
    fn unused_names() {
        assert_eq!(
            told("#declare A = 1; #local B = A; #declare A = 2; #macro M(P) 1 #end", ""),
            ["W0209 B", "W0209 M"]
        );
        assert_eq!(told("#declare A = 1; #declare _B = 2; sphere { 0, A }", ""), [""; 0]);
        assert_eq!(told("#declare A = 1; #undef A", ""), ["W0209 A"]);
        assert_eq!(told("#declare A = 1; #ifdef (A) #end", ""), [""; 0]);
        assert_eq!(told("#declare A = 1; #include \"b\"", "#if (A) #end #declare Unused = 3;"), [""; 0]);
        assert_eq!(told("#declare A = array[2]; #declare A[0] = 1;", ""), ["W0209 A"]);
        assert_eq!(told("#for (I, 1, 3) sphere { 0, 1 } #end", ""), [""; 0]);
    }

    #[test]
    fn hidden_names() {
        let text =
            "#declare A = 1; #macro M(A, optional B) #local C = A + B; C #end #local C = M(A, 1); sphere { 0, C }";
        assert_eq!(told(text, ""), ["W0210 A", "W0210 C"]);
        let inner = "#macro M(P) #local I = P; I #end #macro N() #local I = M(1); I #end N()";
        assert_eq!(told(inner, ""), [""; 0]);
        assert_eq!(told("#macro M(Red) Red #end M(1)", "#declare Red = 2;"), ["W0210 Red"]);
        assert_eq!(told("#if (1) #local A = 1; #end sphere { 0, A }", ""), [""; 0]);
    }
}
