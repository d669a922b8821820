//! Vim's syntax files, and the detection of POV-Ray's INI files.

use super::{File, GENERATED, lines};
use durer::reference::WordsByKind;

pub fn files(by_kind: &WordsByKind, options: &[&str]) -> Vec<File> {
    vec![
        ("neovim/syntax/povray.vim", scene(by_kind)),
        ("neovim/syntax/povrayini.vim", ini(options)),
        ("neovim/lua/durer/options.lua", list(options)),
    ]
}

fn keywords(group: &str, words: &[&str]) -> String {
    lines(words, " ").iter().map(|line| format!("syntax keyword {group} {line}\n")).collect()
}

fn scene(by_kind: &WordsByKind) -> String {
    let sorted = [
        ("povrayObject", &by_kind.objects),
        ("povrayBlock", &by_kind.blocks),
        ("povrayFunction", &by_kind.functions),
        ("povrayConstant", &by_kind.constants),
        ("povrayWord", &by_kind.words),
    ];
    let words: String = sorted.iter().map(|(group, words)| keywords(group, words)).collect();
    let directives = by_kind.directives.join("\\|");
    format!("\" {GENERATED}\n{SCENE_HEAD}{words}{}{SCENE_TAIL}", SCENE_DIRECTIVES.replace("DIRECTIVES", &directives))
}

const SCENE_HEAD: &str = r#"if exists('b:current_syntax')
  finish
endif
syntax case match
syntax iskeyword @,48-57,_

"#;

const SCENE_DIRECTIVES: &str = r#"
syntax match povrayNumber /\%(\<\d\+\%(\.\d*\)\=\|\.\d\+\)\%([eE][-+]\=\d\+\)\=\>\=/
syntax match povrayDeclared /\<\h\w*\>/ contained
syntax match povrayMacro /\<\h\w*\>/ contained nextgroup=povrayParameters skipwhite skipnl
syntax region povrayParameters start=/(/ end=/)/ contained contains=povrayParameter,povrayComment,povrayOptional
syntax match povrayParameter /\<\h\w*\>/ contained
syntax keyword povrayOptional optional contained
syntax match povrayDirective /#[ \t]*\%(DIRECTIVES\)\>/
syntax match povrayDirective /#[ \t]*\%(declare\|local\)\>/ nextgroup=povrayDeclared skipwhite skipnl
syntax match povrayDirective /#[ \t]*macro\>/ nextgroup=povrayMacro skipwhite skipnl
syntax match povrayDirective /#[ \t]*for\>\ze\s*(/ nextgroup=povrayCounter skipwhite
syntax match povrayCounter /(\s*\h\w*/ contained contains=povrayDeclared
"#;

const SCENE_TAIL: &str = r#"
syntax keyword povrayTodo TODO FIXME XXX contained
syntax region povrayString start=/"/ skip=/\\./ end=/"/ contains=povrayEscape
syntax match povrayEscape /\\\%(u\x\{4}\|.\)/ contained
syntax match povrayComment +//.*$+ contains=povrayTodo,@Spell
" They nest.
syntax region povrayComment start=+/\*+ end=+\*/+ contains=povrayComment,povrayTodo,@Spell
syntax sync fromstart

highlight default link povrayObject Type
highlight default link povrayBlock Structure
highlight default link povrayFunction Function
highlight default link povrayConstant Constant
highlight default link povrayWord Statement
highlight default link povrayNumber Number
highlight default link povrayDirective PreProc
highlight default link povrayDeclared Identifier
highlight default link povrayMacro Macro
highlight default link povrayParameter Identifier
highlight default link povrayOptional PreProc
highlight default link povrayString String
highlight default link povrayEscape SpecialChar
highlight default link povrayComment Comment
highlight default link povrayTodo Todo

let b:current_syntax = 'povray'
"#;

fn ini(options: &[&str]) -> String {
    let options = keywords("povrayiniOption", options);
    format!("\" {GENERATED}\n{}{options}{INI_TAIL}", SCENE_HEAD.replace("case match", "case ignore"))
}

const INI_TAIL: &str = r#"syntax keyword povrayiniConstant on off true false yes no
syntax match povrayiniNumber /\%(\<\d\+\%(\.\d*\)\=\|\.\d\+\)\%([eE][-+]\=\d\+\)\=\>\=/
syntax match povrayiniSwitch /\%(^\|\s\)\zs[-+]\a\+/
syntax match povrayiniSection /^\s*\[[^\]]*\]\=/
syntax region povrayiniString start=/"/ end=/"/ oneline
syntax match povrayiniComment /[;#].*$/ contains=@Spell

highlight default link povrayiniOption Identifier
highlight default link povrayiniConstant Constant
highlight default link povrayiniNumber Number
highlight default link povrayiniSwitch Statement
highlight default link povrayiniSection Title
highlight default link povrayiniString String
highlight default link povrayiniComment Comment

let b:current_syntax = 'povrayini'
"#;

fn list(options: &[&str]) -> String {
    let quoted: Vec<_> = options.iter().map(|name| format!("'{name}'")).collect();
    let quoted: Vec<&str> = quoted.iter().map(String::as_str).collect();
    let lines: String = lines(&quoted, ", ").iter().map(|line| format!("  {line},\n")).collect();
    format!("-- {GENERATED}\nreturn {{\n{lines}}}\n")
}
