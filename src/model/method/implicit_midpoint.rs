//! The implicit midpoint rule, of order 2 and symplectic, for every law: what is quadratic in place and velocity and stays constant along
//! rays, such as x × v about a center, does so along its steps too.

use super::Kind;
use crate::model::control::scaled;

pub static KIND: Kind = Kind {
    name: "implicit-midpoint",
    parts: &["method/step/implicit_midpoint"],
    // It is iterated: about so many in 32 bits round a hole at steps of a tenth of the law's scale. In 64 bits they are 13 there.
    evaluations: 8,
    order: 2,
    sweeps: || vec![("implicit-midpoint", scaled::sweep(16))],
    ..Kind::STEPS
};
