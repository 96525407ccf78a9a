//! Laws: how light travels. The contract, and the table of kinds.
//!
//! *Theory.* A law gives the derivative of a point of phase space p = (x, v) along a ray, dp/dτ. The WGSL contract is
//! `law_derivative(p)`, `law_start(x, v)`, `law_projected(p)`, `law_scale(p)` and `path_acceleration(p, rate)`; a law whose acceleration depends on
//! place alone gives `law_acceleration(x, held)` and `law_held(p)` instead of the first and the last. [`Law`] is what the host has to
//! know besides.
//!
//! *Practice.* [`KINDS`] names each kind once. Adding one is a WGSL file, a file here and a line of that table.

mod charged;
mod flow;
mod kerr_newman;
mod landmark;
mod lorenz;
mod medium;
mod metric;
mod observer;
mod orbit;
pub mod own;
mod parametric;
mod rossler;
mod schwarzschild;
mod sources;
mod straight;
#[cfg(test)]
mod tests;
mod wormhole;

use std::fmt;
use std::sync::Arc;

use glam::{DMat3, DMat4, DVec3, DVec4};

use super::same::same;
use super::{Anchor, Binding, Capture, ClosedForm, Filter, Medium, Same, Wgsl, filter};
use crate::assets::{Files, LineElement};
use crate::document::reader::TableReader;
use crate::document::{self, Kinds};

pub use charged::ChargedHole;
pub use flow::FlowOrder;
pub use kerr_newman::{KerrNewman, KerrSchild};
pub use landmark::Landmark;
pub use lorenz::Lorenz;
pub use medium::{InMedium, SOLVED_PARTS};
pub use metric::Metric;
pub use observer::{CameraFrame, OBSERVER_PART};
pub use orbit::{Orbit, OrbitForm, Throat};
pub use own::{Depends, OwnLaw};
pub use parametric::Parametric;
pub use rossler::Rossler;
pub use schwarzschild::{Schwarzschild, SchwarzschildForm};
pub use sources::{ByLength, Sources};
pub use straight::Straight;
pub use wormhole::Wormhole;

/// Reads a law; none if it cannot be used.
type Read = fn(&TableReader, &mut Files) -> Option<Arc<dyn Law>>;
type Kind = document::Kind<Read>;

/// Every kind of law. Adding one is a line here.
pub static KINDS: Kinds<Read> = Kinds {
    table: "law",
    chooser: "kind",
    meaning: "how light travels: straight, round a black hole, by sources of force, along a flow or a curve, or in a medium",
    example: None,
    all: &[
        &straight::KIND,
        &schwarzschild::KIND,
        &charged::KIND,
        &kerr_newman::KIND,
        &metric::KIND,
        &wormhole::KIND,
        &sources::KIND,
        &lorenz::KIND,
        &rossler::KIND,
        &parametric::KIND,
        &medium::KIND,
        &own::KIND,
    ],
};

/// The parts of a usual law of the second order: it holds nothing, and takes starts and steps as they are.
const USUAL_PARTS: [&str; 5] =
    ["law/accelerated", "law/held_nothing", "law/start_as_given", "law/projected_as_is", "law/next_by_force"];

/// Steps that take the least time for most pictures, as charts have shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UsualSteps {
    /// Those of the orbit's own equation, or under a tolerance where there is none.
    Orbit,
    /// Those that a tolerance chooses.
    Tolerant,
    /// A fixed part of the law's scale, which is so short that it seldom has to be a small one.
    Scaled,
}

/// How light travels.
pub trait Law: fmt::Debug + Send + Sync + Same {
    /// The WGSL that keeps the contract.
    fn parts(&self) -> Vec<Wgsl>;

    /// What its parts are fed.
    fn values(&self) -> Vec<Binding> {
        Vec::new()
    }

    /// What the derivative depends on.
    fn order(&self) -> Order;

    /// Does a state carry time, as a fourth number beside place and velocity?
    fn carries_time(&self) -> bool {
        false
    }

    /// The steps by which its rays are usually followed in the least time.
    fn usual_steps(&self) -> UsualSteps {
        UsualSteps::Orbit
    }

    /// Is it the same at all times?
    fn is_stationary(&self) -> bool {
        true
    }

    /// The law at a time so much later, where that is another.
    fn later(&self, time: f64) -> Option<Arc<dyn Law>> {
        let _ = time;
        None
    }

    /// Is its τ the time that light takes, in the scene's units?
    fn keeps_time(&self) -> bool {
        false
    }

    /// How many terms one evaluation of its derivative adds up, each about as long as a simple law.
    fn terms(&self) -> u32 {
        1
    }

    /// What its force comes from, for the parts that know the way there.
    fn anchors(&self) -> Vec<Anchor> {
        Vec::new()
    }

    /// Where rays end. `clearance` is how far the objects of the scene are at least from a place; none where a ray is to be
    /// followed as far as it goes.
    fn captures(&self, clearance: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        let _ = clearance;
        self.medium().and_then(|medium| medium.capture()).into_iter().collect()
    }

    /// The part that captures rays, where its one sphere alone does not say it.
    fn capture_part(&self) -> Option<&'static str> {
        None
    }

    /// The orbit about its only centre, if it has one whose r has an equation of its own.
    fn orbit(&self) -> Option<Orbit> {
        None
    }

    /// What is kept along a ray.
    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        let _ = (x, v);
        Vec::new()
    }

    /// Spheres that a drawing shows: horizons, spheres that capture, edges.
    fn landmarks(&self) -> Vec<Landmark> {
        Vec::new()
    }

    /// The velocity that a given one at x stands for, where the law does not take it as it is.
    fn starting_velocity(&self, x: DVec3, v: DVec3) -> DVec3 {
        let _ = x;
        v
    }

    /// The line element that it is written as, if it is; rays then end where that says.
    fn line_element(&self) -> Option<&LineElement> {
        None
    }

    /// The medium that fills all space, if that is what the law is.
    fn medium(&self) -> Option<&Arc<dyn Medium>> {
        None
    }

    /// What its τ is to the path: the parts that know how fast a place moves, and what a step is measured in.
    fn pace(&self) -> [&'static str; 2] {
        ["law/path_as_velocity", "motion/pace_tau"]
    }

    /// The closed form of all its paths, if they have one, and if that is not a medium's.
    fn closed_form(&self) -> Option<&'static ClosedForm> {
        None
    }

    /// The curve that all rays follow, if they do.
    fn curve(&self) -> Option<&Parametric> {
        None
    }

    /// The τ at which its rays end of themselves.
    fn length(&self) -> Option<f64> {
        None
    }

    /// Why it does not matter where a ray points, if that is so.
    fn ignores_direction(&self) -> Option<&'static str> {
        (self.order() == Order::Flow).then_some("all rays from there follow the same orbit")
    }

    /// Why light cannot be followed from where it shines, if it cannot.
    fn refuses_sent_light(&self) -> Option<&'static str> {
        self.ignores_direction()
    }

    /// Has it the camera's axes?
    fn is_of_camera(&self) -> bool {
        false
    }

    /// The law of a camera with these axes in columns, to the right, up and backwards; none if it is the same for all.
    fn turned(&self, axes: DMat3) -> Option<Arc<dyn Law>> {
        let _ = axes;
        None
    }

    /// Are rays straight lines at a speed of their own, whatever their place?
    fn is_straight(&self) -> bool {
        false
    }

    /// The part that knows the directions of an observer, if they are not the coordinates'; none under laws that know no such observer.
    fn frame_part(&self, frame: CameraFrame) -> Option<&'static str> {
        let _ = frame;
        None
    }

    /// The metric of spacetime at a place, if the law is that of one: of vectors of the place's components, then the time's.
    fn metric(&self, x: DVec3) -> Option<DMat4> {
        let _ = x;
        None
    }

    /// That at a time so much later.
    fn metric_later(&self, x: DVec3, time: f64) -> Option<DMat4> {
        let _ = time;
        self.metric(x)
    }

    /// The length over which its metric changes at a place.
    fn length_scale(&self, x: DVec3) -> f64 {
        let _ = x;
        1.0
    }

    /// The four-velocity of an observer there, under laws that have a metric; or why there can be none, as what follows the camera's
    /// name in the message, and what to do.
    fn observer(&self, frame: CameraFrame, at: DVec3) -> Option<Result<DVec4, [String; 2]>> {
        let _ = (frame, at);
        None
    }

    /// The part that ends light from below a horizon, if it can come to such a place; or with none to any.
    fn below_part(&self, eye: Option<DVec3>) -> Option<&'static str> {
        let _ = eye;
        None
    }

    /// The parts that give the momentum of light, if light has a frequency under this law; else none.
    fn momentum_parts(&self) -> &'static [&'static str] {
        &[]
    }

    /// The centre and the axis about which matter goes round, if it does: on the orbits of [`CameraFrame::Orbiting`].
    fn equator(&self) -> Option<[DVec3; 2]> {
        None
    }

    /// What joins two places of its space, if something does.
    fn throat(&self) -> Option<Throat> {
        None
    }

    /// Why rays cannot be followed within a bounding sphere of this radius: the law's key that is wrong beside it, the mistake, and
    /// what to do.
    fn refuses_bound(&self, radius: f64) -> Option<(&'static str, [String; 2])> {
        let _ = radius;
        None
    }

    /// Is it a place that nothing comes out of, and where rays are not followed?
    fn swallows(&self, x: DVec3) -> bool {
        let _ = x;
        false
    }

    /// Why no eye can be at a place: what follows the eye's name in the message, and what to do.
    fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        let _ = at;
        None
    }

    /// What whoever chose it should know of it within a sphere of space, if that is out of the ordinary.
    fn remark(&self, center: DVec3, radius: f64) -> Option<String> {
        let _ = (center, radius);
        None
    }

    /// Why rays cannot go on from surfaces: from mirrors, and with `interiors` through what objects are filled with.
    fn refuses_surfaces(&self, interiors: bool) -> Option<&'static str> {
        let _ = interiors;
        None
    }
}

same!(Law);

/// What the derivative of a law depends on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// First order: dx = F(x), and v is F(x).
    Flow,
    /// Second order, dx = v, dv = a(x): with a constant of its own that each ray holds, or with none.
    Place,
    /// Second order, by place and velocity, or with time.
    General,
}

/// A quantity that a law keeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Invariant {
    /// Its name.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
    /// The size of what it is made of.
    pub size: f64,
}

/// None if the law cannot be used; straight lines if there is none. And what is left of light on its way through space.
pub(crate) fn read(root: &TableReader, files: &mut Files) -> (Option<Arc<dyn Law>>, Option<Filter>) {
    if root.node("law").is_none() {
        return (Some(Arc::new(Straight)), None);
    }
    let Some(table) = root.subtable("law", "law") else { return (None, None) };
    let law = KINDS.chosen(&table).and_then(|read| read(&table, files));
    let filter = table.node("filter").map(|node| filter::read(&table, node, DVec3::ZERO, files));
    table.finish();
    match filter {
        Some(None) => (None, None),
        Some(filter) => (law, filter),
        None => (law, None),
    }
}
