//! Tests of common synonyms: each message suggests the correct name.

use super::{RAYS, mistakes_of, parse};
use crate::document::synonyms::SYNONYMS;
use crate::scene::reference::REFERENCE;

#[test]
fn every_synonym_leads_to_a_name() {
    for (words, right) in SYNONYMS {
        let is_choice = |value: &str| value.split(['|', ',', ' ']).any(|word| word.trim_matches(['"', '`']) == *right);
        let is_known = REFERENCE.iter().any(|row| row.key == *right || is_choice(&row.value));
        assert!(is_known, "{words:?} lead to `{right}`, which is not a name");
    }
}

/// A table with a key or a value of another name, and the correct name.
const TRIED: &[(&str, &str, &str)] = &[
    ("camera", "kind = \"plane\"", "orthographic"),
    ("camera", "kind = \"ortho\"", "orthographic"),
    ("camera", "kind = \"perspective\"", "pinhole"),
    ("camera", "kind = \"equirectangular\"", "panorama"),
    ("camera", "frame = \"static\"", "observer"),
    ("camera", "observer = \"normal\"", "eulerian"),
    ("camera", "observer = \"falling\"", "infalling"),
    ("camera", "observer = \"rain\"", "infalling"),
    ("camera", "observer = \"orbiting\"", "prograde-orbit"),
    ("camera", "observer = \"counter-orbiting\"", "retrograde-orbit"),
    ("camera", "observer = \"moving\"", "boosted"),
    ("camera", "shift = true", "redshift"),
    ("camera", "doppler = true", "redshift"),
    ("camera", "redshift = true\nhues = \"kept\"", "color_shift"),
    ("camera", "target = [0, 0, 0]", "look_at"),
    ("law", "kind = \"kerr\"", "kerr-newman"),
    ("law", "kind = \"black-hole\"", "schwarzschild"),
    ("law", "kind = \"minkowski\"", "straight"),
    ("law", "kind = \"ellis\"", "wormhole"),
    ("law", "kind = \"reissner-nordstrom\"\ncosmological = 0.1", "cosmological_constant"),
    ("law", "kind = \"kerr-newman\"\na = 0.9", "spin"),
    ("law", "kind = \"wormhole\"\nother = [9, 0, 0]", "other_mouth"),
    ("law", "filter = [1, 1, 1]", "absorption"),
    ("law", "kind = \"schwarzschild\"\nform = \"path\"", "orbit-equation"),
    ("law", "absorption = { density = 1 }", "coefficient"),
    ("law", "absorption = { color = [1, 1, 1] }", "transmittance"),
    ("law", "absorption = { coefficient = 1, glow = [1, 1, 1] }", "emission"),
    ("image", "pattern = \"sobol\"", "sampler"),
    ("image", "sampler = \"progressive\"", "sobol"),
    ("image", "spp = 4", "samples"),
    ("image", "resolution = [9, 9]", "size"),
    ("sky", "texture = \"a.png\"", "image"),
    ("output", "bits = 16", "bit_depth"),
    ("rays", "bound = { radius = 9 }", "bounding_sphere"),
    ("rays", "length = 9", "max_parameter"),
    ("rays", "transport = \"paths\"", "lighting"),
    ("rays", "lighting = \"paths\"", "path-tracing"),
    ("rays", "lighting = \"lights\"", "direct"),
    ("rays", "branches = 3", "max_splits"),
    ("rays", "max_splits = \"random\"", "stochastic"),
    ("rays", "asymptotic = true", "sky_at_infinity"),
    ("rays", "accelerate = \"bvh\"", "acceleration"),
    ("rays", "max_steps = 9", "max_segments"),
    ("rays", "method = \"rk45\"", "dormand-prince"),
    ("rays", "method = \"verlet\"", "leapfrog"),
    ("rays", "precision = \"double\"", "f64"),
    ("path_tracing", "depth = 3", "max_depth"),
    ("path_tracing", "roulette = 3", "rr_depth"),
    ("path_tracing", "aim = true", "light_sampling"),
    ("path_tracing", "guide = true", "guiding"),
    ("[lights]", "kind = \"point\"\nshadows = \"straight\"", "straight-rays"),
    ("[lights]", "kind = \"point\"\nshadows = \"grid\"", "photon-grid"),
    ("[lights]", "kind = \"point\"\nshadows = \"shooting\"", "curved-rays"),
    ("[lights]", "kind = \"point\"\nshadows = \"straight-rays\"\nclear = \"open\"", "transparent"),
    ("[lights]", "kind = \"point\"\nshadows = \"curved-rays\"\nsize = 1", "min_distance"),
    ("[lights]", "kind = \"spot\"", "point"),
    ("[lights]", "kind = \"sun\"", "directional"),
    ("[objects]", "shape = \"cube\"", "box"),
    ("[objects]", "shape = \"disk\"\nhole = 2", "inner_radius"),
    ("[objects]", "shape = \"disk\"\ninner = 2", "inner_radius"),
    ("materials.m", "kind = \"lambert\"", "phong"),
    ("materials.m", "kind = \"fan\"", "ray-splitter"),
    ("animation", "moments = 8", "shutter_samples"),
    ("animation", "fps = 8", "rate"),
    ("[animation.tracks]", "at = [0, 1]", "keyframes"),
    ("[animation.tracks]", "between = \"smooth\"", "interpolation"),
];

#[test]
fn words_that_people_try_are_told_the_right_one() {
    for (table, line, right) in TRIED {
        let rays = if *table == "rays" { "[rays]\n" } else { RAYS };
        let found =
            mistakes_of(parse(&format!("{rays}\n[{table}]\n{line}\n").replace("[rays]\n\n[rays]\n", "[rays]\n")));
        let said = format!("use `{right}`");
        assert!(found.iter().any(|mistake| mistake.help.contains(&said)), "[{table}] {line}: {found:?}");
    }
}
