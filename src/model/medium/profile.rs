//! A layered atmosphere: n as a function of the height above the origin, interpolated between measured points.

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Medium, MediumProperties, ORIGIN, Surroundings, UP, origin, up};
use crate::assets::{Files, Profile, ProfileError, ProfilePoint};
use crate::document::reader::TableReader;
use crate::document::values::{Parsed, array, number};
use crate::document::{Node, Value, keys};
use crate::model::{Row, fields, row};

pub static KIND: Kind = Kind {
    name: "profile",
    keys: &[
        ORIGIN,
        UP,
        keys! {
            file (" and no points"): "file" = "none",
                "measured index profile: CSV with the header height,n and one point per line; heights above the origin, in scene units";
        }[0],
        keys! {
            points (" and no file"): "[[height, n], ...]" = "none",
                "points of the profile, by ascending height, joined by a natural cubic spline; constant outside";
        }[0],
    ],
    read: |table, around, files| Some(Arc::new(Layers::read(table, around, files)?)),
};

/// Reads the points of a profile from the scene or from a file.
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
    // All points are read before the first error returns, so that every error is reported.
    let points: Vec<Option<[f64; 2]>> = nodes.iter().map(|node| table.reader.accept(point(node))).collect();
    let points: Vec<[f64; 2]> = points.into_iter().collect::<Option<_>>()?;
    let flawed = |flaw: ProfileError| {
        let node = flaw.point.map_or(node, |k| &nodes[k]);
        table.reader.fault(node.fault(flaw.problem, flaw.help));
    };
    Profile::through(&points).map_err(flawed).map(Arc::new).ok()
}

/// Reads a height and a positive n.
fn point(node: &Node) -> Parsed<[f64; 2]> {
    let point @ [_, n] = array("a point, [height, n]", number)(node)?;
    if n > 0.0 { Ok(point) } else { Err(node.fault(format!("n must be above 0, found {n}"), "")) }
}

fields! {
    /// A layered atmosphere.
    Layers(table: &TableReader, around: Surroundings, files: &mut Files) {
        /// A point of height 0.
        origin: DVec3 as Vec3 = Some(origin(table, around)),
        /// The unit vector along which height grows.
        up: DVec3 as Vec3 = Some(up(table)),
        /// The index n as a function of height.
        profile: Arc<Profile> = profile(table, files),
    }
}

impl Medium for Layers {
    /// Bisection finds the point below a height.
    fn facts(&self) -> MediumProperties<'_> {
        let terms = self.profile.points.len().next_power_of_two().ilog2();
        MediumProperties { terms, ..MediumProperties::of(&["medium/profile"]) }
    }

    fn values(&self, first: u32) -> Row {
        [self.row(), row! { first: Uint(first), points: Uint(self.profile.points.len() as u32) }].concat()
    }

    fn index(&self, x: DVec3) -> Option<f64> {
        Some(self.profile.index(self.up.dot(x - self.origin)))
    }

    fn points(&self) -> Vec<Row> {
        let row = |point: &ProfilePoint| {
            row! {
                height: Float(point.height),
                n: Float(point.n),
                slope: Float(point.slope),
                bend: Float(point.bend),
                twist: Float(point.twist),
            }
        };
        self.profile.points.iter().map(row).collect()
    }
}
