//! Moving of short lists into uniforms.
//!
//! *Theory.* Lists of the scene are in storage buffers, which have room for any number of entries. A device that runs lanes side by side
//! reads a storage buffer separately for each lane. It reads a uniform once if all lanes need the same entry; otherwise a CPU reads
//! it at half the cost of storage. A list with a length known to the linker may also be traversed without a loop.
//!
//! *Practice.* `var<storage, read> lights: array<Light>` becomes `var<uniform> lights: array<Light, 3>`, and `arrayLength(&lights)`
//! becomes that number. This applies to lists of up to [`SHORT`] entries, because the uniforms of a pass must fit into a device's limit.

use super::regions::Regions;
use super::tokens::{Splice, Tokens};
use crate::model::shape::SOLIDS;
use crate::scene::{Object, Scene, Shadows};

/// The largest number of entries of a list in a uniform.
const SHORT: usize = 32;

/// Returns the lists that may be short, with their lengths in this scene.
pub(super) fn lengths(scene: &Scene, regions: &Regions) -> Vec<(&'static str, usize)> {
    let placed = SOLIDS.into_iter().filter_map(|solid| {
        let is = |object: &&Object| object.solid() == solid;
        Some((solid.lists.as_ref()?.placed, scene.objects.iter().filter(is).count()))
    });
    let with = |shadows| scene.lights.iter().filter(|light| light.shadows == shadows).count();
    let [shot, grids] = [Shadows::Shooting, Shadows::Grid].map(with);
    let plain = || scene.lights.iter().filter(|light| !light.shadows.follows_the_law());
    let points = plain().filter(|light| light.is_point()).count();
    let others = [
        ("materials", scene.materials.len() + regions.regions.len()),
        ("point_lights", points),
        ("directional_lights", plain().count() - points),
        ("shot_lights", shot),
        ("emitters", scene.emitters().len()),
        ("absorptions", regions.regions.len() + 1),
        ("star_skies", 2),
        ("grid_lights", grids + scene.beams().len()),
    ];
    others.into_iter().chain(placed).collect()
}

/// Returns the tokens of a unit with its short lists in uniforms.
pub(super) fn in_uniforms<'a>(tokens: Tokens<'a>, lengths: &[(&str, usize)]) -> Tokens<'a> {
    let short = |word: &str| {
        let found = lengths.iter().find(|(name, length)| *name == word && (1..=SHORT).contains(length));
        found.map(|(_, length)| *length)
    };
    let list = [(0, "<"), (1, "storage"), (2, ","), (3, "read"), (4, ">"), (6, ":"), (7, "array"), (8, "<"), (10, ">")];
    let mut splices: Vec<Splice> = Vec::new();
    for i in 0..tokens.len() {
        let made = |text: &str| Tokens::written_at(text, tokens.origin(i));
        if tokens.are(i, &list) {
            let Some(length) = short(tokens.word(i + 5)) else { continue };
            splices.push((i + 1..i + 4, made("uniform")));
            splices.push((i + 10..i + 10, made(&format!(", {length}"))));
        } else if tokens.are(i, &[(0, "arrayLength"), (1, "("), (2, "&"), (4, ")")]) {
            let Some(length) = short(tokens.word(i + 3)) else { continue };
            splices.push((i..i + 5, tokens.replacement(i, &format!("{length}u"))));
        }
    }
    tokens.spliced(splices)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_lists_move_and_long_ones_stay() {
        let text = "struct A { b: vec4f }\n@group(0) @binding(7) var<storage, read> list: array<A>;\n\
                    fn sum() -> f32 {\n    var sum = 0.0;\n    for (var i = 0u; i < arrayLength(&list); i++) {\n        \
                    sum += list[i].b.x;\n    }\n    return sum;\n}\n";
        let moved = in_uniforms(Tokens::of(text), &[("other", 1), ("list", 3)]).text();
        assert!(moved.contains("@binding(7) var<uniform> list: array<A, 3>;"), "{moved}");
        assert!(moved.contains("i < 3u;") && !moved.contains("arrayLength"), "{moved}");
        for length in [0, SHORT + 1] {
            assert_eq!(in_uniforms(Tokens::of(text), &[("list", length)]).text(), text.trim_end());
        }
    }
}
