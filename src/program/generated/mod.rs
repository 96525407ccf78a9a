//! The few lines of generated WGSL for a scene's list of shapes, materials, falloffs, images and layers.

mod shapes;
mod switch;

use std::fmt::Write as _;

use super::regions::Regions;
use super::unit::Unit;
use super::{Features, LoopBudget, Mode};
use crate::model::point_source;
use crate::model::shape::SOLIDS;
use crate::scene::{Precision, Scene};
pub(super) use shapes::{lists, near, shapes};
pub use shapes::{solid_code, solid_codes};
pub(super) use switch::{switch, unit};

/// Returns the largest number of paths that are searched from a light to a position. With one center, these are two around either side.
/// Otherwise there is one per first direction: straight, and past each source of the law at three distances, or four sides twice, and back.
fn shots(scene: &Scene) -> usize {
    match scene.law.facts().anchors.len() {
        _ if scene.law.facts().orbit.is_some_and(|orbit| orbit.is_plane()) => 4,
        0 => 10,
        aims => 1 + 3 * aims,
    }
}

/// The number of additional first directions all around the light if paths are wanted as numbers; images omit them to save time.
const AROUND: usize = 48;

/// Returns the largest number of paths that are searched if paths are wanted as numbers.
#[must_use]
pub fn all_shots(scene: &Scene) -> usize {
    let planar = scene.law.facts().orbit.is_some_and(|orbit| orbit.is_plane());
    shots(scene) + if planar { 0 } else { AROUND }
}

/// Generates the offset of a position from the source of a force.
pub(super) fn anchors(kinds: &[&point_source::SourceKind]) -> Unit {
    let code =
        |kind: &point_source::SourceKind| point_source::ANCHORS.iter().position(|other| *other == kind).unwrap_or(0);
    let calls: Vec<_> =
        kinds.iter().map(|kind| (format!("{}u", code(kind)), format!("offset_{}(d, along)", kind.name))).collect();
    let signature = "fn anchor_offset(kind: u32, d: Real3, along: Real3) -> Real3";
    unit("generated/anchors.wgsl", switch(signature, "kind", &calls))
}

/// Returns the last name of a module's path, which its functions carry.
fn own_name(part: &str) -> &str {
    part.rsplit('/').next().unwrap_or(part)
}

/// The materials, patterns and lights of surfaces, and the queries to them.
pub(super) struct Answers<'a> {
    /// The modules of the kinds, of the kinds whose color follows from a temperature, and of the kinds that orbit.
    pub kinds: &'a [&'a str],
    pub tempered: &'a [&'a str],
    pub orbiting: &'a [&'a str],
    /// The modules of patterns, each with whether it is multiplied by vertex colors.
    pub patterns: &'a [(&'a str, bool)],
    pub lights: &'a [&'a str],
    /// Whether all materials scatter light on paths, and none of them shows local illumination.
    pub paths: bool,
    /// Whether the motion of matter is queried.
    pub shift: bool,
    /// Whether the redshift changes the brightness of light.
    pub beaming: bool,
}

/// Generates the light that surfaces return: the scene's kinds of material, pattern and light.
pub(super) fn materials(answers: &Answers) -> Unit {
    let Answers { kinds, tempered, orbiting, patterns, lights, paths, shift, beaming } = *answers;
    let each = |call: &dyn Fn(&str, &str) -> String| -> Vec<_> {
        kinds.iter().map(|part| (own_name(part).to_uppercase(), call(part, own_name(part)))).collect()
    };
    let radiance = |part: &str, kind: &str| {
        let radiance = format!("radiance_{kind}(material, color, lit)");
        if beaming && !tempered.contains(&part) { format!("beamed({radiance})") } else { radiance }
    };
    let radiance = if paths { Vec::new() } else { each(&radiance) };
    let color = |(part, has_vertex_colors): &(&str, bool)| {
        let (code, call) = (part.to_uppercase(), format!("pattern_{part}(material, uv)"));
        if *has_vertex_colors { (code + " | VERTEX_COLORS", format!("vertex_color() * {call}")) } else { (code, call) }
    };
    let colors: Vec<_> = patterns.iter().map(color).collect();
    let mut text =
        switch("fn surface_radiance(material: Material, color: vec3f, lit: Lit) -> vec3f", "material.kind", &radiance);
    if paths {
        let mut answers = each(&|_, kind| format!("bsdf_{kind}(material, color)"));
        if answers.is_empty() {
            answers.push((String::new(), "Bsdf(vec3f(0.0), vec3f(0.0), vec3f(0.0), 1.0)".to_owned()));
        }
        text += "\n";
        text += &switch("fn bsdf_at(material: Material, color: vec3f) -> Bsdf", "material.kind", &answers);
    }
    text += "\n";
    text += &switch("fn pattern_color(material: Material, uv: vec2f) -> vec3f", "material.pattern", &colors);
    if shift {
        let mut matter = each(&|part, kind| {
            if orbiting.contains(&part) { format!("matter_{kind}(x)") } else { "matter_at_rest(x)".to_owned() }
        });
        if matter.is_empty() {
            matter.push((String::new(), "matter_at_rest(x)".to_owned()));
        }
        text += "\n";
        text += &switch("fn surface_matter(material: Material, x: Real3) -> Real4", "material.kind", &matter);
    }
    let sum: Vec<_> = lights.iter().map(|l| format!("lit_by_{l}(material, color, lit)")).collect();
    let sum = if sum.is_empty() { "vec3f(0.0)".to_owned() } else { sum.join("\n        + ") };
    let _ = write!(
        text,
        "\nfn lit_radiance(material: Material, color: vec3f, lit: Lit) -> vec3f {{\n    return {sum};\n}}\n"
    );
    unit("generated/materials.wgsl", text)
}

/// Generates next-event estimation, with `guides` guides: each kind of target is chosen in proportion to its brightness at a vertex.
pub(super) fn aims(kinds: &[&str], guides: usize) -> Unit {
    let each = |word: &dyn Fn(&str) -> String, between: &str| -> String {
        kinds.iter().map(|kind| word(kind)).collect::<Vec<_>>().join(between)
    };
    let members = each(&|kind| format!("    {kind}: f32,\n"), "");
    let bright = each(&|kind| format!("{kind}_brightness(vertex)"), ", ");
    let all = each(&|kind| format!("aims.{kind}"), " + ");
    let density = each(&|kind| format!("aims.{kind} * {kind}_density(vertex, aims.{kind}, d)"), "\n        + ");
    let (last, others) = kinds.split_last().expect("paths that aim aim at something");
    let mut way = String::new();
    for kind in others {
        let _ = write!(
            way,
            "    if at < aims.{kind} {{\n        \
             return {kind}_way(vertex, aims.{kind}, vec2f(at / aims.{kind}, u.y));\n    }}\n    \
             at -= aims.{kind};\n"
        );
    }
    let text = format!(
        "const GUIDES: u32 = {guides}u;\n\nstruct Aims {{\n{members}}}\n\n\
         fn aims_at(vertex: PathVertex) -> Aims {{\n    return Aims({bright});\n}}\n\n\
         fn aimed_way(vertex: PathVertex, aims: Aims, u: vec2f) -> vec3f {{\n    \
         var at = u.x * ({all});\n{way}    \
         return {last}_way(vertex, aims.{last}, vec2f(clamp(at / max(aims.{last}, 1e-30), 0.0, 1.0), u.y));\n}}\n\n\
         fn aim_density(vertex: PathVertex, aims: Aims, d: vec3f) -> f32 {{\n    \
         return ({density})\n        / max({all}, 1e-30);\n}}\n"
    );
    unit("generated/aims.wgsl", text)
}

/// Generates the absorption of the given kinds, each with whether it is a texture.
pub(super) fn absorptions(kinds: &[(bool, &str)]) -> Unit {
    let call = |(is_texture, kind): &(bool, &str)| {
        let sum = if *is_texture { ", sum" } else { "" };
        (kind.to_uppercase(), format!("density_{kind}(absorption, p{sum})"))
    };
    let calls: Vec<_> = kinds.iter().map(call).collect();
    // The long sum over a texture is written once, for all kinds that use it.
    let text = if kinds.iter().any(|(is_texture, _)| *is_texture) {
        let signature = "fn textured_density(absorption: Absorption, p: MatterPlace, sum: f32) -> vec3f";
        switch(signature, "absorption.kind", &calls)
            + "\nfn absorption_density(absorption: Absorption, p: MatterPlace) -> vec3f {\n    \
               return textured_density(absorption, p, texture_sum(absorption, p.q));\n}\n"
    } else {
        switch("fn absorption_density(absorption: Absorption, p: MatterPlace) -> vec3f", "absorption.kind", &calls)
    };
    unit("generated/absorption.wgsl", text)
}

/// Generates one texture for each image.
pub(super) fn images(count: usize) -> Unit {
    let mut text = String::new();
    for k in 0..count {
        let _ = writeln!(text, "var image_{k}: texture_2d<f32>;");
    }
    let sizes: Vec<_> = (0..count).map(|k| (format!("{k}u"), format!("textureDimensions(image_{k})"))).collect();
    let texels: Vec<_> = (0..count).map(|k| (format!("{k}u"), format!("textureLoad(image_{k}, p, 0).xyz"))).collect();
    text += "\n";
    text += &switch("fn image_extent(image: u32) -> vec2u", "image", &sizes);
    text += "\n";
    text += &switch("fn image_texel(image: u32, p: vec2u) -> vec3f", "image", &texels);
    unit("generated/images.wgsl", text)
}

/// Generates the storage of the layers.
pub(super) fn layers(names: &[&str]) -> Unit {
    let mut text = String::from("fn keep_layers(pixel: vec2u, ray: Ray, seen: Seen) {\n");
    if !names.is_empty() {
        let kept =
            names.iter().map(|name| format!("        keep_{name}(pixel, ray, seen);\n")).collect::<Vec<_>>().concat();
        let _ = writeln!(text, "    if sample_of(pixel) + frame.branch == 0u {{\n{kept}    }}");
    }
    text += "}\n";
    unit("generated/layers.wgsl", text)
}

/// Generates the scattering of a ray at a surface, by the kinds of material that scatter it. If there are other kinds, the ray `ends` on
/// them, and some of them may be translucent.
pub(super) fn scatter(kinds: &[&str], ends: Option<bool>) -> Unit {
    let arguments = "material, surface, end, index, pixel";
    let mut calls: Vec<_> = kinds
        .iter()
        .map(|part| own_name(part))
        .map(|kind| (kind.to_uppercase(), format!("scatter_{kind}({arguments})")))
        .collect();
    if ends == Some(true) {
        calls.push((String::new(), "scatter_ending(surface, end, index, pixel)".to_owned()));
    } else if ends.is_some() || calls.is_empty() {
        calls.push((String::new(), "Scattered(end.v, vec3f(1.0), false, false)".to_owned()));
    }
    let signature = "fn scattered_at(material: Material, surface: Surface, end: PathPoint, index: u32, pixel: vec2u) \
                     -> Scattered";
    unit("generated/scatter.wgsl", switch(signature, "material.kind", &calls))
}

/// Generates the number of regions, the mask of their bits that represent media, and the number of objects that touch others.
pub(super) fn regions(regions: &Regions) -> Unit {
    let count = regions.regions.len();
    let media = regions.regions.iter().filter(|region| region.kind.is_some()).count();
    let mask = u32::MAX.checked_shr(32 - media as u32).unwrap_or(0);
    let mut text = format!("const REGION_COUNT: u32 = {count}u;\nconst MEDIA_MASK: u32 = {mask:#x}u;\n");
    let (opaque, touching) = (regions.touching.opaque.len(), regions.touching.count());
    let _ = writeln!(text, "const TOUCHING_OPAQUE: u32 = {opaque}u;\nconst TOUCHING_COUNT: u32 = {touching}u;");
    unit("generated/regions.wgsl", text)
}

/// Generates the number of obstacles that spirals may meet, and whether spirals leap over free space.
pub(super) fn obstacles(count: usize, leaps: bool) -> Unit {
    let text = format!("const OBSTACLE_COUNT: u32 = {count}u;\nconst LEAPS: bool = {leaps};\n");
    unit("generated/obstacles.wgsl", text)
}

/// Generates the number of loop iterations that the device allows per invocation, and the number of invocations that share them.
pub(super) fn loop_budget(budget: Option<LoopBudget>) -> Unit {
    let LoopBudget { iterations, lanes } = budget.unwrap_or(LoopBudget { iterations: u32::MAX, lanes: 1 });
    let text = format!("const LOOP_BUDGET: u32 = {iterations}u;\nconst LOOP_LANES: u32 = {lanes}u;\n");
    unit("generated/loop_budget.wgsl", text)
}

/// Generates whether a kind of region contains nothing except its surface, so one step crosses it, and whether its paths are whole lines.
pub(super) fn region(is_empty: bool, is_whole: bool) -> Unit {
    let text = format!("const IS_EMPTY: bool = {is_empty};\nconst IS_WHOLE: bool = {is_whole};\n");
    unit("generated/region.wgsl", text)
}

/// Generates the texel type of the state's textures.
pub(super) fn texels(precision: Precision) -> Unit {
    let texel = if precision == Precision::Half { "rgba16float" } else { "rgba32float" };
    unit("generated/texels.wgsl", format!("alias StateTexture = texture_storage_2d<{texel}, write>;\n"))
}

/// Generates the number of media in a kind of region.
pub(super) fn media(count: usize) -> Unit {
    unit("generated/media.wgsl", format!("const MEDIA_COUNT: u32 = {count}u;\n"))
}

/// Generates the unrolled steps of a chord.
pub(super) fn chord(steps: u32) -> Unit {
    let mut text =
        String::from("fn chord_steps(start: Ray) -> ChordSteps {\n    var ray = start;\n    var over = false;\n");
    for step in 0..steps {
        let test = if step > 0 { "    over = over | may_be_over(ray);\n" } else { "" };
        let _ = writeln!(text, "{test}    ray = accepted_step(ray);");
    }
    text += "    return ChordSteps(ray, over);\n}\n";
    unit("generated/chord.wgsl", text)
}

/// Generates the lengths of the lists that every step or segment traverses; the compiler may unroll loops of known length.
pub(super) fn counts(scene: &Scene, features: &Features, regions: &Regions) -> Unit {
    let mut text = String::new();
    let mut count = |name: &str, n: usize| {
        let _ = writeln!(text, "const {name}_COUNT: u32 = {n}u;");
    };
    for solid in SOLIDS.into_iter().filter(|solid| solid.lists.is_some()) {
        let code = solid.name.to_uppercase();
        count(&code, shapes::count_of(scene, regions, solid, false));
        count(&format!("SIDED_{code}"), shapes::count_of(scene, regions, solid, true));
    }
    count("CAPTURE", scene.captures(None).len());
    count("TRAVEL", scene.travels().count());
    let aims = scene.law.facts().anchors.len();
    count("AIM", aims.max(1));
    let _ = writeln!(text, "const HAS_AIMS: bool = {};", aims > 0);
    let (few, all) = (shots(scene), all_shots(scene));
    let own = if features.mode == Mode::Lit { all } else { few };
    let _ = writeln!(text, "const USUAL_SHOTS: u32 = {few}u;\nconst SHOTS: u32 = {own}u;");
    unit("generated/counts.wgsl", text)
}
