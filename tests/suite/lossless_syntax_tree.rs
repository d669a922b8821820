//! The syntax tree loses nothing: tokens, comments and the blanks between them are the file, every node of the tree has
//! a valid span, and a part of the text alone gives the same elements.

use durer::source::{Sources, Span};
use durer::syntax::ast::*;
use durer::syntax::{Granularity, Names, parse, parse_text, tokens_of};
use rustc_hash::FxHashSet;
use std::path::{Path, PathBuf};

const BOTH: [Granularity; 2] = [Granularity::Whole, Granularity::Tokens];

/// All texts in the language below a folder.
fn gather(folder: &Path, out: &mut Vec<PathBuf>) {
    for path in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()) {
        if path.is_dir() && !path.is_symlink() {
            gather(&path, out);
        } else if path.extension().is_some_and(|e| e == "scene" || e == "pov" || e == "inc") {
            out.push(path);
        }
    }
}

/// The repository's files and, where POV-Ray is installed, every third of its files (`DURER_FUZZ=1`: all).
fn texts() -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = vec![];
    for folder in ["scenes", "tests", "src/library"] {
        gather(&root.join(folder), &mut files);
    }
    assert!(files.len() > 200);
    let mut povrays = vec![];
    gather(Path::new("/usr/share/povray-3.7/include"), &mut povrays);
    gather(Path::new("/usr/share/doc/povray/examples"), &mut povrays);
    povrays.sort();
    let step = if std::env::var_os("DURER_FUZZ").is_some() { 1 } else { 3 };
    files.extend(povrays.into_iter().step_by(step));
    files.sort();
    let read = |path: PathBuf| durer::source::read_text(&durer::source::Disk, &path).ok().map(|text| (path, text));
    // Skip huge lists of numbers.
    files.into_iter().filter_map(read).filter(|(_, text)| text.len() < 500_000).collect()
}

/// Applies a check to each text, and reports failures with their paths.
fn each(check: impl Fn(&str) -> Result<(), String> + Sync) {
    let wrong: Vec<String> = durer::on_big_stack(|| {
        let told = |(path, text): (PathBuf, String)| check(&text).err().map(|why| format!("{}: {why}", path.display()));
        texts().into_iter().filter_map(told).collect()
    });
    assert!(wrong.is_empty(), "{} texts:\n{}", wrong.len(), wrong.join("\n"));
}

// ---------------------------------------------------------------- tokens

/// Tokens and faults are the same without the tree, in a whole text and in one that is truncated or lacks its middle.
fn without_tree(text: &str) -> Result<(), String> {
    let place = |of: usize| text.floor_char_boundary(text.len() * of / 13);
    let (a, b) = (place(5), place(7));
    for text in [text, &text[..a], &text[b..], &format!("{}{}", &text[..a], &text[b..])] {
        let (ast, faults) = parse_text(text, 1, &Names::default(), Granularity::Whole);
        let (tokens, told) = tokens_of(text, 1);
        let said = |all: &[durer::diagnostic::Diagnostic]| format!("{all:?}");
        if said(&faults) != said(&told) {
            return Err(format!("{}\n  with the tree, and\n{}\n  without", said(&faults), said(&told)));
        }
        if !ast.tokens.tokens_and_comments().eq(tokens.tokens_and_comments()) {
            return Err("other tokens".into());
        }
    }
    Ok(())
}

#[test]
fn lexer_and_parser_report_the_same_faults() {
    each(without_tree);
}

/// True for text that the lexer ignores. (A text with faults may contain more of it.)
fn means_nothing(between: &str) -> bool {
    between.chars().all(|c| c <= ' ' || matches!(c, '#' | '\u{A0}' | '\u{FEFF}' | '\u{7F}'))
}

fn joined(text: &str, granularity: Granularity) -> Result<(), String> {
    let sources = Sources::default();
    // A file before it, so that its spans do not begin at 0.
    sources.add("before", None, "sphere { 0, 1 }".into()).unwrap();
    let file = sources.add("text", None, text.into()).unwrap();
    let (ast, faults) = parse(&sources, file, &Names::default(), granularity);
    let base = sources.base(file);
    let (mut out, mut at) = (String::new(), base);
    for piece in ast.tokens.tokens_and_comments() {
        let Span { lo, hi } = piece.span();
        let (lo, hi) = (lo as usize, hi as usize);
        if lo < at || hi < lo || hi > base + text.len() {
            return Err(format!("{piece:?} stands before {at}, or behind the end"));
        }
        let between = &text[at - base..lo - base];
        if faults.is_empty() && !means_nothing(between) {
            return Err(format!("{between:?} between two tokens"));
        }
        out.push_str(between);
        out.push_str(&text[lo - base..hi - base]);
        at = hi;
    }
    let rest = &text[at - base..];
    if faults.is_empty() && !means_nothing(rest) {
        return Err(format!("{rest:?} behind the last token"));
    }
    if out + rest == text { Ok(()) } else { Err("not the same bytes".into()) }
}

#[test]
fn tokens_and_comments_make_up_the_file() {
    for granularity in BOTH {
        each(|text| joined(text, granularity));
    }
}

// ---------------------------------------------------------------- places

/// Walks a tree and checks every span.
struct Places<'t> {
    starts: FxHashSet<u32>,
    ends: FxHashSet<u32>,
    text: &'t str,
    base: usize,
    wrong: Vec<String>,
}

impl Places<'_> {
    fn place(&mut self, what: &str, span: Span, around: Span) {
        let inside = around.lo <= span.lo && span.hi <= around.hi && span.lo <= span.hi;
        let whole = self.starts.contains(&span.lo) && self.ends.contains(&span.hi);
        if inside && whole || self.wrong.len() > 5 {
            return;
        }
        let snippet = |span: Span| {
            let range = (span.lo as usize).saturating_sub(self.base)..(span.hi as usize).saturating_sub(self.base);
            self.text.get(range).unwrap_or("?").chars().take(40).collect::<String>()
        };
        let why = if inside { "no whole tokens" } else { "outside of what it stands in" };
        self.wrong.push(format!("{what} `{}` in `{}`: {why}", snippet(span), snippet(around)));
    }

    /// Consecutive elements: each in its parent, and after the one before.
    fn elements(&mut self, elements: &[Element], around: Span) {
        let mut at = around.lo;
        for e in elements {
            self.place("element", e.span, Span { lo: at, hi: around.hi });
            at = e.span.hi;
            self.element(e);
        }
    }

    fn element(&mut self, e: &Element) {
        match &e.kind {
            ElementKind::Expr(expr) => self.expr(expr, e.span),
            ElementKind::Block(block) => self.block(block, e.span),
            ElementKind::Group(group) | ElementKind::Entry(group) => self.elements(&group.body, e.span),
            ElementKind::Function(function) => self.function(function, e.span),
            ElementKind::Directive(directive) => self.directive(directive, e.span),
            ElementKind::Numbers(list) => self.items(list, e.span),
            ElementKind::Word(_) | ElementKind::Semicolon | ElementKind::Comma | ElementKind::Punctuation(_) => {}
        }
    }

    /// Literals with commas between them: the text of each span is that item.
    fn items(&mut self, list: &NumberList, span: Span) {
        let text = self.text;
        let at = |place: usize| place - self.base;
        let (mut count, mut data, mut end) = (0, vec![], span.lo as usize);
        for item in NumberList::item_spans(&text[at(span.lo as usize)..at(span.hi as usize)], span) {
            let written = &text[at(item.lo as usize)..at(item.hi as usize)];
            let between = &text[at(end)..at(item.lo as usize)];
            if between.trim_matches(|c| c <= ' ') != if count == 0 { "" } else { "," } {
                self.wrong.push(format!("{between:?} before item {count} `{written}`"));
            }
            let numbers = written.split(|c: char| matches!(c, '<' | ',' | '>') || c <= ' ').filter(|n| !n.is_empty());
            data.extend(numbers.map(|n| n.parse::<f64>().unwrap()));
            (count, end) = (count + 1, item.hi as usize);
        }
        if count != list.len() || data != *list.data || end != span.hi as usize {
            self.wrong.push(format!("{count} items for {}, to {end} for {}", list.len(), span.hi));
        }
    }

    fn block(&mut self, block: &Block, span: Span) {
        self.place("name", block.name.span, span);
        self.elements(&block.body, Span { lo: block.name.span.hi, ..span });
    }

    fn function(&mut self, function: &Function, span: Span) {
        self.exprs(&function.size, span);
        self.elements(&function.body, span);
    }

    fn exprs(&mut self, all: &[Expr], around: Span) {
        let mut at = around.lo;
        for e in all {
            self.expr(e, Span { lo: at, hi: around.hi });
            at = e.span.hi;
        }
    }

    fn expr(&mut self, e: &Expr, around: Span) {
        self.place("expression", e.span, around);
        let span = e.span;
        match &e.kind {
            ExprKind::Vector(parts) | ExprKind::Call(_, parts) => self.elements(parts, span),
            ExprKind::Paren(inner) | ExprKind::Prefix(_, inner) => self.expr(inner, span),
            ExprKind::Chain(chain) => {
                self.expr(&chain.first, span);
                let mut at = chain.first.span.hi;
                for (_, operand) in &chain.rest {
                    self.expr(operand, Span { lo: at, ..span });
                    at = operand.span.hi;
                }
            }
            ExprKind::Choice(parts) => self.exprs(&parts[..], span),
            ExprKind::Builtin(_, arguments) => self.exprs(arguments, span),
            ExprKind::Index(base, indices) => {
                self.expr(base, span);
                self.exprs(indices, Span { lo: base.span.hi, ..span });
            }
            ExprKind::Apply(base, arguments) => {
                self.expr(base, span);
                self.elements(arguments, Span { lo: base.span.hi, ..span });
            }
            ExprKind::Dot(base, name, _) => {
                self.expr(base, span);
                self.place("component", name.span, Span { lo: base.span.hi, ..span });
            }
            ExprKind::Function(function) => self.function(function, span),
            ExprKind::Block(block) => self.block(block, span),
            ExprKind::Number(_) | ExprKind::Text(_) | ExprKind::Name(_) | ExprKind::Literal(_) => {}
        }
    }

    fn head(&mut self, head: &Head, span: Span) {
        match head {
            Head::Whole(e) => self.expr(e, span),
            Head::Pieces(Some(elements)) => self.elements(elements, span),
            Head::Pieces(None) => {}
        }
    }

    fn target(&mut self, target: &Target, span: Span) {
        self.place("target", target.span, span);
        self.exprs(&target.indices, Span { lo: target.span.hi, ..span });
    }

    fn branch(&mut self, branch: &Branch, around: Span) {
        self.place("branch", branch.span, around);
        match &branch.condition {
            Condition::True(head) | Condition::Declared(head) | Condition::NotDeclared(head) => {
                self.head(head, branch.span);
            }
            Condition::Always => {}
        }
        self.elements(&branch.body, branch.span);
    }

    fn arm(&mut self, arm: &Arm, around: Span) {
        self.place("arm", arm.span, around);
        match &arm.when {
            When::Case(head) => self.head(head, arm.span),
            When::Range(Some(ends)) => self.elements(ends, arm.span),
            When::Range(None) | When::Otherwise => {}
        }
        self.elements(&arm.body, arm.span);
    }

    fn directive(&mut self, directive: &Directive, span: Span) {
        match directive {
            Directive::Declare(declare) => {
                self.target(&declare.target, span);
                declare.others.iter().for_each(|target| self.target(target, span));
            }
            Directive::If(branches) => {
                let mut at = span.lo;
                for branch in branches {
                    self.branch(branch, Span { lo: at, ..span });
                    at = branch.span.hi;
                }
            }
            Directive::While(head, body) => {
                self.head(head, span);
                self.elements(body, span);
            }
            Directive::For(one) => {
                match &one.head {
                    ForHead::Whole(_, parts) => self.exprs(parts, span),
                    ForHead::Pieces(Some(elements)) => self.elements(elements, span),
                    ForHead::Pieces(None) => {}
                }
                self.elements(&one.body, span);
            }
            Directive::Switch(head, arms) => {
                self.head(head, span);
                let mut at = span.lo;
                for arm in arms {
                    self.arm(arm, Span { lo: at, ..span });
                    at = arm.span.hi;
                }
            }
            Directive::Macro(one) => {
                self.place("name of a macro", one.span, span);
                one.fault.into_iter().for_each(|fault| self.place("fault", fault, span));
                self.elements(&one.body, span);
            }
            Directive::DeclarePieces(_) | Directive::Plain(_) => {}
        }
    }
}

fn placed(text: &str, granularity: Granularity) -> Result<(), String> {
    const BASE: usize = 1234;
    let (ast, _) = parse_text(text, BASE, &Names::default(), granularity);
    let spans: Vec<Span> = ast.tokens.tokens_and_comments().map(|piece| piece.span()).collect();
    let (starts, ends) = (spans.iter().map(|s| s.lo).collect(), spans.iter().map(|s| s.hi).collect());
    let mut places = Places { starts, ends, text, base: BASE, wrong: vec![] };
    places.elements(&ast.elements, Span::new(BASE, BASE + text.len()));
    if places.wrong.is_empty() { Ok(()) } else { Err(places.wrong.join("\n    ")) }
}

#[test]
fn spans_cover_whole_tokens_inside_their_parent() {
    for granularity in BOTH {
        each(|text| placed(text, granularity));
    }
}

// ---------------------------------------------------------------- pieces

/// Positions where the text can be cut: after elements that end a statement, while no bracket is open.
fn cuts(elements: &[Element]) -> Vec<usize> {
    let (mut open, mut cuts) = (0_i64, vec![0]);
    for (i, e) in elements.iter().enumerate() {
        match &e.kind {
            ElementKind::Punctuation(Punctuation::Open(_)) => open += 1,
            ElementKind::Punctuation(Punctuation::Close(_)) => open -= 1,
            _ => {}
        }
        let ends = match &e.kind {
            ElementKind::Semicolon | ElementKind::Block(_) => true,
            ElementKind::Directive(directive) => {
                !matches!(**directive, Directive::Declare(_) | Directive::DeclarePieces(_) | Directive::Plain(_))
            }
            _ => false,
        };
        if ends && open == 0 {
            cuts.push(i + 1);
        }
    }
    cuts.dedup();
    cuts
}

fn alone(text: &str, granularity: Granularity) -> Result<(), String> {
    let names = Names::default();
    const BASE: usize = 77;
    let (ast, faults) = parse_text(text, BASE, &names, granularity);
    if !faults.is_empty() {
        return Ok(());
    }
    let cuts = cuts(&ast.elements);
    let start = |i: usize| ast.elements.get(i).map_or(text.len(), |e| e.span.lo as usize - BASE);
    let pairs = cuts.windows(2).map(|w| (w[0], w[1]));
    // Single statements, and runs of ten.
    let runs = cuts.windows(11).step_by(10).map(|w| (w[0], w[10]));
    for (from, to) in pairs.chain(runs) {
        let (lo, hi) = (start(from), start(to));
        let (piece, faults) = parse_text(&text[lo..hi], BASE + lo, &names, granularity);
        let (found, expected) = (format!("{:?}", piece.elements), format!("{:?}", &ast.elements[from..to]));
        if !faults.is_empty() || found != expected {
            return Err(format!("`{}` alone is\n{found}\nnot\n{expected}", &text[lo..hi]));
        }
    }
    Ok(())
}

#[test]
fn parts_of_a_text_parse_the_same() {
    for granularity in BOTH {
        each(|text| alone(text, granularity));
    }
}
