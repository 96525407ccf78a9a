//! Tests of valid scenes: defaults, every kind, the templates, and the reference.

use super::{RAYS, good};
use crate::assets::Files;
use crate::document::Document;
use crate::document::reader::Reader;
use crate::model::camera::{Corners, Fisheye, Panorama, Pinhole};
use crate::model::control::{self, doubling, scaled};
use crate::model::falloff::Falloff;
use crate::model::law::{FlowOrder, Lorenz, RoundHole, Sources, Straight};
use crate::model::material::Phong;
use crate::model::method::{self, Method};
use crate::model::shape::Plane;
use crate::scene::check::scene;
use crate::scene::{
    Control, Light, LightSource, Observer, Pattern, REFERENCE, Scene, SceneError, Segment, Sky, Stereo, StereoLayout,
    TEMPLATES, reference_markdown,
};
use glam::{DVec2, DVec3};
use std::collections::BTreeSet;
use std::path::Path;

/// Scenes that together request every key.
pub(super) const KINDS: &[&str] = &[
    "[camera]\nkind = \"orthographic\"\nposition = [1, 2, 3]\nheight = 4\n[law]\nkind = \"lorenz\"\norder = 2\n[rays]\n\
     method = \"rk4-doubling\"\ndoubling = \"paper\"\nbounding_sphere = { radius = 1 }\nsegment = \"chord\"\nmax_parameter = 7\n",
    "[law]\nkind = \"rossler\"\n[rays]\nmethod = \"euler\"\nstep = 1\nbounding_sphere = { radius = 1, center = [1, 2, 3] }\n",
    "[law]\nkind = \"sources\"\n[[law.sources]]\nposition = [0, 0, 0]\nstrength = -1\nfalloff = { cubic = 2 }\n\
     [[law.sources]]\nposition = [0, 0, 1]\nstrength = 1\nfalloff = { yukawa = 3 }\ncapture_radius = 1\n[[law.sources]]\n\
     kind = \"line\"\ndirection = [0, 0, 2]\nposition = [0, 0, 0]\nstrength = 1\nfalloff = \"inverse-square\"\n[rays]\nbounding_sphere = { radius = 1 }\n",
    "[law]\nkind = \"medium\"\nindex = { kind = \"explosion\", radius = 1, amplitude = 0.2, frequency = 3 }\n[rays]\n\
     method = \"snell\"\nbounding_sphere = { radius = 1 }\n",
    "[camera]\nposition = [0, 0, 9]\nobserver = \"static\"\n[law]\nkind = \"schwarzschild\"\nmass = 2\n\
     [rays]\nbounding_sphere = { radius = 20 }\nmethod = \"euler-doubling\"\n",
    "[law]\nkind = \"metric\"\nline_element = \"-dt^2 + a*dx^2 + dy^2 + dz^2\"\nscale = \"1\"\ncapture_condition = \"r < 1\"\ntime = 2\n\
     rotate = [0, 0, 90]\ncenter = [1, 2, 3]\n[law.parameters]\na = 1\n[law.terms]\nb = \"2*a\"\n[rays]\nbounding_sphere = { radius = 20 }\n",
    "[law]\nkind = \"reissner-nordstrom\"\nmass = 2\n[rays]\nbounding_sphere = { radius = 20 }\n",
    "[camera]\nposition = [9, 0, 0]\n[law]\nkind = \"wormhole\"\nradius = 2\nlength = 0.5\nmass = 0.3\ncenter = [0, 0, 0]\nother_mouth = [99, 0, 0]\n\
     [rays]\nbounding_sphere = { radius = 20 }\n[sky]\n[sky.other_side]\nimage = \"sky.png\"\n",
    "[camera]\nposition = [9, 0, 0]\nobserver = \"boosted\"\nvelocity = [0, 0.5, 0]\n[law]\nkind = \"kerr-newman\"\nspin = 0.5\n[rays]\nbounding_sphere = { radius = 20 }\n\
     [materials.a]\nkind = \"blackbody\"\ntemperature = 3000\n[materials.b]\nkind = \"accretion\"\ntemperature = 3000\n",
    "[rays]\nbounding_sphere = { radius = 10 }\n[sky]\nimage = \"sky.png\"\n[materials.a]\ndiffuse = { image = \"sky.png\" }\n\
     [materials.b]\nkind = \"emissive\"\ncolor = { checker = [[1, 1, 1], [0, 0, 0]] }\n[[objects]]\nshape = \"box\"\n\
     material = \"b\"\nmin = [0, 0, 0]\nmax = [1, 2, 3]\n[[objects]]\nshape = \"plane\"\nmaterial = \"a\"\n\
     [[objects]]\nshape = \"cylinder\"\nmaterial = \"a\"\n[[objects]]\nshape = \"disk\"\nmaterial = \"a\"\n\
     [[objects]]\nshape = \"mesh\"\nmaterial = \"a\"\nfile = \"mesh.obj\"\n[[lights]]\nkind = \"directional\"\n\
     direction = [0, -2, 0]\n",
    "[rays]\nbounding_sphere = { radius = 10 }\n[[objects]]\nshape = \"sphere\"\ninterior = { kind = \"expression\", n = \"1 + x^2\" }\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"grid\", file = \"n.raw\", size = [2, 2, 2], type = \"u8\" }\n",
    "[rays]\nbounding_sphere = { radius = 10 }\n[[objects]]\nshape = \"sphere\"\ninterior = { kind = \"gaussian\", a = 1.4 }\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"inverse-r\" }\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"maxwell-fisheye\" }\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"rod\", n0 = 1.6, g = 0.3 }\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"linear\", gradient = [0, 0.1, 0] }\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"exponential\", delta = 0.1, height = 1 }\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"profile\", points = [[0, 1.2], [1, 1.1]] }\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"textured\", n = 1.5, amplitude = 0.2, frequency = 2 }\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"noise\", amplitude = 0.2, frequency = 2, octaves = 3 }\n\
     [[objects]]\nshape = \"box\"\ninterior = { kind = \"luneburg\", radius = 1, c = 3 }\n\
     [[objects]]\nshape = \"box\"\ninterior = { kind = \"constant\", n = 1.5 }\npriority = 1\n",
    "[camera]\nposition = [1, 2, 3]\nredshift = true\n[rays]\nbounding_sphere = { radius = 9 }\n",
    "[rays]\nbounding_sphere = { radius = 9 }\n[sky]\nstars = { file = \"none.csv\" }\n",
    "[camera]\nkind = \"fisheye\"\nposition = [1, 2, 3]\ncorners = \"transparent\"\n\
     stereo = { separation = 0.5, layout = \"top-bottom\", convergence = 3 }\n[rays]\nbounding_sphere = { radius = 1 }\n",
    "[rays]\nbounding_sphere = { radius = 9 }\n[[lights]]\nkind = \"point\"\nposition = [0, 0, 1]\nshadows = \"curved-rays\"\n\
     [[lights]]\nkind = \"point\"\nposition = [0, 0, 1]\nshadows = \"straight-rays\"\n\
     [[lights]]\nkind = \"point\"\nposition = [0, 0, 1]\nshadows = \"photon-grid\"\n",
    "[rays]\nbounding_sphere = { radius = 9 }\n[materials.m]\nkind = \"ray-splitter\"\nrays = [[\"dx\", \"dy\", \"dz\", \"1\"]]\n",
    "[law]\nkind = \"parametric\"\nx = \"t\"\ny = \"t\"\nz = \"t\"\nt = [0, 1]\n[rays]\nbounding_sphere = { radius = 1 }\n",
    "[law]\nkind = \"wgsl\"\nfile = \"law.wgsl\"\n[rays]\nbounding_sphere = { radius = 1 }\n",
    "[law]\nkind = \"straight\"\nabsorption = { transmittance = [1, 1, 1] }\n[rays]\nbounding_sphere = { radius = 9 }\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"constant\", n = 1.5, absorption = { texture = \"wrapped\", \
     frequency = 2, low = [0, 0, 0], high = [1, 1, 1] } }\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"constant\", n = 1.5, absorption = { texture = \"ramp\", \
     frequency = 2, ramp = \"none.png\", axis = [0, 1, 0] } }\n",
    "[units]\nlength = \"1 km\"\n[rays]\nbounding_sphere = { radius = 9 }\n[ambient]\nfloor = 0.2\n[materials.m]\nkind = \"glossy\"\nexponent = 9\n",
    "[rays]\nbounding_sphere = { radius = 9 }\nlighting = \"path-tracing\"\n[path_tracing]\nmax_depth = 2\n\
     [[objects]]\nshape = \"sphere\"\ninterior = { kind = \"sellmeier\", b = [1], c = [0.01] }\n",
    "[rays]\nbounding_sphere = { radius = 9 }\n[radiation]\nfrequencies = [1]\n[[volumes]]\nshape = \"sphere\"\nflow = { velocity = [0, 0, 0] }\n\
     source = { black_body = 1 }\n[[volumes]]\nshape = \"box\"\n\
     grids = { g = { file = \"g.raw\", size = [2, 2, 2], type = \"u8\", min = [0, 0, 0], max = [1, 1, 1] } }\n[[volumes]]\nshape = \"cylinder\"\n",
    "[rays]\nbounding_sphere = { radius = 1 }\n[animation]\nframes = 3\n[[animation.tracks]]\nkey = \"rays.bounding_sphere.radius\"\n\
     values = [1, 2]\n",
];

#[test]
fn the_reference_lists_the_keys_that_are_asked_for() {
    let mut asked = BTreeSet::new();
    for text in KINDS.iter().chain([&TEMPLATES[0].text]) {
        let document = Document::parse(text, Path::new("no folder/scene.toml"), &[]).expect("TOML");
        let reader = Reader::new(&document, &REFERENCE);
        scene(&reader, &mut Files::default());
        asked.extend(reader.asked());
    }
    let listed: BTreeSet<_> = REFERENCE.iter().map(|r| (r.table, r.key)).collect();
    let unlisted: Vec<_> = asked.difference(&listed).collect();
    let unasked: Vec<_> = listed.difference(&asked).collect();
    assert!(unlisted.is_empty() && unasked.is_empty(), "unlisted {unlisted:?}, not asked for {unasked:?}");
}

#[test]
fn the_reference_is_a_table_for_each_table() {
    let text = reference_markdown();
    assert!(text.starts_with("### Top level\n\n| key | value |"), "{text}");
    assert!(text.contains("\n\n### `[[objects]]`\n\n| key"), "{text}");
    assert!(text.contains("| `radius` | number above 0 | 1 | With shape = \"sphere\", \"cylinder\" or"), "{text}");
}

#[test]
fn the_templates_parse() {
    for template in TEMPLATES {
        let scene = good(template.text);
        assert!(scene.camera.is_some() && !scene.objects.is_empty(), "{}", template.name);
        assert!(template.text.starts_with("# A scene for bentray: "), "{}", template.name);
    }
    let usual = TEMPLATES[0].text;
    assert!(good(usual).law.downcast::<RoundHole>().is_some());
    for line in usual.lines().filter(|l| !l.is_empty() && !l.starts_with('[')) {
        assert!(line.contains('#'), "no comment: {line}");
    }
}

#[test]
fn little_is_needed() {
    let scene = good(RAYS);
    assert_eq!((scene.image.size, scene.image.samples), ([800, 600], 1));
    assert!(scene.camera.is_none());
    assert_eq!(scene.law.downcast(), Some(&Straight));
    assert_eq!((scene.rays.method, scene.rays.control), (method::CLOSED_FORMS, control::exact::CONTROL));
    assert_eq!(scene.rays.segment, Segment::Arc { tolerance: 1e-3 });
    assert_eq!((scene.rays.max_segments, scene.rays.max_parameter), (1000, None));
    assert_eq!(scene.sky, Sky::Color(DVec3::ZERO));
    assert_eq!(scene.output.bits, 8);
}

#[test]
fn a_camera_has_orthonormal_axes() {
    let scene = good(&format!("{RAYS}[camera]\nposition = [0, 3, 4]\nlook_at = [0, 3, 0]"));
    let camera = scene.camera.expect("a camera");
    assert_eq!(camera.forward, -DVec3::Z);
    assert_eq!(camera.right, DVec3::X);
    assert_eq!(camera.up, DVec3::Y);
    assert_eq!(camera.projection.downcast(), Some(&Pinhole { fov: 50.0 }));
    assert_eq!(camera.observer, Observer::Coordinate);
    let scene = good(&format!("{RAYS}[camera]\nposition = [1, 3, 4]\nup = [3, 1, 0]"));
    let camera = scene.camera.expect("a camera");
    let axes = glam::DMat3::from_cols(camera.right, camera.up, -camera.forward);
    assert!((axes.transpose() * axes).abs_diff_eq(glam::DMat3::IDENTITY, 1e-12));
    assert!(axes.determinant() > 0.0);
}

#[test]
fn cameras_become_values() {
    let camera = |text: &str| good(&format!("{RAYS}[camera]\nposition = [0, 0, 5]\n{text}")).camera.expect("a camera");
    let black = Corners::Black;
    let projection = |text: &str| camera(text).projection;
    let plain = projection("kind = \"fisheye\"");
    assert_eq!(plain.downcast(), Some(&Fisheye { fov: 180.0, corners: black }));
    let around = projection("kind = \"fisheye\"\nfov = 3600\ncorners = \"transparent\"");
    assert_eq!(around.downcast(), Some(&Fisheye { fov: 3600.0, corners: Corners::Transparent }));
    assert!(around.is_transparent() && !plain.is_transparent());
    assert_eq!(projection("kind = \"panorama\"").downcast(), Some(&Panorama { fov: [360.0, 180.0] }));
    let part = projection("kind = \"panorama\"\nfov = [90, 45.5]");
    assert_eq!(part.downcast(), Some(&Panorama { fov: [90.0, 45.5] }));
    let one = camera("");
    assert_eq!((one.eyes(), one.view_size([9, 5]), one.stereo), (vec![DVec3::Z * 5.0], [9, 5], None));
    let beside = camera("stereo = { separation = 0.5 }");
    let layout = StereoLayout::SideBySide;
    assert_eq!(beside.stereo, Some(Stereo { separation: 0.5, layout, convergence: None }));
    assert_eq!(beside.eyes(), [DVec3::new(-0.25, 0.0, 5.0), DVec3::new(0.25, 0.0, 5.0)]);
    assert_eq!(beside.view_size([8, 6]), [4, 6]);
    let stacked = camera("stereo = { separation = 1, layout = \"top-bottom\", convergence = 3 }");
    assert_eq!(stacked.stereo.and_then(|stereo| stereo.convergence), Some(3.0));
    assert_eq!(stacked.view_size([8, 6]), [8, 3]);
}

/// Checks the angle of the center pixel against closed forms: a tangent over half the height, and equal fractions of the other angles.
#[test]
fn pixels_have_angles() {
    let angle = |text: &str| {
        let text = format!("{RAYS}[image]\nsize = [80, 20]\n[camera]\nposition = [0, 0, 5]\n{text}");
        good(&text).pixel_angle().map(f64::to_degrees)
    };
    let near = |text: &str, want: f64| assert!((angle(text).expect(text) - want).abs() < 1e-12, "{text}");
    let height = |degrees: f64| (degrees.to_radians().tan() * 2.0).to_degrees();
    near("fov = 60", height(30.0) / 20.0);
    near("fov = 60\nstereo = { separation = 1, layout = \"top-bottom\" }", height(30.0) / 10.0);
    near("kind = \"fisheye\"\nfov = 720", 36.0);
    near("kind = \"panorama\"", 4.5);
    near("kind = \"panorama\"\nfov = [360, 40]", 2.0);
    near("kind = \"panorama\"\nfov = [80, 180]\nstereo = { separation = 1 }", 2.0);
    assert_eq!(angle("kind = \"orthographic\"\nheight = 2"), None);
}

fn method_from(name: &str) -> Method {
    Method { kind: method::METHODS.into_iter().find(|kind| kind.name == name).expect(name), own: 0.0 }
}

#[test]
fn laws_and_methods_become_values() {
    let scene = good(KINDS[0]);
    let order = FlowOrder::Acceleration;
    assert_eq!(scene.law.downcast(), Some(&Lorenz { sigma: 10.0, rho: 28.0, beta: 8.0 / 3.0, order }));
    assert_eq!(scene.rays.method, method_from("rk4"));
    let Control { kind, setting, grow_below, cap } = scene.rays.control;
    assert_eq!((kind.name, setting, cap), (doubling::PAPER.name, 1e-5, 0.3));
    assert!((grow_below - 1e-6).abs() < 1e-18);
    assert_eq!(scene.rays.segment, Segment::Chord { steps: 10 });
    assert_eq!(scene.rays.max_parameter, Some(7.0));
    let scene = good(KINDS[1]);
    assert_eq!(scene.rays.control, Control::new(&control::fixed::KIND, 1.0, 0.5));
    assert_eq!(scene.rays.bounding_sphere.center, DVec3::new(1.0, 2.0, 3.0));
    let law = good(KINDS[2]).law;
    let Sources(sources) = law.downcast().expect("sources");
    assert_eq!(Some(sources[0].falloff), Falloff::named("cubic", 2.0));
    assert_eq!(Some(sources[1].falloff), Falloff::named("yukawa", 3.0));
    assert_eq!(sources[2].falloff, Falloff::INVERSE_SQUARE);
    assert_eq!((sources[0].strength, sources[1].capture, sources[2].capture), (-1.0, 1.0, 0.0));
    let scene = good(KINDS[3]);
    assert_eq!(scene.rays.method, Method { own: 0.001, ..method_from("snell") });
    assert_eq!(scene.rays.control, scaled::with(0.1));
    assert_eq!(good(KINDS[4]).camera.expect("a camera").observer, Observer::Static);
}

#[test]
fn shapes_go_where_their_keys_say() {
    let scene = good(
        "[rays]\nbounding_sphere = { radius = 100 }\n[materials.a]\n[materials.b]\ndiffuse = { checker = [[1, 1, 1], [0, 0, 0]] }\n\
         [[objects]]\nshape = \"sphere\"\nmaterial = \"b\"\ncenter = [1, 0, 0]\nradius = 2\nscale = 3\nrotate = [0, 0, 90]\n\
         translate = [0, 0, 5]\n[[objects]]\nshape = \"box\"\nmaterial = \"a\"\nmin = [1, 2, 3]\nmax = [2, 4, 6]\n\
         [[objects]]\nshape = \"plane\"\nmaterial = \"a\"\nnormal = [0, 0, -3]\nsize = [2, 4]\ncenter = [0, 0, 1]\n\
         [[objects]]\nshape = \"plane\"\nmaterial = \"a\"\n[[lights]]\nkind = \"directional\"\ndirection = [0, -2, 0]\n",
    );
    let map = |i: usize, p: [f64; 3]| scene.objects[i].transform.0.transform_point3(p.into());
    let near = |a: DVec3, b: [f64; 3]| assert!(a.abs_diff_eq(b.into(), 1e-12), "{a} {b:?}");
    near(map(0, [0.0; 3]), [0.0, 3.0, 5.0]);
    near(map(0, [1.0, 0.0, 0.0]), [0.0, 9.0, 5.0]);
    near(map(1, [-1.0; 3]), [1.0, 2.0, 3.0]);
    near(map(1, [1.0; 3]), [2.0, 4.0, 6.0]);
    near(map(2, [0.0, 1.0, 0.0]), [0.0, 0.0, 0.0]);
    near(map(3, [1.0, 0.0, -1.0]), [100.0, 0.0, -100.0]);
    assert!(scene.objects[2].shape.downcast::<Plane>().is_some());
    assert_eq!((scene.objects[0].material(), scene.objects[1].material()), (Some(1), Some(0)));
    assert_eq!(scene.materials[0].color, Pattern::Constant(DVec3::splat(0.8)));
    let colors = [DVec3::ONE, DVec3::ZERO];
    assert_eq!(scene.materials[1].color, Pattern::Checker { colors, repeat: DVec2::splat(8.0) });
    assert!(matches!(scene.materials[0].surface.downcast(), Some(Phong { ambient: 0.1, .. })));
    let sun = LightSource::Directional(-DVec3::Y);
    assert_eq!(scene.lights[0], Light::new(sun));
}

#[test]
fn a_scene_that_cannot_be_read_is_an_error() {
    let error = Scene::load(Path::new("nowhere/scene.toml"), &[]).expect_err("no such file");
    assert!(matches!(error, SceneError::Read { .. }));
    assert!(error.to_string().starts_with("cannot read `nowhere/scene.toml`: "));
}
