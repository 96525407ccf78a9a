//! A ray splitter: a surface that sends rays in several user-defined directions, each with a weight (G95 §6).

use std::sync::Arc;

use glam::DVec3;

use super::{Kind, Surface, SurfaceProperties, pattern};
use crate::assets::FanRay;
use crate::document::keys;
use crate::document::reader::TableReader;
use crate::document::values::{Parsed, text};
use crate::document::{Node, Value};

pub static KIND: Kind = Kind {
    name: "ray-splitter",
    keys: keys! {
        color: "[red, green, blue], { checker, repeat }, { image, repeat }, { vertex_colors }" = "[1, 1, 1]",
            "reflectance";
        rays: "[[x, y, z, weight], ...], formulas" = "required",
            "directions and weights of 1 to 8 outgoing rays: formulas in dx, dy, dz (incoming unit direction), nx, ny, nz (unit normal on that side) and c (cosine between them); a direction to the other side passes through the surface";
    },
    read: |table, files| {
        let color = pattern::read(table, "color", Some(DVec3::ONE), files);
        let rays = rays(table);
        Some((color?, Arc::new(Fan(rays?))))
    },
};

/// The largest number of rays that leave one surface.
const MOST: usize = 8;
const EXAMPLE: &str = "[[\"dx + 2*c*nx\", \"dy + 2*c*ny\", \"dz + 2*c*nz\", \"1\"]]";

fn rays(table: &TableReader) -> Option<Vec<FanRay>> {
    let node = table.required_node("rays", EXAMPLE)?;
    let items = match &node.value {
        Value::Array(items) if (1..=MOST).contains(&items.len()) => items,
        _ => {
            table.reader.fault(node.expected(&format!("1 to {MOST} rays, for example {EXAMPLE}")));
            return None;
        }
    };
    // All entries are read before the first error returns, so that every error is reported.
    let all: Vec<Option<FanRay>> = items.iter().map(|item| ray(table, item)).collect();
    all.into_iter().collect()
}

fn ray(table: &TableReader, item: &Node) -> Option<FanRay> {
    let nodes = match &item.value {
        Value::Array(nodes) if nodes.len() == 4 => nodes,
        _ => {
            table.reader.fault(item.expected("four formulas: the x, y and z of the direction, and the weight"));
            return None;
        }
    };
    let texts = nodes.iter().map(text).collect::<Parsed<Vec<&str>>>();
    let texts: [&str; 4] = table.reader.accept(texts)?.try_into().ok()?;
    let read = FanRay::parse(texts).map_err(|wrong| {
        for (k, error) in wrong {
            table.reader.fault_inside(&nodes[k], error.place, error.problem, error.help);
        }
    });
    read.ok()
}

/// A surface that splits a ray into several directions.
#[derive(Debug, Clone, PartialEq)]
pub struct Fan(pub Vec<FanRay>);

impl Surface for Fan {
    fn facts(&self) -> SurfaceProperties<'_> {
        SurfaceProperties { fan: Some(&self.0), ..SurfaceProperties::scattering("surface/scatter/fan") }
    }

    /// The weights are the user's responsibility.
    fn albedo(&self, color: DVec3) -> DVec3 {
        color
    }
}
