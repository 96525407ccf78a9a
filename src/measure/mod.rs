//! How right a render is, and how to make it right in the least time.
//!
//! *Theory.* A picture's rays are followed again in 64 bits, by the general law and Dormand and Prince's pair at a far smaller
//! tolerance. A second such run, ten times looser, bounds the first one's own error: rays on which the two disagree (chaotic
//! flows beyond the time that any number of digits follows, rays at the very edge of an object) are *unresolved*, and counted
//! apart. What differs from the truth in the others is the error.
//!
//! *Practice.* [`verify`] measures a scene as it is; [`calibrate`] tries the methods that a law allows on a few thousand rays and
//! takes the cheapest that is right; `chart` sweeps all of them. A program is compiled once per method: what a sweep changes
//! are numbers.

mod calibrate;
mod curve;
mod deviation;
mod drift;
mod ends;
mod focus;
mod methods;
mod refined;
mod sample;
mod shooting;
mod trials;
mod truth;
mod verify;
mod winding;

pub use crate::model::method::method_words;
pub use calibrate::{Calibration, Preparation, calibrate, calibrate_for};
pub use curve::Curve;
pub use deviation::{Deviations, Quantiles};
pub use drift::drift;
pub use ends::{Settled, compared_layers};
pub use focus::{Focus, focus};
pub use methods::{Candidate, all_methods, cost, evaluations, fast_methods, usual_method};
pub use sample::{every_pixel, scattered};
pub use shooting::calibrate_paths;
pub use trials::Trial;
pub use truth::{Known, Truth, double_device, reference};
pub use verify::{Verification, verify};
pub use winding::windings;
