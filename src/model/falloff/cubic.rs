//! The fall-off d(r) = 2r³/R³ − 3r²/R² + 1 inside R, and 0 outside, with local range (G95 after Wyvill, W04 §5.2).

use super::FalloffKind;
use crate::document::keys;

pub static KIND: FalloffKind = FalloffKind {
    name: "cubic",
    parameter: Some((
        "radius",
        keys! {
            cubic: "R" = "none",
                "R: the force is 2r³/R³ − 3r²/R² + 1 inside this radius and 0 outside; scene units";
        }[0],
    )),
    wgsl: "cubic",
    potential: |r, radius| {
        let inside = r < radius;
        if inside { r.powi(4) / (2.0 * radius.powi(3)) - r.powi(3) / radius.powi(2) + r - 0.5 * radius } else { 0.0 }
    },
    reach: |radius| radius,
    orbit: "law/orbit/cubic",
    is_free_far_away: false,
};
