//! Animations: the numbers of the frames and the clock of each, by the rules of POV-Ray 3.7 (quirk: `animation_clock`).

use super::args::values::{Clock, Frames};
use crate::interpreter::Timing;

/// An animation of the frames `first` to `last`, of which `start` to `end` are rendered.
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    /// Number of the animation's first frame, POV-Ray's `Initial_Frame`.
    pub first: u32,
    /// Number of the animation's last frame and value of the constant `final_frame`: POV-Ray's `Final_Frame`, and one more for
    /// a cyclic animation, whose additional frame is rendered only if `end` includes it.
    pub last: u32,
    /// Clock of the animation's first and last frames, `Initial_Clock` and `Final_Clock`.
    pub clock: Clock,
    /// First frame to render of an animation, POV-Ray's `Subset_Start_Frame`.
    pub start: u32,
    /// Last frame to render of an animation, POV-Ray's `Subset_End_Frame`, which may exceed `last`.
    pub end: u32,
    /// Step between rendered frames of an animation, POV-Ray's `Frame_Step`.
    pub step: u32,
    /// Number of digits of the frame number in file names.
    pub digits: usize,
}

impl Animation {
    /// Creates the animation of the option `--frames A-B:STEP`, with a clock from 0 to 1.
    pub fn new(frames: Frames) -> Self {
        let Frames { first, last, step, digits } = frames;
        Self { first, last, clock: Clock { first: 0.0, last: 1.0 }, start: first, end: last, step, digits }
    }

    /// Returns the animation with other frames to render, which keep their clock. Does not check that the animation has them.
    pub fn restricted_to(&self, frames: Frames) -> Self {
        let Frames { first, last, step, digits } = frames;
        Self { start: first, end: last, step, digits: digits.max(self.digits), ..self.clone() }
    }

    /// Returns the numbers of the frames that this run renders.
    pub fn frames_to_render(&self) -> impl Iterator<Item = u32> + use<> {
        (self.start..=self.end.max(self.start)).step_by(self.step.max(1) as usize)
    }

    /// True if the animation has the frame of this number, whether this run renders the frame or not. Frames after `last`
    /// count only up to `end`.
    pub fn has_frame(&self, frame: u32) -> bool {
        (self.first..=self.last.max(self.end)).contains(&frame)
    }

    /// Returns the values of `clock`, `frame_number` and the other constants in a frame. The clock has 32 bits, and the
    /// other numbers have six digits. The clock of an animation of one frame is the initial one (quirk:
    /// `animation_clock`).
    pub fn timing(&self, frame: u32) -> Timing {
        let (first, last) = (self.clock.first as f32, self.clock.last as f32);
        let range = f64::from(last - first);
        let count = f64::from(self.last.saturating_sub(self.first).max(1));
        let passed = f64::from(frame) - f64::from(self.first);
        Timing {
            clock: f64::from((f64::from(first) + range * passed / count) as f32),
            clock_on: true,
            clock_delta: round_to_six_significant(range / count),
            frame,
            initial_frame: self.first,
            final_frame: self.last,
            initial_clock: round_to_six_significant(self.clock.first),
            final_clock: round_to_six_significant(self.clock.last),
        }
    }
}

/// Returns the values of the animation's constants for a single picture; `clock` is the value of `--clock`.
pub fn still_picture_timing(clock: Option<Clock>) -> Timing {
    let value = clock.map_or(0.0, |clock| f64::from(clock.first as f32));
    Timing { clock: value, clock_on: clock.is_some(), ..Timing::default() }
}

fn round_to_six_significant(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frames(text: &str) -> Animation {
        Animation::new(text.parse().unwrap())
    }

    /// `povray +KFF12 +KI… +KF…` and `#debug str(clock,0,9)`.
    #[test]
    fn clocks_have_32_bits() {
        let clock = |animation: &Animation, frame| format!("{:.9}", animation.timing(frame).clock);
        let twelve = frames("1-12");
        assert_eq!([3, 8, 10].map(|f| clock(&twelve, f)), ["0.181818187", "0.636363626", "0.818181813"]);
        let four = Animation { clock: Clock { first: 1.0, last: 3.0 }, ..frames("2-5") };
        assert_eq!([2, 3, 4, 5].map(|f| clock(&four, f)), ["1.000000000", "1.666666627", "2.333333254", "3.000000000"]);
        let steep = Animation { clock: Clock { first: 12345.6789, last: 0.0012345678 }, ..frames("1-3") };
        assert_eq!([1, 2, 3].map(|f| clock(&steep, f)), ["12345.678710938", "6172.839843750", "0.000976562"]);
        assert_eq!(clock(&Animation { end: 12, ..frames("1-9") }, 12), "1.375000000");
    }

    #[test]
    fn initial_clock_and_delta_have_six_digits() {
        let timing = Animation { clock: Clock { first: 12345.6789, last: 0.0012345678 }, ..frames("1-3") }.timing(2);
        let found = [timing.initial_clock, timing.final_clock, timing.clock_delta];
        assert_eq!(found, [12345.7, 0.00123457, -6172.84]);
        assert_eq!(frames("1-12").timing(1).clock_delta, 0.0909091);
    }

    #[test]
    fn the_clock_of_one_frame_is_the_initial_one() {
        let timing = frames("5-5").timing(5);
        assert_eq!((timing.clock, timing.clock_delta, timing.initial_frame, timing.final_frame), (0.0, 1.0, 5, 5));
        assert_eq!(still_picture_timing(None), Timing::default());
        assert!(still_picture_timing(Some(Clock { first: 0.0, last: 0.0 })).clock_on);
    }

    #[test]
    fn a_subset_keeps_the_clock() {
        let all = frames("1-30");
        let part = all.restricted_to("7-9:2".parse().unwrap());
        assert_eq!(part.frames_to_render().collect::<Vec<_>>(), [7, 9]);
        assert_eq!(part.timing(7), all.timing(7));
        assert_eq!(part.digits, 2);
        assert!(!part.has_frame(31) && !part.has_frame(0) && part.has_frame(30));
    }
}
