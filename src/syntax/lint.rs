//! The lints of `--warn`: names that are declared and never used, and names that hide others. They are found in the
//! text alone, so that branches that do not run count too.

use super::ast::Symbol;
use super::class;
use super::lex::{Lexed, lex};
use super::{Names, portable};
use crate::diagnostic::{Diagnostic, codes};
use crate::source::{FileId, Sources, Span};
use rustc_hash::{FxHashMap, FxHashSet};

/// Switches that enable lints of a scene's text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lints {
    /// W0209: declared in the scene's own file, and used in none of the files.
    pub unused: bool,
    /// W0210: a `#local` or a parameter in a macro of the scene's own file hides a name declared outside of macros.
    pub shadow: bool,
    /// W0420: text in the scene's own file that POV-Ray 3.7 would reject.
    pub portable: bool,
}

/// Declaration of a name that a lint examines.
struct Declaration {
    symbol: Symbol,
    span: Span,
    what: What,
    /// Number of macro definitions that enclose the declaration.
    depth: usize,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum What {
    Declare,
    Local,
    Macro,
    Parameter,
}

/// Lints the first file, which is the scene's own; the others are its includes.
pub fn lint(sources: &Sources, names: &Names, files: &[FileId], lints: Lints) -> Vec<Diagnostic> {
    let scans: Vec<Scan> = files.iter().map(|&file| Scan::of(sources, names, file)).collect();
    let Some(own) = scans.first() else { return vec![] };
    let mut out = vec![];
    if lints.unused {
        out.extend(unused(names, own, &scans));
    }
    if lints.shadow {
        out.extend(shadows(names, own, &scans));
    }
    if lints.portable {
        out.extend(portable::lint_portability(sources, names, files));
    }
    out
}

fn unused(names: &Names, own: &Scan, all: &[Scan]) -> Vec<Diagnostic> {
    let used: FxHashSet<Symbol> = all.iter().flat_map(|scan| scan.uses.iter().copied()).collect();
    let mut told = FxHashSet::default();
    let mut out = vec![];
    for d in own.declarations.iter().filter(|d| d.what != What::Parameter && !used.contains(&d.symbol)) {
        let name = names.text(d.symbol);
        // A leading `_` marks an intentionally unused name.
        if !name.starts_with('_') && told.insert(d.symbol) {
            let what = if d.what == What::Macro { "the macro " } else { "" };
            let message = format!("{what}`{name}` is declared and never used");
            let help = format!("remove it, or call it `_{name}` if that is meant");
            out.push(Diagnostic::new(codes::UNUSED_NAME, d.span, message).help(help));
        }
    }
    out
}

fn shadows(names: &Names, own: &Scan, all: &[Scan]) -> Vec<Diagnostic> {
    let mut globals: FxHashMap<Symbol, Span> = FxHashMap::default();
    for d in all.iter().flat_map(|scan| &scan.declarations).filter(|d| d.depth == 0) {
        globals.entry(d.symbol).or_insert(d.span);
    }
    let inner = own.declarations.iter().filter(|d| d.depth > 0 && matches!(d.what, What::Local | What::Parameter));
    let hides = |d: &Declaration| {
        let outer = *globals.get(&d.symbol)?;
        let name = names.text(d.symbol);
        let what = if d.what == What::Local { "`#local`" } else { "parameter" };
        let message = format!("the {what} `{name}` hides a name that is declared outside of the macro");
        let d = Diagnostic::new(codes::HIDDEN_NAME, d.span, message).label("from here on, this one is meant");
        Some(d.also(outer, "not this one").help("give it another name"))
    };
    inner.filter_map(hides).collect()
}

/// Declarations and uses of names that the lints found in one file.
#[derive(Default)]
struct Scan {
    declarations: Vec<Declaration>,
    uses: Vec<Symbol>,
}

impl Scan {
    fn of(sources: &Sources, names: &Names, file: FileId) -> Self {
        let (text, base) = (sources.text(file), sources.base(file));
        let mut scanner =
            Scanner { text, base, lexed: lex(text, base, names, true), at: 0, open: vec![], out: Scan::default() };
        while scanner.at < scanner.lexed.classes.len() {
            scanner.step();
        }
        scanner.out
    }
}

struct Scanner<'t> {
    text: &'t str,
    base: usize,
    lexed: Lexed,
    at: usize,
    /// Open directives around the token; true for macros.
    open: Vec<bool>,
    out: Scan,
}

impl Scanner<'_> {
    fn class(&self, ahead: usize) -> u8 {
        self.lexed.classes.get(self.at + ahead).copied().unwrap_or(0)
    }

    fn step(&mut self) {
        match self.class(0) {
            class::DECLARE => self.declaration(),
            class::MACRO => self.definition(),
            class if class::opens_body(class) => self.open.push(false),
            class::END => drop(self.open.pop()),
            // `#undef A` is not a use.
            class::PLAIN if self.is_undef() && self.class(1) == class::NAME => self.at += 1,
            class::NAME => self.out.uses.push(Symbol(self.lexed.tokens[self.at].data)),
            _ => {}
        }
        self.at += 1;
    }

    fn is_undef(&self) -> bool {
        let token = self.lexed.tokens[self.at];
        self.text[token.start as usize..token.end as usize].ends_with("undef")
    }

    /// Scans a declaration, `#declare A =`; `#declare A[i] =` declares an element only.
    fn declaration(&mut self) {
        let token = self.lexed.tokens[self.at];
        let local = self.text[token.start as usize..token.end as usize].ends_with("local");
        let skipped = if self.class(1) == class::DEPRECATED {
            1 + (2..5).take_while(|&i| self.class(i) != class::NAME).count()
        } else {
            0
        };
        if self.class(1 + skipped) == class::NAME {
            self.at += 1 + skipped;
            if self.class(1) == class::EQUAL {
                self.declare(if local { What::Local } else { What::Declare });
            }
        }
    }

    /// Scans a macro definition, `#macro A(B, optional C)`.
    fn definition(&mut self) {
        if self.class(1) == class::NAME {
            self.at += 1;
            self.declare(What::Macro);
        }
        self.open.push(true);
        if self.class(1) == class::PAREN {
            self.at += 1;
            while !matches!(self.class(1), class::PAREN_END | 0) {
                self.at += 1;
                // `optional C`: the second name is the parameter's.
                if self.class(0) == class::NAME && self.class(1) != class::NAME {
                    self.declare(What::Parameter);
                }
            }
        }
    }

    /// Records a declaration of the current name.
    fn declare(&mut self, what: What) {
        let token = self.lexed.tokens[self.at];
        let span = Span::new(self.base + token.start as usize, self.base + token.end as usize);
        let depth = self.open.iter().filter(|is_macro| **is_macro).count();
        self.out.declarations.push(Declaration { symbol: Symbol(token.data), span, what, depth });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(text: &str, include: &str) -> Vec<String> {
        let (sources, names) = (Sources::default(), Names::default());
        let files = [text, include].map(|text| sources.add("a", None, text.into()).unwrap());
        let lints = Lints { unused: true, shadow: true, portable: false };
        let line = |d: &Diagnostic| format!("{} {}", d.code, sources.snippet(d.span()));
        lint(&sources, &names, &files, lints).iter().map(line).collect()
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
