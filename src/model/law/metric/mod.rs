//! Custom spacetimes, which a scene specifies by their line element.
//!
//! *Theory.* The geodesic equation in coordinate time follows from the metric and the Euler–Lagrange equations of the line element; both
//! are derived from the text (`assets::LineElement`). Rays go into the past by τ = `t_camera` − t, and v = dx/dτ.
//!
//! *Practice.* The state is position and velocity, as under the other laws. A line element that depends on t uses the clock of laws that
//! carry time.
//!
//! *Length.* This file is over 300 lines, because it contains the keys, the checks and the trait of one kind together.

mod read;

use std::sync::Arc;

use glam::{DMat3, DMat4, DVec3, DVec4};

use super::observer::{four_velocity, light_speed};
use super::{Form, Invariant, Kind, Law, LawProperties, Observer, Order, Throat, UsualSteps};
use crate::assets::{LineElement, Spot};
use crate::document::keys;
use crate::model::{Binding, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "metric",
    keys: keys! {
        line_element: "formula" = "required",
            "ds² (G = c = 1, −+++) in x, y, z, t, r, rho, theta, phi and dx, dy, dz, dt, dr, drho, dtheta, dphi, dOmega2, and in names from `parameters` and `terms`; the geodesic equation is derived from it";
        scale: "formula" = "required", "length scale of the metric, in scene units, as a function of position and t; steps are a fraction of it";
        parameters: "table of numbers" = "{}", "named numbers";
        terms: "table of formulas" = "{}", "named formulas; each may use those before it";
        throat: "number above 0" = "none", "throat radius ρ₀ of a space with two sides, each around its own mouth: r = ρ₀ + |l|; `l` and `dl` give the distance from the throat, negative on the other side";
        other_mouth (" and throat"): "[x, y, z]" = "required", "position of the mouth on the other side, in scene units, around which the objects there are placed";
        capture_condition: "formula < formula" = "where the lapse is below 0.03, unless it changes with t", "condition under which rays are captured";
        time: "number" = "0", "coordinate time t of the image";
        center: "[x, y, z]" = "[0, 0, 0]", "origin of x, y and z";
        rotate: "[x, y, z]" = "[0, 0, 0]", "rotation about x, then y, then z of the scene, in degrees";
    },
    read: |table, _| read::read(table).map(|law| Arc::new(law) as Arc<dyn Law>),
};

/// A spacetime defined by its line element.
#[derive(Debug, Clone, PartialEq)]
pub struct Metric {
    /// The line element ds² and its derived expressions.
    pub element: LineElement,
    /// The coordinate time t of the image.
    pub time: f64,
    /// The origin of x, y and z.
    pub center: DVec3,
    /// The throat between the two sides, if the spacetime has two.
    pub throat: Option<Throat>,
}

impl Metric {
    fn carries_time(&self) -> bool {
        self.element.depends_on_time()
    }

    fn at(&self, x: DVec3) -> DMat4 {
        self.element.metric(self.spot(x, 0.0))
    }

    /// Returns the offset from the center, or from the nearer mouth.
    fn arm(&self, x: DVec3) -> DVec3 {
        self.spot(x, 0.0).x
    }

    /// Returns a position of the scene, `time` later than the image.
    fn spot(&self, x: DVec3, time: f64) -> Spot {
        let (arm, side) = self.throat.map_or((x - self.center, 1.0), |throat| throat.offset(x));
        Spot { x: arm, t: self.time + time, side }
    }

    /// Returns the direction of the spacetime's z axis.
    fn axis(&self) -> DVec3 {
        self.element.written().axes.z_axis
    }

    /// Returns `true` if the spacetime is symmetric around its axis, by rotating a few positions and velocities.
    fn is_axisymmetric(&self) -> bool {
        let turn = DMat3::from_axis_angle(self.axis(), 0.7);
        let places = [DVec3::new(1.3, -0.7, 2.1), DVec3::new(-4.2, 3.1, 0.9), DVec3::new(11.0, 7.0, -13.0)];
        let velocities = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(0.48, 0.6, -0.64)];
        places.into_iter().all(|x| {
            let [here, there] = [x, turn * x].map(|x| self.element.metric(Spot { x, t: self.time, side: 1.0 }));
            velocities.into_iter().all(|v| {
                let (u, turned) = (v.extend(-1.0), (turn * v).extend(-1.0));
                let (one, other) = (u.dot(here * u), turned.dot(there * turned));
                // A position without a value must have none after the rotation.
                (one - other).abs() <= 1e-9 * one.abs().max(1.0) || one.is_nan() && other.is_nan()
            })
        })
    }

    /// Returns the problem and the remedy for a position where the line element is infinite or 0/0. On the axis, `dtheta`, `dphi` and
    /// `drho` are singular, though space may be regular there.
    fn says_singular(&self, at: DVec3) -> [String; 2] {
        /// The distance from the axis, as a fraction of the camera's distance, at which the view equals that on the axis.
        const OFF: f64 = 1e-4;
        let arm = self.arm(at);
        let aside = self.axis().any_orthonormal_vector();
        let is_on_axis = self.axis().cross(arm).length() <= 1e-12 * arm.length();
        let off = at + OFF * arm.length().max(OFF) * aside;
        if !is_on_axis || !has_space(&self.at(off)) {
            let problem = "is where the line element has no value: a term divides by 0 or is not a real number";
            return says_none(problem, "move it, or write the line element in coordinates that are regular there");
        }
        let problem = "is on the coordinate axis of the line element, where the differentials of `theta`, `phi` and \
                       `rho` are singular (0/0)";
        let help = format!(
            "move it off the axis, such as to [{}, {}, {}], or write dOmega2 for dtheta^2 + sin(theta)^2*dphi^2",
            off.x, off.y, off.z
        );
        says_none(problem, &help)
    }

    /// Returns dφ/dt of the circular orbit through a position, with φ or against it: where the line element's derivative perpendicular to
    /// the axis vanishes.
    fn orbiting(&self, at: DVec3, sense: f64) -> Option<f64> {
        let (x, axis) = (self.arm(at), self.axis());
        let out = x - x.dot(axis) * axis;
        let rho = out.length();
        let is_level = x.dot(axis).abs() <= 1e-6 * rho;
        let (out, around) = (out / rho, axis.cross(x).extend(0.0));
        // The derivative ∂Q/∂ρ for U that rotates with its position.
        let slope = |u: DVec4, v: DVec4, turning: f64| {
            let change = |u: DVec4| self.slope(self.spot(at, 0.0), u, out);
            0.5 * (change(u + v) - change(u) - change(v)) + turning * u.dot(self.at(at) * v) / rho
        };
        let clock = DVec4::W;
        let (tt, tp, pp) = (slope(clock, clock, 0.0), slope(clock, around, 1.0), slope(around, around, 2.0));
        let root = (tp * tp - tt * pp).sqrt();
        let turning = (-tp + sense * root) / pp;
        (is_level && turning.is_finite()).then_some(turning)
    }

    /// Returns ∂Q/∂s along a direction at constant U, by central four-point differences with a relative error of about 1e-12.
    fn slope(&self, at: Spot, u: DVec4, along: DVec3) -> f64 {
        let q = |s: f64| u.dot(self.element.metric(Spot { x: at.x + s * along, ..at }) * u);
        let h = 1e-3 * at.x.length();
        let first = |h: f64| (q(h) - q(-h)) / (2.0 * h);
        let second = |h: f64| (4.0 * first(0.5 * h) - first(h)) / 3.0;
        (16.0 * second(0.5 * h) - second(h)) / 15.0
    }
}

/// Returns `true` if slices of equal time are spacelike and t is timelike across them: γ is positive, and g has one negative sign.
fn has_space(metric: &DMat4) -> bool {
    let gamma = DMat3::from_mat4(*metric);
    let leading = gamma.x_axis.x.min(gamma.x_axis.x * gamma.y_axis.y - gamma.x_axis.y * gamma.x_axis.y);
    leading.min(gamma.determinant()) > 0.0 && metric.determinant() < 0.0
}

/// Returns a position and a time in the past from the k-th quasi-random point: positions are denser near the center of the ball, and times
/// reach back over its diameter.
fn sample(k: u32, center: DVec3, radius: f64) -> (DVec3, f64) {
    let part = |step: f64| (f64::from(k) * step).fract();
    // The powers of the inverse of 1.1673…, the root of x⁵ = x + 1: a four-dimensional low-discrepancy sequence.
    let [height, around, out, ago] = [0.856_674_883_9, 0.733_891_856_6, 0.628_706_721_0, 0.538_596_253_1].map(part);
    let (cosine, angle) = (2.0 * height - 1.0, std::f64::consts::TAU * around);
    let across = (1.0 - cosine * cosine).sqrt();
    let way = DVec3::new(across * angle.cos(), across * angle.sin(), cosine);
    (center + radius * out * way, 2.0 * radius * ago)
}

fn says_none(why: &str, help: &str) -> [String; 2] {
    [why.to_owned(), help.to_owned()]
}

impl Law for Metric {
    fn parts(&self) -> Vec<Wgsl> {
        let order = if self.carries_time() { "law/by_time" } else { "law/by_velocity" };
        let element = ["law/metric", "law/light_speed", "law/line_element", "law/projected_as_is", "medium/formula"];
        [Wgsl::parts(&[order]), Wgsl::parts(&element)].concat()
    }

    fn values(&self) -> Vec<Binding> {
        let (other, radius) = self.throat.map_or((self.center, 0.0), |throat| (throat.mouths[1], throat.rim()));
        let row = row! {
            center: Vec3(self.center),
            time: Float(self.time),
            other: Vec3(other),
            radius: Float(radius),
        };
        vec![Binding::one("law", row)]
    }

    fn facts(&self) -> LawProperties<'_> {
        let in_time = self.element.depends_on_time();
        let sent = match self.throat {
            Some(_) => Some("light has more paths through a throat than bentray searches for"),
            None => (!self.element.is_static())
                .then_some("in this spacetime, light does not retrace the path of a ray from the camera"),
        };
        LawProperties {
            order: Order::General,
            carries_time: in_time,
            changes_with_time: in_time,
            keeps_time: true,
            usual_steps: UsualSteps::Scaled,
            throat: self.throat,
            form: Form::LineElement(&self.element),
            momentum_parts: &["law/momentum/radius", "law/momentum/metric"],
            flows: &[Observer::Zamo],
            refuses_surfaces: in_time.then_some("a law that depends on t would restart at each surface"),
            refuses_interiors: Some("in a spacetime, the speed of light in an interior is not defined"),
            refuses_sent_light: sent,
            ..LawProperties::default()
        }
    }

    fn seen(&self, _: Option<DMat3>, time: f64) -> Option<Arc<dyn Law>> {
        Some(Arc::new(Self { time: self.time + time, ..self.clone() }))
    }

    /// Returns the null condition, and L/E around the axis for rays whose energy E is positive.
    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        if self.carries_time() {
            return Vec::new();
        }
        let (metric, u) = (self.at(x), v.extend(-1.0));
        let lowered = metric * u;
        let mut kept = vec![Invariant { name: "null condition", value: u.dot(lowered), size: metric.w_axis.w.abs() }];
        if self.is_axisymmetric() && lowered.w > 0.0 {
            let momentum = lowered.truncate() / lowered.w;
            let arm = self.arm(x);
            let about = -self.axis().dot(arm.cross(momentum));
            kept.push(Invariant { name: "L / E", value: about, size: arm.length() * momentum.length() });
        }
        kept
    }

    /// Returns a velocity along v at the speed of light.
    fn starting_velocity(&self, x: DVec3, v: DVec3) -> DVec3 {
        let (metric, way) = (self.at(x), v.extend(0.0));
        v / light_speed(-metric.w_axis.w, way.dot(metric.w_axis), way.dot(metric * way))
    }

    fn metric(&self, x: DVec3, time: f64) -> Option<DMat4> {
        Some(self.element.metric(self.spot(x, time)))
    }

    fn length_scale(&self, x: DVec3) -> f64 {
        self.element.scale(self.spot(x, 0.0))
    }

    fn observer(&self, frame: Observer, at: DVec3) -> Option<Result<DVec4, [String; 2]>> {
        let found = match frame {
            Observer::Coordinate => return None,
            Observer::Zamo | Observer::ProgradeOrbit | Observer::RetrogradeOrbit if !self.is_axisymmetric() => {
                let problem = "cannot orbit, because the line element is not axisymmetric";
                return Some(Err(says_none(problem, "use observer = \"boosted\" or \"eulerian\"")));
            }
            _ => {
                let around = self.axis().cross(self.arm(at));
                four_velocity(&self.at(at), frame, around, &|sense| self.orbiting(at, sense))
            }
        };
        Some(found.ok_or_else(|| match frame {
            Observer::Static => says_none("is where nothing can be static", "use observer = \"eulerian\", or move it"),
            Observer::Boosted(_) => says_none("moves faster than light", "use a velocity below 1"),
            Observer::ProgradeOrbit | Observer::RetrogradeOrbit => says_none(
                "is not on a circular orbit of matter",
                "circular orbits are in the plane z = 0, outside the innermost one",
            ),
            Observer::Infalling => {
                let problem = "falls, and a line element does not define the starting point";
                says_none(problem, "use observer = \"boosted\" and camera.velocity")
            }
            _ => says_none("is where the signature of the metric is not −+++", "move it"),
        }))
    }

    fn equator(&self) -> Option<[DVec3; 2]> {
        (!self.carries_time() && self.is_axisymmetric()).then(|| [self.center, self.axis()])
    }

    fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        if let Some(refused) = self.throat.and_then(|throat| throat.refuses_eye(at)) {
            return Some(refused);
        }
        if self.element.gap(self.spot(at, 0.0)).is_some_and(|gap| gap.w <= 0.0) {
            return Some(says_none("is where rays are captured: see law.capture_condition", "move it away"));
        }
        let metric = self.at(at);
        if !metric.is_finite() {
            return Some(self.says_singular(at));
        }
        let problem = "is where the line element has no spacelike slice: its signature is not −+++";
        (!has_space(&metric)).then(|| says_none(problem, "move it, or check the signs of law.line_element"))
    }

    fn remark(&self, center: DVec3, radius: f64) -> Option<String> {
        const PLACES: u32 = 4096;
        let fails = |k: u32| {
            let (x, ago) = sample(k, center, radius);
            let spot = self.spot(x, -ago);
            let within = self.throat.is_some_and(|throat| spot.x.length() < throat.radius);
            let ended = within || self.element.gap(spot).is_some_and(|gap| gap.w <= 0.0);
            (!ended && !has_space(&self.element.metric(spot))).then_some((x, spot.t))
        };
        let failed: Vec<_> = (1..=PLACES).filter_map(fails).collect();
        let (x, t) = failed.first()?;
        let when = if self.carries_time() { format!(" at t = {t:.2}") } else { String::new() };
        Some(format!(
            "at {} of {PLACES} positions within the bounding sphere, such as [{:.3}, {:.3}, {:.3}]{when}, the line \
             element does not have the signature −+++: rays fail there",
            failed.len(),
            x.x,
            x.y,
            x.z
        ))
    }
}
