//! What `clock`, `frame_number` and their kin say (manual, "Built-in Variables").

/// The moment of an animation that a picture shows. The default is that of POV-Ray where nothing is animated: all are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Timing {
    /// `clock`.
    pub clock: f64,
    /// `clock_on`: is there an animation, or was a clock asked for?
    pub clock_on: bool,
    /// `clock_delta`: from one frame to the next.
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
    /// The value of one of the constants that speak of time.
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
