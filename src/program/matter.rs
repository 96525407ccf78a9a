//! The scene's matter as WGSL: its modules, and the sum of all matter at a point of a path.

use std::fmt::Write as _;

use super::features::VolumeFeatures;
use super::matter_bounds::{Light, matter_bounds};
use super::names::Names;
use super::unit::Unit;
use super::{Features, formula, generated, volumes};
use crate::model::volume::{Radiation, Show};
use crate::model::{Absorption, Wgsl};
use crate::scene::Scene;

/// The module with the functions of formulas, which media and laws may have already.
const FORMULA: &str = "medium/formula";

/// Adds the modules for light along paths through matter.
pub(super) fn matter_parts(scene: &Scene, features: &Features, names: &mut Names) {
    if !features.volumes.transfers {
        return;
    }
    names.all(&["volume/transfer", "volume/piece", "volume/tail", "volume/path", "volume/spot", "volume/placed"]);
    names.add(if features.volumes.transfers_orbits { "volume/stretch_orbit" } else { "volume/stretch" });
    names.when(features.weakens_lines, &["volume/line"]);
    names.add(if features.volumes.is_spectral { "picture/radiation" } else { "volume/colored" });
    names.when(features.volumes.media_absorb, &["absorption/matter", "absorption/density", "absorption/jumping"]);
    if features.volumes.media_absorb {
        absorption_parts(scene, names);
    }
    names.when(features.volumes.bounds_matter, &["real/interval", "volume/bounds"]);
    if features.volumes.has_volumes {
        volumes::volume_parts(scene, features, names);
    }
    let by_law = scene.law.parts().contains(&Wgsl::Part(FORMULA.into()));
    let has_formulas = features.volumes.has_volumes || scene.absorptions().any(|own| own.formulas().is_some());
    let has_own = || scene.media().any(|medium| medium.facts().formula.is_some()) || !scene.fans().is_empty();
    names.when(has_formulas && !has_own() && !by_law, &[FORMULA]);
    names.make(matter(scene, features));
}

/// Adds the modules for the absorption of media.
fn absorption_parts(scene: &Scene, names: &mut Names) {
    let mut kinds: Vec<_> = scene.absorptions().map(|own| (own.texture().is_some(), own.kind())).collect();
    // If nothing absorbs, absorption is uniform.
    kinds.push((false, "even"));
    kinds.sort_unstable();
    kinds.dedup();
    names.when(kinds.iter().any(|(is_texture, _)| *is_texture), &["absorption/noise", "medium/fractal_noise"]);
    let formulas: Vec<_> = scene.absorptions().filter_map(Absorption::formulas).collect();
    if !formulas.is_empty() {
        names.make(formula::absorptions(&formulas));
    }
    names.make(generated::absorptions(&kinds));
}

/// Generates the matter at a point of a path: of all volumes, and of the medium.
fn matter(scene: &Scene, features: &Features) -> Unit {
    let frequencies = volumes::frequencies(scene, features).len();
    let channels = frequencies + features.mean_redshifts(scene).count();
    let mut text = format!(
        "const CHANNELS: u32 = {channels}u;\n// Further channels have light multiplied by its redshift factor.\nconst FREQUENCIES: u32 = {frequencies}u;\n"
    );
    text += &shares(scene, features, channels);
    if features.volumes.has_volumes {
        text += &volumes::volumes(scene, features);
    }
    if features.volumes.bounds_matter {
        let VolumeFeatures { bounds_media, is_spectral, .. } = features.volumes;
        let light = Light { frequencies: volumes::frequencies(scene, features), is_spectral };
        text += &matter_bounds(scene, bounds_media, &light);
    }
    text += "\nfn matter_of(spot: Spot, within: u32) -> Matter {\n    var matter: Matter;\n";
    for v in 0..scene.volumes.len() {
        let call = format!("add_volume_{v}(spot, &matter);");
        // Without other matter, a piece is in the only volume, so that no test is necessary.
        let _ = match scene.volumes.len() {
            1 if !features.volumes.media_absorb => writeln!(text, "    {call}"),
            _ => writeln!(text, "    if (within & {}u) != 0u {{\n        {call}\n    }}", 1_u32 << v),
        };
    }
    if features.volumes.media_absorb {
        text += "    add_medium(spot, &matter);\n";
    }
    text += "    return matter;\n}\n\nfn matter_at(step: Stretch, within: u32, f: Real) -> Matter {\n    \
             return matter_of(stretch_spot(step, f), within);\n}\n\n";
    if let Some(radiation) = scene.radiation.as_ref().filter(|_| features.volumes.is_spectral) {
        text += &shown(radiation);
    }
    generated::unit("generated/matter.wgsl", text)
}

/// Generates the place of each channel's matter, and its factors.
fn shares(scene: &Scene, features: &Features, channels: usize) -> String {
    let common = volumes::common_exponents(scene, features);
    let (matters, place) = if common.is_some() { (1, "0u") } else { (channels, "k") };
    let factors = |power: f64| {
        let all = volumes::frequencies(scene, features).into_iter().map(|nu| nu.powf(power)).enumerate();
        let chain = |chain: String, (k, factor)| match k {
            0 => format!("Real({factor:?})"),
            _ => format!("select({chain}, {factor:?}, k == {k}u)"),
        };
        all.fold(String::new(), chain)
    };
    let [emission, absorption] = common.map_or(["1.0".to_owned(), "1.0".to_owned()], |powers| powers.map(factors));
    format!(
        "const MATTERS: u32 = {matters}u;\n\nfn channel_matter(k: u32) -> u32 {{\n    return {place};\n}}\n\n\
         fn channel_emission(k: u32) -> Real {{\n    return {emission};\n}}\n\n\
         fn channel_absorption(k: u32) -> Real {{\n    return {absorption};\n}}\n\n"
    )
}

/// Generates the color of a picture's intensities.
fn shown(radiation: &Radiation) -> String {
    let value = match radiation.show {
        Show::Gray => "vec3f(f32(transferred.light[0]))".to_owned(),
        Show::Heat => "heat_color(f32(transferred.light[0]))".to_owned(),
        Show::Frequencies(all) => {
            format!("vec3f({})", all.map(|k| format!("f32(transferred.light[{k}])")).join(", "))
        }
    };
    format!("fn shown_radiation() -> vec3f {{\n    return {value} / transfer.white;\n}}\n")
}
