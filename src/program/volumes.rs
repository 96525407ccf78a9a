//! The scene's volumes as WGSL: where matter is, how it moves, and how it emits and absorbs light.

use std::fmt::Write as _;

use super::Features;
use super::formula::body;
use super::generated::switch;
use super::names::Names;
use crate::assets::{Id, VolumeFormulas};
use crate::model::law::Observer;
use crate::model::volume::{Flow, Radiation};
use crate::scene::{Scene, Volume};

/// Planck's constant times 1 Hz divided by Boltzmann's constant, in kelvins.
const KELVIN_PER_HERTZ: f64 = 4.799_243_073_366_221e-11;

/// Adds the modules for matter in volumes.
pub(super) fn volume_parts(scene: &Scene, features: &Features, names: &mut Names) {
    let is_central =
        features.volumes.transfers_orbits && scene.volumes.iter().all(|volume| central_radius(volume, scene).is_some());
    names.all(&["volume/region_crossing", "volume/flow"]);
    names.add(if is_central { "volume/region_central" } else { "volume/region" });
    names.when(features.volumes.places_by_law, scene.law.facts().momentum_parts);
    names.when(features.volumes.has_grids, &["volume/grids"]);
}

/// Generates the matter of each volume.
pub(super) fn volumes(scene: &Scene, features: &Features) -> String {
    let all = &scene.volumes;
    let mut text = format!("const VOLUMES: u32 = {}u;\n\n", all.len());
    let norms: Vec<_> = all.iter().enumerate().map(|(v, volume)| (format!("{v}u"), norm(volume))).collect();
    text += &switch("fn volume_norm(v: u32, p: Real3) -> Real", "v", &norms);
    let gap = |volume: &Volume| match central_radius(volume, scene) {
        Some(radius) if radius.is_finite() => format!("reach - {radius:?}"),
        _ => "Real(-1e30)".to_owned(),
    };
    let gaps: Vec<_> = all.iter().enumerate().map(|(v, volume)| (format!("{v}u"), gap(volume))).collect();
    text += &switch("fn volume_gap(v: u32, reach: Real) -> Real", "v", &gaps);
    for (v, volume) in all.iter().enumerate() {
        text += &one(v, volume, scene, features);
    }
    if features.volumes.has_grids {
        text += &cells(all);
    }
    text
}

/// The longest piece of a path through a grid, in cells: its six points are not farther apart than samples.
const CELLS: f64 = 4.0;

/// Generates the number of all grids, and the longest piece in volumes, in scene units.
fn cells(all: &[Volume]) -> String {
    let grids = all.iter().map(|volume| volume.grids.len()).sum::<usize>();
    let mut text = format!(
        "const VOLUME_GRIDS: u32 = {grids}u;\n\nfn volume_cells(within: u32) -> Real {{\n    var cells: Real = 1e30;\n"
    );
    for (v, volume) in all.iter().enumerate() {
        for grid in &volume.grids {
            let (bit, length) = (1_u32 << v, CELLS * grid.cell.min_element());
            let _ = writeln!(text, "    cells = select(cells, min(cells, {length:?}), (within & {bit}u) != 0u);");
        }
    }
    text + "    return cells;\n}\n\n"
}

/// Returns the radius of a volume that is a sphere around the law's center; infinity if it is all of space.
fn central_radius(volume: &Volume, scene: &Scene) -> Option<f64> {
    let Some(region) = &volume.region else { return Some(f64::INFINITY) };
    let [center, _] = scene.law.equator()?;
    let radius = region.transform.uniform_scale().filter(|_| region.name == "sphere")?;
    (region.transform.0.translation == center).then_some(radius)
}

fn norm(volume: &Volume) -> String {
    volume.region.as_ref().map_or_else(|| "Real(0.0)".to_owned(), |region| format!("norm_{}(p)", region.name))
}

/// Generates the functions of one volume.
fn one(v: usize, volume: &Volume, scene: &Scene, features: &Features) -> String {
    let formulas = &volume.formulas;
    let variables: &'static [&'static str] = &VolumeFormulas::VARIABLES;
    let mut text = String::new();
    let origin = if features.volumes.places_by_law { String::new() } else { format!(", volumes[{v}u].origin") };
    let by = if features.volumes.places_by_law { "law" } else { "origin" };
    let before: usize = scene.volumes[..v].iter().map(|volume| volume.grids.len()).sum();
    let mut grids = String::new();
    for k in 0..volume.grids.len() {
        let _ = writeln!(grids, "    p.grids[{k}] = grid_value({}u, p.q);", before + k);
    }
    let _ = writeln!(
        text,
        "\nfn volume_place_{v}(spot: Spot) -> MatterPlace {{\n    var p = placed_by_{by}(spot{origin});\n{grids}    return p;\n}}\n"
    );
    let mut function = |name: &str, arguments: &str, roots: &[Id]| {
        let (lines, values) = body(formulas.graph(), roots, variables);
        let of = if values.len() > 1 { format!("Real{}", values.len()) } else { "Real".to_owned() };
        let value = if values.len() > 1 { format!("{of}({})", values.join(", ")) } else { values.join("") };
        let _ = writeln!(
            text,
            "fn volume_{name}_{v}(p: MatterPlace{arguments}) -> {of} {{\n{lines}    return {value};\n}}\n"
        );
    };
    function("density", "", &[formulas.density]);
    for (k, channel) in formulas.coefficients.iter().enumerate() {
        function(&format!("matter_{k}"), ", n: Real, nu: Real", &[channel.emission, channel.absorption]);
    }
    if !formulas.flow.is_empty() {
        function("flow", "", &formulas.flow);
    }
    if let Some(temperature) = formulas.temperature {
        function("temperature", "", &[temperature]);
    }
    text += &added(v, volume, scene, features);
    text
}

/// Returns the frequency of each channel of light, in units of ν₀. On paths from light sources, all colors have the first one.
pub(super) fn frequencies(scene: &Scene, features: &Features) -> Vec<f64> {
    match &scene.radiation {
        Some(radiation) if features.volumes.is_spectral => radiation.frequencies.clone(),
        radiation => vec![radiation.as_ref().map_or(1.0, |radiation| radiation.frequencies[0]); 3],
    }
}

/// Returns the powers of ν to which all emission and all absorption are proportional, so that one channel has the matter of all frequencies.
pub(super) fn common_exponents(scene: &Scene, features: &Features) -> Option<[f64; 2]> {
    let is_alone = !features.volumes.media_absorb && features.mean_redshifts(scene).next().is_none();
    let mut all = scene.volumes.iter().map(|volume| volume.formulas.exponents());
    let first = all.next().flatten().filter(|_| features.volumes.is_spectral && is_alone)?;
    all.all(|own| own == Some(first)).then_some(first)
}

/// Generates the addition of a volume's matter at a spot.
fn added(v: usize, volume: &Volume, scene: &Scene, features: &Features) -> String {
    let formulas = &volume.formulas;
    let is_bounded = features.volumes.bounds_matter && formulas.varies();
    let mut text = format!(
        "fn add_volume_{v}(spot: Spot, matter: ptr<function, Matter>) {{\n    let p = volume_place_{v}(spot);\n    \
         let n = volume_density_{v}(p);\n"
    );
    if is_bounded {
        let _ = writeln!(text, "    see_volume_{v}(p);");
    }
    text += "    if n >= 0.0 && n < LEAST_DENSITY {\n        return;\n    }\n    transfer_invalid = transfer_invalid || !(n > 0.0);\n";
    let shifts = features.volumes.shifts_volumes;
    let shift = if shifts { shift(v, volume.flow) } else { "1.0".to_owned() };
    let eulerian_falls = scene.law.facts().below.is_some();
    let higher = if features.volumes.has_horizon { higher(volume.flow, eulerian_falls) } else { "" };
    let _ = writeln!(text, "    let s: Real = {shift}{higher};");
    text += "    let rate = spot.pace / (s * s * spot.index);\n    let dimming = spot.pace * s;\n";
    let radiation = scene.radiation.as_ref();
    let factors = radiation.and_then(|_| formulas.exponents());
    if is_bounded && factors.is_none() {
        let _ = writeln!(text, "    see_shift({v}u, s);");
    }
    if let Some([emission, absorption]) = factors {
        let _ = writeln!(text, "    let one = volume_matter_0_{v}(p, n, 1.0);");
        if is_bounded {
            let _ = writeln!(text, "    see_matter({v}u, 0u, one);");
        }
        // Without shifts s is 1.
        let power = |p: f64| if shifts { product(p) } else { String::new() };
        let _ = writeln!(text, "    let bright = rate * one.x{};", power(emission));
        let _ = writeln!(text, "    let dim = dimming * one.y{};", power(absorption));
    }
    if common_exponents(scene, features).is_some() {
        return text + "    add_matter(matter, 0u, bright, dim);\n}\n\n";
    }
    if radiation.is_none() && formulas.temperature.is_some() {
        // A black body of frequency sν and temperature T is s³ times that of ν and T/s.
        let color = format!("black_body_color(f32(volume_temperature_{v}(p) / s), {:?})", volume.white);
        let _ = writeln!(text, "    let shown = s * s * s * Real3({color});");
    }
    let mut all = Vec::new();
    for (k, nu) in frequencies(scene, features).into_iter().enumerate() {
        let values = if let Some([emission, absorption]) = factors {
            [format!("{:?} * bright", nu.powf(emission)), format!("{:?} * dim", nu.powf(absorption))]
        } else {
            let which = k.min(formulas.coefficients.len() - 1);
            let _ = writeln!(text, "    let c{k} = volume_matter_{which}_{v}(p, n, {nu:?} * s);");
            if is_bounded {
                let emission = match formulas.temperature {
                    Some(_) => format!("volume_temperature_{v}(p) * c{k}.y"),
                    None => format!("c{k}.x"),
                };
                let seen = if features.volumes.is_spectral { k } else { which };
                let _ = writeln!(text, "    see_matter({v}u, {seen}u, Real2({emission}, c{k}.y));");
            }
            let emission = match formulas.temperature {
                Some(_) if radiation.is_none() => format!("rate * c{k}.y * shown[{k}]"),
                Some(_) => format!("rate * c{k}.y * {}", black_body(v, nu, scene)),
                None => format!("rate * c{k}.x"),
            };
            [emission, format!("dimming * c{k}.y")]
        };
        let [emission, absorption] = values;
        let _ = writeln!(text, "    add_matter(matter, {k}u, {emission}, {absorption});");
        all.push([emission, absorption]);
    }
    for (k, own) in features.mean_redshifts(scene).enumerate() {
        let [emission, absorption] = &all[own];
        let _ = writeln!(text, "    add_matter(matter, FREQUENCIES + {k}u, {emission} / s, {absorption});");
    }
    text + "}\n\n"
}

/// Returns a factor sᵖ: as products and a square root, if it takes few.
fn product(p: f64) -> String {
    let halves = 2.0 * p.abs();
    if halves > 8.0 || halves.fract() > 0.0 {
        return format!(" * real_exp({p:?} * real_log(s))");
    }
    let halves = halves as usize;
    let factors: Vec<_> = (0..halves / 2).map(|_| "s").chain((halves % 2 == 1).then_some("sqrt(s)")).collect();
    let all = factors.join(" * ");
    match p {
        0.0 => all,
        _ if p < 0.0 => format!(" / ({all})"),
        _ => format!(" * {all}"),
    }
}

/// Returns the Planck function at the frequency of the matter, in units of the emission times the scene's unit of length. Without units,
/// temperatures are in units of hν₀/k and intensities of 2hν₀³/c².
fn black_body(v: usize, nu: f64, scene: &Scene) -> String {
    let radiation = scene.radiation.as_ref();
    let most =
        radiation.and_then(Radiation::planck_unit).zip(scene.intensity_unit()).map_or(1.0, |(all, one)| all / one);
    let kelvin = radiation.and_then(|radiation| radiation.reference).map_or(1.0, |hertz| KELVIN_PER_HERTZ * hertz);
    format!("planck({nu:?} * s, {most:?}, {kelvin:?}, volume_temperature_{v}(p))")
}

/// Returns the frequency of light to the matter of a volume.
fn shift(v: usize, flow: Flow) -> String {
    match flow {
        Flow::Observer(Observer::Eulerian) => "shift_of_velocity(spot, law_eulerian(spot.x))".to_owned(),
        Flow::Observer(Observer::Infalling) => "shift_of_velocity(spot, law_falling(spot.x, 1.0, 0.0))".to_owned(),
        Flow::Observer(Observer::Zamo) => "shift_of_momentum(spot, law_turning(spot), 0.0)".to_owned(),
        Flow::Observer(Observer::ProgradeOrbit) => orbiting("1.0, transfer.last_prograde"),
        Flow::Observer(Observer::RetrogradeOrbit) => orbiting("-1.0, transfer.last_retrograde"),
        Flow::Observer(_) => "shift_at_rest(spot)".to_owned(),
        Flow::AngularMomentum => format!("shift_of_momentum(spot, law_turning(spot), volume_flow_{v}(p))"),
        Flow::AngularVelocity => format!("shift_of_rate(spot, law_turning(spot), volume_flow_{v}(p))"),
        Flow::Velocity => format!("shift_of_boost(spot, volume_flow_{v}(p))"),
    }
}

/// Returns the factor of the frequency at twice the height above a horizon, where matter that falls moves differently. Eulerian observers
/// fall where the coordinates of the law continue below the horizon.
fn higher(flow: Flow, eulerian_falls: bool) -> &'static str {
    match flow {
        Flow::Observer(Observer::Eulerian) | Flow::Velocity if !eulerian_falls => " * spot.higher",
        Flow::Observer(Observer::Static | Observer::Zamo) | Flow::AngularMomentum | Flow::AngularVelocity => {
            " * spot.higher"
        }
        _ => " * spot.higher * spot.higher",
    }
}

fn orbiting(sense: &str) -> String {
    format!("shift_of_orbit(spot, p.r * p.sine, {sense})")
}
