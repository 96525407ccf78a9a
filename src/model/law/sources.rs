//! Sources of force, whose accelerations add: dv = −Σ strength · d(r) n̂ (G95 §2.1, W04 §5.2).

use std::fmt::Write as _;
use std::sync::Arc;

use glam::DVec3;

use super::{
    CharacteristicSurface, Invariant, Kind, Law, LawProperties, Orbit, OrbitForm, Order, USUAL_PARTS, UsualSteps,
};
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::{choice, not_negative_length, not_zero, point, word};
use crate::model::falloff::{self, FALLOFFS, Falloff};
use crate::model::point_source::SOURCES;
use crate::model::{Anchor, Binding, Capture, Row, Source, Wgsl, row};

pub static KIND: Kind = Kind {
    name: "sources",
    keys: keys! {
        sources: "array of tables" = "required", "sources of force, at least one";
        parameter: "time | length" = "time",
            "independent variable: time (Newtonian), or path length, as in the iteration of Gröller (1995)";
    },
    read: |table, _| {
        let tables = table.subtables("sources", "law.sources");
        if tables.is_empty() {
            let help = "add [[law.sources]] with position = [0, 0, 0] and strength = 1";
            table.fault(&["sources", "kind"], "kind = \"sources\" requires at least one source", help);
            return None;
        }
        // All sources are read before the first error returns, so that every error is reported.
        let sources: Vec<Option<Source>> = tables.into_iter().map(source).collect();
        let by_length = table.or("parameter", false, word(&[("time", false), ("length", true)]));
        let sources = Sources(sources.into_iter().collect::<Option<_>>()?);
        Some(if by_length { Arc::new(ByLength(sources)) } else { Arc::new(sources) })
    },
};

fn source(table: TableReader) -> Option<Source> {
    let kind = table.decide("kind", 0, choice(&SOURCES.map(|kind| kind.name))).map(|kind| SOURCES[kind]);
    let position = table.required("position", "[0, 0, 0]", point);
    let along = kind.and_then(|kind| (kind.along)(&table));
    let strength = table.required("strength", "1", not_zero);
    let capture = table.or("capture_radius", 0.0, not_negative_length);
    let falloff = match table.node("falloff") {
        Some(node) => falloff::read(&table, node),
        None => Some(Falloff::INVERSE_SQUARE),
    };
    table.finish();
    let anchor = Anchor { kind: kind?, position: position?, along: along? };
    Some(Source { anchor, strength: strength?, falloff: falloff?, capture })
}

/// The reason why light cannot cross surfaces under this law.
pub(super) const OWN_SPEED: &str =
    "interiors require a law under which the speed of light is constant: straight, schwarzschild or medium";

/// Any number of sources.
#[derive(Debug, Clone, PartialEq)]
pub struct Sources(pub Vec<Source>);

impl Sources {
    fn of(&self, kind: &falloff::FalloffKind) -> impl Iterator<Item = &Source> {
        self.0.iter().filter(move |source| source.falloff.kind == kind)
    }

    /// Returns the kinds of fall-off that the sources use.
    fn falloffs(&self) -> impl Iterator<Item = &'static falloff::FalloffKind> {
        FALLOFFS.into_iter().filter(|kind| self.of(kind).next().is_some())
    }

    /// Returns the WGSL of the sum of accelerations and of the distance to the nearest source.
    fn sums(&self) -> String {
        let sum: Vec<_> = self.falloffs().map(|kind| format!("{}_acceleration(x)", kind.wgsl)).collect();
        let nearest = self.falloffs().map(|kind| format!("{}_distance(x)", kind.wgsl));
        let nearest = nearest.reduce(|all, one| format!("min({all}, {one})")).unwrap_or_default();
        format!(
            "fn source_acceleration(x: Real3) -> Real3 {{\n    return {};\n}}\n\n\
             fn source_distance(x: Real3) -> Real {{\n    return {nearest};\n}}\n",
            sum.join(" + ")
        )
    }

    /// Returns the WGSL modules of the total acceleration and of the distance to the nearest source.
    fn forces(&self) -> Vec<Wgsl> {
        let mut parts = Wgsl::parts(&["law/sources"]);
        parts.extend(self.falloffs().map(|kind| Wgsl::Part(format!("law/falloff/{}", kind.wgsl).into())));
        let text = |file: &'static str, text: String| Wgsl::Text { file: file.into(), text: text.into() };
        parts.push(text("generated/sources.wgsl", self.sums()));
        parts.push(text("generated/source_counts.wgsl", self.counts()));
        parts
    }

    /// Returns the potential V, and the sum of the magnitudes of its terms.
    fn potential(&self, x: DVec3) -> [f64; 2] {
        let parts =
            self.0.iter().map(|source| source.strength * source.falloff.potential(source.anchor.offset(x).length()));
        [parts.clone().sum(), parts.map(f64::abs).sum()]
    }

    /// Returns the orbit around the only center, if there is one.
    fn orbit(&self) -> Option<Orbit> {
        let [only] = self.0.as_slice() else { return None };
        let falloff = only.falloff.kind;
        let orbit = Orbit {
            center: only.anchor.position,
            form: OrbitForm::Plane(falloff.orbit),
            is_free_far_away: falloff.is_free_far_away,
        };
        only.anchor.kind.is_point.then_some(orbit)
    }

    /// Returns the lengths of the lists as WGSL constants, so that the compiler may unroll loops.
    fn counts(&self) -> String {
        let mut text = String::new();
        for kind in self.falloffs() {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "const {}_COUNT: u32 = {}u;", kind.wgsl.to_uppercase(), self.of(kind).count());
        }
        text
    }
}

impl Law for Sources {
    fn parts(&self) -> Vec<Wgsl> {
        [Wgsl::parts(&USUAL_PARTS), self.forces()].concat()
    }

    fn values(&self) -> Vec<Binding> {
        let row = |source: &Source| -> Row {
            let anchor = source.anchor;
            let common = row! {
                position: Vec3(anchor.position),
                strength: Float(source.strength),
                along: Vec3(anchor.along),
                kind: Uint(anchor.code()),
            };
            common.into_iter().chain(source.falloff.values()).collect()
        };
        self.falloffs().map(|kind| Binding::list(kind.wgsl, self.of(kind).map(row).collect())).collect()
    }

    /// Rays pass close to a source, where steps of the orbit equation are as long as others and cost more.
    fn facts(&self) -> LawProperties<'_> {
        LawProperties {
            usual_steps: UsualSteps::Tolerant,
            terms: self.0.len() as u32,
            anchors: self.0.iter().map(|source| source.anchor).collect(),
            orbit: self.orbit(),
            refuses_interiors: Some(OWN_SPEED),
            ..LawProperties::default()
        }
    }

    fn captures(&self, _: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        let capture = |source: &Source| Capture { anchor: source.anchor, radius: source.capture };
        self.0.iter().filter(|source| source.capture > 0.0).map(capture).collect()
    }

    /// Returns the energy ½|v|² + V and, for a single center, x × v.
    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        let kinetic = 0.5 * v.length_squared();
        let [potential, size] = self.potential(x);
        let mut all = vec![Invariant { name: "energy", value: kinetic + potential, size: kinetic + size }];
        if let Some(orbit) = self.orbit() {
            let d = x - orbit.center;
            let (value, size) = (d.cross(v).length(), d.length() * v.length());
            all.push(Invariant { name: "angular momentum", value, size });
        }
        all
    }

    fn landmarks(&self) -> Vec<CharacteristicSurface> {
        let both = |source: &Source| {
            let sphere =
                |name, radius, captures| CharacteristicSurface::sphere(name, source.anchor.position, radius, captures);
            [sphere("capture", source.capture, true), sphere("range of a source", source.falloff.reach(), false)]
        };
        self.0.iter().filter(|source| source.anchor.kind.is_point).flat_map(both).collect()
    }

    fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        let capture = self.captures(None).into_iter().find(|capture| capture.distance(at) <= 0.0)?;
        let [x, y, z] = capture.anchor.position.to_array();
        let problem = format!("is inside the capture radius {} of the source at [{x}, {y}, {z}]", capture.radius);
        Some([problem, "move it away from the source".to_owned()])
    }
}

/// Sources whose force acts over the arc length at any speed: dx = v/|v|, dv = −Σ strength · d(r) n̂. This is the limit of G95's iteration
/// as its step, and with it M, approaches 0. The paths differ from Newtonian ones.
#[derive(Debug, Clone, PartialEq)]
pub struct ByLength(pub Sources);

impl Law for ByLength {
    fn parts(&self) -> Vec<Wgsl> {
        let own = ["law/by_length", "law/no_constant", "law/start_as_given", "law/projected_as_is"];
        [Wgsl::parts(&own), self.0.forces()].concat()
    }

    fn values(&self) -> Vec<Binding> {
        self.0.values()
    }

    fn facts(&self) -> LawProperties<'_> {
        LawProperties {
            order: Order::General,
            by_length: true,
            usual_steps: UsualSteps::Orbit,
            orbit: None,
            ..self.0.facts()
        }
    }

    fn captures(&self, clearance: Option<&dyn Fn(DVec3) -> f64>) -> Vec<Capture> {
        self.0.captures(clearance)
    }

    /// Returns the constant of motion |v| + V.
    fn invariants(&self, x: DVec3, v: DVec3) -> Vec<Invariant> {
        let [potential, size] = self.0.potential(x);
        vec![Invariant { name: "|v| + V", value: v.length() + potential, size: v.length() + size }]
    }

    fn landmarks(&self) -> Vec<CharacteristicSurface> {
        self.0.landmarks()
    }

    fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        self.0.refuses_eye(at)
    }
}
