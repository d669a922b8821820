//! Rules of the lint `--warn portable`, which finds text that POV-Ray 3.7 rejects.

use super::declared::DeclaredKind;
use super::{Check, is_keyword, value};
use crate::diagnostic::Label;
use crate::syntax::class::{self, is_directive};
use crate::syntax::word::{self, GROUPS, SHAPES};

/// Blocks in which POV-Ray accepts no comma before a keyword and none before the `}`.
#[rustfmt::skip]
const VALUE_BLOCKS: &[&str] = &[
    "sphere", "box", "cylinder", "cone", "torus", "plane", "triangle", "smooth_triangle", "polygon", "prism", "lathe",
    "superellipsoid", "quadric", "text", "isosurface", "sphere_sweep", "blob", "mesh", "object", "finish", "camera",
    "global_settings", "light_source", "interior",
];
/// Blocks of objects in which POV-Ray accepts no comma at all.
const CSG_BLOCKS: &[&str] = &["union", "merge", "intersection", "difference"];
/// Blocks with lists of blocks, in which POV-Ray accepts no comma between two blocks.
const LIST_BLOCKS: &[&str] = &["mesh", "blob", "sky_sphere"];
/// Blocks of maps, in which POV-Ray accepts no comma between the entries.
const MAP_BLOCKS: &[&str] =
    &["color_map", "colour_map", "pigment_map", "normal_map", "texture_map", "slope_map", "density_map"];
/// Keywords of objects, cameras and lights that can't begin an operand, so that a comma before them is wrong.
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

/// Blocks of patterns, in which POV-Ray accepts no comma before the words [`MODIFIERS`], except after a pattern's list.
const PATTERN_BLOCKS: &[&str] = &["pigment", "normal", "texture"];
#[rustfmt::skip]
const PATTERN_WORDS: &[&str] = &[
    "color_map", "colour_map", "pigment_map", "normal_map", "slope_map", "texture_map", "frequency", "phase",
    "turbulence", "octaves", "omega", "lambda", "ramp_wave", "sine_wave", "triangle_wave", "scallop_wave", "cubic_wave",
    "poly_wave", "quick_color", "quick_colour", "warp", "bump_size",
];
/// Patterns that take a list, after whose last entry POV-Ray accepts a comma.
const LIST_PATTERNS: &[&str] = &["checker", "hexagon", "brick", "square", "triangular", "cubic", "object", "tiles"];

impl Check<'_> {
    /// Applies all rules of the lint to the token of the index `token`.
    pub(super) fn apply_rules(&mut self, token: usize) {
        match self.outline.class(token) {
            class::COMMA => self.report_comma_if_refused(token),
            class::SEMICOLON => self.report_semicolon_if_refused(token),
            class::VECTOR | class::NUMBER => self.report_color_without_keyword(token),
            class::DECLARE => self.check_declaration(token),
            class::NAME => self.report_misused_declared_name(token),
            class::KEYWORD | class::HEAD if self.outline.token_text(token) == "array" => {
                self.report_unsized_array(token)
            }
            class::STRING if token > 0 && self.outline.token_text(token - 1) == "ttf" => {
                self.report_font_family_name(token)
            }
            class::KEYWORD => self.report_durer_only_word(token),
            _ => {}
        }
    }

    fn report_comma_if_refused(&mut self, token: usize) {
        let mut brackets = self.brackets_around(token);
        let Some(open) = brackets.next() else {
            // Between statements; the context of a macro's body is unknown.
            if self.outline.class_before(token) == class::BRACE_END && self.follows_statement_block(token) {
                self.report(token, "POV-Ray accepts no comma between objects".into(), "leave it out");
            }
            return;
        };
        if open.bracket == b'[' {
            // `array[2, 3]`, `A[1, 2]`; a map's entry is in brackets too.
            if self.outline.head(open) == "array" || self.outline.class_before(open.opener) == class::NAME {
                let message = "POV-Ray needs each index in brackets of its own";
                self.report(token, message.into(), "write `[2][3]` for `[2, 3]`");
            }
            return;
        }
        let Some(block) = self.enclosing_block_word(token) else { return };
        let next = self.outline.class(token + 1);
        // Text that a directive inserts there may need it.
        if is_directive(next) || is_directive(self.outline.class_before(token)) {
            return;
        }
        // `pigment { object { … } }` is a list of pigments.
        let outer = brackets.next().map_or("", |outer| self.outline.head(outer));
        if block == "object" && matches!(outer, "pigment" | "normal" | "texture" | "density") {
            return;
        }
        let modifies = is_keyword(self.outline, token + 1) && MODIFIERS.contains(&self.outline.token_text(token + 1));
        let in_row = LIST_BLOCKS.contains(&block) && self.outline.class_before(token) == class::BRACE_END;
        if PATTERN_BLOCKS.contains(&block) {
            let begins = is_keyword(self.outline, token + 1)
                && (modifies || PATTERN_WORDS.contains(&self.outline.token_text(token + 1)));
            // A macro that is called before it may contain a list.
            let listed = self.outline.class_before(token) == class::PAREN_END || self.has_list_pattern_before(token);
            if (begins || next == class::BRACE_END) && !listed {
                self.report(token, format!("in `{block} {{ … }}`, POV-Ray accepts no comma here"), "leave it out");
            }
            return;
        }
        let (what, wrong) = if CSG_BLOCKS.contains(&block) || MAP_BLOCKS.contains(&block) || in_row {
            ("here", true)
        } else if VALUE_BLOCKS.contains(&block) && next == class::BRACE_END {
            ("at the end of a block", true)
        } else {
            ("here", VALUE_BLOCKS.contains(&block) && modifies)
        };
        if wrong {
            self.report(token, format!("in `{block} {{ … }}`, POV-Ray accepts no comma {what}"), "leave it out");
        }
    }

    /// True if the open block has a pattern with a list, such as `checker`, before this token, or a name that may be
    /// one.
    fn has_list_pattern_before(&self, token: usize) -> bool {
        let start = self.brackets_around(token).next().map_or(0, |open| open.opener);
        (start..token)
            .any(|i| self.outline.class(i) == class::NAME || LIST_PATTERNS.contains(&self.outline.token_text(i)))
    }

    fn report_semicolon_if_refused(&mut self, semicolon: usize) {
        match self.brackets_around(semicolon).next() {
            // `#end;`
            None if self.outline.class_before(semicolon) == class::END
                && self.ended_directive_begins_statement(semicolon - 1) =>
            {
                self.report(semicolon, "POV-Ray accepts no `;` after `#end`".into(), "leave it out");
            }
            // `M();`, where M's last word is none that a `;` may follow
            None if self.outline.class_before(semicolon) == class::PAREN_END
                && !self.in_macro(semicolon)
                && self.follows_statement_call_of_block_macro(semicolon) =>
            {
                let message = "POV-Ray accepts no `;` after this macro, which ends with a block";
                self.report(semicolon, message.into(), "leave it out");
            }
            None if self.outline.class_before(semicolon) == class::BRACE_END
                && self.follows_statement_block(semicolon) =>
            {
                self.report(semicolon, "POV-Ray accepts no `;` after an object".into(), "leave it out");
            }
            // `#include "a.inc";`
            None if self.outline.class_before(semicolon) == class::STRING
                && !self.in_macro(semicolon)
                && semicolon > 1 =>
            {
                let directive = self.outline.token_text(semicolon - 2);
                if matches!(
                    directive.trim_start_matches('#'),
                    "include" | "debug" | "warning" | "render" | "statistics"
                ) {
                    self.report(semicolon, format!("POV-Ray accepts no `;` after `{directive}`"), "leave it out");
                }
            }
            // After a directive in the same brackets, the `;` may belong to the directive.
            Some(open) if self.directive < Some(open.opener) => {
                if let Some(block) = self.enclosing_block_word(semicolon).filter(|block| VALUE_BLOCKS.contains(block)) {
                    self.report(semicolon, format!("in `{block} {{ … }}`, POV-Ray accepts no `;`"), "leave it out");
                }
            }
            _ => {}
        }
    }

    /// True if the directive that ends with the `#end` at this index begins a statement, and is not part of a value.
    fn ended_directive_begins_statement(&self, end: usize) -> bool {
        let Some(head) = self.outline.closed_by(end).map(|pair| pair.opener) else { return false };
        head == 0
            || self.outline.class(head - 1) == class::SEMICOLON
            || self.outline.class(head - 1) == class::BRACE_END && self.follows_statement_block(head)
    }

    /// True if the token before this index ends a macro call that begins a statement, and the macro's body ends with a
    /// block.
    fn follows_statement_call_of_block_macro(&self, token: usize) -> bool {
        let Some(name) = self.outline.closed_by(token - 1).and_then(|pair| pair.opener.checked_sub(1)) else {
            return false;
        };
        let before = self.outline.class_before(name);
        let starts = matches!(before, 0 | class::SEMICOLON | class::END)
            || before == class::BRACE_END && self.follows_statement_block(name);
        starts
            && self.outline.class(name) == class::NAME
            && self.declared.macro_ends_with_block(self.outline.token_text(name))
    }

    /// True if the block that ends before this token is a statement, not a value or a part of a macro or a branch.
    fn follows_statement_block(&self, token: usize) -> bool {
        let Some(head) = self.outline.closed_by(token - 1).and_then(|pair| pair.opener.checked_sub(1)) else {
            return false;
        };
        let (word, before) = (self.outline.token_text(head), self.outline.class_before(head));
        let known = is_object(word) || word == "light_source" || word == "camera";
        // (After `=` it is a value, after a comma or `(` an argument.)
        known && matches!(before, 0 | class::BRACE_END | class::SEMICOLON)
    }

    /// Reports a colour without a keyword, as in `pigment { <1, 0, 0> }` or `[0 <1, 0, 0>]`.
    fn report_color_without_keyword(&mut self, token: usize) {
        let is_vector = self.outline.class(token) == class::VECTOR;
        if self.is_first_in_pigment(token) || is_vector && self.is_map_entry_value(token) {
            let what = if is_vector { "vector" } else { "number" };
            self.report(token, format!("POV-Ray accepts no {what} for a colour here"), "write `rgb` before it");
        }
    }

    /// True if the token is the first one in a pigment's braces.
    fn is_first_in_pigment(&self, token: usize) -> bool {
        let open = self.brackets_around(token).next();
        self.enclosing_block_word(token) == Some("pigment") && open.is_some_and(|open| open.opener + 1 == token)
    }

    /// True if the token begins the value of an entry of a colour map: it follows the number of the entry.
    fn is_map_entry_value(&self, token: usize) -> bool {
        let mut outwards = self.brackets_around(token);
        let (Some(entry), Some(map)) = (outwards.next(), outwards.next()) else { return false };
        entry.bracket == b'['
            && entry.opener + 2 == token
            && self.outline.class(entry.opener + 1) == class::NUMBER
            && matches!(self.outline.head(map), "color_map" | "colour_map" | "pigment_map")
    }

    /// Reports an array without a size, `array { 1, 2 }`.
    fn report_unsized_array(&mut self, token: usize) {
        if self.outline.class(token + 1) == class::BRACE {
            self.report(token, "POV-Ray needs an array's size".into(), "write `array[2] { … }`");
        }
    }

    fn check_declaration(&mut self, token: usize) {
        if self.outline.class(token + 1) == class::PAREN {
            let message = "POV-Ray 3.7 declares one name at a time";
            return self.report(token + 1, message.into(), "write a `#declare` for each name");
        }
        if self.declared.has_old_version || self.outline.class(token + 1) != class::NAME {
            return;
        }
        let Some(equal) = (token + 2..self.outline.tokens.len()).find(|&i| self.outline.class(i) == class::EQUAL)
        else {
            return;
        };
        // Between the name and the equal sign are only indices.
        let indices =
            (token + 2..equal).all(|i| !is_directive(self.outline.class(i)) && self.outline.class(i) != class::BRACE);
        let Some(end) = value::token_after_value(self.outline, equal + 1).filter(|_| indices) else { return };
        let next = self.outline.class(end);
        let goes_on =
            is_keyword(self.outline, end) && !self.outline.token_text(end).is_empty() && next != class::FUNCTION;
        // (The token that ends a macro may precede the `;` of its call.)
        let ends_branch = matches!(next, class::END | class::ELSE | class::ELSEIF | class::CASE | class::RANGE)
            && !self.directives_around(token).next().is_some_and(|inner| self.outline.is_macro(inner));
        if matches!(next, 0 | class::DECLARE | class::PLAIN)
            || ends_branch
            || goes_on && is_statement_word(self.outline.token_text(end))
        {
            let name = self.outline.token_text(token + 1);
            let message = format!("POV-Ray needs a `;` after the value of `{name}`");
            self.report(token + 1, message, format!("`#declare {name} = …;`"));
            let behind = self.outline.token_span(end - 1).end();
            let label = Label { span: behind, text: super::MISSING_SEMICOLON.into() };
            self.out.last_mut().into_iter().for_each(|d| d.labels.push(label.clone()));
        }
    }

    fn report_misused_declared_name(&mut self, token: usize) {
        let next = self.outline.class(token + 1);
        let calls = matches!(next, class::PAREN | class::BRACKET | class::EQUAL | class::DOT);
        let before = self.outline.class_before(token);
        let said =
            matches!(before, class::EQUAL | class::COMMA | class::PLUS | class::MINUS | class::TIMES | class::OVER);
        if calls || said || is_directive(before) {
            return self.report_durer_only_word(token);
        }
        let is_color = self.is_first_in_pigment(token) || self.is_map_entry_value(token);
        let block = self.enclosing_block_word(token).unwrap_or("");
        let name = self.outline.token_text(token);
        match self.declared.kind(name) {
            Some(DeclaredKind::Block(of))
                if is_object(block) && self.outline.token_text(token.saturating_sub(1)) != "transform" =>
            {
                let message = format!("POV-Ray takes the name of a `{of}` only inside of `{of} {{ … }}`");
                self.report(token, message, format!("write `{of} {{ {name} }}`"));
            }
            Some(DeclaredKind::Vector) if is_color => {
                let message = format!("`{name}` is a vector, and POV-Ray accepts no vector for a colour here");
                self.report(token, message, format!("write `rgb {name}`"));
            }
            _ => self.report_durer_only_word(token),
        }
    }

    /// Reports a word that only durer has.
    fn report_durer_only_word(&mut self, token: usize) {
        let (Some(block), Some(open)) = (self.enclosing_block_word(token), self.brackets_around(token).next()) else {
            return;
        };
        let name = self.outline.token_text(token);
        let own = word::durer_words_of_block(block).contains(&name);
        // One message for each block is enough.
        let is_reported = self.addition > Some(open.opener);
        if own && self.declared.kind(name).is_none() && !is_reported {
            self.addition = Some(token);
            let help = match block {
                "camera" => "`camera { location … look_at … angle … }` is what both know",
                "mesh" => "triangles that are written out are what both know",
                _ => "`plane { <A, B, C>, distance }` is what both know",
            };
            self.report(token, format!("`{name}` of `{block}` is a word of durer's own"), help);
        }
    }

    /// Reports a font that is given by its family name. (The name of a font file usually has no blanks, or an ending.)
    fn report_font_family_name(&mut self, token: usize) {
        if self.outline.token_text(token).contains(' ') && !self.outline.token_text(token).contains('.') {
            let help = "`ttf \"file.ttf\"` is what both know";
            self.report(token, "only durer finds fonts by the names of their families".into(), help);
        }
    }
}

/// True if a statement begins with this keyword, which can't continue a value.
fn is_statement_word(name: &str) -> bool {
    is_object(name)
        || matches!(name, "light_source" | "camera" | "background" | "global_settings" | "sky_sphere" | "fog")
}

fn is_object(name: &str) -> bool {
    SHAPES.contains(&name) || GROUPS.contains(&name)
}
