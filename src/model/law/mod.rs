//! Laws: how light travels. The contract, and the table of kinds.
//!
//! *Theory.* A law gives the derivative of a point of phase space p = (x, v) along a ray, dp/dτ. The WGSL contract is
//! `law_derivative(p)`, `law_start(x, v)`, `law_projected(p)`, `law_scale(p)` and `path_acceleration(p, rate)`; a law whose acceleration
//! depends on place alone gives `law_acceleration(x, held)` and `law_held(p)` instead of the first and the last. [`Law`] is what the host
//! has to know besides.
//!
//! *Practice.* [`KINDS`] names each kind once. Adding one is a WGSL file, a file here and a line of that table.
//!
//! *Length.* Over 300 lines, because the contract of laws and the facts that they state stand together, each with its documentation.

mod charged;
mod flow;
mod hole;
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

pub use flow::FlowOrder;
pub use hole::{HoleForm, RoundHole};
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
    meaning: "how light travels: in straight lines, around a black hole, under forces, along a flow or a curve, or in a medium",
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
const USUAL_PARTS: [&str; 4] = ["law/accelerated", "law/held_nothing", "law/start_as_given", "law/projected_as_is"];

/// What is known of a law whatever the place.
#[derive(Debug, Clone)]
#[allow(clippy::struct_excessive_bools)] // facts, each by itself
pub struct Facts<'a> {
    /// What the derivative depends on.
    pub order: Order,
    /// Does a state carry time, as a fourth number beside place and velocity?
    pub carries_time: bool,
    /// Is it another law at another time?
    pub changes_with_time: bool,
    /// Is its τ the time that light takes, in the scene's units?
    pub keeps_time: bool,
    /// Are rays straight lines at a speed of their own, whatever their place?
    pub is_straight: bool,
    /// The steps by which its rays are usually followed in the least time.
    pub usual_steps: UsualSteps,
    /// How many terms one evaluation of its derivative adds up, each about as long as a simple law.
    pub terms: u32,
    /// The medium, the curve or the line element that it is, if it is one.
    pub form: Form<'a>,
    /// What its force comes from, for the parts that know the way there.
    pub anchors: Vec<Anchor>,
    /// The orbit about its only center, if it has one whose r has an equation of its own.
    pub orbit: Option<Orbit>,
    /// What joins two places of its space, if something does.
    pub throat: Option<Throat>,
    /// The closed form of all its paths, if they have one, and if that is not a medium's.
    pub closed_form: Option<&'static ClosedForm>,
    /// The τ at which its rays end of themselves.
    pub length: Option<f64>,
    /// Is τ the path's length, whatever the velocity?
    pub by_length: bool,
    /// Do orbits of light lie within the place where rays are captured, so that some turn there and are not?
    pub turns_before_capture: bool,
    /// The part that ends light from below a horizon, and the horizon.
    pub below: Option<(&'static str, Capture)>,
    /// The surface within which rays are not followed, and that nothing comes out of.
    pub swallows: Option<Capture>,
    /// The parts that give the momentum of light, if light has a frequency under this law; else none.
    pub momentum_parts: &'static [&'static str],
    /// Why it does not matter where a ray points, if that is so.
    pub ignores_direction: Option<&'static str>,
    /// Why light cannot be followed from where it shines, if it cannot.
    pub refuses_sent_light: Option<&'static str>,
    /// Why rays cannot go on from surfaces.
    pub refuses_surfaces: Option<&'static str>,
    /// Why rays cannot go on through what objects are filled with, where they can go on from mirrors.
    pub refuses_interiors: Option<&'static str>,
}

/// What a law is, where others have to know it.
#[derive(Debug, Clone, Copy)]
pub enum Form<'a> {
    /// None of these.
    Other,
    /// A medium that fills all space.
    Medium(&'a Arc<dyn Medium>),
    /// A curve that all rays follow.
    Curve(&'a Parametric),
    /// A line element; rays end where that says.
    LineElement(&'a LineElement),
}

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

impl Default for Facts<'_> {
    /// Returns the facts of a law of the second order that makes no demands and knows no observers.
    fn default() -> Self {
        Self {
            order: Order::Place,
            carries_time: false,
            changes_with_time: false,
            keeps_time: false,
            is_straight: false,
            usual_steps: UsualSteps::Orbit,
            terms: 1,
            form: Form::Other,
            anchors: Vec::new(),
            orbit: None,
            throat: None,
            closed_form: None,
            length: None,
            by_length: false,
            turns_before_capture: false,
            below: None,
            swallows: None,
            momentum_parts: &[],
            ignores_direction: None,
            refuses_sent_light: None,
            refuses_surfaces: None,
            refuses_interiors: None,
        }
    }
}

impl<'a> Facts<'a> {
    /// Returns the facts of a flow: a law of the first order.
    #[must_use]
    pub fn flow() -> Self {
        const SAME: &str = "all rays from there follow the same orbit";
        Self {
            order: Order::Flow,
            ignores_direction: Some(SAME),
            refuses_sent_light: Some(SAME),
            refuses_surfaces: Some("an orbit of a flow has no direction of its own"),
            ..Self::default()
        }
    }

    /// Returns the medium that fills all space, if that is what the law is.
    #[must_use]
    pub fn medium(&self) -> Option<&'a Arc<dyn Medium>> {
        if let Form::Medium(medium) = self.form { Some(medium) } else { None }
    }

    /// Returns the curve that all rays follow, if they do.
    #[must_use]
    pub fn curve(&self) -> Option<&'a Parametric> {
        if let Form::Curve(curve) = self.form { Some(curve) } else { None }
    }

    /// Returns the line element that the law is written as, if it is.
    #[must_use]
    pub fn line_element(&self) -> Option<&'a LineElement> {
        if let Form::LineElement(element) = self.form { Some(element) } else { None }
    }

    /// Returns why rays cannot go on from surfaces: from mirrors, and with `interiors` through what objects are filled with.
    #[must_use]
    pub fn refuses_surfaces(&self, interiors: bool) -> Option<&'static str> {
        self.refuses_surfaces.or(self.refuses_interiors.filter(|_| interiors))
    }

    /// Returns `true` if rays are not followed from this place, which nothing comes out of.
    #[must_use]
    pub fn swallows(&self, x: DVec3) -> bool {
        self.swallows.is_some_and(|surface| surface.distance(x) < 0.0)
    }
}

/// How light travels.
pub trait Law: fmt::Debug + Send + Sync + Same {
    /// The WGSL that keeps the contract.
    fn parts(&self) -> Vec<Wgsl>;

    /// What its parts are fed.
    fn values(&self) -> Vec<Binding> {
        Vec::new()
    }

    /// What is known of it whatever the place.
    fn facts(&self) -> Facts<'_> {
        Facts::default()
    }

    /// The law at a time so much later, in a camera's axes, which are columns: to the right, up and backwards; none if it is the same.
    fn seen(&self, axes: Option<DMat3>, time: f64) -> Option<Arc<dyn Law>> {
        let _ = (axes, time);
        None
    }

    /// Where rays end. `clearance` is how far the objects of the scene are at least from a place; none where a ray is to be
    /// followed as far as it goes.
    fn captures(&self, clearance: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        let _ = clearance;
        self.facts().medium().and_then(|medium| medium.facts().capture).into_iter().collect()
    }

    /// What is kept along a ray.
    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        let _ = (x, v);
        Vec::new()
    }

    /// Spheres that a drawing shows: horizons, spheres that capture, edges.
    fn landmarks(&self) -> Vec<Landmark> {
        self.facts().throat.map_or_else(Vec::new, |throat| throat.landmarks())
    }

    /// The velocity that a given one at x stands for, where the law does not take it as it is.
    fn starting_velocity(&self, x: DVec3, v: DVec3) -> DVec3 {
        let _ = x;
        v
    }

    /// The metric of spacetime at a place and so much later, if the law is that of one: of vectors of the place's components, then
    /// the time's.
    fn metric(&self, x: DVec3, time: f64) -> Option<DMat4> {
        let _ = (x, time);
        None
    }

    /// The length over which its metric changes at a place.
    fn length_scale(&self, x: DVec3) -> f64 {
        let _ = x;
        1.0
    }

    /// The four-velocity of an observer there; none, whatever the place, under laws that know no such observer. Or why there can be
    /// none, as what follows the camera's name in the message, and what to do.
    fn observer(&self, frame: CameraFrame, at: DVec3) -> Option<Result<DVec4, [String; 2]>> {
        let _ = (frame, at);
        None
    }

    /// The part that knows the directions of an observer, if they are not the coordinates'; none under laws that know no such observer.
    fn frame_part(&self, frame: CameraFrame) -> Option<&'static str> {
        self.observer(frame, DVec3::ZERO).map(|_| OBSERVER_PART)
    }

    /// The center and the axis about which matter goes round, if it does: on the orbits of [`CameraFrame::ProgradeOrbit`].
    fn equator(&self) -> Option<[DVec3; 2]> {
        None
    }

    /// Why no eye can be at a place: what follows the eye's name in the message, and what to do.
    fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        self.facts().throat?.refuses_eye(at)
    }

    /// A warning about the law within a sphere of space, if it is out of the ordinary there.
    fn remark(&self, center: DVec3, radius: f64) -> Option<String> {
        let _ = (center, radius);
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
    let filter = table.node("absorption").map(|node| filter::read(&table, node, DVec3::ZERO, files));
    table.finish();
    match filter {
        Some(None) => (None, None),
        Some(filter) => (law, filter),
        None => (law, None),
    }
}
