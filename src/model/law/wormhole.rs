//! A wormhole: a throat that connects two regions.
//!
//! *Theory.* ds² = −dt² + dl² + r(l)² dΩ² (Ellis 1973; James, von Tunzelmann, Franklin and Thorne 2015, eqs. 1 and 5), with l from −∞ on
//! the other side to ∞ on this side. There is no time dilation, so that light follows spatial geodesics.
//!
//! *Practice.* Each side has coordinates around a separate mouth, x = R n̂ with R = ρ₀ + |l|. Both sides therefore use one coordinate
//! system, objects on either side need no special treatment, and no ray has to store its side. Slightly below the throat is a surface from
//! which rays continue. The scene places it around each mouth because of [`LawProperties::throat`], and has a bounding sphere around each.

use std::sync::Arc;

use glam::{DMat4, DVec3, DVec4};

use super::observer::{in_space, spherical};
use super::{Invariant, Kind, Law, LawProperties, Observer, Order, Throat, UsualSteps};
use crate::document::keys;
use crate::document::values::{mass, not_negative_length, point, positive_length};
use crate::model::{Binding, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "wormhole",
    keys: keys! {
        radius: "number above 0" = "1", "throat radius ρ₀, in scene units";
        length: "number from 0" = "0", "length 2a of the cylindrical part of the throat, in scene units; for a throat with `mass`";
        mass: "number above 0" = "none", "M, which sets how fast the throat opens, as with a black hole of that mass; the lensing width is 1.43 M. Without it, an Ellis wormhole";
        center: "[x, y, z]" = "[0, 0, 0]", "position of the mouth on this side";
        other_mouth: "[x, y, z]" = "required", "position of the mouth on the other side, in scene units, around which the objects there are placed";
    },
    read: |table, _| {
        let mass = table.optional("mass", mass);
        let length = table.or("length", 0.0, not_negative_length);
        if mass.is_none() && length > 0.0 {
            table.fault(&["length"], "an Ellis wormhole has no cylindrical part", "add `mass`, or remove `length`");
        }
        Some(Arc::new(Wormhole {
            radius: table.or("radius", 1.0, positive_length),
            length,
            mass,
            center: table.or("center", DVec3::ZERO, point),
            other: table.required("other_mouth", "[1000, 0, 0]", point)?,
        }))
    },
};

/// A throat that connects two regions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wormhole {
    /// The radius ρ₀ of the throat, in scene units, above 0.
    pub radius: f64,
    /// The length 2a over which the throat is a cylinder, in scene units, at least 0; 0 without `mass`.
    pub length: f64,
    /// The mass M, in scene units, above 0, which determines the opening of the mouth; `None` for an Ellis wormhole.
    pub mass: Option<f64>,
    /// The position of the mouth on this side.
    pub center: DVec3,
    /// The position of the mouth on the other side.
    pub other: DVec3,
}

impl Wormhole {
    /// Returns r at a proper distance from the throat.
    #[must_use]
    pub fn width(&self, l: f64) -> f64 {
        let Some(mass) = self.mass else { return self.radius.hypot(l) };
        let y = (2.0 * (l.abs() - 0.5 * self.length) / (std::f64::consts::PI * mass)).max(0.0);
        self.radius + mass * (y * y.atan() - 0.5 * y.mul_add(y, 1.0).ln())
    }

    fn joint(&self) -> Throat {
        Throat::new([self.center, self.other], self.radius)
    }

    /// Returns the outward direction, and the ratio of r to the coordinate distance.
    fn drawn(&self, x: DVec3) -> (DVec3, f64) {
        let d = self.joint().offset(x).0;
        let away = d.length();
        (d / away, self.width(away - self.radius) / away)
    }
}

impl Law for Wormhole {
    fn parts(&self) -> Vec<Wgsl> {
        let throat = if self.mass.is_some() { "law/throat/three_parameter" } else { "law/throat/ellis" };
        Wgsl::parts(&["law/by_velocity", "law/projected_as_is", "law/wormhole", throat])
    }

    fn values(&self) -> Vec<Binding> {
        let row = row! {
            center: Vec3(self.center),
            other: Vec3(self.other),
            radius: Float(self.radius),
            half_length: Float(0.5 * self.length),
            mouth: Float(self.mass.unwrap_or(self.radius)),
        };
        vec![Binding::one("law", row)]
    }

    fn facts(&self) -> LawProperties<'_> {
        LawProperties {
            order: Order::General,
            keeps_time: true,
            usual_steps: UsualSteps::Scaled,
            throat: Some(self.joint()),
            momentum_parts: &["law/momentum/radius", "law/momentum/wormhole"],
            refuses_interiors: Some("near a wormhole, the speed of light in an interior is not defined"),
            refuses_sent_light: Some("light has more paths through a wormhole than bentray searches for"),
            ..LawProperties::default()
        }
    }

    /// Returns the speed of light, and L/E = r v⊥ r/R.
    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        let (n, wider) = self.drawn(x);
        let away = self.joint().offset(x).0.length();
        let rising = n.dot(v);
        let across = (v - rising * n) * wider;
        vec![
            Invariant { name: "speed", value: rising.hypot(across.length()), size: 1.0 },
            Invariant { name: "L / E", value: n.cross(across).length() * wider * away, size: away },
        ]
    }

    fn starting_velocity(&self, x: DVec3, v: DVec3) -> DVec3 {
        let (n, wider) = self.drawn(x);
        let rising = n.dot(v);
        v / rising.hypot((v - rising * n).length() * wider)
    }

    fn metric(&self, x: DVec3, _: f64) -> Option<DMat4> {
        let (n, wider) = self.drawn(x);
        Some(spherical(n, 1.0, wider * wider, 1.0))
    }

    fn length_scale(&self, _: DVec3) -> f64 {
        self.mass.unwrap_or(self.radius).min(self.radius)
    }

    fn observer(&self, frame: Observer, at: DVec3) -> Option<Result<DVec4, [String; 2]>> {
        in_space(&self.metric(at, 0.0)?, frame).filter(|_| frame != Observer::Eulerian)
    }
}
