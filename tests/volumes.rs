//! Tests the light of volumes against closed forms and integrals of high order, and its invariants.

use std::collections::BTreeMap;

use bentray::program::{Layer, Mode, ProgramOptions, Schedule};
use bentray::render::{
    Plane, RenderSettings, Renderer, Rendering, Starts, Totals, Tracer, Transferred, frequency_reports,
};
use bentray::scene::Scene;

use crate::oracle::{rows, vector};
use crate::support::{assert_same_image, gpu, scene};

/// The matter of a row of the table, with the law in front of `[radiation]`.
fn matter(name: &str) -> String {
    let frequencies = |text: &str| format!("[radiation]\nfrequencies = {text}\ntolerance = 1e-5\n[[volumes]]\n");
    let black = "[rays]\nbounding_sphere = { radius = 300 }\n";
    let schwarzschild =
        "[law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = { radius = 1100 }\nmethod = \"planar\"\n";
    let kerr = |spin: f64| {
        format!(
            "[law]\nkind = \"kerr-newman\"\nspin = {spin}\n[rays]\nbounding_sphere = {{ radius = 1100 }}\nmethod = \"separated\"\n"
        )
    };
    let (before, channels, volume) = match name {
        "flat01" => {
            (black.into(), "[1.0]", "shape = \"sphere\"\ncenter = [0.5, -0.3, 0.2]\nradius = 2\nemission = 1.3")
        }
        "flat02" => (
            black.into(),
            "[0.1, 0.5, 1.0, 4.0]",
            "shape = \"box\"\nsize = [100, 100, 1]\nemission = \"2.1*nu^-0.5\"\nabsorption = \"3*nu^-3\"",
        ),
        "flat03" => (
            black.into(),
            "[1.0]",
            "shape = \"sphere\"\nradius = 3\ndensity = \"exp(-r^2/0.72)\"\nemission = \"2*n\"\nabsorption = 1.5",
        ),
        "flat04" => (
            black.into(),
            "[0.4, 1.0, 3.0]",
            "shape = \"sphere\"\nradius = 5\ndensity = \"(1 + r^2/0.64)^-1.5\"\nemission = \"n*nu^-0.7\"\nabsorption = \"0.9*n*nu^-2\"",
        ),
        "flat05" => (
            black.into(),
            "[1.0]",
            "shape = \"box\"\ncenter = [0, 7, 0]\nsize = [400, 14, 400]\ndensity = \"exp(-(y + 7)/0.7)\"\n\
             emission = \"2*n*(0.5 + 0.3*1.4*n)\"\nabsorption = \"2*n\"",
        ),
        "flat06" => (
            format!("[sky]\ncolor = [0.5, 0.5, 0.5]\n{black}"),
            "[0.5, 1.0, 2.0]",
            "shape = \"sphere\"\nemission = \"1/nu\"\nabsorption = \"0.7*nu^-2\"\n[[volumes]]\nshape = \"sphere\"\n\
             center = [1.2, 0.3, 0]\nradius = 0.8\nemission = 0.2\nabsorption = \"2.5/nu\"",
        ),
        "flat07" => (
            black.into(),
            "[0.1, 0.3, 1.0, 3.0, 10.0]",
            "shape = \"sphere\"\nemission = \"nu^-0.6\"\nabsorption = \"2*nu^-3.1\"",
        ),
        "flat08" => (
            format!(
                "[law]\nkind = \"medium\"\nindex = {{ kind = \"linear\", n0 = 1.2, gradient = [0, 0.25, 0] }}\n{black}"
            ),
            "[1.0]",
            "shape = \"sphere\"\ncenter = [3, 0.5, 0]\nradius = 1.5\nemission = \"1 + 0.2*x\"\nabsorption = 0.3",
        ),
        "flat09" => (
            format!("[[objects]]\nshape = \"sphere\"\ninterior = {{ kind = \"luneburg\" }}\n{black}"),
            "[1.0]",
            "shape = \"sphere\"\nemission = \"1 - 0.5*r^2\"\nabsorption = \"0.6 + 0.4*x\"",
        ),
        "shift01" => (
            black.into(),
            "[0.5, 1.0, 2.0]",
            "shape = \"box\"\nsize = [2, 2, 2]\nflow = { velocity = [0.5, 0, 0] }\nemission = \"1/nu\"\nabsorption = \"0.4/nu^2\"",
        ),
        "shift03" => (
            schwarzschild.into(),
            "[0.5, 1.0, 2.0]",
            "density = \"exp(-(r - 6)^2/0.5)\"\nemission = \"n/nu\"\nabsorption = \"0.8*n*nu^-2.5\"",
        ),
        "shift04" => (
            schwarzschild.into(),
            "[1.0]",
            "flow = \"infalling\"\ndensity = \"r^-1.5*exp(-(r/12)^4)\"\nemission = \"n*nu^-0.7\"",
        ),
        "shift05" => (
            kerr(0.9),
            "[0.5, 1.0, 2.0]",
            "flow = { angular_velocity = 0.04 }\ndensity = \"exp(-((r*sin(theta) - 8)^2 + (r*cos(theta))^2)/1.28)\"\n\
             emission = \"n/nu\"\nabsorption = \"0.3*n/nu^2\"",
        ),
        "shift06" => (
            kerr(0.95),
            "[1.0]",
            "flow = \"zamo\"\ndensity = \"exp(-((r - 3)^2/0.64 + (r*cos(theta))^2)/2)*(1 - 1.31224989991992/r)^2\"\nemission = \"n*nu\"",
        ),
        "shift07" => (
            kerr(0.9),
            "[0.1, 1.0, 10.0]",
            "flow = { angular_momentum = \"R^1.5/(1 + R)\" }\nterms = { R = \"r*sin(theta)\" }\n\
             density = \"exp(-((r/10)^2 + (10/3*cos(theta))^2)/2)\"\nemission = \"n*nu^-0.7\"",
        ),
        "shift08" => (
            schwarzschild.into(),
            "[0.5, 1.0, 4.0]",
            "shape = \"sphere\"\nradius = 7\ndensity = \"max(0, min(1, 1e9*(r - 6)))\"\nsource = { black_body = 2 }\nabsorption = 1e5",
        ),
        name => return kerr(torus(name)[0]) + &frequencies("[1.0]") + &torus_matter(name),
    };
    before + &frequencies(channels) + volume
}

/// The spin, A, q, h and l₀ of a problem of Gold et al. (2020), with A per unit length.
fn torus(name: &str) -> [f64; 5] {
    match name {
        "torus01" => [0.9, 0.0, -3.0, 0.0, 0.0],
        "torus02" => [0.0, 0.0, -2.0, 0.0, 1.0],
        "torus03" => [0.9, 0.0, 0.0, 10.0 / 3.0, 1.0],
        "torus04" => [0.9, 0.18, 0.0, 10.0 / 3.0, 1.0],
        _ => [0.9, 1.8, 0.0, 100.0 / 3.0, 1.0],
    }
}

fn torus_matter(name: &str) -> String {
    let [_, absorption, q, h, l0] = torus(name);
    format!(
        "shape = \"sphere\"\nradius = 60\ndensity = \"exp(-((r/10)^2 + (h*cos(theta))^2)/2)\"\n\
         flow = {{ angular_momentum = \"l0*R^1.5/(1 + R)\" }}\nterms = {{ R = \"r*sin(theta)\" }}\n\
         emission = \"n*nu^-q\"\nabsorption = \"A*n*nu^-(2.5 + q)\"\n\
         parameters = {{ h = {h}, l0 = {l0}, q = {q:?}, A = {absorption} }}\n"
    )
}

fn lights(scene: &Scene, rays: &[[f64; 6]]) -> Vec<Vec<Transferred>> {
    let (lights, totals) = lights_of(scene, rays);
    assert_eq!((totals.unsettled, totals.undefined), (0, 0), "{totals}");
    lights
}

pub fn lights_of(scene: &Scene, rays: &[[f64; 6]]) -> (Vec<Vec<Transferred>>, Totals) {
    let gpu = gpu();
    let mut tracer = Tracer::new(&gpu, scene, RenderSettings::default(), Mode::Trace).unwrap();
    let (_, totals) = tracer.follow(Starts::Given(rays)).unwrap();
    (tracer.spectra().to_vec(), totals)
}

/// The bound is 1e-4, and ten times the effect of one rounding of the ray.
#[test]
fn rays_shine_as_integrals_of_high_order_state() {
    let table = rows(include_str!("tables/radiation.tsv"));
    let mut groups: BTreeMap<&str, Vec<&Vec<&str>>> = BTreeMap::new();
    for row in &table {
        groups.entry(row[0]).or_default().push(row);
    }
    let numbers = |text: &str| -> Vec<f64> { text.split(' ').map(|word| word.parse().unwrap_or(f64::NAN)).collect() };
    for (name, members) in groups {
        let rays: Vec<[f64; 6]> = members
            .iter()
            .map(|row| {
                let (x, v) = (vector(row[1]), vector(row[2]));
                [x.x, x.y, x.z, v.x, v.y, v.z]
            })
            .collect();
        let brightest = members.iter().flat_map(|row| numbers(row[3])).fold(0.0, f64::max);
        for (row, found) in members.iter().zip(lights(&scene(&matter(name)), &rays)) {
            let (expected, depths) = (numbers(row[3]), numbers(row[4]));
            assert_eq!(found.len(), expected.len(), "{name}");
            let bound = 1e-4 + 10.0 * row[5].parse::<f64>().unwrap();
            for (k, light) in found.iter().enumerate() {
                let off = (light.intensity - expected[k]).abs();
                assert!(off < bound * expected[k] + 1e-6 * brightest, "{name} {}: {light:?} {}", row[1], expected[k]);
                let deep = (light.optical_depth - depths[k]).abs();
                let is_known = !depths[k].is_nan();
                assert!(
                    !is_known || deep < 3.0 * bound * depths[k] + 1e-6,
                    "{name} {}: {light:?} {}",
                    row[1],
                    depths[k]
                );
            }
        }
    }
}

pub fn picture(text: &str, schedule: Schedule) -> Rendering {
    let options = ProgramOptions { schedule, layers: vec![Layer::Intensity(0)], ..ProgramOptions::default() };
    Renderer::new(&gpu(), &scene(text), RenderSettings { options, ..RenderSettings::default() })
        .unwrap()
        .render()
        .unwrap()
}

pub fn intensities(found: &Rendering) -> &[f32] {
    let Some(Plane::Scalar(values)) = found.band.layer(Layer::Intensity(0)) else { panic!("no intensity") };
    values
}

pub const EYE: &str = "[camera]\nposition = [40, 3, 9]\nup = [0, 0, 1]\nfov = 40\nobserver = \"static\"\n";

/// Tolman: matter at rest with the temperature `T₀/√(−g_tt)` is in equilibrium. Where it is opaque, a static observer sees one black body.
#[test]
fn matter_in_equilibrium_shows_no_picture() {
    let text = format!(
        "[image]\nsize = [24, 16]\n{EYE}[law]\nkind = \"schwarzschild\"\n[rays]\nbounding_sphere = {{ radius = 100 }}\nmethod = \"planar\"\n\
         [radiation]\nfrequencies = [1.0]\n[[volumes]]\nshape = \"sphere\"\nradius = 30\n\
         source = {{ black_body = \"2/sqrt(1 - 2/r)\" }}\nabsorption = \"100*(1 + r)\"\n"
    );
    let clock = (1.0 - 2.0 / (40.0_f64.powi(2) + 9.0 + 81.0).sqrt()).sqrt();
    let expected = 1.0 / ((clock / 2.0).exp() - 1.0);
    let found = picture(&text, Schedule::Whole);
    for (i, light) in intensities(&found).iter().enumerate().filter(|(_, light)| **light > 0.0) {
        assert!((f64::from(*light) / expected - 1.0).abs() < 1e-4, "{i}: {light} {expected}");
    }
    assert!(intensities(&found).iter().filter(|light| **light > 0.0).count() > 200);
}

/// The flux of the first problem of Gold et al. (2020), in janskys: 1.658774 through the centers of 128 × 128 pixels.
#[test]
fn the_flux_of_a_torus_is_that_of_the_literature() {
    let kerr = matter("torus01").replace("tolerance = 1e-5", "").replace("[1.0]", "[\"230 GHz\"]\nemission = 3e-18");
    let text = format!(
        "units = {{ length = \"6e9 m\", distance = \"2.4e20 m\" }}\n[image]\nsize = [128, 128]\n[camera]\n\
         position = [866.0254037844386, 0, 500]\nup = [0, 0, 1]\nfov = 1.7187446\nobserver = \"static\"\n{kerr}"
    );
    let scene = scene(&text);
    let found = Renderer::new(&gpu(), &scene, RenderSettings::default()).unwrap().render().unwrap();
    let report = frequency_reports(&scene, &found.totals.radiation)[0];
    assert!((report.flux_jy.unwrap() / 1.658_774 - 1.0).abs() < 2e-4, "{report:?}");
    assert_eq!(report.frequency_hz, Some(230e9));
}

#[test]
fn schedules_and_halves_of_a_volume_agree() {
    let of = |method: &str, volumes: &str| {
        format!(
            "[image]\nsize = [32, 24]\n{EYE}[law]\nkind = \"kerr-newman\"\nspin = 0.7\n[rays]\nbounding_sphere = {{ radius = 100 }}\n\
             {method}[radiation]\nfrequencies = [1.0]\n{volumes}"
        )
    };
    let matter = "density = \"exp(-((r - 8)/2)^2)\"\nemission = \"n/nu\"\nabsorption = 0.3\nflow = { angular_velocity = 0.03 }\n";
    let general = "method = \"dormand-prince\"\ntolerance = 1e-6\n";
    let whole = of(general, &format!("[[volumes]]\nshape = \"box\"\ncenter = [10, 0, 0]\nsize = [6, 8, 6]\n{matter}"));
    let halves = of(
        general,
        &format!(
            "[[volumes]]\nshape = \"box\"\ncenter = [8.5, 0, 0]\nsize = [3, 8, 6]\n{matter}\
         [[volumes]]\nshape = \"box\"\ncenter = [11.5, 0, 0]\nsize = [3, 8, 6]\n{matter}"
        ),
    );
    let first = picture(&whole, Schedule::Whole);
    let separated = of("method = \"separated\"\n", &format!("[[volumes]]\n{matter}"));
    for (text, first) in [(&whole, &first), (&separated, &picture(&separated, Schedule::Whole))] {
        for schedule in [Schedule::Fused, Schedule::Segment] {
            assert_same_image(&picture(text, schedule), first, &format!("{schedule:?}"));
        }
    }
    let brightest = intensities(&first).iter().copied().fold(0.0, f32::max);
    assert!(brightest > 0.1);
    for (one, two) in intensities(&first).iter().zip(intensities(&picture(&halves, Schedule::Whole))) {
        assert!((one - two).abs() < 3e-4 * brightest, "{one} {two}");
    }
}

#[test]
fn impossible_matter_is_counted_and_black() {
    let text = format!(
        "[image]\nsize = [16, 12]\n{EYE}[law]\nkind = \"kerr-newman\"\n[rays]\nbounding_sphere = {{ radius = 100 }}\nmethod = \"separated\"\n\
         [radiation]\nfrequencies = [1.0]\n[[volumes]]\nshape = \"sphere\"\nradius = 20\nflow = {{ angular_velocity = 0.2 }}\nemission = 1\n"
    );
    let found = picture(&text, Schedule::Whole);
    let black = intensities(&found).iter().filter(|light| **light == 0.0).count() as u64;
    assert!(found.totals.undefined > 10 && black >= found.totals.undefined, "{}", found.totals);
}

#[test]
fn wrong_volumes_are_explained() {
    let head = "[rays]\nbounding_sphere = { radius = 20 }\n";
    for (text, problem, help) in [
        ("[[volumes]]\nemission = \"n*nu\"\n", "`nu` requires the frequencies of light", "add [radiation]"),
        ("[[volumes]]\ndensity = \"exp(-q)\"\nemission = 1\n", "unknown name `q`", ""),
        ("[[volumes]]\nemission = -1\n", "expected a coefficient of 0 or above, found -1", ""),
        ("[[volumes]]\nshape = \"disk\"\nemission = 1\n", "unknown value `disk`", "sphere"),
        ("[[volumes]]\nflow = \"zamo\"\nemission = 1\n", "matter cannot move so under this law", ""),
        ("[radiation]\nfrequencies = [1.0]\n", "`radiation` requires matter that emits light", "add [[volumes]]"),
        (
            "[radiation]\nfrequencies = [1.0, \"3 GHz\"]\n[[volumes]]\nemission = 1\n",
            "frequencies with and without units",
            "",
        ),
        ("[radiation]\nfrequencies = [-1.0]\n[[volumes]]\nemission = 1\n", "expected a number above 0, found -1", ""),
        (
            "[radiation]\nfrequencies = [1.0]\n[[volumes]]\nemission = [1, 2, 3]\n",
            "coefficients have no color channels",
            "write one formula",
        ),
    ] {
        let scene = Scene::parse(&format!("{head}{text}"), "scene.toml".as_ref(), &[]);
        let said = scene.expect_err(text).to_string();
        assert!(said.contains(problem) && said.contains(help) && said.contains("scene.toml:"), "{text}{said}");
    }
}
