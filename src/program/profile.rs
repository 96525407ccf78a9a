//! What a device is like, as far as programs and passes depend on it.

/// What is known of a device before anything runs on it. The default is that of a GPU.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct DeviceProfile {
    /// Where the device stops an invocation for its loops; `None` if it never does.
    pub loop_budget: Option<LoopBudget>,
    /// The pixels of a workgroup across; `None` for as many as `shaders/state/active.wgsl` says.
    pub group_width: Option<u32>,
    /// Pixels that one invocation of the pass `whole` follows, one below the other.
    pub lane_pixels: u32,
    /// Is it a CPU, on which each invocation is a lane of a vector? It reads uniforms fastest before any loop, and selects faster than it
    /// branches.
    pub is_processor: bool,
}

/// A limit on the loop iterations of one invocation, all its loops together, beyond which every loop ends after its first iteration without a
/// word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct LoopBudget {
    /// Iterations up to the limit.
    pub iterations: u32,
    /// Invocations that run in step, and use up the limit together.
    pub lanes: u32,
}

impl DeviceProfile {
    /// The kinds of devices, by the names that users write.
    pub const NAMES: [&'static str; 2] = ["gpu", "cpu"];

    /// Returns the usual profile of a kind of devices, by its name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "gpu" => Some(Self::GPU),
            "cpu" => Some(Self::cpu(8)),
            _ => None,
        }
    }

    /// The default: a GPU needs every invocation that it can get.
    pub const GPU: Self = Self { loop_budget: None, group_width: None, lane_pixels: 1, is_processor: false };

    /// Mesa's lavapipe, which runs so many invocations side by side on a processor.
    ///
    /// It stops an invocation after 65,535 loop iterations. It runs the lanes of a row side by side and fetches memory ahead along it: there a
    /// workgroup is one row, by which passes are 1.03 to 1.1 times as fast as by squares. It has few invocations, and does what a group
    /// does once for each eight lanes of it.
    #[must_use]
    pub fn cpu(lanes: u32) -> Self {
        let loop_budget = Some(LoopBudget { iterations: 65_535, lanes: lanes.max(1) });
        Self { loop_budget, group_width: Some(64), lane_pixels: 8, is_processor: true }
    }
}

impl Default for DeviceProfile {
    fn default() -> Self {
        Self::GPU
    }
}
