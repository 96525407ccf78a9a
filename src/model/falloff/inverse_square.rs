//! The fall-off d(r) = 1/r², which is singular at the source.

use super::FalloffKind;

pub static KIND: FalloffKind = FalloffKind {
    name: "inverse-square",
    parameter: None,
    wgsl: "inverse_square",
    potential: |r, _| -1.0 / r,
    reach: |_| 0.0,
    orbit: "law/orbit/inverse_square",
    is_free_far_away: true,
};
