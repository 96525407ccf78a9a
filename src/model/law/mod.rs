//! Laws, which define how light propagates: the contract and the table of kinds.
//!
//! *Theory.* A law is the derivative dp/dτ of a point of phase space p = (x, v) along a ray. The WGSL contract is `law_derivative(p)`,
//! `law_start(x, v)`, `law_projected(p)`, `law_scale(p)` and `path_acceleration(p, rate)`. A law whose acceleration depends on position
//! alone implements `law_acceleration(x, held)` and `law_ray_constant(p)` instead of the first and the last. [`Law`] contains the properties that
//! the host needs.
//!
//! *Practice.* [`KINDS`] lists each kind once. To add a kind, add a WGSL file, a file here and a line of that table.
//!
//! *Length.* This file is over 300 lines, because it contains the contract of laws and their properties, with documentation of each.

mod characteristic_surface;
mod charged;
pub mod custom;
mod flow;
mod hole;
mod kerr_newman;
mod lorenz;
mod medium;
mod metric;
mod observer;
mod orbit;
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

use glam::{DMat3, DMat4, DQuat, DVec3, DVec4};

use super::dyn_eq::same;
use super::{Absorption, Anchor, Binding, Capture, ClosedForm, DynEq, Medium, Wgsl, absorption};
use crate::assets::{Files, LineElement};
use crate::document::reader::TableReader;
use crate::document::{self, Kinds};

pub use characteristic_surface::CharacteristicSurface;
pub use custom::{CustomLaw, Depends};
pub use flow::FlowOrder;
pub use hole::{HoleForm, RoundHole};
pub use kerr_newman::{KerrNewman, KerrSchild};
pub use lorenz::Lorenz;
pub use medium::{InMedium, SOLVED_PARTS};
pub use metric::Metric;
pub use observer::{OBSERVER_PART, Observer};
pub use orbit::{Orbit, OrbitForm, Throat};
pub use parametric::Parametric;
pub use rossler::Rossler;
pub use sources::{ByLength, Sources};
pub use straight::Straight;
pub use wormhole::Wormhole;

/// Reads a law; returns `None` after an error.
type Read = fn(&TableReader, &mut Files) -> Option<Arc<dyn Law>>;
type Kind = document::Kind<Read>;

/// The table of all laws; a new kind needs one line here.
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
        &custom::KIND,
    ],
};

/// The modules of a usual second-order law, which stores no constant per ray and leaves starts and steps unchanged.
const USUAL_PARTS: [&str; 4] = ["law/accelerated", "law/no_constant", "law/start_as_given", "law/projected_as_is"];

/// The properties of a law that do not depend on position.
#[derive(Debug, Clone)]
#[allow(clippy::struct_excessive_bools)] // facts, each by itself
pub struct LawProperties<'a> {
    /// The variables on which the derivative depends.
    pub order: Order,
    /// Is `true` if a state includes time as a fourth number next to position and velocity.
    pub carries_time: bool,
    /// Is `true` if the law depends on time.
    pub changes_with_time: bool,
    /// Is `true` if τ is the travel time of light, in the scene's units.
    pub keeps_time: bool,
    /// Is `true` if rays are straight lines whose speed does not depend on position.
    pub is_straight: bool,
    /// The steps that usually follow its rays in the least time.
    pub usual_steps: UsualSteps,
    /// The number of terms of one derivative evaluation, each about as expensive as a simple law.
    pub terms: u32,
    /// The medium, curve or line element of the law, if it is one of these.
    pub form: Form<'a>,
    /// The sources of force, for the modules that compute the offset to them.
    pub anchors: Vec<Anchor>,
    /// The orbit around the only center, if the law has one and r has a separate equation.
    pub orbit: Option<Orbit>,
    /// The throat that connects two regions of its space, if there is one.
    pub throat: Option<Throat>,
    /// The closed form of all paths, if they have one that is not a medium's.
    pub closed_form: Option<&'static ClosedForm>,
    /// The τ at which all rays end.
    pub length: Option<f64>,
    /// Is `true` if τ is the arc length of the path, whatever the velocity.
    pub by_length: bool,
    /// Is `true` if photon orbits extend into the capture region, so that some rays turn there and are not captured.
    pub turns_before_capture: bool,
    /// The module that ends light from below a horizon, and the horizon.
    pub below: Option<(&'static str, Capture)>,
    /// The surface inside which rays are not followed, and that nothing leaves.
    pub swallows: Option<Capture>,
    /// The modules for the momentum of light; empty if light has no frequency under this law.
    pub momentum_parts: &'static [&'static str],
    /// The observers as which matter in volumes may move, in addition to static and Eulerian ones.
    pub flows: &'static [Observer],
    /// The reason why the direction of a ray has no effect, if this is so.
    pub ignores_direction: Option<&'static str>,
    /// The reason why light cannot be traced forward from its sources, if this is so.
    pub refuses_sent_light: Option<&'static str>,
    /// The reason why rays cannot continue from surfaces, if this is so.
    pub refuses_surfaces: Option<&'static str>,
    /// The reason why rays cannot continue through interiors, if they can continue from mirrors.
    pub refuses_interiors: Option<&'static str>,
}

/// A position in coordinates about an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spherical {
    /// The radius, in scene units.
    pub radius: f64,
    /// The azimuth, from −π to π, counterclockwise about the axis.
    pub azimuth: f64,
    /// The difference of the law's time and the time in these coordinates at the same event, in scene units.
    pub time_ahead: f64,
}

impl Spherical {
    /// Returns the distance from a center and the azimuth about a unit vector; `d` is the vector from the center.
    #[must_use]
    pub fn about(axis: DVec3, d: DVec3) -> Self {
        let (first, second) = axis.any_orthonormal_pair();
        Self { radius: d.length(), azimuth: d.dot(second).atan2(d.dot(first)), time_ahead: 0.0 }
    }
}

/// A structure of a law that other code depends on.
#[derive(Debug, Clone, Copy)]
pub enum Form<'a> {
    /// No special structure.
    Other,
    /// A medium that fills all of space.
    Medium(&'a Arc<dyn Medium>),
    /// A curve that all rays follow.
    Curve(&'a Parametric),
    /// A line element, which also defines where rays end.
    LineElement(&'a LineElement),
}

/// The kind of steps that takes the least time for most images, according to charts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UsualSteps {
    /// Steps of the orbit's equation, or of a tolerance if there is no orbit.
    Orbit,
    /// Steps that a tolerance determines.
    Tolerant,
    /// A fixed fraction of the law's length scale: for laws whose scale is so short that the fraction seldom has to be small, and for those
    /// whose derivative is long, because the program of a tolerance contains it more often. A tolerance is tried next if it does not suffice.
    Scaled,
}

impl Default for LawProperties<'_> {
    /// Returns the properties of a second-order law without restrictions and without observers.
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
            flows: &[],
            ignores_direction: None,
            refuses_sent_light: None,
            refuses_surfaces: None,
            refuses_interiors: None,
        }
    }
}

impl<'a> LawProperties<'a> {
    /// Returns the properties of a flow, which is a first-order law.
    #[must_use]
    pub fn flow() -> Self {
        const SAME: &str = "all rays from a point follow the same orbit";
        Self {
            order: Order::Flow,
            ignores_direction: Some(SAME),
            refuses_sent_light: Some(SAME),
            refuses_surfaces: Some("in a flow, the position of a ray determines its direction"),
            ..Self::default()
        }
    }

    /// Returns the medium that fills all of space, if the law is one.
    #[must_use]
    pub fn medium(&self) -> Option<&'a Arc<dyn Medium>> {
        if let Form::Medium(medium) = self.form { Some(medium) } else { None }
    }

    /// Returns the curve that all rays follow, if the law is one.
    #[must_use]
    pub fn curve(&self) -> Option<&'a Parametric> {
        if let Form::Curve(curve) = self.form { Some(curve) } else { None }
    }

    /// Returns the line element, if the law has one.
    #[must_use]
    pub fn line_element(&self) -> Option<&'a LineElement> {
        if let Form::LineElement(element) = self.form { Some(element) } else { None }
    }

    /// Returns why rays cannot continue from mirrors or, with `interiors`, through interiors.
    #[must_use]
    pub fn refuses_surfaces(&self, interiors: bool) -> Option<&'static str> {
        self.refuses_surfaces.or(self.refuses_interiors.filter(|_| interiors))
    }

    /// Returns `true` if rays are not followed from this position, because nothing leaves it.
    #[must_use]
    pub fn swallows(&self, x: DVec3) -> bool {
        self.swallows.is_some_and(|surface| surface.distance(x) < 0.0)
    }
}

/// A law, which defines how light propagates.
///
/// A custom law implements [`parts`](Self::parts) and [`values`](Self::values) with WGSL as text, as `examples/own_law.rs` does.
pub trait Law: fmt::Debug + Send + Sync + DynEq {
    /// Returns the WGSL modules that implement the contract.
    fn parts(&self) -> Vec<Wgsl>;

    /// Returns the values of the modules.
    fn values(&self) -> Vec<Binding> {
        Vec::new()
    }

    /// Returns the properties that do not depend on position.
    fn facts(&self) -> LawProperties<'_> {
        LawProperties::default()
    }

    /// Returns the law `time` later, in a camera's axes, which are columns to the right, up and backwards; `None` if it is unchanged.
    fn seen(&self, axes: Option<DMat3>, time: f64) -> Option<Arc<dyn Law>> {
        let _ = (axes, time);
        None
    }

    /// Returns the regions in which rays end. `clearance` is a lower bound of the distance from a position to the scene's objects; `None`
    /// if rays are followed as far as possible.
    fn captures(&self, clearance: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        let _ = clearance;
        self.facts().medium().and_then(|medium| medium.facts().capture).into_iter().collect()
    }

    /// Returns the constants of motion of a ray.
    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        let _ = (x, v);
        Vec::new()
    }

    /// Returns the spheres that a diagram shows: horizons, capture spheres, edges.
    fn landmarks(&self) -> Vec<CharacteristicSurface> {
        self.facts().throat.map_or_else(Vec::new, |throat| throat.landmarks())
    }

    /// Returns the initial velocity of a ray at x with direction v, which the law may normalize.
    fn starting_velocity(&self, x: DVec3, v: DVec3) -> DVec3 {
        let _ = x;
        v
    }

    /// Returns the metric of spacetime at a position and `time` later, if the law has one; vectors have spatial components followed by the
    /// time component.
    fn metric(&self, x: DVec3, time: f64) -> Option<DMat4> {
        let _ = (x, time);
        None
    }

    /// Returns the length scale over which the metric changes at a position.
    fn length_scale(&self, x: DVec3) -> f64 {
        let _ = x;
        1.0
    }

    /// Returns the four-velocity of an observer at a position, or `None` under laws without such observers. An error contains the text that
    /// follows the camera's name in the message, and the remedy.
    fn observer(&self, frame: Observer, at: DVec3) -> Option<Result<DVec4, [String; 2]>> {
        let _ = (frame, at);
        None
    }

    /// Returns the module for the directions of an observer; `None` for coordinate directions and under laws without such observers.
    fn frame_part(&self, frame: Observer) -> Option<&'static str> {
        self.observer(frame, DVec3::ZERO).map(|_| OBSERVER_PART)
    }

    /// Returns the center and the axis of the matter on [`Observer::ProgradeOrbit`], if matter can orbit.
    fn equator(&self) -> Option<[DVec3; 2]> {
        None
    }

    /// Returns the axes of formulas of position in the law's coordinates, of which the third is the axis of the law.
    fn formula_axes(&self) -> DMat3 {
        let axis = self.equator().map_or(DVec3::Z, |[_, axis]| axis);
        DMat3::from_quat(DQuat::from_rotation_arc(DVec3::Z, axis))
    }

    /// Returns a position in the coordinates in which the spacetime is usually described, about [`equator`](Self::equator); `None` if there
    /// is no equator.
    fn spherical(&self, x: DVec3) -> Option<Spherical> {
        let [center, axis] = self.equator()?;
        Some(Spherical::about(axis, x - center))
    }

    /// Returns why no eye can be at a position: the text that follows the eye's name in the message, and the remedy.
    fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        self.facts().throat?.refuses_eye(at)
    }

    /// Returns a warning about unusual behavior of the law within a sphere, if there is any.
    fn remark(&self, center: DVec3, radius: f64) -> Option<String> {
        let _ = (center, radius);
        None
    }
}

same!(Law);

/// The variables on which the derivative of a law depends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// First order: dx = F(x), and v is F(x).
    Flow,
    /// Second order, dx = v, dv = a(x), optionally with a constant that each ray stores.
    Place,
    /// Second order with dependence on position and velocity, or on time.
    General,
}

/// A constant of motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Invariant {
    /// The name.
    pub name: &'static str,
    /// The value.
    pub value: f64,
    /// The sum of the magnitudes of its terms.
    pub size: f64,
}

/// Reads the law and the absorption of space. The law defaults to straight lines, and is `None` after an error.
pub(crate) fn read(root: &TableReader, files: &mut Files) -> (Option<Arc<dyn Law>>, Option<Absorption>) {
    if root.node("law").is_none() {
        return (Some(Arc::new(Straight)), None);
    }
    let Some(table) = root.subtable("law", "law") else { return (None, None) };
    let law = KINDS.chosen(&table).and_then(|read| read(&table, files));
    let absorption = table.node("absorption").map(|node| absorption::read(&table, node, DVec3::ZERO, files));
    table.finish();
    match absorption {
        Some(None) => (None, None),
        Some(absorption) => (law, absorption),
        None => (law, None),
    }
}
