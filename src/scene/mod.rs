//! What the author said, after all macros and loops ran: plain data.

use serde::Serialize;

/// Everything the text put into the scene.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Scene {}
