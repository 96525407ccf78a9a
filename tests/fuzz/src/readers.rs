//! All readers of files and formulas, as the program calls them: for the fuzzer, and for the tests, which replay its
//! findings.
//!
//! *Idea.* A reader may reject any bytes with a reason. It neither panics, nor takes long, nor allocates much more memory
//! than its file has bytes. To add one, add a line to [`READERS`] and a few valid files to `corpus/NAME`.

use std::cell::OnceCell;
use std::fmt::Display;
use std::path::{Path, PathBuf};

use bentray::assets::{GridUse, RawGridLayout, Spacetime, Stored};
use bentray::glam::{DMat3, DVec3, DVec4};
use bentray::gpu::Geometry;
use bentray::output::{csv, merge, picture, said, settings_of};
use bentray::program::{Program, ProgramError, ProgramOptions};
use bentray::scene::import::import;
use bentray::scene::{
    Catalog, Curve, FanRay, Formula, FormulaError, Gltf, Interval, LineElement, Mesh, Override, Picture, Profile,
    SampledGrid, Scene, follow_as,
};

/// A reader, with a folder of files in `corpus`.
pub struct Reader {
    /// The name of the folder.
    pub name: &'static str,
    /// Reads these bytes, and panics if they reveal an error of the program.
    pub read: fn(&[u8]),
    /// The allowed memory in KiB per byte of input, in addition to [`LEAST_MIB`].
    pub kib_per_byte: usize,
    /// The number of changed files that the tests try; the fuzzer makes its files itself.
    #[allow(dead_code)]
    pub changes: usize,
}

/// The memory in MiB that every reader may use.
pub const LEAST_MIB: usize = 64;

const fn reader(name: &'static str, read: fn(&[u8]), kib_per_byte: usize, changes: usize) -> Reader {
    Reader { name, read, kib_per_byte, changes }
}

/// All readers.
pub const READERS: &[Reader] = &[
    reader("scene", |bytes| _ = scene(&text(bytes), &[]), 1, 1000),
    reader("override", overrides, 1, 500),
    reader("formula", formula, 8, 500),
    reader("program", program, 64, 20),
    reader("law", law, 64, 40),
    reader("obj", mesh::<'o'>, 1, 1000),
    reader("ply", mesh::<'p'>, 1, 1000),
    reader("stl", mesh::<'s'>, 1, 1000),
    reader("gltf", gltf, 1, 1000),
    reader("nrrd", grid, 8, 1000),
    reader("rays", rays, 1, 1000),
    reader("profile", profile, 1, 1000),
    reader("catalog", |bytes| _ = shown(Catalog::parse(&text(bytes), Path::new("a.csv"))), 1, 1000),
    // A byte may hold thousands of pixels.
    reader("picture", sky, 256, 1000),
    reader("part", part, 64, 1000),
    reader("method", method, 1, 1000),
];

/// Returns `tests/fuzz`, from either crate that includes this file.
pub fn folder() -> PathBuf {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    if own.ends_with("tests/fuzz") { own.to_owned() } else { own.join("tests/fuzz") }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Returns the value that was read, or checks that the error message has a reasonable length.
fn shown<T, E: Display>(read: Result<T, E>) -> Option<T> {
    let length = |error: E| error.to_string().len();
    read.map_err(|error| assert!((1..1_000_000).contains(&length(error)))).ok()
}

/// Calls a function with the path of a file of these bytes.
fn with_file(name: &str, bytes: &[u8], read: impl FnOnce(&Path)) {
    thread_local!(static FOLDER: OnceCell<tempfile::TempDir> = const { OnceCell::new() });
    FOLDER.with(|folder| {
        let path = folder.get_or_init(|| tempfile::tempdir().unwrap()).path().join(name);
        std::fs::write(&path, bytes).unwrap();
        read(&path);
    });
}

fn scene(text: &str, overrides: &[Override]) -> Option<Scene> {
    let path = folder().join("files/scene.toml");
    let scene = shown(Scene::parse(text, &path, overrides))?;
    let _ = (scene.swallowed_lights(), scene.captures(None));
    let followed = scene.rays.followed();
    assert!(scene.rays.auto.is_some() || shown(follow_as(&followed)).is_some(), "{followed}");
    Some(scene)
}

/// Checks that a valid scene is also a valid program.
fn program(bytes: &[u8]) {
    if let Some(scene) = scene(&text(bytes), &[]) {
        linked(&scene).unwrap_or_else(|error| panic!("{error}"));
    }
}

fn linked(scene: &Scene) -> Result<Program, ProgramError> {
    let geometry = Geometry::new(scene);
    Program::new(scene, &geometry.analysis, &ProgramOptions::default(), geometry.extent())
}

/// Reads one override per line, for a scene that has a key for each.
fn overrides(bytes: &[u8]) {
    let base = include_str!("../files/scene.toml");
    let text = text(bytes);
    let all: Vec<Override> = text.lines().take(8).filter_map(|line| shown(line.parse())).collect();
    scene(base, &all);
}

fn method(bytes: &[u8]) {
    let Some(overrides) = shown(follow_as(&text(bytes))) else { return };
    scene(include_str!("../files/scene.toml"), &overrides);
}

/// Checks that the error of a formula has a location in its text.
fn placed<T>(read: Result<T, FormulaError>, text: &str) -> Option<T> {
    read.map_err(|error| {
        assert!(!error.problem.is_empty());
        assert!(error.place.start <= error.place.end && error.place.end <= text.len(), "{error:?}");
    })
    .ok()
}

/// Reads lines as one formula each, and all together as a curve, as a custom surface law and as a spacetime.
fn formula(bytes: &[u8]) {
    let text = text(bytes);
    let lines: Vec<&str> = text.split('\n').take(400).collect();
    let line = |k: usize, usual: &'static str| lines.get(k).copied().unwrap_or(usual);
    let place = DVec3::new(0.5, -2.0, 1e-3);
    if let Some(formula) = placed(Formula::parse(line(0, "")), line(0, "")) {
        let _ = (formula.value(place), formula.gradient(DVec3::ZERO), formula.constant());
        let written = formula.to_string();
        let again = Formula::parse(&written);
        assert!(again.as_ref() == Ok(&formula) || written.len() > 1000, "`{text}`, written `{written}`: {again:?}");
    }
    let curve = [line(0, "0"), line(1, "t"), line(2, "1")];
    match Curve::parse(curve) {
        Ok(curve) => {
            let over = curve.over(Interval::between(-1.0, 2.0)).0;
            for (order, point) in curve.at(0.25).into_iter().enumerate() {
                let holds = |k: usize| !point[k].is_finite() || over[order][k].holds(point[k]);
                assert!((0..3).all(holds), "{point} is not in {:?}", over[order]);
            }
        }
        Err(wrong) => {
            for (k, error) in wrong {
                placed::<()>(Err(error), curve[k]);
            }
        }
    }
    let fan = [line(0, "dx"), line(1, "dy"), line(2, "dz"), line(3, "1")];
    if let Err(wrong) = FanRay::parse(fan) {
        for (k, error) in wrong {
            placed::<()>(Err(error), fan[k]);
        }
    }
    let terms = lines.iter().skip(3).filter_map(|line| line.split_once('='));
    let written = Spacetime {
        line_element: line(0, "").to_owned(),
        parameters: vec![("M".to_owned(), 1.0)],
        terms: terms.map(|(name, text)| (name.trim().to_owned(), text.to_owned())).collect(),
        scale: line(1, "r").to_owned(),
        captured: lines.get(2).filter(|line| !line.is_empty()).map(|line| (*line).to_owned()),
        throat: bytes.ends_with(b"\n").then_some(2.0),
        axes: DMat3::IDENTITY,
    };
    if let Ok(element) = LineElement::parse(written) {
        let spot = bentray::assets::Spot { x: place, t: 0.0, side: 1.0 };
        let _ = (element.metric(spot), element.force(spot, DVec4::ONE), element.scale(spot), element.gap(spot));
    }
}

/// Links a custom law into a program.
fn law(bytes: &[u8]) {
    with_file("law.wgsl", bytes, |path| {
        let law = text(bytes);
        let depends = [
            ("flow_field", "flow"),
            ("law_acceleration_by_time", "time"),
            ("law_acceleration_by_velocity", "velocity"),
        ];
        let depends = depends.iter().find(|(name, _)| law.contains(name)).map_or("place", |(_, depends)| depends);
        let text = include_str!("../files/law.toml").replace("\"place\"", &format!("\"{depends}\""));
        let Some(scene) = shown(Scene::parse(&text, &path.with_file_name("scene.toml"), &[])) else { return };
        shown(linked(&scene));
    });
}

fn mesh<const FORMAT: char>(bytes: &[u8]) {
    let name = match FORMAT {
        'o' => "a.obj",
        'p' => "a.ply",
        _ => "a.stl",
    };
    with_file(name, bytes, |path| _ = shown(Mesh::load(path)).map(|mesh| whole(&mesh)));
}

/// Checks the guarantees of every mesh.
fn whole(mesh: &Mesh) {
    let used = mesh.triangles.iter().flatten().max().map_or(0, |last| *last as usize + 1);
    assert_eq!(used, mesh.vertices.len());
    for vertex in &mesh.vertices {
        let length = vertex.normal.length();
        assert!(vertex.position.is_finite() && vertex.uv.is_finite() && (length - 1.0).abs() < 1e-3, "{vertex:?}");
    }
    let _ = mesh.hole();
    mesh.solids().iter().for_each(|solid| assert_eq!((solid.hole(), solid.opening()), (None, None)));
    assert!(mesh.winding(DVec3::new(0.1, 0.2, 0.3)).is_finite());
}

fn gltf(bytes: &[u8]) {
    let name = if bytes.starts_with(b"glTF") { "a.glb" } else { "a.gltf" };
    with_file(name, bytes, |path| {
        if let Some(mesh) = shown(Mesh::load(path)) {
            whole(&mesh);
        }
        let Some(file) = shown(Gltf::open(bytes.to_vec(), path)) else { return };
        let scene = path.with_file_name("imported.toml");
        let Some(imported) = shown(import(&file, &scene)) else { return };
        for (name, bytes) in &imported.pictures {
            std::fs::write(scene.with_file_name(name), bytes).unwrap();
        }
        let read = Scene::parse(&imported.text, &scene, &[]);
        // Images may be broken, and the camera may be in a wall, but the written text must be valid.
        let said = read.err().map(|error| error.to_string()).unwrap_or_default();
        let is_of_the_file = ["picture", "cannot read", "the camera is"].iter().any(|words| said.contains(words));
        assert!(said.is_empty() || is_of_the_file, "{said}\n{}", imported.text);
    });
}

fn grid(bytes: &[u8]) {
    let corners = Some([DVec3::ZERO, DVec3::ONE]);
    let bare = RawGridLayout { size: [2, 2, 3], stored: Stored::U16, little: true };
    with_file("a.nrrd", bytes, |path| {
        for (bare, corners) in [(None, None), (None, corners), (Some(bare), corners)] {
            let Some(grid) =
                shown(SampledGrid::load(path, &GridUse { bare, corners, scale: 0.5, offset: 1.0, is_index: true }))
            else {
                continue;
            };
            assert_eq!(grid.samples.len() as u64, grid.size.iter().map(|n| u64::from(*n)).product::<u64>());
            assert!(grid.samples.iter().all(|n| n.is_finite() && *n > 0.0));
            assert!(grid.origin.is_finite() && grid.cell.is_finite());
        }
    });
}

fn rays(bytes: &[u8]) {
    with_file("a.csv", bytes, |path| {
        let rays = shown(csv::read_rays(path, true)).unwrap_or_default();
        let places = shown(csv::read_places(path)).unwrap_or_default();
        assert!(rays.as_flattened().iter().chain(places.as_flattened()).all(|number| number.is_finite()));
    });
}

fn profile(bytes: &[u8]) {
    with_file("a.csv", bytes, |path| {
        let Some(profile) = shown(Profile::load(path)) else { return };
        for point in &profile.points {
            let n = profile.index(point.height);
            assert!(n.is_finite() && n > 0.0, "{point:?}: {n}");
        }
    });
}

fn sky(bytes: &[u8]) {
    with_file("a.picture", bytes, |path| {
        let Some(picture) = shown(Picture::load(path)) else { return };
        let [width, height] = picture.size.map(|side| side as usize);
        assert_eq!(picture.pixels.len(), width * height);
        assert!(picture.pixels.iter().flatten().all(|x| x.is_finite()));
    });
}

/// Reads an image that the program wrote, and parts of one.
fn part(bytes: &[u8]) {
    let name = if bytes.starts_with(b"\x89PNG") { "a.png" } else { "a.exr" };
    with_file(name, bytes, |path| {
        shown(said(path, "scene"));
        let settings = shown(settings_of(path));
        if name == "a.png" {
            return;
        }
        if let Some((settings, band)) = shown(picture(path)) {
            assert_eq!([band.width, band.rows], settings.window.size);
            let pixels = band.width as usize * band.rows as usize;
            assert!(band.color.iter().all(|plane| plane.len() == pixels));
        }
        let is_small = settings.is_some_and(|settings| settings.size.iter().all(|side| *side < 256));
        if is_small {
            let outputs = ["b.exr", "b.png"].map(|name| path.with_file_name(name));
            shown(merge(&[path.to_owned()], &outputs));
        }
    });
}
