//! Rays along a curve x(t), y(t), z(t) from the scene, which is the same at every position (G95 §2.3).
//!
//! *Theory.* The curve is translated so that it passes through the point on the image plane at t = 0 (G95 Table 3, "translated") or, if the
//! range of t does not contain 0, at its start. Only the starting point determines the path of a ray.
//!
//! *Practice.* The curve is the path, so that no solver is needed. A solver may be specified for comparison, and then integrates the second
//! derivative (G95 Table 1 has such a row). Derivatives are computed from the formulas.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::{Form, Kind, Law, LawProperties, Order};
use crate::assets::{Curve, Interval};
use crate::document::reader::TableReader;
use crate::document::values::{Parsed, array, number, text, word};
use crate::document::{Node, keys};
use crate::model::{Binding, ClosedForm, Start, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "parametric",
    keys: keys! {
        x: "formula" = "required", "x of the ray as a function of t, with numbers, pi, and the operators and functions of `medium.n`";
        y: "formula" = "required", "y of the ray, as for x";
        z: "formula" = "required", "z of the ray, as for x";
        t: "[first, last]" = "required",
            "range of t; at t = 0, or at the first value if the range excludes 0, the ray crosses the image plane at its pixel";
        axes: "scene | camera" = "scene",
            "axes of the formulas: of the scene, or of the camera (x right, y up, z towards the viewer)";
    },
    read: |table, _| {
        let curve = curve(table);
        let range = table.required("t", "[0, 12]", range);
        let axes = table.or("axes", false, word(&[("scene", false), ("camera", true)]));
        let [first, last] = range?;
        let law = Parametric { curve: curve?, first, last, turned: axes.then_some(DMat3::IDENTITY) };
        law.is_sound(table).then(|| Arc::new(law) as Arc<dyn Law>)
    },
};

/// The closed form of the curve, for rays that need no solver.
static FORM: ClosedForm = ClosedForm {
    name: "parametric",
    parts: &["motion/parametric", "motion/pace_tau", "motion/closed"],
    leaps: false,
    is_line: false,
    meets_obstacles: false,
    // `NODES` of the ray in one step, each compared with `VISITS` of the objects.
    start: Start::Own,
};

fn curve(table: &TableReader) -> Option<Curve> {
    let nodes = ["x", "y", "z"].map(|key| table.required_node(key, "\"t^2\""));
    let [x, y, z] = nodes.map(|node| written(table, node));
    let curve = Curve::parse([x?, y?, z?]).map_err(|wrong| {
        for (k, error) in wrong {
            if let Some(node) = nodes[k] {
                table.reader.fault_inside(node, error.place, error.problem, error.help);
            }
        }
    });
    curve.ok()
}

fn written<'a>(table: &TableReader, node: Option<&'a Node>) -> Option<&'a str> {
    let node = node?;
    let help = "for example \"cos(2 * t)\", or \"2\"";
    text(node).map_err(|_| table.reader.fault(node.fault("expected a formula, in quotes", help))).ok()
}

fn range(node: &Node) -> Parsed<[f64; 2]> {
    let [first, last] = array("a range of t, [first, last]", number)(node)?;
    if first < last {
        Ok([first, last])
    } else {
        Err(node.fault("the range of t is empty", "make the first t less than the last"))
    }
}

/// A curve and the range of its parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Parametric {
    /// The coordinates x(t), y(t) and z(t).
    pub curve: Curve,
    /// The parameter t at the start of the ray.
    pub first: f64,
    /// The parameter t at its end.
    pub last: f64,
    /// The axes of the formulas, as columns, if they are those of a camera.
    pub turned: Option<DMat3>,
}

/// The number of points at which the range of a curve is checked for values.
const LOOKS: u32 = 4096;

impl Parametric {
    /// Returns the t at which the curve passes through the starting point.
    #[must_use]
    pub fn anchor(&self) -> f64 {
        if self.first <= 0.0 && self.last >= 0.0 { 0.0 } else { self.first }
    }

    fn axes(&self) -> DMat3 {
        self.turned.unwrap_or(DMat3::IDENTITY)
    }

    /// Returns position, velocity and three more derivatives at t = first + `tau`, in the scene's axes.
    #[must_use]
    pub fn at(&self, tau: f64) -> [DVec3; 5] {
        self.curve.at(self.first + tau).map(|c| self.axes() * c)
    }

    /// Returns the derivatives over an interval, and `true` if the curve has no kink there.
    #[must_use]
    pub fn over(&self, tau: Interval) -> ([[Interval; 3]; 5], bool) {
        let (all, smooth) = self.curve.over(tau.plus(Interval::at(self.first)));
        let Some(axes) = self.turned else { return (all, smooth) };
        let turned = all.map(|c| {
            let row = |k: usize| {
                let part = |j: usize| Interval::at(axes.col(j)[k]).times(c[j]);
                part(0).plus(part(1)).plus(part(2))
            };
            [row(0), row(1), row(2)]
        });
        (turned, smooth)
    }

    /// Returns `true` if the curve has values over its whole range and is not a point. Errors are reported at the faulty formula.
    fn is_sound(&self, table: &TableReader) -> bool {
        let place = |k: u32| self.first + (self.last - self.first) * f64::from(k) / f64::from(LOOKS);
        let all: Vec<_> = std::iter::once(self.anchor()).chain((0..=LOOKS).map(place)).collect();
        let mut sound = true;
        for (k, key) in ["x", "y", "z"].into_iter().enumerate() {
            let known = |t: f64| self.curve.at(t)[..2].iter().all(|c| (c[k] as f32).is_finite());
            if let Some(t) = all.iter().find(|t| !known(**t)) {
                let what =
                    if self.curve.at(*t)[0][k].is_finite() { "the derivative of the formula" } else { "the formula" };
                let problem = format!("{what} has no finite value at t = {t}, which is in the range of t");
                let help =
                    format!("change it, or exclude that value from `t`, which is [{}, {}]", self.first, self.last);
                table.fault(&[key], problem, help);
                sound = false;
            }
        }
        if sound && all.iter().all(|t| self.curve.at(*t)[1] == DVec3::ZERO) {
            table.fault(
                &["x"],
                "the curve is a single point, because none of its formulas depends on t",
                "for example y = \"t\"",
            );
            sound = false;
        }
        sound
    }
}

impl Law for Parametric {
    fn parts(&self) -> Vec<Wgsl> {
        Wgsl::parts(&["law/parametric", "law/by_time", "law/projected_as_is", "medium/formula"])
    }

    fn values(&self) -> Vec<Binding> {
        let offset = self.axes() * (self.curve.at(self.first)[0] - self.curve.at(self.anchor())[0]);
        let law = Binding::one("law", row! { offset: Vec3(offset), first: Float(self.first) });
        let axes = self.turned.map(|axes| {
            let [x, y, z] = [axes.x_axis, axes.y_axis, axes.z_axis];
            Binding::one("axes", row! { x: Vec3(x), y: Vec3(y), z: Vec3(z) })
        });
        [law].into_iter().chain(axes).collect()
    }

    fn facts(&self) -> LawProperties<'_> {
        const SAME: &str = "all rays from a point follow the same curve";
        LawProperties {
            order: Order::General,
            carries_time: true,
            closed_form: Some(&FORM),
            form: Form::Curve(self),
            length: Some(self.last - self.first),
            ignores_direction: Some(SAME),
            refuses_sent_light: Some(SAME),
            refuses_surfaces: Some("a parametric ray has no direction in which it could leave a surface"),
            ..LawProperties::default()
        }
    }

    fn seen(&self, axes: Option<DMat3>, _: f64) -> Option<Arc<dyn Law>> {
        self.turned?;
        Some(Arc::new(Self { turned: Some(axes?), ..self.clone() }))
    }

    fn starting_velocity(&self, _: DVec3, _: DVec3) -> DVec3 {
        self.at(0.0)[1]
    }
}
