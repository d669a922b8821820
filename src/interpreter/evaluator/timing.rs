//! Values of `clock`, `frame_number` and the other constants of an animation (manual, "Built-in Variables").

/// Values of the animation's constants for one frame. The default is a picture without animation: all values are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Timing {
    /// Value of the constant `clock`, the animation's time.
    pub clock: f64,
    /// Value of the constant `clock_on`: true in an animation, and if a clock was set.
    pub clock_on: bool,
    /// Value of the constant `clock_delta`: difference of the clock between two frames.
    pub clock_delta: f64,
    /// Value of the constant `frame_number`, the number of the animation's current frame.
    pub frame: u32,
    /// Value of the constant `initial_frame`, the number of the animation's first frame.
    pub initial_frame: u32,
    /// Value of the constant `final_frame`, the number of the animation's last frame.
    pub final_frame: u32,
    /// Value of the constant `initial_clock`, the clock of the animation's first frame.
    pub initial_clock: f64,
    /// Value of the constant `final_clock`, the clock of the animation's last frame.
    pub final_clock: f64,
}

impl Timing {
    /// Returns the value of one of the animation's constants; `None` for other names.
    pub(in crate::interpreter) fn animation_constant(&self, name: &str) -> Option<f64> {
        Some(match name {
            "clock" => self.clock,
            "clock_on" => f64::from(self.clock_on),
            "clock_delta" => self.clock_delta,
            "frame_number" => f64::from(self.frame),
            "initial_frame" => f64::from(self.initial_frame),
            "final_frame" => f64::from(self.final_frame),
            "initial_clock" => self.initial_clock,
            "final_clock" => self.final_clock,
            _ => return None,
        })
    }
}
