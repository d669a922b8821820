//! Cameras before `#version 3.5`, whose words take effect in their order (quirk: `camera_words_in_order`).

use super::{Kind, PovrayCamera};
use crate::math::Transform;

impl PovrayCamera {
    /// Applies the camera's words so far to its vectors, so that each word that follows takes effect at once, in the
    /// order written.
    pub(super) fn begin_immediate_words(&mut self) {
        let frame = self.frame();
        self.location = frame.origin;
        (self.direction, self.right, self.up) = (frame.direction, frame.right, frame.up);
        self.transform = Transform::IDENTITY;
        self.ordered = true;
    }

    /// Makes the words that follow take effect in any order, on the vectors that earlier words made in their order.
    pub(super) fn end_immediate_words(&mut self) {
        if std::mem::take(&mut self.ordered) {
            (self.look_at, self.sized) = (None, true);
            if matches!(self.kind, Kind::Perspective | Kind::Orthographic) {
                (self.angle, self.has_angle) = (None, false);
            }
        }
    }

    /// Applies the word that was just read to the camera's vectors or focal distance, if it is `look_at`, `angle`,
    /// `orthographic` or `focal_point`; other words need no more than their value.
    pub(super) fn apply_word(&mut self, word: &str) {
        match word {
            "look_at" if self.look_at != Some(self.location) => self.apply_look_at(),
            "angle" if self.angle.is_some_and(|angle| angle > 0.0 && angle < 180.0) => self.apply_angle(),
            "orthographic" => self.scale_orthographic_window(),
            "focal_point" => self.blur.distance = Some(self.blur.focal_point.distance(self.location)),
            _ => {}
        }
    }
}
