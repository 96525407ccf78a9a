//! Measurement of a render's accuracy, and the search for accurate settings of the least cost.
//!
//! *Theory.* A reference solution follows an image's rays again in 64 bits, by the general law and the Dormand–Prince pair at a far smaller
//! tolerance. A second such run, ten times looser, bounds the error of the first: rays on which the two disagree (chaotic flows beyond the
//! time that any number of digits can follow, rays at the edge of an object) are *unresolved*, and counted separately. For the others, the
//! error is the difference from the reference solution.
//!
//! *Practice.* [`verify`] measures a scene unchanged; [`calibrate`] tries the methods that a law allows on a few thousand rays and takes
//! the cheapest accurate one; `chart` sweeps all of them. A program is compiled once per method, because a sweep changes only numbers.

mod calibrate;
mod curve;
mod deviation;
mod drift;
mod ends;
mod focus;
mod jacobian;
mod judged;
mod methods;
mod optical_path;
pub mod profile;
mod reference;
mod refined;
mod sample;
mod shooting;
mod trials;
mod verify;
mod winding;

pub use crate::model::method::method_words;
pub use calibrate::{Calibration, Preparation, calibrate, calibrate_for};
pub use curve::Curve;
pub use deviation::{ErrorStats, Quantiles, flux_error};
pub use drift::drift;
pub use ends::{Settled, compared_layers};
pub use focus::{Focus, focus};
pub use jacobian::{EndJacobian, Jacobian, jacobians};
pub use judged::Judged;
pub use methods::{Candidate, all_methods, cost, evaluations, fast_methods, usual_method};
pub use optical_path::{OpticalPath, optical_paths, refuses_optical_paths};
pub(crate) use reference::double_device;
pub use reference::{Known, ReferenceSolution, reference};
pub use sample::{every_pixel, scattered};
pub use shooting::calibrate_paths;
pub use trials::Trial;
pub use verify::{Verification, verify};
pub use winding::windings;
