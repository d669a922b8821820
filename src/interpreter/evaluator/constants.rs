//! The language's built-in constants (manual, "Built-in Constants", "Built-in Variables").

use crate::interpreter::Inputs;
use crate::math::DVec3;
use crate::source::Host;
use crate::syntax::ast::Symbol;
use crate::syntax::word;
use crate::value::{Value, VecN};

/// Built-in constants of the scene language by symbol.
pub(super) struct Constants {
    values: Vec<Option<Value>>,
    version: Symbol,
    /// Symbol of `now`, the only built-in constant whose value is computed at each use.
    now: Symbol,
}

impl Constants {
    pub(super) fn new(inputs: Inputs) -> Self {
        let (version, now) = (inputs.names.intern("version"), inputs.names.intern("now"));
        let mut constants = Self { values: vec![], version, now };
        for (name, _) in word::CONSTANTS {
            let value = initial_constant_value(name, inputs);
            constants.set(inputs.names.intern(name), value);
        }
        constants
    }

    fn set(&mut self, symbol: Symbol, value: Option<Value>) {
        let i = symbol.0 as usize;
        if i >= self.values.len() {
            self.values.resize(i + 1, None);
        }
        self.values[i] = value;
    }

    pub(super) fn set_version(&mut self, version: u32) {
        self.set(self.version, Some(Value::Float(f64::from(version) / 100.0)));
    }

    pub(super) fn get(&self, symbol: Symbol, host: &dyn Host) -> Option<Value> {
        if symbol == self.now {
            return Some(Value::Float(host.since_1970().as_secs_f64() / 86_400.0 - DAYS_TO_2000));
        }
        self.fixed_value(symbol).cloned()
    }

    /// Returns the value of a built-in constant other than `now`, which has no stored value; `None` for `now` and for
    /// all other names.
    #[inline]
    pub(super) fn fixed_value(&self, symbol: Symbol) -> Option<&Value> {
        self.values.get(symbol.0 as usize)?.as_ref()
    }
}

/// Returns the initial value of a built-in constant; `None` for `version`, for `now` and for other names.
fn initial_constant_value(name: &str, inputs: Inputs) -> Option<Value> {
    let flag = |b: bool| Some(Value::Float(f64::from(b)));
    let float = |x: f64| Some(Value::Float(x));
    match name {
        "x" => Some(Value::Vector(DVec3::X.into())),
        "y" => Some(Value::Vector(DVec3::Y.into())),
        "z" => Some(Value::Vector(DVec3::Z.into())),
        "u" => Some(Value::Vector(VecN::from_slice(&[1.0, 0.0]))),
        "v" => Some(Value::Vector(VecN::from_slice(&[0.0, 1.0]))),
        "t" => Some(Value::Vector(VecN::from_slice(&[0.0, 0.0, 0.0, 1.0]))),
        "pi" => float(std::f64::consts::PI),
        "true" | "on" | "yes" => flag(true),
        "false" | "off" | "no" => flag(false),
        "image_width" => float(inputs.options.size.0 as f64),
        "image_height" => float(inputs.options.size.1 as f64),
        "input_file_name" => Some(Value::Text(inputs.options.input_name.as_str().into())),
        _ => inputs.options.timing.animation_constant(name).map(Value::Float),
    }
}

/// Days from the beginning of 1970 to that of 2000, from where `now` counts (manual, "now").
const DAYS_TO_2000: f64 = 10_957.0;
