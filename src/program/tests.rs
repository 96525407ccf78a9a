//! Tests that every module is needed: a shipped scene links it, or a scene or a test that is listed here.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::copies::with_region_copies;
use super::fold::folded;
use super::link::{index, reach};
use super::short_lists::in_uniforms;
use super::sources::Sources;
use super::*;
use crate::scene::Scene;

/// The beginning of each of [`OTHERS`].
const BEGINNING: &str =
    "camera.position = [0, 0, 9]\nrays.bounding_sphere.radius = 90\nmaterials.m.diffuse = [0.5, 0.5, 0.5]\n";

/// Scenes, each with modules that no scene before it links.
const OTHERS: [&str; 15] = [
    "camera.kind = 'panorama'
     camera.stereo = { separation = 0.1, convergence = 3 }",
    "camera.stereo = { separation = 0.1, convergence = 3 }
     image = { samples = 64, adaptive = 0.1 }
     rays.method = 'rk4'
     rays.precision = 'f64'",
    "camera.stereo.separation = 0.1
     law.kind = 'schwarzschild'
     law.form = 'geodesic'
     rays.method = 'rk4-doubling'
     rays.segment = 'chord'",
    "camera.observer = 'static'
     camera.redshift = true
     law.kind = 'schwarzschild'
     objects = [{ shape = 'sphere', center = [4, 0, 0], material = 'm' }]
     rays.method = 'rk4-doubling'
     rays.doubling = 'paper'
     rays.precision = 'f16'",
    "camera.observer = 'static'
     camera.redshift = true
     law.kind = 'reissner-nordstrom'
     objects = [{ shape = 'sphere', center = [4, 0, 0], material = 'm' }]
     rays.method = 'bogacki-shampine'",
    "law.kind = 'reissner-nordstrom'
     rays.method = 'planar'",
    "law.kind = 'kerr-newman'
     law.spin = 0.5
     rays.method = 'separated'",
    "camera.observer = 'static'
     law.kind = 'kerr-newman'
     radiation.frequencies = [1]
     rays.method = 'separated'
     volumes = [{ shape = 'sphere', emission = 1 }]",
    "law.kind = 'lorenz'
     law.order = 2
     rays.method = 'leapfrog'
     rays.curvature_step = 2",
    "camera.kind = 'orthographic'
     camera.height = 1
     law.kind = 'lorenz'
     rays.method = 'groeller'
     rays.step = 0.01",
    "law.kind = 'sources'
     law.parameter = 'length'
     law.sources = [{ kind = 'line', direction = [0, 1, 0], position = [0, 0, 0], strength = 1 }]
     rays.method = 'euler'
     rays.step = 0.1",
    "camera.kind = 'orthographic'
     camera.height = 1
     law = { kind = 'parametric', x = 't', y = 't', z = 't', t = [0, 1] }",
    "rays.acceleration = 'none'
     sky.faces = ['F', 'F', 'F', 'F', 'F', 'F']
     materials.a.diffuse.image = 'F'
     materials.b = { kind = 'ray-splitter', rays = [['dx', 'dy', 'dz', '1']] }
     lights = [{ kind = 'point', position = [0, 9, 0], shadows = 'straight-rays', transparent = 'tinted' }]
     objects = [{ shape = 'mesh', file = 'data/teapot.obj', material = 'a' }, { shape = 'box', material = 'b' }, { shape = 'box', center = [3, 0, 0], interior = { kind = 'constant', n = 1.5, roughness = 0.2, absorption = [0, 1, 1] } }]",
    "law.kind = 'schwarzschild'
     rays.acceleration = 'grid'
     lights = [{ kind = 'point', position = [0, 9, 0], shadows = 'curved-rays' }]
     objects = [{ shape = 'mesh', file = 'data/teapot.obj', material = 'm' }]",
    "rays.lighting = 'path-tracing'
     output.clamp = 5
     sky.image = 'F'
     materials.a = { diffuse = [0.5, 0.5, 0.5], specular = [0.2, 0.2, 0.2] }
     objects = [{ shape = 'box', material = 'a' }]",
];

/// Media and their absorption, each inside a sphere, in scenes with these methods.
const MEDIA: [(&str, &str); 6] = [
    ("exact", "kind = 'maxwell-fisheye'"),
    ("exact", "kind = 'linear', gradient = [0, 0.1, 0]"),
    ("rkn4", "kind = 'eaton', absorption = { transmittance = '0.5' }"),
    ("snell", "kind = 'sech', n0 = 1.5, g = 0.1, absorption = { coefficient = ['0.1', '0.2', 'x^2'] }"),
    (
        "rk4",
        "kind = 'profile', points = [[-2, 1.2], [2, 1.1]], absorption = { texture = 'ramp', frequency = 2, ramp = 'F' }",
    ),
    (
        "rk4",
        "kind = 'noise', amplitude = 0.1, frequency = 2, absorption = { texture = 'ramp', frequency = 2, ramp = 'F', axis = [0, 1, 0] }",
    ),
];

/// Modules that no short scene links, or no scene at all, each with a test that does.
const TESTED: [(&str, &str); 15] = [
    ("device_speed/multiply_add", "json_is_for_scripts"),
    ("device_speed/texture_read", "json_is_for_scripts"),
    ("device_speed/texture_write", "json_is_for_scripts"),
    ("law/time_given", "a_users_flow_is_followed"),
    ("medium/grid", "splines_go_through_their_samples"),
    ("pass/reshade", "images_from_maps_have_the_bits_of_new_ones"),
    ("picture/bundle/kept", "images_from_maps_have_the_bits_of_new_ones"),
    ("picture/bundle/stored", "images_from_maps_have_the_bits_of_new_ones"),
    ("segment/order_placed", "a_mesh_that_is_kept_once_is_met_where_its_copies_are"),
    ("segment/stored_end", "images_from_maps_have_the_bits_of_new_ones"),
    ("segment/structure/bvh_instances", "a_mesh_that_is_kept_once_is_met_where_its_copies_are"),
    ("shape/instance", "a_mesh_that_is_kept_once_is_met_where_its_copies_are"),
    ("state/ends", "images_from_maps_have_the_bits_of_new_ones"),
    ("surface/vertex_colors", "vertex_colors_multiply_the_color_of_any_material"),
    ("volume/grids", "samples_shine_as_their_function"),
];

/// Returns the files with this extension in a folder and its subfolders.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let paths = folder.read_dir().unwrap().map(|entry| entry.unwrap().path());
    let all = paths.flat_map(|path| if path.is_dir() { files(&path, extension) } else { vec![path] });
    all.filter(|path| path.extension().is_some_and(|own| own == extension)).collect()
}

/// Returns the choices for a scene: images by every schedule, all layers, every way to skip terminated rays, and every purpose.
fn all_options() -> Vec<ProgramOptions> {
    let plain = ProgramOptions::default;
    let purposes = [Mode::Trace, Mode::Pixels, Mode::Lit, Mode::Light, Mode::Caustics, Mode::Bare];
    let schedules = Schedule::ALL.map(|schedule| ProgramOptions { schedule, masks: schedule.masks(), ..plain() });
    let purposes = purposes.map(|mode| ProgramOptions { mode, schedule: Schedule::Fused, ..plain() });
    let others = [
        ProgramOptions { layers: Layer::ALL.to_vec(), ..plain() },
        ProgramOptions { schedule: Schedule::Fused, masks: RaySkipping::Off, ..plain() },
    ];
    schedules.into_iter().chain(purposes).chain(others).collect()
}

/// Returns the modules that the passes of a scene call, before functions that only pass on a value are inlined.
fn reached(scene: &Scene) -> BTreeSet<String> {
    let analysis = Analysis::of(scene);
    let mut reached = BTreeSet::new();
    for options in all_options() {
        let features = Features::of(scene, &options, &analysis);
        let parts = plan(scene, &analysis, &features).unwrap();
        let mut sources = Sources::of(&parts);
        sources.edit(|tokens, _| in_uniforms(tokens, &parts.lengths));
        sources.edit(folded);
        let (all, units) = with_region_copies(sources).unwrap();
        let by_name = index(&all, &units).unwrap();
        let declarations = features.passes().into_iter().flat_map(|pass| reach(&all, &by_name, pass.entry()).unwrap());
        let units = declarations.map(|i| &units[all[i].origin().unit]).filter(|unit| unit.author == Author::BuiltIn);
        reached.extend(units.map(|unit| unit.file.trim_end_matches(".wgsl").to_owned()));
    }
    reached
}

#[test]
fn every_part_is_linked() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut linked = BTreeSet::new();
    for path in files(&root.join("scenes"), "toml") {
        linked.extend(reached(&Scene::load(&path, &[]).unwrap()));
    }
    let media = MEDIA.map(|(method, medium)| {
        format!("rays.method = '{method}'\nobjects = [{{ shape = 'sphere', interior = {{ {medium} }} }}]")
    });
    for text in OTHERS.into_iter().chain(media.iter().map(String::as_str)) {
        let whole = BEGINNING.to_owned() + &text.replace("'F'", "'data/stars.png'");
        let scene = Scene::parse(&whole, &root.join("scenes/test.toml"), &[]);
        let own = reached(&scene.unwrap_or_else(|error| panic!("{error}")));
        assert!(!own.is_subset(&linked), "other scenes link all of this:\n{text}");
        linked.extend(own);
    }
    let all = all_parts().into_iter().map(|part| part.file.trim_end_matches(".wgsl"));
    let others: Vec<&str> = all.filter(|part| !linked.contains(*part)).collect();
    assert_eq!(others, TESTED.map(|(part, _)| part), "modules that no scene links");
    let tests: String =
        files(&root.join("tests"), "rs").iter().map(|path| std::fs::read_to_string(path).unwrap()).collect();
    for (part, test) in TESTED {
        assert!(tests.contains(&format!("#[test]\nfn {test}()")), "no test {test} links {part}");
    }
}
