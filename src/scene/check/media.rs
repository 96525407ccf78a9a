//! Media: a number, the name of a common one, or a table with a `kind`.

use super::files::Files;
use super::written;
use crate::scene::document::reader::TableReader;
use crate::scene::document::values::{
    Read, array, direction, number, number_where, positive, suggest, vector, whole, word,
};
use crate::scene::document::{Node, Value};
use crate::scene::profile::Flaw;
use crate::scene::{COMMON, Explosion, Ingoing, Medium, Noise, Profile};
use glam::DVec3;
use std::sync::Arc;

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
    Profile,
    Noise,
    Textured,
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
    ("profile", Kind::Profile),
    ("noise", Kind::Noise),
    ("textured", Kind::Textured),
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
pub fn read(
    parent: &TableReader,
    node: &Node,
    path: &'static str,
    around: Surroundings,
    files: &mut Files,
) -> Option<Medium> {
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
    let medium = kind.and_then(|kind| medium(&table, kind, around, files));
    table.finish();
    medium
}

fn medium(table: &TableReader, kind: Kind, around: Surroundings, files: &mut Files) -> Option<Medium> {
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
            Medium::Linear { origin, n0, gradient: table.required("gradient", "[0, 0.02, 0]", gradient)? }
        }
        Kind::Exponential => {
            let (origin, up) = (origin(), up());
            // Below −1 the index would be negative at the origin itself.
            let delta = number_where("a number above -1, other than 0", |delta| delta > -1.0 && delta != 0.0);
            let delta = table.required("delta", "0.00029", delta);
            let height = table.required("height", "8000", positive);
            Medium::Exponential { origin, up, delta: delta?, height: height? }
        }
        Kind::Sech => {
            let (origin, up) = (origin(), up());
            let n0 = table.required("n0", "1.5", positive);
            let g = table.required("g", "1", positive);
            Medium::Sech { origin, up, n0: n0?, g: g? }
        }
        Kind::Profile => {
            let (origin, up) = (origin(), up());
            Medium::Profile { origin, up, profile: profile(table, files)? }
        }
        Kind::Noise => Medium::Noise(noise(table, table.or("n0", 1.0, positive), around)?),
        Kind::Textured => {
            let n = table.required("n", "1.5", positive);
            let noise = noise(table, n.unwrap_or(f64::INFINITY), around);
            Medium::Textured(Noise { n0: n?, ..noise? })
        }
        Kind::Explosion => Medium::Explosion(explosion(table, around)?),
        Kind::Expression => written::expression(table, around)?,
        Kind::Grid => written::grid(table, files)?,
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

/// About an index of n₀.
fn noise(table: &TableReader, n0: f64, around: Surroundings) -> Option<Noise> {
    let center = table.or("center", around.center, vector);
    let amplitude = table.required("amplitude", "0.1", number);
    let frequency = table.required("frequency", "1", positive);
    let octaves = table.or("octaves", 1, whole(1..=8));
    let seed = table.or("seed", 0, whole(0..=u32::MAX));
    let (amplitude, reach) = (amplitude?, Noise::reach(octaves));
    if amplitude.abs() * reach >= n0 {
        let problem = format!("n could fall to {:.4}, and must stay above 0", n0 - amplitude.abs() * reach);
        // Rounded down, and never to n₀/reach itself.
        let most = ((n0 / reach * 1e3).ceil() - 1.0) / 1e3;
        table.fault(
            &["amplitude"],
            problem,
            format!("so much noise goes up to {reach} times its amplitude: {most} would do"),
        );
        return None;
    }
    Some(Noise { center, n0, amplitude, frequency: frequency?, octaves, seed })
}

/// Points in the scene, or in a file.
fn profile(table: &TableReader, files: &mut Files) -> Option<Arc<Profile>> {
    const CHOICES: &str = "file = \"air.csv\" or points = [[0, 1.00029], [8000, 1.0001]]";
    let (key, node) = table.required_one_of(&["points", "file"], CHOICES)?;
    if key == "file" {
        return files.profile(table.reader, node);
    }
    let Value::Array(nodes) = &node.value else {
        table.reader.fault(node.expected("points, [[height, n], ...]"));
        return None;
    };
    // All are read before any is missed.
    let points: Vec<Option<[f64; 2]>> = nodes.iter().map(|node| table.reader.accept(point(node))).collect();
    let points: Vec<[f64; 2]> = points.into_iter().collect::<Option<_>>()?;
    let flawed = |flaw: Flaw| {
        let node = flaw.point.map_or(node, |k| &nodes[k]);
        table.reader.fault(node.fault(flaw.problem, flaw.help));
    };
    Profile::through(&points).map_err(flawed).map(Arc::new).ok()
}

/// A height, and n above 0.
fn point(node: &Node) -> Read<[f64; 2]> {
    let point @ [_, n] = array("a point, [height, n]", number)(node)?;
    if n > 0.0 { Ok(point) } else { Err(node.fault(format!("n must be above 0, found {n}"), "")) }
}

/// Without one the index would be constant.
fn gradient(node: &Node) -> Read<DVec3> {
    let gradient = vector(node)?;
    let none = || Err(node.fault("without a gradient the index is constant", "use kind = \"constant\""));
    if gradient == DVec3::ZERO { none() } else { Ok(gradient) }
}
