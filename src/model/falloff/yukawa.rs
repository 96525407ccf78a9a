//! The fall-off d(r) = e^(−μr)(1 + μr)/r² of the screened potential V = −e^(−μr)/r (W04 §5.2, with a sign that repels).

use super::FalloffKind;
use crate::document::keys;

pub static KIND: FalloffKind = FalloffKind {
    name: "yukawa",
    parameter: Some(("mu", keys! { yukawa: "mu" = "none", "μ: the force is e^(−μr)(1 + μr)/r²; per scene unit"; }[0])),
    wgsl: "yukawa",
    potential: |r, mu| -(-mu * r).exp() / r,
    reach: |_| 0.0,
    orbit: "law/orbit/yukawa",
    is_free_far_away: false,
};
