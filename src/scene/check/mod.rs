//! The conversion of documents to scenes, which reads and checks every value and reports all errors in one run.
//!
//! Each file here reads one table. A table is read after the tables that it depends on (rays after the law, the camera after both, objects
//! after materials and the bounding sphere). An invalid value is reported and replaced, or its table is omitted, so that the reader can
//! continue; a scene is returned only if there are no errors.
//!
//! *Length.* This file is over 300 lines, so that the order of dependent tables is in one place.

mod ambient;
mod animation;
mod eyes;
mod image;
mod lights;
mod matter;
mod paths;
mod rays;
mod regions;
mod shift;
mod sky;
mod stars;
mod travel;
mod units;

use super::optics::Optics;
use super::throat::add_throat;
use super::{Animation, Bound, Output, REFERENCE, Scene, SceneError, Shadows, Tonemap};
use crate::assets::Files;
use crate::document::reader::{Reader, TableReader};
use crate::document::values::{number_where, positive, whole, word};
use crate::document::{Document, Override, given_name, read_given_text};
use crate::model::{Camera, Capture, Law, camera, law, material, shape, volume};
use glam::{DMat3, DVec3};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

impl Scene {
    /// Reads and checks the scene file at `path`, with all files that it references.
    ///
    /// Files are relative to the folder of the scene file. The path `-` is standard input, whose files are relative to the working
    /// directory. Each override sets or removes one key, like `--set` on the command line.
    ///
    /// # Errors
    ///
    /// Returns [`SceneError::Read`] if the scene file cannot be read, and [`SceneError::Diagnostics`] with all errors of the scene and of
    /// its other files, each with line, column and remedy. A TOML syntax error is reported alone.
    ///
    /// # Examples
    ///
    /// ```
    /// use bentray::scene::{Scene, SceneError};
    ///
    /// let scene = Scene::load("scenes/laws/vortex.toml".as_ref(), &["image.size=[64, 36]".parse()?])?;
    /// assert_eq!(scene.image.size, [64, 36]);
    /// # Ok::<(), SceneError>(())
    /// ```
    pub fn load(path: &Path, overrides: &[Override]) -> Result<Self, SceneError> {
        Self::load_with(&mut Files::default(), path, overrides, None)
    }

    /// Loads a scene like [`Scene::load`], with a cache of files for later scenes and, if a frame is given, with the values of
    /// `[animation]` at that frame. `frame_of` returns the frame of each track, or a time between two frames, from its key; the result is
    /// equal for all tracks, unless the effect of a single track is examined.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`load`](Self::load).
    pub fn load_with(
        files: &mut Files,
        path: &Path,
        overrides: &[Override],
        frame_of: Option<&dyn Fn(&str) -> f64>,
    ) -> Result<Self, SceneError> {
        Self::of(&document(path, overrides, frame_of)?, given_name(path), files)
    }

    /// Returns the contents of a scene file after overrides and frame values: every value by its key, without `[animation]`, but with its
    /// tracks if a frame's shutter is open. Equivalent files have equal listings.
    ///
    /// # Errors
    ///
    /// Returns an error if the file cannot be read or is not valid TOML.
    pub fn listing(
        path: &Path,
        overrides: &[Override],
        frame_of: Option<&dyn Fn(&str) -> f64>,
    ) -> Result<BTreeMap<String, String>, SceneError> {
        let mut lines = document(path, overrides, frame_of)?.listing();
        // The values of a frame do not describe the open shutter, but the tracks do.
        let is_open = frame_of.is_some() && lines.get("animation.shutter").is_some_and(|part| part.parse() != Ok(0.0));
        let stays = |key: &str| is_open && !["animation.frames", "animation.rate"].contains(&key);
        lines.retain(|key, _| !key.starts_with("animation.") || stays(key));
        Ok(lines)
    }

    /// Returns the contents of a scene like [`listing`](Self::listing), from its text.
    ///
    /// # Errors
    ///
    /// Returns an error if the text is not valid TOML.
    pub fn text_listing(
        text: &str,
        path: &Path,
        overrides: &[Override],
    ) -> Result<BTreeMap<String, String>, SceneError> {
        Ok(Document::parse(text, path, overrides)?.listing())
    }

    /// Parses and checks a scene file like [`load`](Self::load), from its text. `path` names the text in errors, and files are relative to
    /// the folder of `path`.
    ///
    /// # Errors
    ///
    /// Returns [`SceneError::Diagnostics`] with all errors of the text and of its files.
    ///
    /// # Examples
    ///
    /// ```
    /// use bentray::scene::{Scene, SceneError};
    ///
    /// let text = "[law]\nkind = \"schwarzschild\"\nmas = 2\n[rays]\nbounding_sphere = { radius = 50 }\n";
    /// let Err(SceneError::Diagnostics(errors)) = Scene::parse(text, "scene.toml".as_ref(), &[]) else { panic!() };
    /// assert_eq!((errors[0].line, errors[0].column), (3, 1));
    /// ```
    pub fn parse(text: &str, path: &Path, overrides: &[Override]) -> Result<Self, SceneError> {
        Self::parse_with(&mut Files::default(), text, path, overrides)
    }

    /// Parses a scene like [`Scene::parse`], with a cache of files for later scenes.
    ///
    /// # Errors
    ///
    /// Returns the errors of [`parse`](Self::parse).
    pub fn parse_with(files: &mut Files, text: &str, path: &Path, overrides: &[Override]) -> Result<Self, SceneError> {
        let mut document = Document::parse(text, path, overrides)?;
        units::resolve(&mut document);
        Self::of(&document, path, files)
    }

    fn of(document: &Document, path: &Path, files: &mut Files) -> Result<Self, SceneError> {
        let reader = Reader::new(document, &REFERENCE);
        files.begin();
        let scene = scene(&reader, files);
        let mut mistakes = reader.into_mistakes();
        // Errors of the scene come first, in order of location; those of other files stay together in the order in which they were found.
        mistakes.sort_by_key(|m| if m.file == path { (m.line, m.column) } else { (usize::MAX, 0) });
        match scene {
            Some(scene) if mistakes.is_empty() => Ok(scene),
            _ => Err(SceneError::Diagnostics(mistakes)),
        }
    }
}

/// Reads a scene file with its changes.
fn document(
    path: &Path,
    overrides: &[Override],
    frame_of: Option<&dyn Fn(&str) -> f64>,
) -> Result<Document, SceneError> {
    let mut document = Document::parse(&read_given_text(path)?, given_name(path), overrides)?;
    units::resolve(&mut document);
    if let Some(frame_of) = frame_of {
        animation::apply(&mut document, frame_of);
    }
    Ok(document)
}

/// Creates the scene as far as possible; the reader collects errors.
pub(super) fn scene(reader: &Reader, files: &mut Files) -> Option<Scene> {
    let root = reader.root();
    let units = units::read(&root);
    let (law, absorption) = law::read(&root, files);
    let table = rays::table(&root);
    let bound = table.as_ref().and_then(rays::bound);
    let paths = paths::read(&root, table.as_ref(), law.as_deref());
    let image = image::read(&root, paths.is_some());
    let camera = camera::read(&root, law.as_deref(), image.size);
    let law = law.and_then(|law| seen(&root, law, camera.as_ref()));
    let sky::Skies { near: sky, beyond, stars } = sky::read(&root, files, law.as_deref(), paths.is_some());
    let output = output(&root, paths.is_some());
    let (names, mut materials) = material::read(&root, files, paths.is_some());
    let centers = bound.map(|bound| bound.centers(law.as_deref()));
    let balls = centers.as_deref().zip(bound.map(|bound| bound.radius));
    let placed = shape::read(&root, (&names, &materials), balls, law.as_deref(), files);
    let placed = regions::solids(placed, &materials);
    regions::check(reader, &placed, &materials);
    if let Some(law) = &law {
        shift::check_discs(reader, &placed, &materials, &**law);
    }
    let mut objects: Vec<_> = placed.into_iter().map(|(_, object)| object).collect();
    if let Some(law) = &law {
        add_throat(&**law, &mut materials, &mut objects);
        if let Some((key, [problem, help])) =
            law.facts().throat.zip(bound).and_then(|(throat, bound)| throat.refuses_bound(bound.radius))
        {
            root.fault_within("law", key, problem, help);
        }
    }
    if let Some(camera) = &camera {
        eyes::check(&root, camera, &objects);
    }
    if let (Some(law), Some(bound)) = (&law, bound) {
        check_bound(&root, &**law, bound);
    }
    let optics = Optics { law: law.as_deref(), objects: &objects, materials: &materials, paths };
    let rays = table.and_then(|table| rays::read(table, bound, &optics));
    let chords = rays.as_ref().is_some_and(|rays| rays.segment.has_chords());
    let lights = lights::read(&root, bound.map_or(1.0, |bound| bound.radius), &optics);
    if chords && lights.iter().any(|light| light.shadows == Shadows::Shooting) {
        let help = "use segment = \"arc\", or shadows = \"straight-rays\"";
        root.fault(&["lights"], "shadows = \"curved-rays\" requires arcs, and these rays are chords", help);
    }
    if chords && absorption.is_some() {
        let help = "use segment = \"arc\", or remove law.absorption";
        root.fault(&["law"], "absorption requires arcs, and these rays are chords", help);
    }
    let occlusion = ambient::read(&root, &optics, chords);
    let (volumes, radiation) = volume::read(&root, law.as_deref(), files);
    let matter = matter::Rest { law: law.as_deref(), camera: camera.as_ref(), objects: &objects };
    matter::check(&root, (&volumes, radiation.as_ref()), &matter, [chords, paths.is_some(), image.adaptive.is_some()]);
    if paths.is_some() {
        paths::refuse(&root, &lights);
    }
    let reach = bound.map_or(1.0, |bound| bound.radius);
    let (law_now, absorption_now) = (law.as_deref(), absorption.as_ref());
    let rest =
        shift::Rest { law: law_now, materials: &materials, absorption: absorption_now, paths: paths.is_some(), reach };
    shift::check(&root, camera.as_ref(), &rest);
    let sight = stars::Sight { law: law_now, camera: camera.as_ref(), rays: rays.as_ref() };
    stars::check(&root, &stars, &sight, radiation.is_some());
    travel::check(&root, camera.as_ref(), bound, chords, &optics);
    let animation = animation::read(&root).map(|read| Animation {
        frames: read.frames,
        rate: read.rate,
        shutter: read.shutter,
        moments: read.moments,
        keys: read.keys(),
    });
    check_shutter(&root, image.adaptive.is_some(), animation.as_ref());
    root.finish();
    let mut scene = Scene {
        units,
        image,
        camera,
        law: law?,
        absorption,
        rays: rays?,
        sky,
        sky_other_side: beyond,
        stars,
        output,
        materials,
        objects,
        lights,
        volumes,
        radiation,
        occlusion,
        animation,
        pictures: files.pictures(),
        left_out: files.left_out(),
    };
    if scene.rays.path_tracing.is_none() {
        scene.output.clamp = None;
    }
    for light in scene.swallowed_lights() {
        scene.lights[light].color = DVec3::ZERO;
    }
    Some(scene)
}

/// Reports an open shutter with adaptive sampling.
fn check_shutter(root: &TableReader, adapts: bool, animation: Option<&Animation>) {
    if adapts && animation.is_some_and(|animation| animation.shutter > 0.0) {
        let problem = "adaptive sampling cannot be combined with an open shutter".to_owned();
        let help = "remove image.adaptive and set image.samples".to_owned();
        root.fault_within("animation", "shutter", problem, help);
    }
}

/// Reports a bounding sphere inside a capture region, which would show nothing.
fn check_bound(root: &TableReader, law: &dyn Law, bound: Bound) {
    let swallows = |capture: &Capture| {
        capture.anchor.offset(bound.center).length() + bound.radius <= capture.radius && capture.radius > 0.0
    };
    if let Some(capture) = law.captures(None).iter().find(|capture| swallows(capture)) {
        let problem = format!("the bounding sphere is inside the capture region, r = {:.4}", capture.radius);
        root.fault_within("rays", "bounding_sphere", problem, "use a larger radius".to_owned());
    }
}

/// Returns the law at the camera's time and, if the law uses them, with the camera's axes.
fn seen(root: &TableReader, law: Arc<dyn Law>, camera: Option<&Camera>) -> Option<Arc<dyn Law>> {
    if camera.is_none() && law.facts().curve().is_some_and(|curve| curve.turned.is_some()) {
        // An invalid camera is already reported.
        if root.node("camera").is_none() {
            let problem = "the law uses the axes of the camera, and the scene has no camera";
            root.fault(&["law"], problem, "use axes = \"scene\", or add [camera]");
        }
        return None;
    }
    let axes = camera.map(|camera| DMat3::from_cols(camera.right, camera.up, -camera.forward));
    Some(law.seen(axes, camera.map_or(0.0, |camera| camera.time)).unwrap_or(law))
}

/// Reads `[output]`; `by_paths` is `true` for path tracing.
fn output(root: &TableReader, by_paths: bool) -> Output {
    let mut output = Output::default();
    if let Some(table) = root.subtable("output", "output") {
        let stops = number_where("a number of stops from -64 to 64", |x| x.abs() <= 64.0);
        output.exposure = table.or("exposure", 0.0, stops);
        output.tonemap = table.or("tonemap", Tonemap::None, word(Tonemap::NAMES));
        output.bits = table.or("bit_depth", 8, |node| match whole(8..=16)(node)? {
            8 => Ok(8),
            16 => Ok(16),
            other => Err(node.fault(format!("expected 8 or 16 bits, found {other}"), "")),
        });
        output.glare = table.or("glare", 0.0, number_where("a fraction from 0 to 1", |x| (0.0..=1.0).contains(&x)));
        output.clamp = table.optional("clamp", positive);
        if output.clamp.is_some() && !by_paths {
            let help = "remove it; reduce the brightness of the image with `exposure` and `tonemap`";
            table.fault(&["clamp"], "`clamp` applies only to path tracing", help);
        }
        table.finish();
    }
    output
}
