//! Packs the lists of a scene: shapes, meshes, materials, lights and force centers.
//!
//! *Length.* Over 300 lines, because it is a table with an arm for each list.

use glam::DVec3;

use super::GpuError;
use super::LightGridData;
use super::geometry::PlacedShape;
use super::glow::{black_bodies, orbits};
use super::hierarchy::Node;
use super::mesh;
use super::ray_tree::{RayNode, object_tree, ray_tree};
use super::records::{pack, pack_shared};
use super::source::Uploads;
use crate::model::Value::{self, Float, Uint, Uint4, Vec3};
use crate::model::camera::{Camera, frequency, frequency_of_given, observer};
use crate::model::shape::{Primitive, SOLIDS};
use crate::model::{Binding, Capture, Material, Object, RigidMotion, Row, row};
use crate::program::{Layout, Obstacle, constant};
use crate::scene::{Emitter, Light, LightSource, Segment, Shadows, TransparentShadows, Volume};

impl Uploads<'_> {
    /// Returns the bindings of the scene's kinds (law, method, camera, control and others).
    pub(super) fn of_kinds(&self) -> Vec<Binding> {
        let scene = self.scene;
        let camera = scene.camera.iter().flat_map(|camera| camera.values(scene.image.size));
        let control = Binding::one("control", scene.rays.control.values());
        let laws = scene.law.values().into_iter().chain(scene.rays.method.values());
        let captures = Binding::list("capture_spheres", self.captures());
        let observer = scene.camera.as_ref().and_then(|camera| observer(&*scene.law, camera));
        let observer = observer.map(|row| Binding::one("observer", row));
        let seen = |camera: &Camera| frequency(&*scene.law, camera, scene.keeps_turning(camera));
        let frequency = if self.program.features.mode.is_given() || self.program.features.volumes.is_parallel {
            Some(frequency_of_given(&*scene.law, !scene.deflects()))
        } else {
            scene.camera.as_ref().and_then(seen)
        };
        let frequency = frequency.map(|row| Binding::one("frequency", row));
        laws.chain(camera)
            .chain(observer)
            .chain(frequency)
            .chain(self.glowing())
            .chain([control, captures])
            .chain(self.solids())
            .collect()
    }

    /// Returns the colors of black bodies and the orbits of matter, if the scene uses them.
    fn glowing(&self) -> Vec<Binding> {
        let scene = self.scene;
        let mut bindings = Vec::new();
        let hues = self.program.features.shifts_hues;
        let is_black = |volume: &Volume| scene.radiation.is_none() && volume.formulas.temperature.is_some();
        if hues
            || self.program.features.has_stars
            || scene.volumes.iter().any(is_black)
            || scene.used_materials().any(|material| material.surface.facts().has_temperature)
        {
            bindings.push(black_bodies());
        }
        if scene.used_materials().any(|material| material.surface.facts().orbits) {
            bindings.extend(orbits(&*scene.law, scene.rays.bounding_sphere.radius).into_iter().flatten());
        }
        if scene.has_translucent() {
            let row = |material: &Material| row! { opacity: Float(material.surface.facts().opacity) };
            bindings.push(Binding::list("endings", scene.materials.iter().map(row).collect()));
        }
        bindings
    }

    /// Returns the lists of each solid: shapes on which rays end, shapes with two sides, and all shapes.
    fn solids(&self) -> Vec<Binding> {
        let lists = |solid: &Primitive| {
            let lists = solid.lists.as_ref()?;
            let all = self.geometry.placed.get(solid.name).map_or(&[][..], Vec::as_slice);
            let test = |shape: &PlacedShape| (lists.row)(&shape.placed);
            let side = |shape: &PlacedShape| {
                shape.bit.map(|bit| [(lists.row)(&shape.placed), row! { bit: Uint(bit) }].concat())
            };
            let opaque = all.iter().filter(|shape| shape.bit.is_none() && !shape.moves).map(test).collect();
            let two_sided = all.iter().filter_map(side).collect();
            let placed = all.iter().map(placed_row).collect();
            Some([
                Binding::list(solid.opaque_list(), opaque),
                Binding::list(solid.sided_list(), two_sided),
                Binding::list(lists.placed, placed),
            ])
        };
        SOLIDS.into_iter().filter_map(lists).flatten().collect()
    }

    /// Returns the capture spheres: for images as large as they can be without containing objects, for traced rays unchanged.
    fn captures(&self) -> Vec<Row> {
        let clearance = |x: DVec3| self.geometry.clearance(x);
        let picture = !self.program.features.mode.is_given();
        let row = |capture: Capture| {
            let anchor = capture.anchor;
            row! {
                center: Vec3(anchor.position),
                radius: Float(capture.radius),
                along: Vec3(anchor.along),
                kind: Uint(anchor.code()),
            }
        };
        let clearance: Option<&dyn Fn(DVec3) -> f64> = if picture { Some(&clearance) } else { None };
        self.scene.captures(clearance).into_iter().map(row).collect()
    }

    pub(super) fn list(&self, name: &str, layout: &Layout) -> Result<Option<Vec<u8>>, GpuError> {
        let g = self.geometry;
        match name {
            "surroundings" => pack(name, layout, self.surroundings()).map(Some),
            "aims" => {
                let anchors = self.scene.law.facts().anchors;
                let positions = anchors.iter().map(|anchor| anchor.position).chain([DVec3::ZERO]);
                let rows = positions.take(anchors.len().max(1)).map(|position| [("position", Vec3(position))]);
                pack(name, layout, rows).map(Some)
            }
            "travels" => pack(name, layout, self.travels()).map(Some),
            "obstacles" => pack(name, layout, g.analysis.regions.obstacles.iter().map(obstacle)).map(Some),
            "touching" => pack(name, layout, self.touching()).map(Some),
            "object_bits" => Ok(Some(bytemuck::cast_slice(&self.object_bits()).to_vec())),
            "nodes" => {
                let slack = constant("segment/structure/boxes", "BOX_SLACK");
                let row = |node: Node| {
                    let [lo, hi] = node.grown(slack);
                    let bits = |corner: DVec3, last| {
                        let [x, y, z] = corner.as_vec3().to_array().map(f32::to_bits);
                        Uint4([x, y, z, last])
                    };
                    [("lo_skip", bits(lo, node.skip)), ("hi_leaf", bits(hi, node.leaf))]
                };
                pack(name, layout, g.nodes().map(row)).map(Some)
            }
            "instances" => {
                let rows = g.instances.rows(g.structure.nodes.len() as u32, &g.materials);
                pack(name, layout, rows).map(Some)
            }
            "ray_nodes" => pack(name, layout, self.ray_nodes()).map(Some),
            "object_nodes" => pack(name, layout, self.object_nodes()).map(Some),
            "corners" => {
                let (bits, none) = (self.object_bits(), no_bit());
                let place = |i: u32| Vec3(g.vertices[i as usize].position.into());
                let row = |[a, b, c, object]: &[u32; 4]| {
                    let bit = bits.get(*object as usize).copied().unwrap_or(none);
                    [("p", place(*a)), ("bit", Uint(bit)), ("q", place(*b)), ("r", place(*c))]
                };
                pack(name, layout, g.triangles.iter().map(row)).map(Some)
            }
            "mesh" => Ok(Some(
                bytemuck::cast_slice(&mesh::words(g, self.scene, self.program.features.has_vertex_colors)).to_vec(),
            )),
            "items" => Ok(Some(bytemuck::cast_slice(&g.structure.items).to_vec())),
            "cells" => Ok(g.structure.grid.as_ref().map(|grid| bytemuck::cast_slice(&grid.cells).to_vec())),
            "materials" => self.materials(layout).map(Some),
            "absorptions" => pack_shared(name, layout, self.absorptions()).map(Some),
            "emitters" => pack(name, layout, self.scene.emitters().into_iter().map(Emitter::row)).map(Some),
            "sky_cells" => {
                let columns = constant("path/light_sampling/sky", "SKY_COLUMNS") as u32;
                let rows = constant("path/light_sampling/sky", "SKY_ROWS") as u32;
                let sky = self.scene.sky_cells([columns, rows]);
                let all = [sky.total].into_iter().chain(sky.rows).chain(sky.cells);
                Ok(Some(all.flat_map(f32::to_ne_bytes).collect()))
            }
            "grid_lights" => pack(name, layout, self.grid_lights()).map(Some),
            "light_bricks" => {
                let bricks = self.fields.iter().flat_map(|field| &field.bricks);
                Ok(Some(bricks.flat_map(|brick| brick.to_ne_bytes()).collect()))
            }
            "light_field" => {
                let values = self.fields.iter().flat_map(|field| &field.field);
                Ok(Some(values.flat_map(|value| bytemuck::cast::<_, [u8; 16]>(value.to_array())).collect()))
            }
            "star_skies" => self.star_skies(layout),
            _ => self.lights(name, layout),
        }
    }

    /// Packs a record for every material, with the members of its kind. The records of the scene's materials are followed by one for each
    /// region, which only states whose surface it is.
    fn materials(&self, layout: &Layout) -> Result<Vec<u8>, GpuError> {
        let code = |part: &str| constant(part, &part.rsplit('/').next().unwrap_or(part).to_uppercase()) as u32;
        let vertex_colors = constant("surface/vertex_colors", "VERTEX_COLORS") as u32;
        let row = |material: &Material| -> Row {
            let pattern = constant("surface/pattern", &material.color.part().to_uppercase()) as u32;
            let pattern = pattern | if material.color.has_vertex_colors() { vertex_colors } else { 0 };
            let kinds = row! { kind: Uint(code(material.surface.facts().part)), pattern: Uint(pattern) };
            [kinds, material.color.values(), material.surface.values()].concat()
        };
        // A fan is identified by its index among the fans.
        let fans = self.scene.fans();
        let place = |i: usize| fans.iter().position(|(material, _)| *material == i);
        let fan = |i: usize| place(i).map(|which| ("fan".into(), Uint(which as u32)));
        let side = |bit: usize| -> Row {
            let object = self.geometry.analysis.regions.regions[bit].object;
            let gloss = self.scene.objects[object].interior().map(|interior| interior.gloss).unwrap_or_default();
            [row! { kind: Uint(code(gloss.part())), bit: Uint(bit as u32) }, gloss.values()].concat()
        };
        let own = self.scene.materials.iter().enumerate().map(|(i, m)| row(m).into_iter().chain(fan(i)).collect());
        let sides = (0..self.geometry.analysis.regions.regions.len()).map(side);
        pack_shared("materials", layout, own.chain(sides))
    }

    fn lights(&self, name: &str, layout: &Layout) -> Result<Option<Vec<u8>>, GpuError> {
        let row = |light: &Light| -> (&str, Row) {
            let shadows = match light.shadows {
                Shadows::Straight => self.shadow_code(light.transparent),
                _ => 0,
            };
            let falls = u32::from(light.falls);
            match light.source {
                LightSource::Point(position) if light.shadows == Shadows::Shooting => (
                    "shot_lights",
                    row! { position: Vec3(position), color: Vec3(light.color), falls: Uint(falls), size: Float(light.min_distance) },
                ),
                LightSource::Point(position) => {
                    let row = row! { position: Vec3(position), color: Vec3(light.color), shadows: Uint(shadows), falls: Uint(falls) };
                    ("point_lights", row)
                }
                LightSource::Directional(direction) => (
                    "directional_lights",
                    row! { direction: Vec3(direction), color: Vec3(light.color), shadows: Uint(shadows) },
                ),
            }
        };
        let others = self.scene.lights.iter().filter(|light| light.shadows != Shadows::Grid);
        let all: Vec<_> = others.map(row).filter(|(list, _)| *list == name).collect();
        if all.is_empty() { Ok(None) } else { pack(name, layout, all.iter().map(|(_, row)| row)).map(Some) }
    }

    /// Returns the shaders' code for straight shadows, which depends on the treatment of transparent objects.
    pub(super) fn shadow_code(&self, clear: TransparentShadows) -> u32 {
        match clear {
            TransparentShadows::Filtered if self.scene.weakens_lines() => {
                constant("surface/shadow/clear", "WEAKENED") as u32
            }
            TransparentShadows::Closed if self.scene.splits() => constant("surface/shadow/clear", "SHUT_OUT") as u32,
            _ => 1,
        }
    }

    /// Returns the rows of lights with a grid and of beams that guide paths, each with the location of its voxels.
    fn grid_lights(&self) -> Vec<Row> {
        let lights = self.scene.lights.iter().filter(|light| light.shadows == Shadows::Grid);
        let lights = lights.map(|light| {
            let position = match light.source {
                LightSource::Point(position) => position,
                LightSource::Directional(_) => DVec3::ZERO,
            };
            let falls = u32::from(light.falls_in_grid());
            row! { color: Vec3(light.color), falls: Uint(falls), position: Vec3(position) }
        });
        // The guide needs the irradiance of a beam, not its color.
        let guide = self.scene.beams().into_iter().map(|beam| -> Row {
            row! { color: Vec3(DVec3::splat(beam.emitter.power)), falls: Uint(1), position: Vec3(beam.emitter.center) }
        });
        let (mut bricks, mut values) = (0, 0);
        let row = |(own, field): (Row, &LightGridData)| {
            let place = field.row(bricks, values);
            bricks += field.bricks.len();
            values += field.field.len();
            [own, place].concat()
        };
        lights.chain(guide).zip(self.fields).map(row).collect()
    }

    /// Returns the motions of objects, with their primitives.
    fn travels(&self) -> Vec<Row> {
        let time = self.scene.camera.as_ref().map_or(0.0, |camera| camera.time);
        let row = |(i, object, travel): (usize, &Object, &RigidMotion)| -> Row {
            [travel.values(object.ball(), time), row! { item: Uint(self.geometry.primitive(i)) }].concat()
        };
        self.scene.travels().map(row).collect()
    }

    /// Returns the spheres and disks around everything that a segment may meet: for each list the shapes on which rays end, then those that
    /// rays cross, then the parts of the acceleration structure.
    fn surroundings(&self) -> Vec<Row> {
        let g = self.geometry;
        // Enlarge the spheres by their own rounding error; the shaders allow for the rounding error of the segment.
        let slack = constant("segment/near_balls", "NEAR_SLACK");
        let row = |(center, radius): (DVec3, f64), normal: DVec3| {
            let radius = radius + slack * (radius + center.length());
            row! { center: Vec3(center), radius: Float(radius), normal: Vec3(normal) }
        };
        let shape = |shape: &PlacedShape| {
            let object = &self.scene.objects[shape.object as usize];
            let flat = object.solid().lists.as_ref().is_some_and(|lists| lists.flat);
            let normal = shape.placed.rows[1].truncate().normalize_or_zero();
            row(object.ball(), if flat { normal } else { DVec3::ZERO })
        };
        let held = |name: &str| g.analysis.structure.solids.iter().any(|solid| solid.name == name);
        let opaque = g.placed.iter().filter(|(name, _)| !held(name)).flat_map(|(_, shapes)| shapes);
        let sided = g.placed.values().flatten().filter(|shape| shape.bit.is_some());
        let listed = opaque.filter(|shape| shape.bit.is_none() && !shape.moves).chain(sided).map(shape);
        let part = |[lo, hi]: [DVec3; 2]| row((0.5 * (lo + hi), 0.5 * lo.distance(hi)), DVec3::ZERO);
        listed.chain(g.structure.parts().map(part)).collect()
    }

    /// Returns the tree over the curve that all rays follow.
    fn ray_nodes(&self) -> Vec<Row> {
        let rays = &self.scene.rays;
        let tolerance = match rays.segment {
            Segment::Arc { tolerance } => tolerance,
            Segment::Chord { .. } => f64::INFINITY,
        };
        let length = rays.max_parameter.unwrap_or(f64::MAX);
        let nodes = self.scene.law.facts().curve().map(|curve| ray_tree(curve, length, tolerance)).unwrap_or_default();
        let row = |node: &RayNode| {
            // Enlarge the boxes by the rounding error of 32 bits.
            let corner = |at: DVec3, sign: f64| at + sign * 1e-6 * at.abs();
            let [lo, hi] = node.corners;
            row! {
                lo: Vec3(corner(lo, -1.0)),
                hi: Vec3(corner(hi, 1.0)),
                end: Float(node.tau[1]),
                skip: Uint(node.skip),
            }
        };
        nodes.iter().map(row).collect()
    }

    /// Returns the hierarchy of objects that is traversed together with the tree of the curve.
    fn object_nodes(&self) -> Vec<Row> {
        let g = self.geometry;
        let held = |name: &str| g.analysis.structure.solids.iter().any(|solid| solid.name == name);
        let listed = g.placed.iter().filter(|(name, _)| !held(name)).flat_map(|(_, shapes)| shapes);
        let own = |shape: &PlacedShape| {
            let (lo, hi) = g.boxes[shape.object as usize];
            (lo.as_vec3(), hi.as_vec3())
        };
        let nodes = object_tree(listed.map(own).chain(g.structure.coarse()));
        let row = |node: &Node| {
            let (lo, hi) = (node.lo.as_dvec3(), node.hi.as_dvec3());
            let slack = 2e-6 * lo.abs().max(hi.abs());
            row! {
                lo: Vec3(lo - slack),
                skip: Uint(node.skip),
                hi: Vec3(hi + slack),
                leaf: Uint(u32::from(node.leaf != 0)),
            }
        };
        nodes.iter().map(row).collect()
    }

    /// Returns the objects that touch others, the opaque ones first.
    fn touching(&self) -> Vec<[(&'static str, Value); 2]> {
        let g = self.geometry;
        let clear = |&object: &usize| (object, g.analysis.regions.bit(object).map_or(0, |bit| 1 << bit));
        let opaque = g.analysis.regions.touching.opaque.iter().map(|&object| (object, 0));
        let all = opaque.chain(g.analysis.regions.touching.clear.iter().map(clear));
        all.map(|(object, bits)| [("primitive", Uint(g.primitive(object))), ("bits", Uint(bits))]).collect()
    }

    /// Returns the bit of each object in the set of regions.
    fn object_bits(&self) -> Vec<u32> {
        let bit = |object| self.geometry.analysis.regions.bit(object).map_or_else(no_bit, |bit| bit as u32);
        (0..self.scene.objects.len()).map(bit).collect()
    }
}

fn no_bit() -> u32 {
    constant("shape/facing", "NO_BIT") as u32
}

fn obstacle(ball: &Obstacle) -> [(&'static str, Value); 3] {
    [("center", Vec3(ball.center)), ("radius", Float(ball.radius)), ("place", Uint(ball.place as u32))]
}

fn placed_row(shape: &PlacedShape) -> Row {
    let own = row! {
        center: Vec3(shape.placed.center),
        radius: Float(shape.placed.number),
        material: Uint(shape.material),
        object: Uint(shape.object),
    };
    [own, shape.placed.space()].concat()
}
