//! The report on a valid scene.

use std::path::Path;

use serde_json::{Value, json};

use super::catalogs::Catalog;
use crate::cli::format::{CommandResult, counted, shown};
use crate::cli::render::followed;
use crate::gpu::{AccelStructure, Geometry, Grid, LightVolume, Memory, adapters, halved_pictures, light_bytes};
use crate::model::medium::VISIBLE;
use crate::program::Program;
use crate::render::usual_steps;
use crate::scene::{ARCSECOND, Beam, Scene, Shadows};

/// A scene, with its program and its size on the device.
pub(super) struct Modelled<'a> {
    pub path: &'a Path,
    pub scene: Scene,
    pub geometry: Geometry,
    pub program: Program,
    pub memory: Memory,
    /// The number of frames of its animation that were checked.
    pub frames_checked: u32,
    /// `true` if the modules of each pass are listed.
    pub names_parts: bool,
    /// `true` if the dispatches are listed.
    pub names_commands: bool,
}

impl CommandResult for Modelled<'_> {
    fn text(&self) -> String {
        let scene = &self.scene;
        let [width, height] = scene.image.size;
        let (samples, objects) = (scene.image.samples, scene.objects.len());
        let mut lines =
            vec![format!("{}: {width}×{height}, samples {samples}, objects {objects}", self.path.display())];
        let mut add = |more: Vec<String>| lines.extend(more.into_iter().map(|line| format!("  {line}")));
        add(unit_words(scene));
        add(self.adaptive_words().into_iter().collect());
        add(structure_words(&self.geometry).into_iter().collect());
        add(self.pass_words());
        add(self.command_words());
        add(self
            .remark()
            .into_iter()
            .chain(scene.mesh_remarks())
            .chain(scene.unused_vertex_colors())
            .chain(self.halved_pictures())
            .collect());
        add(scene.warnings().iter().map(|words| format!("warning: {words}")).collect());
        let swallowed = |light| format!("lights[{light}] is inside a capture region and has no effect");
        add(scene.swallowed_lights().into_iter().map(swallowed).collect());
        add(self.light_grids().map(|grid| grid.words()).collect());
        add(Catalog::all(scene).iter().map(Catalog::words).collect());
        add(random_words(scene));
        if scene.rays.auto.is_some() {
            add(vec!["method auto: chosen when the scene is rendered; this output assumes rk4".to_owned()]);
        }
        add(vec![self.memory_words()]);
        add(self.frame_words());
        lines.join("\n")
    }

    fn json(&self) -> Value {
        let scene = &self.scene;
        json!({
            "scene": shown(self.path),
            "errors": [],
            "size": scene.image.size,
            "samples": scene.image.samples,
            "units": units(scene),
            "adaptive": scene.image.adaptive,
            "objects": scene.objects.len(),
            "acceleration": structure(&self.geometry),
            "passes": self.passes(),
            "commands": self.names_commands.then(|| self.commands()),
            "integrator": scene.rays.auto.is_none().then(|| followed(&scene.rays)),
            "bytes_per_pixel": self.memory.bytes_per_pixel(),
            "bytes_per_pixel_of": self.memory.items.iter().map(|(name, n)| (name.clone(), json!(n))).collect::<Value>(),
            "light_grids": self.light_grids().map(|grid| grid.json()).collect::<Vec<_>>(),
            "stars": Catalog::all(scene).iter().map(Catalog::json).collect::<Vec<_>>(),
            "captured_lights": scene.swallowed_lights(),
            "frames": scene.animation.as_ref().map(|animation| animation.frames),
            "frames_checked": self.frames_checked,
            "shutter_samples": scene.moments(0).len(),
            "animated": scene.animation.as_ref().map_or(&[][..], |animation| &animation.keys),
            "notes": self.remark().into_iter().chain(scene.mesh_remarks()).chain(scene.unused_vertex_colors()).chain(self.halved_pictures()).chain(random_words(scene)).collect::<Vec<_>>(),
            "warnings": scene.warnings(),
        })
    }
}

/// Returns the scale of the scene in SI units, and in microarcseconds on the sky.
fn units(scene: &Scene) -> Option<Value> {
    let units = scene.units?;
    Some(json!({
        "length_m": units.length,
        "time_s": units.time(),
        "distance_m": units.distance,
        "length_uas": units.angle().map(|angle| angle / ARCSECOND * 1e6),
        "pixel_uas": scene.pixel_on_sky().map(|pixel| pixel / ARCSECOND * 1e6),
    }))
}

fn unit_words(scene: &Scene) -> Vec<String> {
    let Some(units) = scene.units else { return Vec::new() };
    let mut words = Vec::new();
    if let (Some(length), Some(time)) = (units.length, units.time()) {
        words.push(format!("unit of length: {} km, which light travels in {} s", six(length / 1e3), six(time)));
    }
    if let Some(angle) = units.angle() {
        words.push(format!("on the sky: {} uas per unit of length", six(angle / ARCSECOND * 1e6)));
    }
    if let Some(pixel) = scene.pixel_on_sky() {
        words.push(format!("a pixel: {} uas", six(pixel / ARCSECOND * 1e6)));
    }
    words
}

/// Returns a number with six significant digits, and an exponent of ten if it is large or small.
fn six(value: f64) -> String {
    if (1e-3..1e6).contains(&value) {
        let digits = 5 - value.log10().floor() as i32;
        return format!("{value:.*}", digits.max(0) as usize);
    }
    format!("{value:.5e}")
}

impl Modelled<'_> {
    fn adaptive_words(&self) -> Option<String> {
        let (tolerance, most) = (self.scene.image.adaptive?, self.scene.image.samples);
        Some(format!(
            "adaptive sampling: one ray per pixel corner, then 16 to {most} samples per pixel until the error is \
             below {tolerance}"
        ))
    }

    fn pass_words(&self) -> Vec<String> {
        let passes = self.program.passes.iter().map(|(pass, linked, reflection)| {
            let (lines, bindings) = (linked.source.lines().count(), reflection.bindings.len());
            let parts = linked.parts();
            let named = if self.names_parts { format!(": {}", parts.join(" ")) } else { String::new() };
            let (entry, count) = (pass.entry(), parts.len());
            format!("pass {entry:<10} {lines:>4} lines, {bindings:>2} bindings, {count:>2} modules{named}")
        });
        passes.collect()
    }

    /// Returns the dispatches of one iteration of a sample.
    fn commands(&self) -> Vec<String> {
        usual_steps(&self.scene, &self.program.features).iter().map(ToString::to_string).collect()
    }

    fn command_words(&self) -> Vec<String> {
        if !self.names_commands {
            return Vec::new();
        }
        let commands = self.commands();
        let head = match self.program.features.rounds {
            1 => format!("{} commands per sample, in order:", commands.len()),
            rounds => format!("{} commands per round, in order; up to {rounds} rounds per sample:", commands.len()),
        };
        [head].into_iter().chain(commands.into_iter().map(|command| format!("  {command}"))).collect()
    }

    fn passes(&self) -> Vec<Value> {
        let passes = self.program.passes.iter().map(|(pass, linked, reflection)| {
            json!({
                "name": pass.entry(),
                "lines": linked.source.lines().count(),
                "bindings": reflection.bindings.len(),
                "modules": linked.parts(),
            })
        });
        passes.collect()
    }

    /// Returns the remark of the law about this scene, if it has one.
    fn remark(&self) -> Option<String> {
        let bound = &self.scene.rays.bounding_sphere;
        self.scene.law.remark(bound.center, bound.radius)
    }

    /// Describes images that are too large for the device that would be chosen, if there is one.
    fn halved_pictures(&self) -> Vec<String> {
        if self.scene.pictures.is_empty() {
            return Vec::new();
        }
        adapters().first().map(|device| halved_pictures(&self.scene, device.texture_side)).unwrap_or_default()
    }

    fn light_grids(&self) -> impl Iterator<Item = GridOfLight> {
        let lights = self.scene.lights.iter().enumerate().filter(|(_, light)| light.shadows == Shadows::Grid);
        lights.map(|(light, own)| {
            let volume = LightVolume::new(&self.scene, own.grid.voxels);
            let bytes = light_bytes(volume.voxels() as u64);
            GridOfLight { light, voxels: volume.count, paths: own.grid.paths, bytes }
        })
    }

    fn memory_words(&self) -> String {
        let items: Vec<_> = self.memory.items.iter().map(|(name, bytes)| format!("{name} {bytes}")).collect();
        format!("{} bytes per pixel: {}", self.memory.bytes_per_pixel(), items.join(", "))
    }

    fn frame_words(&self) -> Vec<String> {
        let Some(animation) = &self.scene.animation else { return Vec::new() };
        let (frames, checked) = (animation.frames, self.frames_checked);
        let some = format!("checked {checked} of {frames} frames, evenly spaced from the first to the last");
        let all = format!("{frames} frames with one program; animated: {}", animation.keys.join(", "));
        let moments = self.scene.moments(0).len();
        let blurred = (moments > 0).then(|| {
            format!("{moments} shutter samples per frame; the shutter is open for {} of the frame", animation.shutter)
        });
        (checked < frames).then_some(some).into_iter().chain([all]).chain(blurred).collect()
    }
}

/// A photon grid with the directions of a light.
struct GridOfLight {
    light: usize,
    voxels: [u32; 3],
    paths: u32,
    bytes: u64,
}

impl GridOfLight {
    fn words(&self) -> String {
        let Self { light, voxels: [x, y, z], paths, bytes } = self;
        format!("lights[{light}]: photon grid of {x}×{y}×{z} voxels, {paths} paths, at least {bytes} bytes")
    }

    fn json(&self) -> Value {
        let Self { light, voxels, paths, bytes } = self;
        json!({ "light": light, "voxels": voxels, "paths": paths, "bytes": bytes })
    }
}

/// Lists the random elements of the image.
fn random_words(scene: &Scene) -> Vec<String> {
    let mut words = Vec::new();
    if scene.rays.path_tracing.is_some() {
        let emitters: Vec<_> = scene.emitters().iter().map(|emitter| format!("objects[{}]", emitter.object)).collect();
        let count = counted((emitters.len(), "emitter"));
        let emitters = (!emitters.is_empty()).then(|| format!("{count} ({})", emitters.join(", ")));
        let sky = scene.aims_at_sky().then(|| "the bright parts of the sky".to_owned());
        let aims: Vec<_> = emitters.into_iter().chain(sky).collect();
        words.push(if aims.is_empty() {
            "direct-light sampling: none, paths find light only by chance".to_owned()
        } else {
            format!("direct-light sampling: {}", aims.join(" and "))
        });
        words.extend(guide_words(scene));
    } else if scene.has_lobes() {
        words.push(
            "rough surfaces: each sample draws one random direction, so images with few samples are noisy".to_owned(),
        );
    } else if scene.is_occluded() {
        words.push(
            "ambient occlusion: each sample draws one random direction, so images with few samples are noisy; 64 \
             samples are smooth"
                .to_owned(),
        );
    }
    words.extend(dispersion_words(scene));
    words
}

/// Describes the wavelengths of light, if they matter.
fn dispersion_words(scene: &Scene) -> Option<String> {
    scene.disperses().then(|| {
        if scene.rays.path_tracing.is_some() {
            format!("dispersion: each path has one wavelength, from {} to {} nm", VISIBLE.start(), VISIBLE.end())
        } else {
            format!(
                "dispersion: all light has a wavelength of {} nm; path tracing uses all visible wavelengths",
                scene.rays.wavelength
            )
        }
    })
}

/// Describes path guiding, if it is used.
fn guide_words(scene: &Scene) -> Option<String> {
    let beam = |beam: &Beam| match beam.through {
        Some(object) => format!("objects[{}] via objects[{object}]", beam.emitter.object),
        None => format!("objects[{}]", beam.emitter.object),
    };
    let beams: Vec<_> = scene.beams().iter().map(beam).collect();
    let (grids, paths) = (counted((beams.len(), "photon grid")), scene.guide_grid().paths);
    (!beams.is_empty()).then(|| format!("path guiding by {grids} of {paths} paths: {}", beams.join(", ")))
}

/// Describes the acceleration structure that segments search, if there is one.
fn structure_words(geometry: &Geometry) -> Option<String> {
    let AccelStructure { items, nodes, grid, .. } = &geometry.structure;
    let triangles = geometry.triangles.len();
    let places = geometry.instances.places().len();
    Some(match grid {
        _ if items.is_empty() => return None,
        _ if places > 0 => format!(
            "BVH: {} primitives, {places} of them mesh instances; {triangles} triangles, {} nodes",
            items.len(),
            geometry.nodes().count()
        ),
        Some(Grid { count: [x, y, z], .. }) => {
            format!("uniform grid: {x}×{y}×{z} cells, {} entries, {triangles} triangles", items.len())
        }
        None if nodes.is_empty() => {
            format!("no acceleration structure: {} primitives ({triangles} triangles)", items.len())
        }
        None => format!("BVH: {} primitives ({triangles} triangles), {} nodes", items.len(), nodes.len()),
    })
}

fn structure(geometry: &Geometry) -> Value {
    let AccelStructure { items, grid, .. } = &geometry.structure;
    json!({
        "primitives": items.len(),
        "triangles": geometry.triangles.len(),
        "nodes": geometry.nodes().count(),
        "instances": geometry.instances.places().len(),
        "cells": grid.as_ref().map(|grid| grid.count),
    })
}
