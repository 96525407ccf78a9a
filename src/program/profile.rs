//! The properties of a device that programs and passes depend on.

/// The properties of a device that are known before it runs anything. The default is a GPU.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct DeviceProfile {
    /// The limit on loop iterations of an invocation; `None` if there is no limit.
    pub loop_budget: Option<LoopBudget>,
    /// The width of a workgroup in pixels; `None` for the default in `shaders/state/active.wgsl`.
    pub group_width: Option<u32>,
    /// The number of pixels that one invocation of the pass `whole` follows.
    pub lane_pixels: u32,
    /// The number of invocations that keeps the device busy.
    pub invocations: u64,
    /// The maximum number of pixels of a tile whose paths are followed in one dispatch; drivers fail on more if paths are long.
    pub whole_pixels: u64,
    /// Whether the device is a CPU, on which each invocation is a lane of a vector. A
    /// CPU reads uniforms fastest before any loop, and selects faster than it branches.
    pub is_processor: bool,
}

/// A limit on the loop iterations of one invocation, summed over all its
/// loops. Beyond it every loop silently ends after its first iteration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct LoopBudget {
    /// The number of iterations up to the limit.
    pub iterations: u32,
    /// The number of invocations that run in lockstep and share the limit.
    pub lanes: u32,
}

/// The largest number of pixels whose random paths one invocation follows. On a CPU 16 pixels take 0.9 times as long as 8, and 32 as long
/// as 16.
const RANDOM_LANE_PIXELS: u64 = 16;

impl DeviceProfile {
    /// The kinds of devices, under the names that users write.
    pub const NAMES: [&'static str; 2] = ["gpu", "cpu"];

    /// Returns the default profile of a kind of device, by its name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "gpu" => Some(Self::GPU),
            "cpu" => Some(Self::cpu(8)),
            _ => None,
        }
    }

    /// The default; a GPU needs as many invocations as possible.
    pub const GPU: Self = Self {
        loop_budget: None,
        group_width: None,
        lane_pixels: 1,
        invocations: 1 << 18,
        whole_pixels: 1 << 20,
        is_processor: false,
    };

    /// Returns the profile of a discrete GPU, which is so fast that the end of a dispatch, when few groups are left, takes a part of it.
    #[must_use]
    pub fn discrete() -> Self {
        Self { whole_pixels: 1 << 22, ..Self::GPU }
    }

    /// Returns the profile of Mesa's lavapipe, which runs `lanes` invocations side by side on a CPU.
    ///
    /// It stops an invocation after 65,535 loop iterations. It runs the lanes of a row side by side and
    /// prefetches memory along the row: with one row per workgroup, passes are 1.03 to 1.1 times as
    /// fast as with squares. It has few invocations, and shares the work of a group among eight lanes.
    #[must_use]
    pub fn cpu(lanes: u32) -> Self {
        let loop_budget = Some(LoopBudget { iterations: 65_535, lanes: lanes.max(1) });
        Self {
            loop_budget,
            group_width: Some(64),
            lane_pixels: 8,
            invocations: 1 << 12,
            is_processor: true,
            ..Self::GPU
        }
    }

    /// Returns the number of pixels whose random paths one invocation of the pass `whole` follows, if a dispatch has `pixels` pixels. The
    /// more there are, the less lanes wait for the longest path of their neighbors.
    ///
    /// Neighbors on a GPU run the same code for curved rays only as long as they begin together. On one H200 an image with 8 pixels per
    /// invocation takes 0.89 (`paths/box`) and 0.83 (`paths/prism`) times as long as with one, but 1.09 (`paths/hole`) and 1.31
    /// (`paths/luneburg`) if rays curve.
    #[must_use]
    pub fn random_lane_pixels(&self, pixels: u64, curved: bool) -> u32 {
        if curved && !self.is_processor {
            return self.lane_pixels;
        }
        let shared = (pixels / self.invocations).min(RANDOM_LANE_PIXELS) as u32;
        shared.max(self.lane_pixels)
    }
}

impl Default for DeviceProfile {
    fn default() -> Self {
        Self::GPU
    }
}
