//! Limits that `--untrusted` sets unless other limits are given.

use super::SceneArgs;
use super::values::{Bytes, Seconds};

/// Time limit of an untrusted scene without `--max-time`.
const MAX_TIME: Seconds = Seconds(60.0);
/// Memory limit for an untrusted scene without `--max-memory`.
const MAX_MEMORY: Bytes = Bytes(2 << 30);
/// Maximum number of pixels of the picture of an untrusted scene.
pub const MAX_PIXELS: u128 = 1 << 24;

/// True if the environment variable `DURER_UNTRUSTED` is neither empty nor `0`.
pub fn environment_is_untrusted() -> bool {
    std::env::var_os("DURER_UNTRUSTED").is_some_and(|value| !value.is_empty() && value != "0")
}

impl SceneArgs {
    /// True for `--untrusted`, and if the environment variable `DURER_UNTRUSTED` is neither empty nor `0`.
    pub fn is_untrusted(&self) -> bool {
        self.untrusted || environment_is_untrusted()
    }

    /// Returns the time limit of the scene; `None` for no limit.
    pub fn time_limit(&self) -> Option<Seconds> {
        self.max_time.or_else(|| self.is_untrusted().then_some(MAX_TIME))
    }

    /// Returns the memory limit of the process; `None` for the limit of the machine.
    pub fn memory_limit_if_set(&self) -> Option<Bytes> {
        self.max_memory.or_else(|| self.is_untrusted().then_some(MAX_MEMORY))
    }
}
