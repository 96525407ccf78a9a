//! The shooting method against closed forms, against straight shadows, and its two variants against each other.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use bentray::measure::calibrate_paths;
use bentray::render::{LightPath, RenderSettings, Renderer, light_paths};
use glam::DVec3;

use crate::shaders::Random;
use crate::support::{gpu, scene};

fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace().map(|word| word.parse().unwrap()).collect()
}

fn apart(path: &LightPath, leaves: DVec3) -> f64 {
    DVec3::from(path.leaves).distance(leaves)
}

/// Checks all images of a light in 32 bits: directions to 1e-5, and the spread of the ray bundle to 1e-3.
#[test]
fn paths_are_where_closed_forms_say() {
    let gpu = gpu();
    for row in include_str!("tables/light_paths.tsv").lines().filter(|line| !line.starts_with('#')) {
        let fields: Vec<&str> = row.split('\t').collect();
        let law = fields[1].replace(';', "\n");
        let text =
            format!("[law]\n{law}\n[rays]\nbounding_sphere = {{ radius = {} }}\nmax_segments = 3000\n", fields[2]);
        let [light, place] = [3, 4].map(|k: usize| DVec3::from_slice(&numbers(fields[k])));
        let scene = scene(&text);
        let (found, totals) = light_paths(&gpu, &scene, &RenderSettings::default(), &[[place, light]]).unwrap();
        assert_eq!(totals.unfollowed(), 0, "{}", fields[0]);
        let images: Vec<_> = fields[5].split(';').map(numbers).filter(|image| !image.is_empty()).collect();
        assert!(found[0].len() >= images.len(), "{}: {:?}", fields[0], found[0]);
        for image in images {
            let (leaves, back) = (DVec3::from_slice(&image[..3]), DVec3::from_slice(&image[3..6]));
            let near = found[0].iter().min_by(|a, b| apart(a, leaves).total_cmp(&apart(b, leaves))).unwrap();
            let off = apart(near, leaves).max(DVec3::from(near.arrives).distance(-back));
            assert!(off < 1e-5, "{}: {off:e}", fields[0]);
            assert!((near.spread / image[6] - 1.0).abs() < 1e-3, "{}: {} for {}", fields[0], near.spread, image[6]);
            assert!(near.clear);
        }
    }
}

const CENTRE: &str = "[[law.sources]]\nposition = [0, 2, 0]\nstrength = 0.6\ncapture_radius = 0.1\n";
const HARDLY: &str = "[[law.sources]]\nposition = [0, -30, 0]\nstrength = 1e-9\n";

/// A scene with a wall behind a center and a ball in front.
fn lit(law: &str, shadows: &str, falloff: &str) -> String {
    format!(
        "[image]\nsize = [64, 48]\n[camera]\nposition = [0, 8, 20]\nlook_at = [0, 0, 0]\nfov = 50\n[law]\n{law}\n\
         [rays]\nbounding_sphere = {{ radius = 60 }}\n{}\n[materials.wall]\ndiffuse = [1, 1, 1]\nspecular = [0, 0, 0]\nambient = 0\n\
         [[objects]]\nshape = \"plane\"\ncenter = [0, -3, 0]\nsize = [40, 40]\nmaterial = \"wall\"\n\
         [[objects]]\nshape = \"sphere\"\ncenter = [3, 0, 3]\nradius = 1.2\nmaterial = \"wall\"\n\
         [[lights]]\nkind = \"point\"\nposition = [4, 12, 5]\nshadows = \"{shadows}\"\nfalloff = \"{falloff}\"\ncolor = [150, 150, 150]\n",
        if law.contains("straight") { "" } else { "tolerance = 1e-6" },
    )
}

fn picture(text: &str) -> Vec<f64> {
    let scene = scene(text);
    let rendered = Renderer::new(&gpu(), &scene, RenderSettings::default()).unwrap().render().unwrap();
    assert_eq!(rendered.totals.unfollowed(), 0, "{}", rendered.totals);
    rendered.band.color[0].iter().map(|value| f64::from(*value)).collect()
}

/// Returns the fraction of the pixels in which two images agree to a fraction `part` of their brightness.
fn alike(a: &[f64], b: &[f64], part: f64) -> f64 {
    let same = a.iter().zip(b).filter(|(a, b)| (**a - **b).abs() <= part * (a.abs() + b.abs()) + 1e-5).count();
    same as f64 / a.len() as f64
}

/// In straight light the shooting method finds straight shadows and inverse-square falloff.
#[test]
fn straight_light_is_shot_straight() {
    for falloff in ["none", "inverse-square"] {
        let [straight, shot] =
            ["straight-rays", "curved-rays"].map(|shadows| picture(&lit("kind = \"straight\"", shadows, falloff)));
        let part = alike(&straight, &shot, 2e-3);
        assert!(part > 0.99, "{falloff}: {part}");
    }
}

/// Around one center the search in a plane agrees with Newton's method, which is used because of a second center without strength.
#[test]
fn both_ways_to_shoot_agree() {
    let law = |sources: &[&str]| {
        let mut law = String::from("kind = \"sources\"\n");
        for source in sources {
            write!(law, "{source}").unwrap();
        }
        law
    };
    let one = picture(&lit(&law(&[CENTRE]), "curved-rays", "inverse-square"));
    let two = picture(&lit(&law(&[CENTRE, HARDLY]), "curved-rays", "inverse-square"));
    let part = alike(&one, &two, 2e-2);
    assert!(part > 0.95, "{part}");
    let straight = picture(&lit(&law(&[CENTRE]), "straight-rays", "inverse-square"));
    assert!(alike(&one, &straight, 2e-2) < 0.7);
}

/// Returns the directions at the light and at the position of the logarithmic spiral between two positions around the
/// origin if n = k/r: the angle to the radius is constant. The spiral takes the short or the long way.
fn spiral(light: DVec3, place: DVec3, long: bool) -> [DVec3; 2] {
    let (radial, at_place) = (light.normalize(), place.normalize());
    let normal = radial.cross(at_place).normalize() * if long { -1.0 } else { 1.0 };
    let between = radial.angle_between(at_place);
    let turn = if long { TAU - between } else { between };
    let to_radius = turn.atan2((place.length() / light.length()).ln());
    [radial, at_place].map(|radial| to_radius.cos() * radial + to_radius.sin() * normal.cross(radial))
}

/// Paths from `auto` have the requested accuracy, and the reported error is correct: in 32 and in 64 bits.
#[test]
fn paths_are_as_accurate_as_is_asked_for() {
    let gpu = gpu();
    let mut random = Random::new(77);
    let mut place = || random.direction() * random.within(0.7, 3.0);
    let pairs: Vec<[DVec3; 2]> = (0..12).map(|_| [place(), place()]).collect();
    for (accuracy, bits) in [(1e-4, 32), (1e-6, 64), (1e-9, 64)] {
        let scene = scene(&format!(
            "[law]\nkind = \"medium\"\nindex = {{ kind = \"inverse-r\", k = 3 }}\n\
             [rays]\nmethod = \"auto\"\naccuracy = {accuracy:e}\nprecision = \"f{bits}\"\nbounding_sphere = {{ radius = 20 }}\nmax_segments = 9000\n",
        ));
        let (found, mut renderer) = calibrate_paths(&gpu, &scene, &RenderSettings::default(), &pairs).unwrap().unwrap();
        assert!(found.chosen.error <= accuracy, "{found}");
        let (paths, _) = renderer.paths_between(&pairs).unwrap();
        for ([place, light], paths) in pairs.iter().zip(&paths) {
            // Light that starts inward is captured.
            let outward = |[leaves, _]: &[DVec3; 2]| leaves.dot(*light) > 0.0;
            for [leaves, arrives] in
                [false, true].map(|long| spiral(*light, *place, long)).iter().filter(|s| outward(s))
            {
                let near = paths.iter().min_by(|a, b| apart(a, *leaves).total_cmp(&apart(b, *leaves))).unwrap();
                let off = apart(near, *leaves).max(arrives.distance(near.arrives.into()));
                assert!(off < accuracy, "{accuracy:e}, {light} to {place}: {off:e}; {found}");
            }
        }
    }
}

/// If n² grows linearly two parabolas join two positions: one starts toward the side from which light returns.
#[test]
fn light_that_comes_back_is_found() {
    let (light, place, gradient) = (DVec3::new(0.2, 0.1, 0.0), DVec3::new(1.5, -0.8, 0.6), DVec3::new(0.3, -0.6, 0.1));
    let (way, pull, start) = (place - light, gradient / 4.0, 1.5 * 1.5 + gradient.dot(light));
    let scene = scene(
        "[law]\nkind = \"medium\"\nindex = { kind = \"linear\", n0 = 1.5, gradient = [0.3, -0.6, 0.1] }\n\
         [rays]\nbounding_sphere = { radius = 60 }\nmax_segments = 3000\n",
    );
    let (found, _) = light_paths(&gpu(), &scene, &RenderSettings::default(), &[[place, light]]).unwrap();
    // |way − pull T²|² = n² T², because T is the time of flight.
    let half = pull.length_squared().recip() * (way.dot(pull) + 0.5 * start);
    let root = (half * half - way.length_squared() / pull.length_squared()).sqrt();
    for square in [half - root, half + root] {
        let leaves = (way - pull * square).normalize();
        assert!(found[0].iter().any(|path| apart(path, leaves) < 1e-4), "{leaves}: {found:?}");
    }
}
