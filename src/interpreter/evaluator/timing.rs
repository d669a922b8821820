//! Values of `clock`, `frame_number` and the other constants of an animation (manual, "Built-in Variables").

/// The frame of an animation. The default is POV-Ray's without an animation: all values are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Timing {
    /// `clock`.
    pub clock: f64,
    /// `clock_on`: true in an animation, and if a clock was set.
    pub clock_on: bool,
    /// `clock_delta`: difference of the clock between two frames.
    pub clock_delta: f64,
    /// `frame_number`.
    pub frame: u32,
    /// `initial_frame`.
    pub initial_frame: u32,
    /// `final_frame`.
    pub final_frame: u32,
    /// `initial_clock`.
    pub initial_clock: f64,
    /// `final_clock`.
    pub final_clock: f64,
}

impl Timing {
    /// The value of one of these constants.
    pub(in crate::interpreter) fn constant(&self, name: &str) -> Option<f64> {
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
