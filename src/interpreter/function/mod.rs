//! Compiles `function { … }` to arithmetic operations. Names are resolved where the function is declared.

mod call;
mod read;
mod sampler;
mod token_function;

use super::Interpreter;
use super::evaluator::component_index;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::{
    self, Body, Callee, Function, Graph, Id, Operation, Program, ResultType, Sampler, Spline, SplineKind, internal,
    numeric,
};
use crate::pattern::PigmentPattern;
use crate::source::Span;
use crate::syntax::ast::{Element, ElementKind, Expr, ExprKind, Name, Operator, Prefix, Symbol};
use crate::texture::{Brightness, Pigment, PigmentProgram};
use crate::value::{Next, Reader, ReaderExt, Thing, Value, VecN, downcast};
use sampler::{PatternSampler, PigmentSampler, TransformSampler};
use std::sync::Arc;
use std::sync::atomic::AtomicU8;

/// Maximum number of operations of a function that is inlined into its callers.
const MAX_COPIED: usize = 500;

/// Compiler state of a user-defined function under construction.
struct Compiler {
    graph: Graph,
    parameters: Vec<Symbol>,
}

impl<'a> Interpreter<'a> {
    fn read_block_function(&mut self, has_parameters: bool, word: &'static str, span: Span) -> Result<Arc<dyn Thing>> {
        if has_parameters {
            let message = format!("a function made of a `{word}` has no parameters of its own");
            return Diagnostic::new(codes::WRONG_COUNT, span, message)
                .help(format!("`function {{ {word} {{ … }} }}`"))
                .into();
        }
        let sampler: Arc<dyn Sampler> = match word {
            "pigment" => {
                self.take_token()?;
                let defaults = self.builder.defaults().texture.clone();
                let pigment = Pigment::read(self, &Pigment::default(), &defaults)?;
                self.leave_block()?;
                Arc::new(PigmentSampler(PigmentProgram::new(&pigment), self.builder.noise_generator().clone()))
            }
            "pattern" => {
                self.take_token()?;
                let defaults = self.builder.defaults().texture.clone();
                let pattern = Pigment::read(self, &Pigment::default(), &defaults)?;
                self.leave_block()?;
                Arc::new(PatternSampler(PigmentProgram::new(&pattern), self.builder.noise_generator().clone()))
            }
            "transform" => {
                self.take_token()?;
                let transform = self.read_transform_contents()?;
                self.leave_block()?;
                Arc::new(TransformSampler(transform))
            }
            "spline" => self.read_spline()?,
            _ => {
                return Err(self
                    .unexpected_token("an expression, `pigment`, `pattern`, `transform` or `spline`")
                    .into());
            }
        };
        if self.peek()?.is_closer_or_end() {
            return Ok(Arc::new(Function { parameters: default_parameter_names(), body: Body::Sampled(sampler) }));
        }
        Err(self.unexpected_token("the end of the function").into())
    }

    /// Reads the contents of a pigment block as a pattern whose value is the pigment's brightness. The default pigment
    /// is ignored (quirk: `pigment_function_ignores_default`).
    pub(super) fn read_pigment_as_pattern(&mut self) -> Result<Arc<dyn Thing>> {
        let defaults = self.builder.defaults().texture.clone();
        let pigment = Pigment::read(self, &Pigment::default(), &defaults)?;
        Ok(Arc::new(PigmentPattern::new(Arc::new(Brightness::new(&pigment)))))
    }

    /// Reads `spline { linear_spline 0, <1, 2, 3> 1, <2, 3, 4> }`.
    pub(super) fn read_spline(&mut self) -> Result<Arc<Spline>> {
        let at = self.take_token()?;
        let mut kind = SplineKind::Linear;
        let mut points: Vec<(f64, VecN)> = vec![];
        if let Some(declared) = ReaderExt::take_declared::<Spline>(self)? {
            kind = declared.kind;
            points = declared.points().collect();
        }
        if let Next::Word(word) = Reader::peek_next(self)?
            && let Some(named) = SplineKind::from_word(word)
        {
            self.stream.advance();
            kind = named;
        }
        while Reader::peek_next(self)? != Next::End {
            let t = self.float()?;
            let (value, span) = self.read_value()?;
            let point = match value {
                Value::Vector(v) => v,
                // A number is a point of two equal components.
                Value::Float(x) => VecN::splat(x, 2),
                other => {
                    let message = format!("expected a vector, found {}", other.describe());
                    return Diagnostic::err(codes::WRONG_TYPE, span, message);
                }
            };
            points.push((t, point));
        }
        self.leave_block()?;
        if points.is_empty() {
            return Diagnostic::new(codes::EMPTY_MAP, at, "this spline has no points")
                .help("`spline { linear_spline 0, <0, 0, 0> 1, <1, 2, 3> }`")
                .into();
        }
        Ok(Arc::new(Spline::new(kind, &points)))
    }

    /// Compiles an expression of a user-defined function's body.
    fn compile(&mut self, c: &mut Compiler, e: &'a Expr) -> Result<Id> {
        match &e.kind {
            ExprKind::Number(x) => Ok(c.graph.add_constant(*x)),
            ExprKind::Name(symbol) => self.compile_name(c, *symbol, e),
            ExprKind::Paren(inner) => self.compile(c, inner),
            ExprKind::Prefix(prefix, inner) => {
                let a = self.compile(c, inner)?;
                Ok(c.prefixed(*prefix, a))
            }
            ExprKind::Chain(chain) => {
                let mut left = self.compile(c, &chain.first)?;
                for (op, operand) in &chain.rest {
                    let right = self.compile(c, operand)?;
                    left = c.graph.add_operation(Operation::Binary(*op, left, right));
                }
                Ok(left)
            }
            ExprKind::Choice(parts) => {
                let [condition, yes, no] = &**parts;
                let condition = self.compile(c, condition)?;
                let (yes, no) = (self.compile(c, yes)?, self.compile(c, no)?);
                Ok(c.graph.add_operation(Operation::Choice(condition, yes, no)))
            }
            ExprKind::Builtin(name, arguments) => self.compile_builtin(c, name.name, arguments, e.span),
            ExprKind::Call(name, arguments) => self.compile_call(c, *name, arguments, None, e.span),
            ExprKind::Dot(base, component, _) => match &base.kind {
                ExprKind::Call(name, arguments) => self.compile_call(c, *name, arguments, Some(component), e.span),
                ExprKind::Apply(callee, arguments) => {
                    let callee = self.evaluate(callee)?;
                    let ids = self.compile_arguments(c, arguments)?;
                    self.compile_call_of(c, &callee, ids, Some(component), e.span)
                }
                _ => self.compile_constant(c, e),
            },
            // A call of a function in an array.
            ExprKind::Apply(callee, arguments) => {
                let callee = self.evaluate(callee)?;
                let ids = self.compile_arguments(c, arguments)?;
                self.compile_call_of(c, &callee, ids, None, e.span)
            }
            _ => self.compile_constant(c, e),
        }
    }

    /// Compiles an expression that does not depend on the parameters to its present value.
    fn compile_constant(&mut self, c: &mut Compiler, e: &'a Expr) -> Result<Id> {
        let x = self.evaluate_number(e)?;
        Ok(c.graph.add_constant(x))
    }

    fn compile_name(&mut self, c: &mut Compiler, symbol: Symbol, e: &'a Expr) -> Result<Id> {
        if let Some(i) = c.parameters.iter().position(|p| *p == symbol) {
            return Ok(c.graph.add_operation(Operation::Parameter(i as u16)));
        }
        // `u` and `v` are synonyms of `x` and `y`.
        let other = match self.inputs.names.text(symbol) {
            "u" => "x",
            "v" => "y",
            _ => return self.compile_constant(c, e),
        };
        match c.parameters.iter().position(|p| self.inputs.names.text(*p) == other) {
            Some(i) => Ok(c.graph.add_operation(Operation::Parameter(i as u16))),
            None => self.compile_constant(c, e),
        }
    }

    fn compile_builtin(&mut self, c: &mut Compiler, name: &str, arguments: &'a [Expr], span: Span) -> Result<Id> {
        if name == "sum" || name == "prod" {
            return self.compile_series(c, name == "prod", arguments, span);
        }
        let ids = arguments.iter().map(|e| self.compile(c, e)).collect::<Result<Vec<Id>>>()?;
        self.compile_builtin_of(c, name, &ids, span)
    }

    /// Compiles the call of a built-in function with compiled arguments.
    fn compile_builtin_of(&mut self, c: &mut Compiler, name: &str, ids: &[Id], span: Span) -> Result<Id> {
        if name == "select" && (3..=4).contains(&ids.len()) {
            return Ok(c.select(ids));
        }
        let Some(row) = numeric::find_numeric(name) else {
            let message = format!("`{name}` does not give a number of numbers: a function can't call it");
            return Diagnostic::err(codes::NOT_CALLABLE, span, message);
        };
        let (wanted, node): (&str, Option<Id>) = match (numeric::TABLE[row as usize].kernel, ids) {
            (numeric::Kernel::One(_), [a]) => ("", Some(c.graph.add_operation(Operation::One(row, *a)))),
            (numeric::Kernel::Two(_), [a, b]) => ("", Some(c.graph.add_operation(Operation::Two(row, *a, *b)))),
            (numeric::Kernel::Many(_), [first, rest @ ..]) => {
                ("", Some(rest.iter().fold(*first, |a, b| c.graph.add_operation(Operation::Two(row, a, *b)))))
            }
            (numeric::Kernel::One(_), _) => ("one argument", None),
            (numeric::Kernel::Two(_), _) => ("two arguments", None),
            (numeric::Kernel::Many(_), _) => ("one or more arguments", None),
        };
        let found = ids.len();
        node.ok_or_else(|| {
            Box::new(Diagnostic::new(codes::WRONG_COUNT, span, format!("`{name}` takes {wanted}, found {found}")))
        })
    }

    /// Compiles `sum(I, 1, 10, x/I)`, where the counter is an additional parameter of the term.
    fn compile_series(&mut self, c: &mut Compiler, product: bool, arguments: &'a [Expr], span: Span) -> Result<Id> {
        let [Expr { kind: ExprKind::Name(counter), .. }, first, last, term] = arguments else {
            let name = if product { "prod" } else { "sum" };
            return Diagnostic::new(
                codes::WRONG_COUNT,
                span,
                format!("`{name}` takes a counter, a first and a last value, and a term"),
            )
            .help(format!("`{name}(I, 1, 10, x/I)`"))
            .into();
        };
        let ids = vec![self.compile(c, first)?, self.compile(c, last)?];
        let mut inner = c.with_counter(*counter);
        inner.graph.result = self.compile(&mut inner, term)?;
        compile_series_call(c, product, ids, inner, span)
    }
    /// Compiles a call of a declared function.
    fn compile_call(
        &mut self,
        c: &mut Compiler,
        name: Symbol,
        arguments: &'a [Element],
        component: Option<&Name>,
        span: Span,
    ) -> Result<Id> {
        let ids = self.compile_arguments(c, arguments)?;
        self.compile_call_ids(c, name, ids, component, span)
    }

    fn compile_arguments(&mut self, c: &mut Compiler, arguments: &'a [Element]) -> Result<Vec<Id>> {
        let mut ids = vec![];
        for element in arguments {
            match &element.kind {
                ElementKind::Expr(e) => ids.push(self.compile(c, e)?),
                ElementKind::Numbers(list) => ids.extend(list.data.iter().map(|x| c.graph.add_constant(*x))),
                _ => return Diagnostic::err(codes::EXPECTED_VALUE, element.span, "expected a number"),
            }
        }
        Ok(ids)
    }

    /// Compiles a call of a name with compiled arguments.
    fn compile_call_ids(
        &mut self,
        c: &mut Compiler,
        name: Symbol,
        ids: Vec<Id>,
        component: Option<&Name>,
        span: Span,
    ) -> Result<Id> {
        let callee = self.evaluate_name(name, span)?;
        self.compile_call_of(c, &callee, ids, component, span)
    }

    /// Compiles a call of a function or spline with compiled arguments. The name is at the start of `span`.
    fn compile_call_of(
        &mut self,
        c: &mut Compiler,
        callee: &Value,
        ids: Vec<Id>,
        component: Option<&Name>,
        span: Span,
    ) -> Result<Id> {
        let (callee, gives, arity) = self.callee_type_and_arity(callee, span)?;
        self.check_arity(span, ids.len(), arity)?;
        let component = self.select_component(gives, component, span)?;
        if let Callee::Function(f) = &callee
            && let Body::Numeric(program) = &f.body
            && program.graph().nodes.len() <= MAX_COPIED
        {
            return Ok(c.graph.inline_graph(program.graph(), &ids));
        }
        let one = |c: &mut Compiler, i: u8| c.graph.add_call_component(callee.clone(), i, ids.clone().into());
        Ok(match component {
            Component::Of(i) => one(c, i),
            Component::Weighted(weights) => {
                let mut sum = c.graph.add_constant(0.0);
                for (i, weight) in weights.iter().enumerate() {
                    let (value, weight) = (one(c, i as u8), c.graph.add_constant(*weight));
                    let term = c.graph.add_operation(Operation::Binary(Operator::Mul, value, weight));
                    sum = c.graph.add_operation(Operation::Binary(Operator::Add, sum, term));
                }
                sum
            }
        })
    }

    /// Returns the function or spline in a value, with its result type and number of parameters.
    fn callee_type_and_arity(&mut self, callee: &Value, span: Span) -> Result<(Callee, ResultType, usize)> {
        if let Value::Thing(thing) = callee {
            if let Some(f) = downcast::<Function>(thing) {
                let (gives, arity) = (f.result_type(), f.arity());
                let callee = match &f.body {
                    Body::Sampled(sampler) => Callee::Sampler(sampler.clone()),
                    Body::Numeric(_) => Callee::Function(f.clone()),
                };
                return Ok((callee, gives, arity));
            }
            if let Some(spline) = downcast::<Spline>(thing) {
                let gives = ResultType::Vector(spline.len);
                return Ok((Callee::Sampler(spline), gives, 1));
            }
        }
        let text = self.called_name_text(span);
        Diagnostic::err(codes::NOT_CALLABLE, span, format!("`{text}` is neither a macro nor a function"))
    }

    /// Returns the name at the start of a call's span.
    fn called_name_text(&self, span: Span) -> &'a str {
        let text = self.inputs.sources.snippet(span);
        text.split('(').next().unwrap_or(text).trim_end()
    }

    fn check_arity(&self, called: Span, found: usize, wanted: usize) -> Result<()> {
        if found == wanted {
            return Ok(());
        }
        let name = self.called_name_text(called);
        let plural = if wanted == 1 { "" } else { "s" };
        let message = format!("function `{name}` takes {wanted} argument{plural}, found {found}");
        Diagnostic::err(codes::WRONG_COUNT, called, message)
    }

    fn select_component(&self, gives: ResultType, component: Option<&Name>, span: Span) -> Result<Component> {
        let text = self.called_name_text(span);
        let Some(component) = component else {
            return match gives {
                ResultType::Number => Ok(Component::Of(0)),
                ResultType::Vector(_) => {
                    Diagnostic::new(codes::WRONG_TYPE, span, format!("function `{text}` gives a vector"))
                        .help("`.x`, `.y` or `.z` after the call selects one of its components")
                        .into()
                }
                ResultType::Color => {
                    Diagnostic::new(codes::WRONG_TYPE, span, format!("function `{text}` gives a colour"))
                        .help("`.red`, `.green`, `.blue` or `.gray` after the call selects one of its components")
                        .into()
                }
            };
        };
        let weights = crate::color::GRAY_WEIGHTS;
        if let Some(i) = component_index(component) {
            return Ok(Component::Of(i as u8));
        }
        match (self.inputs.sources.snippet(component.span), gives) {
            ("gray" | "grey", ResultType::Color) => Ok(Component::Weighted(weights)),
            // The 16 bits of a height field: red is the upper byte, green the lower one
            // (quirk: `hf_component_weights`).
            ("hf", ResultType::Color) => Ok(Component::Weighted([0.996093, 0.003906, 0.0])),
            _ => {
                let message = format!("`.{}` is no component of this", self.inputs.sources.snippet(component.span));
                Diagnostic::err(codes::NO_COMPONENT, component.span, message)
            }
        }
    }
}

/// Component of a function's result that a call selects.
enum Component {
    Of(u8),
    Weighted([f64; 3]),
}

impl Compiler {
    fn new(me: &Interpreter, parameters: &[Symbol]) -> Self {
        let parameters = match parameters {
            [] => ["x", "y", "z"].map(|name| me.inputs.names.intern(name)).to_vec(),
            some => some.to_vec(),
        };
        Self { graph: Graph::default(), parameters }
    }

    /// Creates a compiler for the term of `sum` and `prod`, with the counter as the last parameter.
    fn with_counter(&self, counter: Symbol) -> Self {
        let parameters = self.parameters.iter().copied().chain([counter]).collect();
        Self { graph: Graph::default(), parameters }
    }

    fn prefixed(&mut self, prefix: Prefix, a: Id) -> Id {
        match prefix {
            Prefix::Plus => a,
            Prefix::Minus => {
                let minus = self.graph.add_constant(-1.0);
                self.graph.add_operation(Operation::Binary(Operator::Mul, a, minus))
            }
            Prefix::Not => {
                let zero = self.graph.add_constant(0.0);
                self.graph.add_operation(Operation::Binary(Operator::Equal, a, zero))
            }
        }
    }

    /// Compiles `select(a, below, zero, above)` or `select(a, below, not_below)`.
    fn select(&mut self, ids: &[Id]) -> Id {
        let zero = self.graph.add_constant(0.0);
        let below = self.graph.add_operation(Operation::Binary(Operator::Less, ids[0], zero));
        let rest = match ids {
            [a, _, at, above] => self.graph.add_operation(Operation::Choice(*a, *above, *at)),
            ids => ids[2],
        };
        self.graph.add_operation(Operation::Choice(below, ids[1], rest))
    }

    /// Compiles the operations to a function of the scene; an error if there are too many.
    fn into_function(self, me: &Interpreter, span: Span) -> Result<Arc<dyn Thing>> {
        let parameters: Box<[Box<str>]> = self.parameters.iter().map(|p| me.inputs.names.text(*p).into()).collect();
        match Program::new(self.graph, parameters.len()) {
            Some(program) => Ok(Arc::new(Function { parameters, body: Body::Numeric(program) })),
            None => too_large_error(span),
        }
    }
}

/// Compiles `sum` or `prod` over a range of the counter.
fn compile_series_call(c: &mut Compiler, product: bool, mut ids: Vec<Id>, inner: Compiler, span: Span) -> Result<Id> {
    let Some(body) = Program::new(inner.graph, inner.parameters.len()) else { return too_large_error(span) };
    ids.extend(
        (0..c.parameters.len()).map(|i| c.graph.add_operation(Operation::Parameter(i as u16))).collect::<Vec<_>>(),
    );
    Ok(c.graph.add_call_component(Callee::Series { product, body: Arc::new(body) }, 0, ids.into()))
}

fn too_large_error<T>(span: Span) -> Result<T> {
    Diagnostic::err(codes::TOO_DEEP, span, "this function has more than 60000 operations")
}

fn default_parameter_names() -> Box<[Box<str>]> {
    ["x", "y", "z"].map(Box::from).into()
}

/// Returns the function of `functions.inc` that `internal(61)` names by its number.
pub(super) fn internal_function(number: f64, noise: &Arc<AtomicU8>) -> Option<Function> {
    let row = internal::find_internal(number as u32).filter(|_| number >= 0.0)?;
    let mut graph = function::Graph::default();
    let count = 3 + row.parameters.len();
    let ids: Box<[Id]> = (0..count).map(|i| graph.add_operation(Operation::Parameter(i as u16))).collect();
    let callee = match row.number {
        internal::SCENE_NOISE => Callee::SceneNoise(noise.clone()),
        _ => Callee::Internal(row),
    };
    graph.result = graph.add_call_component(callee, 0, ids);
    let names =
        ["x", "y", "z"].map(Box::from).into_iter().chain((0..row.parameters.len()).map(|i| format!("P{i}").into()));
    let program = Program::new(graph, count)?;
    Some(Function { parameters: names.collect(), body: Body::Numeric(program) })
}
