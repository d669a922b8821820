//! The rules of [`super`].

use super::declared::Kind;
use super::{Walk, is_directive, value};
use crate::diagnostic::Label;
use crate::syntax::class;
use crate::syntax::word::{self, GROUPS, SHAPES};

/// Blocks with numbers and words, in which POV-Ray accepts no comma before a word and none at the end.
#[rustfmt::skip]
const STRICT: &[&str] = &[
    "sphere", "box", "cylinder", "cone", "torus", "plane", "triangle", "smooth_triangle", "polygon", "prism", "lathe",
    "superellipsoid", "quadric", "text", "isosurface", "sphere_sweep", "blob", "mesh", "object", "finish", "camera",
    "global_settings", "light_source", "interior",
];
/// Blocks of objects, in which it accepts no comma at all.
const JOINING: &[&str] = &["union", "merge", "intersection", "difference"];
/// Blocks with lists of blocks, in which it accepts none between two.
const ROWS: &[&str] = &["mesh", "blob", "sky_sphere"];
/// Maps, in which it accepts none between the entries.
const MAPS: &[&str] =
    &["color_map", "colour_map", "pigment_map", "normal_map", "texture_map", "slope_map", "density_map"];
/// Words of objects, cameras and lights, none of which can begin anything else after a comma.
#[rustfmt::skip]
const MODIFIERS: &[&str] = &[
    "pigment", "texture", "normal", "finish", "interior", "material", "interior_texture", "scale", "rotate",
    "translate", "matrix", "transform", "no_shadow", "no_image", "no_reflection", "hollow", "open", "sturm", "inverse",
    "clipped_by", "bounded_by", "double_illuminate", "photons", "uv_mapping", "location", "look_at", "right", "up",
    "sky", "angle", "direction", "shadowless", "spotlight", "point_at", "radius", "falloff", "tightness", "area_light",
    "adaptive", "jitter", "fade_distance", "fade_power", "looks_like", "parallel", "max_trace_level", "assumed_gamma",
    "ambient_light", "adc_bailout", "ior", "ambient", "diffuse", "phong", "phong_size", "specular", "roughness",
    "reflection", "emission", "brilliance", "crand", "metallic", "max_gradient", "contained_by", "accuracy",
];

/// Blocks of patterns, in which it accepts no comma before these words either, except after a list of the pattern.
const PAINTS: &[&str] = &["pigment", "normal", "texture"];
#[rustfmt::skip]
const PAINT_WORDS: &[&str] = &[
    "color_map", "colour_map", "pigment_map", "normal_map", "slope_map", "texture_map", "frequency", "phase",
    "turbulence", "octaves", "omega", "lambda", "ramp_wave", "sine_wave", "triangle_wave", "scallop_wave", "cubic_wave",
    "poly_wave", "quick_color", "quick_colour", "warp", "bump_size",
];
/// Patterns with lists, after whose last entry it accepts a comma.
const LISTS: &[&str] = &["checker", "hexagon", "brick", "square", "triangular", "cubic", "object", "tiles"];

impl Walk<'_> {
    /// Applies the rules to a token.
    pub(super) fn judge(&mut self, at: usize) {
        match self.text.class(at) {
            class::COMMA => self.comma(at),
            class::SEMICOLON => self.semicolon(at),
            class::VECTOR | class::NUMBER => self.bare_value(at),
            class::DECLARE => self.declaration(at),
            class::NAME => self.name(at),
            class::KEYWORD | class::HEAD if self.text.word(at) == "array" => self.array_without_size(at),
            class::STRING if at > 0 && self.text.word(at - 1) == "ttf" => self.font(at),
            class::KEYWORD => self.addition(at),
            _ => {}
        }
    }

    fn comma(&mut self, at: usize) {
        let Some(open) = self.open.last().copied() else {
            // Between statements; the context of a macro's body is unknown.
            if self.text.before(at) == class::BRACE_END && self.is_statement(at) {
                self.report(at, "POV-Ray accepts no comma between objects".into(), "leave it out");
            }
            return;
        };
        if open.class == class::BRACKET {
            // `array[2, 3]`, `A[1, 2]`; a map's entry is in brackets too.
            if open.at > 0 && (self.text.word(open.at - 1) == "array" || self.text.class(open.at - 1) == class::NAME) {
                let message = "POV-Ray needs each index in brackets of its own";
                self.report(at, message.into(), "write `[2][3]` for `[2, 3]`");
            }
            return;
        }
        let Some(block) = self.block() else { return };
        let next = self.text.class(at + 1);
        // Text that a directive inserts there may need it.
        if is_directive(next) || is_directive(self.text.before(at)) {
            return;
        }
        // `pigment { object { … } }` is a list of pigments.
        let outer = self.open.iter().rev().nth(1).map_or("", |outer| outer.word);
        if block == "object" && matches!(outer, "pigment" | "normal" | "texture" | "density") {
            return;
        }
        let modifies = self.text.is_keyword(at + 1) && MODIFIERS.contains(&self.text.word(at + 1));
        let in_row = ROWS.contains(&block) && self.text.before(at) == class::BRACE_END;
        if PAINTS.contains(&block) {
            let begins = self.text.is_keyword(at + 1) && (modifies || PAINT_WORDS.contains(&self.text.word(at + 1)));
            // A macro that is called before it may contain a list.
            let listed = self.text.before(at) == class::PAREN_END || self.has_list(at);
            if (begins || next == class::BRACE_END) && !listed {
                self.report(at, format!("in `{block} {{ … }}`, POV-Ray accepts no comma here"), "leave it out");
            }
            return;
        }
        let (what, wrong) = if JOINING.contains(&block) || MAPS.contains(&block) || in_row {
            ("here", true)
        } else if STRICT.contains(&block) && next == class::BRACE_END {
            ("at the end of a block", true)
        } else {
            ("here", STRICT.contains(&block) && modifies)
        };
        if wrong {
            self.report(at, format!("in `{block} {{ … }}`, POV-Ray accepts no comma {what}"), "leave it out");
        }
    }

    /// True if the open block has a pattern with a list before this token.
    fn has_list(&self, at: usize) -> bool {
        let start = self.open.last().map_or(0, |open| open.at);
        (start..at).any(|i| self.text.class(i) == class::NAME || LISTS.contains(&self.text.word(i)))
    }

    fn semicolon(&mut self, at: usize) {
        match self.open.last() {
            // `#end;`
            None if self.text.before(at) == class::END && self.begins_statement(at - 1) => {
                self.report(at, "POV-Ray accepts no `;` after `#end`".into(), "leave it out");
            }
            // `M();`, where M's last word is none that a `;` may follow
            None if self.text.before(at) == class::PAREN_END && self.macros.is_empty() && self.calls_objects(at) => {
                let message = "POV-Ray accepts no `;` after this macro, which ends with a block";
                self.report(at, message.into(), "leave it out");
            }
            None if self.text.before(at) == class::BRACE_END && self.is_statement(at) => {
                self.report(at, "POV-Ray accepts no `;` after an object".into(), "leave it out");
            }
            // `#include "a.inc";`
            None if self.text.before(at) == class::STRING && self.macros.is_empty() && at > 1 => {
                let directive = self.text.word(at - 2);
                if matches!(
                    directive.trim_start_matches('#'),
                    "include" | "debug" | "warning" | "render" | "statistics"
                ) {
                    self.report(at, format!("POV-Ray accepts no `;` after `{directive}`"), "leave it out");
                }
            }
            Some(open) if open.class == class::BRACE && !open.directed && STRICT.contains(&open.word) => {
                let message = format!("in `{} {{ … }}`, POV-Ray accepts no `;`", open.word);
                self.report(at, message, "leave it out");
            }
            _ => {}
        }
    }

    /// True if the directive that ends with this `#end` begins at the start of a statement, and not in a value.
    fn begins_statement(&self, end: usize) -> bool {
        let Some(head) = self.partner(end, class::opens_body, |class| class == class::END) else { return false };
        head == 0
            || self.text.class(head - 1) == class::SEMICOLON
            || self.text.class(head - 1) == class::BRACE_END && self.is_statement(head)
    }

    /// True if a call of a macro that ends with an object ends before this token, where a statement may begin.
    fn calls_objects(&self, at: usize) -> bool {
        let opener = self.partner(at - 1, |class| class == class::PAREN, |class| class == class::PAREN_END);
        let Some(name) = opener.and_then(|opener| opener.checked_sub(1)) else { return false };
        let before = self.text.before(name);
        let starts = matches!(before, 0 | class::SEMICOLON | class::END)
            || before == class::BRACE_END && self.is_statement(name);
        starts && self.text.symbol(name).is_some_and(|name| self.declared.ends_with_block(name))
    }

    /// True if the block that ends before this token is a statement: neither a value, nor a part of a macro or a
    /// branch.
    fn is_statement(&self, at: usize) -> bool {
        let Some(brace) = self.partner(at - 1, |class| class == class::BRACE, |class| class == class::BRACE_END) else {
            return false;
        };
        let word = brace.checked_sub(1).map_or("", |head| self.text.word(head));
        let before = brace.checked_sub(2).map_or(0, |before| self.text.class(before));
        let known = is_object(word) || word == "light_source" || word == "camera";
        // (After `=` it is a value, after a comma or `(` an argument.)
        known && matches!(before, 0 | class::BRACE_END | class::SEMICOLON)
    }

    /// The opener of the construct that ends with this token.
    fn partner(&self, end: usize, opens: impl Fn(u8) -> bool, closes: impl Fn(u8) -> bool) -> Option<usize> {
        let mut depth = 0;
        (0..=end).rev().find(|&at| {
            let class = self.text.class(at);
            depth += i32::from(closes(class)) - i32::from(opens(class));
            opens(class) && depth == 0
        })
    }

    /// Checks for a colour without a keyword, as in `pigment { <1, 0, 0> }` or `[0 <1, 0, 0>]`.
    fn bare_value(&mut self, at: usize) {
        let is_vector = self.text.class(at) == class::VECTOR;
        if self.begins_pigment(at) || is_vector && self.is_map_entry(at) {
            let what = if is_vector { "vector" } else { "number" };
            self.report(at, format!("POV-Ray accepts no {what} for a colour here"), "write `rgb` before it");
        }
    }

    /// True if the token is the first one in a pigment's braces.
    fn begins_pigment(&self, at: usize) -> bool {
        self.block() == Some("pigment") && self.open.last().is_some_and(|open| open.at + 1 == at)
    }

    /// True if the token follows the number of an entry of a map of colours.
    fn is_map_entry(&self, at: usize) -> bool {
        let mut outwards = self.open.iter().rev();
        let (Some(entry), Some(map)) = (outwards.next(), outwards.next()) else { return false };
        entry.class == class::BRACKET
            && entry.at + 2 == at
            && self.text.class(entry.at + 1) == class::NUMBER
            && matches!(map.word, "color_map" | "colour_map" | "pigment_map")
    }

    /// Checks for an array without a size, `array { 1, 2 }`.
    fn array_without_size(&mut self, at: usize) {
        if self.text.class(at + 1) == class::BRACE {
            self.report(at, "POV-Ray needs an array's size".into(), "write `array[2] { … }`");
        }
    }

    fn declaration(&mut self, at: usize) {
        if self.text.class(at + 1) == class::PAREN {
            let message = "POV-Ray 3.7 declares one name at a time";
            return self.report(at + 1, message.into(), "write a `#declare` for each name");
        }
        if self.declared.is_old || self.text.class(at + 1) != class::NAME {
            return;
        }
        let Some(equal) = (at + 2..self.text.len()).find(|&i| self.text.class(i) == class::EQUAL) else { return };
        // Between the name and the equal sign are only indices.
        let indices = (at + 2..equal).all(|i| !is_directive(self.text.class(i)) && self.text.class(i) != class::BRACE);
        let Some(end) = value::end(self.text, equal + 1).filter(|_| indices) else { return };
        let next = self.text.class(end);
        let goes_on = self.text.is_keyword(end) && !self.text.word(end).is_empty() && next != class::FUNCTION;
        // (The token that ends a macro may precede the `;` of its call.)
        let ends_branch = matches!(next, class::END | class::ELSE | class::ELSEIF | class::CASE | class::RANGE)
            && self.macros.last() != Some(&class::MACRO);
        if matches!(next, 0 | class::DECLARE | class::PLAIN)
            || ends_branch
            || goes_on && is_statement_word(self.text.word(end))
        {
            let name = self.text.word(at + 1);
            let message = format!("POV-Ray needs a `;` after the value of `{name}`");
            self.report(at + 1, message, format!("`#declare {name} = …;`"));
            let behind = self.text.span(end - 1).end();
            let label = Label { span: behind, text: super::MISSING_SEMICOLON.into() };
            self.out.last_mut().into_iter().for_each(|told| told.labels.push(label.clone()));
        }
    }

    fn name(&mut self, at: usize) {
        let next = self.text.class(at + 1);
        let calls = matches!(next, class::PAREN | class::BRACKET | class::EQUAL | class::DOT);
        let before = self.text.before(at);
        let said =
            matches!(before, class::EQUAL | class::COMMA | class::PLUS | class::MINUS | class::TIMES | class::OVER);
        if calls || said || is_directive(before) {
            return self.addition(at);
        }
        let is_color = self.begins_pigment(at) || self.is_map_entry(at);
        let block = self.block().unwrap_or("");
        let kind = self.text.symbol(at).and_then(|symbol| self.declared.kind(symbol));
        let name = self.text.word(at);
        match kind {
            Some(Kind::Block(of)) if is_object(block) && self.text.word(at.saturating_sub(1)) != "transform" => {
                let message = format!("POV-Ray takes the name of a `{of}` only inside of `{of} {{ … }}`");
                self.report(at, message, format!("write `{of} {{ {name} }}`"));
            }
            Some(Kind::Vector) if is_color => {
                let message = format!("`{name}` is a vector, and POV-Ray accepts no vector for a colour here");
                self.report(at, message, format!("write `rgb {name}`"));
            }
            _ => self.addition(at),
        }
    }

    /// Checks for a word that only durer has.
    fn addition(&mut self, at: usize) {
        let Some(block) = self.block() else { return };
        let name = self.text.word(at);
        let own = word::contextual(block).contains(&name);
        let is_named = self.text.symbol(at).is_some_and(|symbol| self.declared.kind(symbol).is_some());
        if own && !is_named && !self.open.last().is_some_and(|open| open.told) {
            self.open.iter_mut().for_each(|open| open.told = true);
            let help = match block {
                "camera" => "`camera { location … look_at … angle … }` is what both know",
                "mesh" => "triangles that are written out are what both know",
                _ => "`plane { <A, B, C>, distance }` is what both know",
            };
            self.report(at, format!("`{name}` of `{block}` is a word of durer's own"), help);
        }
    }

    /// A font by its family: a file's name usually has no blanks, or an ending.
    fn font(&mut self, at: usize) {
        if self.text.word(at).contains(' ') && !self.text.word(at).contains('.') {
            let help = "`ttf \"file.ttf\"` is what both know";
            self.report(at, "only durer finds fonts by the names of their families".into(), help);
        }
    }
}

/// True if a statement begins with this word. (Others may continue the value.)
fn is_statement_word(name: &str) -> bool {
    is_object(name)
        || matches!(name, "light_source" | "camera" | "background" | "global_settings" | "sky_sphere" | "fog")
}

fn is_object(name: &str) -> bool {
    SHAPES.contains(&name) || GROUPS.contains(&name)
}
