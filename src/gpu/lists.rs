//! The values of a scene's lists: shapes, meshes, materials, lights, force centres.

use glam::{DVec2, DVec3};

use super::GpuError;
use super::geometry::PlacedShape;
use super::hierarchy::Node;
use super::media::capture_radius;
use super::records::Value::{self, Float, Uint, Vec2, Vec3, Vec4};
use super::records::pack;
use super::source::Source;
use crate::program::{Layout, Obstacle, Purpose, constant};
use crate::scene::{Falloff, Law, Light, MaterialKind, Medium, Pattern};

impl Source<'_> {
    pub(super) fn list(&self, name: &str, layout: &Layout) -> Result<Option<Vec<u8>>, GpuError> {
        let g = self.geometry;
        let all = |kind: &str| g.placed.get(kind).map_or(&[][..], Vec::as_slice).iter();
        let opaque = |kind: &str| all(kind).filter(|shape| shape.bit.is_none());
        let sided = |kind: &str| all(kind).filter(|shape| shape.bit.is_some());
        let placed = |kind: &str| pack(name, layout, all(kind).map(placed_row)).map(Some);
        let spaces = |kind: &str| pack(name, layout, opaque(kind).map(space_rows)).map(Some);
        match name {
            "sphere_list" => {
                let row = |s: &PlacedShape| [("center", Vec3(s.center)), ("radius", Float(s.radius))];
                pack(name, layout, opaque("sphere").map(row)).map(Some)
            }
            "ellipsoid_list" => spaces("ellipsoid"),
            "box_list" => spaces("box"),
            "cylinder_list" => spaces("cylinder"),
            "plane_list" => spaces("plane"),
            "disk_list" => pack(name, layout, opaque("disk").map(disk_row)).map(Some),
            "sided_sphere_list" => pack(name, layout, sided("sphere").map(sided_ball)).map(Some),
            "sided_ellipsoid_list" => pack(name, layout, sided("ellipsoid").map(sided_space)).map(Some),
            "sided_box_list" => pack(name, layout, sided("box").map(sided_space)).map(Some),
            "sided_cylinder_list" => pack(name, layout, sided("cylinder").map(sided_space)).map(Some),
            "obstacles" => pack(name, layout, g.regions.obstacles.iter().map(obstacle)).map(Some),
            "touching" => pack(name, layout, self.touching()).map(Some),
            "object_bits" => Ok(Some(bytemuck::cast_slice(&self.object_bits()).to_vec())),
            "spheres" => placed("sphere"),
            "ellipsoids" => placed("ellipsoid"),
            "boxes" => placed("box"),
            "cylinders" => placed("cylinder"),
            "planes" => placed("plane"),
            "disks" => placed("disk"),
            "nodes" => {
                let row = |(node, [lo, hi]): (&Node, [DVec3; 2])| {
                    [("lo", Vec3(lo)), ("hi", Vec3(hi)), ("skip", Uint(node.skip)), ("leaf", Uint(node.leaf))]
                };
                pack(name, layout, g.structure.nodes.iter().zip(g.structure.boxes()).map(row)).map(Some)
            }
            "triangles" => pack(
                name,
                layout,
                g.triangles.iter().map(|[a, b, c, object]| {
                    [("a", Uint(*a)), ("b", Uint(*b)), ("c", Uint(*c)), ("object", Uint(*object))]
                }),
            )
            .map(Some),
            "corners" => {
                let place = |i: u32| Vec3(g.vertices[i as usize].position.into());
                let row = |[a, b, c, object]: &[u32; 4]| {
                    [("p", place(*a)), ("object", Uint(*object)), ("q", place(*b)), ("r", place(*c))]
                };
                pack(name, layout, g.triangles.iter().map(row)).map(Some)
            }
            "vertices" => pack(
                name,
                layout,
                g.vertices.iter().map(|v| {
                    [
                        ("position", Vec3(v.position.into())),
                        ("normal", Vec3(v.normal.into())),
                        ("u", Float(v.uv.x.into())),
                        ("v", Float(v.uv.y.into())),
                    ]
                }),
            )
            .map(Some),
            "items" => Ok(Some(bytemuck::cast_slice(&g.structure.items).to_vec())),
            "cells" => Ok(g.structure.grid.as_ref().map(|grid| bytemuck::cast_slice(&grid.cells).to_vec())),
            "object_materials" => Ok(Some(bytemuck::cast_slice(&g.materials).to_vec())),
            "materials" => self.materials(layout).map(Some),
            _ => self.lights_and_sources(name, layout),
        }
    }

    fn materials(&self, layout: &Layout) -> Result<Vec<u8>, GpuError> {
        let code = |part: &str, name: &str| constant(part, name) as u32;
        let kinds = [
            code("material/emissive", "EMISSIVE"),
            code("material/phong", "PHONG"),
            code("scatter/mirror", "MIRROR"),
            code("scatter/clear", "CLEAR"),
        ];
        let patterns =
            [code("pattern/constant", "CONSTANT"), code("pattern/checker", "CHECKER"), code("pattern/image", "IMAGE")];
        let rows = self.scene.materials.iter().map(|material| {
            let (kind, ambient, specular, shininess, emission) = match material.kind {
                MaterialKind::Mirror => (kinds[2], 0.0, DVec3::ZERO, 1.0, DVec3::ZERO),
                MaterialKind::Emissive => (kinds[0], 0.0, DVec3::ZERO, 1.0, DVec3::ZERO),
                MaterialKind::Phong { ambient, specular, shininess, emission } => {
                    (kinds[1], ambient, specular, shininess, emission)
                }
            };
            let (pattern, color, second, repeat, image) = match &material.color {
                Pattern::Constant(color) => (patterns[0], *color, DVec3::ZERO, DVec2::ONE, 0),
                Pattern::Checker { colors, repeat } => (patterns[1], colors[0], colors[1], *repeat, 0),
                Pattern::Picture { picture, repeat } => (patterns[2], DVec3::ONE, DVec3::ZERO, *repeat, *picture),
            };
            [
                ("kind", Uint(kind)),
                ("pattern", Uint(pattern)),
                ("color", Vec3(color)),
                ("second_color", Vec3(second)),
                ("specular", Vec3(specular)),
                ("shininess", Float(shininess)),
                ("emission", Vec3(emission)),
                ("ambient", Float(ambient)),
                ("repeat", Vec2(repeat)),
                ("image", Uint(image as u32)),
                ("bit", Uint(0)),
            ]
        });
        let clear = (0..self.geometry.regions.regions.len()).map(|bit| clear_material(kinds[3], bit));
        pack("materials", layout, rows.chain(clear))
    }

    fn lights_and_sources(&self, name: &str, layout: &Layout) -> Result<Option<Vec<u8>>, GpuError> {
        let lights = self.scene.lights.iter();
        let sources = match &self.scene.law {
            Law::Sources(sources) => sources.as_slice(),
            _ => &[],
        };
        let bytes = match name {
            "point_lights" => pack(
                name,
                layout,
                lights.filter_map(|light| match *light {
                    Light::Point { position, color } => Some([("position", Vec3(position)), ("color", Vec3(color))]),
                    Light::Directional { .. } => None,
                }),
            ),
            "directional_lights" => pack(
                name,
                layout,
                lights.filter_map(|light| match *light {
                    Light::Directional { direction, color } => {
                        Some([("direction", Vec3(direction)), ("color", Vec3(color))])
                    }
                    Light::Point { .. } => None,
                }),
            ),
            "inverse_square" => pack(
                name,
                layout,
                sources
                    .iter()
                    .filter(|s| s.falloff == Falloff::InverseSquare)
                    .map(|s| [("position", Vec3(s.position)), ("strength", Float(s.strength))]),
            ),
            "cubic" => pack(
                name,
                layout,
                sources.iter().filter_map(|s| match s.falloff {
                    Falloff::Cubic { radius } => Some([
                        ("position", Vec3(s.position)),
                        ("strength", Float(s.strength)),
                        ("radius", Float(radius)),
                    ]),
                    _ => None,
                }),
            ),
            "yukawa" => pack(
                name,
                layout,
                sources.iter().filter_map(|s| match s.falloff {
                    Falloff::Yukawa { mu } => {
                        Some([("position", Vec3(s.position)), ("strength", Float(s.strength)), ("mu", Float(mu))])
                    }
                    _ => None,
                }),
            ),
            "capture_spheres" => pack(
                name,
                layout,
                self.capture_spheres()
                    .into_iter()
                    .map(|(center, radius)| [("center", Vec3(center)), ("radius", Float(radius))]),
            ),
            _ => return Ok(None),
        };
        bytes.map(Some)
    }

    /// A hole captures at its horizon, or as far out as its photon sphere where nothing lies between that a ray moving inwards
    /// could still hit. Traced rays are followed to the horizon itself.
    fn capture_spheres(&self) -> Vec<(DVec3, f64)> {
        match &self.scene.law {
            Law::Schwarzschild { mass, center, .. } => {
                let clear =
                    self.geometry.clearance(*center) > 3.0 * mass && self.program.choice.purpose != Purpose::Trace;
                vec![(*center, if clear { 3.0 * mass } else { 2.0 * mass })]
            }
            Law::Sources(sources) => {
                sources.iter().filter(|s| s.capture > 0.0).map(|s| (s.position, s.capture)).collect()
            }
            _ => self.scene.media().filter_map(capture_sphere).collect(),
        }
    }

    /// The objects that touch others, the opaque ones first.
    fn touching(&self) -> Vec<[(&'static str, Value); 2]> {
        let g = self.geometry;
        let clear = |&object: &usize| (object, g.regions.bit(object).map_or(0, |bit| 1 << bit));
        let opaque = g.regions.touching.opaque.iter().map(|&object| (object, 0));
        let all = opaque.chain(g.regions.touching.clear.iter().map(clear));
        all.map(|(object, bits)| [("primitive", Uint(g.primitive(object))), ("bits", Uint(bits))]).collect()
    }

    /// For each object its bit in the set of regions.
    fn object_bits(&self) -> Vec<u32> {
        let none = constant("facing/sided", "NO_BIT") as u32;
        let bit = |object| self.geometry.regions.bit(object).map_or(none, |bit| bit as u32);
        (0..self.scene.objects.len()).map(bit).collect()
    }
}

/// The middle of an inverse-r sphere.
fn capture_sphere(medium: &Medium) -> Option<(DVec3, f64)> {
    match medium {
        Medium::InverseR { center, k, .. } => Some((*center, capture_radius(*k))),
        _ => None,
    }
}

/// What the surface of an object that light goes through has for a material: no more than whose surface it is.
fn clear_material(kind: u32, bit: usize) -> [(&'static str, Value); 11] {
    let black = Vec3(DVec3::ZERO);
    [
        ("kind", Uint(kind)),
        ("pattern", Uint(0)),
        ("color", black),
        ("second_color", black),
        ("specular", black),
        ("shininess", Float(1.0)),
        ("emission", black),
        ("ambient", Float(0.0)),
        ("repeat", Vec2(DVec2::ONE)),
        ("image", Uint(0)),
        ("bit", Uint(bit as u32)),
    ]
}

fn obstacle(ball: &Obstacle) -> [(&'static str, Value); 3] {
    [("center", Vec3(ball.center)), ("radius", Float(ball.radius)), ("place", Uint(ball.place as u32))]
}

fn sided_ball(shape: &PlacedShape) -> [(&'static str, Value); 3] {
    [("center", Vec3(shape.center)), ("radius", Float(shape.radius)), ("bit", Uint(shape.bit.unwrap_or(0)))]
}

fn sided_space(shape: &PlacedShape) -> [(&'static str, Value); 4] {
    let [x, y, z] = space_rows(shape);
    [x, y, z, ("bit", Uint(shape.bit.unwrap_or(0)))]
}

fn space_rows(shape: &PlacedShape) -> [(&'static str, Value); 3] {
    [("row_x", Vec4(shape.rows[0])), ("row_y", Vec4(shape.rows[1])), ("row_z", Vec4(shape.rows[2]))]
}

fn disk_row(shape: &PlacedShape) -> [(&'static str, Value); 4] {
    let [x, y, z] = space_rows(shape);
    [x, y, z, ("hole", Float(shape.radius))]
}

fn placed_row(shape: &PlacedShape) -> [(&'static str, Value); 7] {
    [
        ("center", Vec3(shape.center)),
        ("radius", Float(shape.radius)),
        ("row_x", Vec4(shape.rows[0])),
        ("row_y", Vec4(shape.rows[1])),
        ("row_z", Vec4(shape.rows[2])),
        ("material", Uint(shape.material)),
        ("object", Uint(shape.object)),
    ]
}
