//! Media: a number, the name of a common one, or a table with a `kind`.

use super::written;
use crate::scene::document::reader::TableReader;
use crate::scene::document::values::{
    direction, not_zero, number, number_where, positive, suggest, vector, whole, word,
};
use crate::scene::document::{Node, Value};
use crate::scene::{COMMON, Explosion, Ingoing, Medium};
use glam::DVec3;

#[derive(Clone, Copy)]
enum Kind {
    Constant,
    Luneburg,
    Gaussian,
    InverseR,
    Fisheye,
    Eaton,
    Rod,
    Linear,
    Exponential,
    Sech,
    Explosion,
    Expression,
    Grid,
}

const KINDS: &[(&str, Kind)] = &[
    ("constant", Kind::Constant),
    ("luneburg", Kind::Luneburg),
    ("gaussian", Kind::Gaussian),
    ("inverse-r", Kind::InverseR),
    ("maxwell-fisheye", Kind::Fisheye),
    ("eaton", Kind::Eaton),
    ("rod", Kind::Rod),
    ("linear", Kind::Linear),
    ("exponential", Kind::Exponential),
    ("sech", Kind::Sech),
    ("explosion", Kind::Explosion),
    ("expression", Kind::Expression),
    ("grid", Kind::Grid),
];

/// What a medium's own keys default to: the place and size of the object that it fills.
#[derive(Debug, Clone, Copy, Default)]
pub struct Surroundings {
    /// The object's middle; the origin for a medium that fills all space.
    pub center: DVec3,
    /// Of a sphere or cylinder.
    pub radius: Option<f64>,
    /// Of a cylinder.
    pub axis: Option<DVec3>,
}

/// The medium that a node gives; `path` is its table's name in the reference.
pub fn read(parent: &TableReader, node: &Node, path: &'static str, around: Surroundings) -> Option<Medium> {
    let reader = parent.reader;
    match &node.value {
        Value::Table(_) => {}
        Value::Text(name) => {
            let names: Vec<&str> = COMMON.iter().map(|(name, _)| *name).collect();
            let known = COMMON.iter().find(|(known, _)| known == name).map(|(_, n)| Medium::Constant { n: *n });
            if known.is_none() {
                reader.fault(node.fault(format!("unknown medium `{name}`"), suggest(name, &names, "media")));
            }
            return known;
        }
        _ => return reader.accept(positive(node)).map(|n| Medium::Constant { n }),
    }
    let table = reader.open(path, node)?;
    let kind = table.decide_required("kind", "\"luneburg\"", word(KINDS, &[]));
    let medium = kind.and_then(|kind| medium(&table, kind, around));
    table.finish();
    medium
}

fn medium(table: &TableReader, kind: Kind, around: Surroundings) -> Option<Medium> {
    let center = || table.or("center", around.center, vector);
    let radius = || match around.radius {
        Some(radius) => Some(table.or("radius", radius, positive)),
        None => table.required("radius", "1", positive),
    };
    let origin = || table.or("origin", around.center, vector);
    let up = || table.or("up", DVec3::Y, direction);
    Some(match kind {
        Kind::Constant => Medium::Constant { n: table.required("n", "1.5", positive)? },
        Kind::Luneburg => {
            let (center, radius) = (center(), radius());
            let c = table.or("c", 2.0, number_where("a number of 2 or more", |c| c >= 2.0));
            Medium::Luneburg { center, radius: radius?, c }
        }
        Kind::Gaussian => {
            let (center, radius) = (center(), radius());
            let a = table.required("a", "1.4", positive);
            // By default n = 1 at R.
            let b = table.or("b", a.unwrap_or(1.0).ln(), number);
            Medium::Gaussian { center, radius: radius?, a: a?, b }
        }
        Kind::InverseR => {
            let center = center();
            // By default n = 1 at the surface.
            let k = match around.radius {
                Some(radius) => Some(table.or("k", radius, positive)),
                None => table.required("k", "4", positive),
            };
            let ingoing = &[("black", Ingoing::Black), ("continue", Ingoing::Continued)];
            let ingoing = table.or("ingoing", Ingoing::Black, word(ingoing, &[]));
            Medium::InverseR { center, k: k?, ingoing }
        }
        Kind::Fisheye => {
            let center = center();
            let n0 = table.or("n0", 2.0, positive);
            let a = match around.radius {
                Some(radius) => Some(table.or("a", radius, positive)),
                None => table.required("a", "1", positive),
            };
            Medium::Fisheye { center, n0, a: a? }
        }
        Kind::Eaton => Medium::Eaton { center: center(), radius: radius()? },
        Kind::Rod => {
            let axis = table.or("axis", around.axis.unwrap_or(DVec3::Z), direction);
            let n0 = table.required("n0", "1.6", positive);
            let g = table.required("g", "0.3", positive);
            Medium::Rod { center: center(), axis, n0: n0?, g: g? }
        }
        Kind::Linear => {
            let origin = origin();
            let n0 = table.or("n0", 1.0, positive);
            Medium::Linear { origin, n0, gradient: table.required("gradient", "[0, 0.02, 0]", vector)? }
        }
        Kind::Exponential => {
            let (origin, up) = (origin(), up());
            let delta = table.required("delta", "0.00029", not_zero);
            let height = table.required("height", "8000", positive);
            Medium::Exponential { origin, up, delta: delta?, height: height? }
        }
        Kind::Sech => {
            let (origin, up) = (origin(), up());
            let n0 = table.required("n0", "1.5", positive);
            let g = table.required("g", "1", positive);
            Medium::Sech { origin, up, n0: n0?, g: g? }
        }
        Kind::Explosion => Medium::Explosion(explosion(table, around)?),
        Kind::Expression => written::expression(table, around)?,
        Kind::Grid => written::grid(table)?,
    })
}

fn explosion(table: &TableReader, around: Surroundings) -> Option<Explosion> {
    let amplitude = number_where("a number between -0.5 and 0.5", |x| x.abs() < 0.5);
    let center = table.or("center", around.center, vector);
    let radius = match around.radius {
        Some(radius) => Some(table.or("radius", radius, positive)),
        None => table.required("radius", "3", positive),
    };
    let amplitude = table.required("amplitude", "0.1", amplitude);
    let frequency = table.required("frequency", "1", positive);
    let octaves = table.or("octaves", 1, whole(1..=8));
    let seed = table.or("seed", 0, whole(0..=u32::MAX));
    Some(Explosion { center, radius: radius?, amplitude: amplitude?, frequency: frequency?, octaves, seed })
}
