//! A scene's shapes in lists and in its structure: what a segment is near, and where it meets which.

use std::fmt::Write as _;

use super::switch::{switch, unit};
use crate::model::shape::{SOLIDS, Solid};
use crate::program::regions::Regions;
use crate::program::unit::Unit;
use crate::program::{Analysis, PARTS, constant};
use crate::scene::{Object, Scene};

/// A solid in the upper bits of a primitive: its place in the table of all.
///
/// # Panics
///
/// Where the table does not have it.
#[must_use]
pub fn solid_code(solid: &Solid) -> u32 {
    let place = SOLIDS.iter().position(|other| other.name == solid.name);
    let place = place.unwrap_or_else(|| panic!("{} is in no table", solid.name));
    place as u32 * (constant("segment/ray", "PRIMITIVE_INDEX") as u32 + 1)
}

/// The codes as WGSL.
#[must_use]
pub fn solid_codes(solids: &[&Solid]) -> String {
    let code = |solid: &&Solid| format!("const {}: u32 = {:#x}u;\n", solid.name.to_uppercase(), solid_code(solid));
    solids.iter().map(code).collect()
}

/// Where a piece meets an item of the structure, or one that moves, and the surface of a primitive; of one that moves, at rest.
pub(in crate::program) fn shapes(Analysis { structure, .. }: &Analysis, all: &[&Solid], moving: &[&Solid]) -> Unit {
    // What is kept once is known by more than a kind and an index.
    let has_kind = |solid: &&&Solid| !(structure.once && solid.lists.is_none());
    let case = |solid: &&Solid, call: String| (solid.name.to_uppercase(), call);
    let surface = |solid: &&Solid| format!("surface_{}(primitive & PRIMITIVE_INDEX, x)", solid.name);
    let fraction = |solid: &&Solid| format!("{}_fraction(item & PRIMITIVE_INDEX, a, d)", solid.name);
    let surfaces: Vec<_> = all.iter().filter(has_kind).map(|solid| case(solid, surface(solid))).collect();
    let travelling: Vec<_> =
        all.iter().filter(|solid| moving.contains(solid)).map(|solid| case(solid, fraction(solid))).collect();
    let fractions: Vec<_> =
        structure.solids.iter().filter(has_kind).map(|solid| case(solid, fraction(solid))).collect();
    let mut text = solid_codes(all) + "\n";
    if structure.once {
        let head = Head {
            name: "item_fraction",
            primitive: "item",
            rest: "a: Real3, d: Real3",
            arguments: "a, d",
            result: "Real",
        };
        text += &instances_first(&head, "instance_fraction(item & INSTANCE_INDEX, a, d)", &fractions);
    } else if let Some((first, _)) = fractions.first() {
        let signature = "fn item_fraction(item: u32, a: Real3, d: Real3) -> Real";
        text += &switch(signature, "item & ~PRIMITIVE_INDEX", &fractions);
        let _ = writeln!(text, "\nconst ITEM_KIND: u32 = {first};\n");
    }
    if !travelling.is_empty() {
        let signature = "fn moving_fraction(item: u32, a: Real3, d: Real3) -> Real";
        text += &switch(signature, "item & ~PRIMITIVE_INDEX", &travelling);
        text += "\n";
    }
    let name = if moving.is_empty() { "hit_surface" } else { "resting_surface" };
    if structure.once {
        let head = Head { name, primitive: "primitive", rest: "x: Real3", arguments: "x", result: "Surface" };
        text += &instances_first(&head, "surface_instance(primitive & INSTANCE_INDEX, x)", &surfaces);
    } else {
        let signature = format!("fn {name}(primitive: u32, x: Real3) -> Surface");
        text += &switch(&signature, "primitive & ~PRIMITIVE_INDEX", &surfaces);
    }
    unit("generated/shapes.wgsl", text)
}

/// A function of a primitive and some arguments that calls `instance` for what is kept once, and else what its kind calls.
fn instances_first(head: &Head, instance: &str, kinds: &[(String, String)]) -> String {
    let Head { name, primitive, rest, arguments, result } = head;
    let signature = format!("({primitive}: u32, {rest}) -> {result}");
    if kinds.is_empty() {
        return format!("fn {name}{signature} {{\n    return {instance};\n}}\n\n");
    }
    let others = switch(&format!("fn {name}_of_kind{signature}"), &format!("{primitive} & ~PRIMITIVE_INDEX"), kinds);
    format!(
        "{others}\nfn {name}{signature} {{\n    if {primitive} >= INSTANCE {{\n        return {instance};\n    }}\n    \
         return {name}_of_kind({primitive}, {arguments});\n}}\n\n"
    )
}

/// A function of a primitive.
struct Head {
    name: &'static str,
    primitive: &'static str,
    /// The other parameters, and as arguments.
    rest: &'static str,
    arguments: &'static str,
    result: &'static str,
}

/// The first hit of a straight piece among the shapes in lists, those that end rays and those that rays cross.
pub(in crate::program) fn lists(
    scene: &Scene,
    Analysis { regions, structure }: &Analysis,
    listed: &[&Solid],
    sided: &[&Solid],
) -> Unit {
    let mut text =
        String::from("fn piece_hit(a: Real3, b: Real3, best: Hit) -> Hit {\n    let d = b - a;\n    var hit = best;\n");
    let lists = listed.iter().map(|solid| (solid, false)).chain(sided.iter().map(|solid| (solid, true)));
    for (solid, sided) in lists {
        let count = structure.written_out.then(|| count_of(scene, regions, solid, sided));
        text += &list_hit(solid.name, sided, count);
    }
    text += "    return hit;\n}\n\n";
    // Nothing is ruled out: every segment is tested against everything (the crossbar of W04 §5.4).
    text += "fn items_near(s: Segment) -> u32 {\n    return 0xffffffffu;\n}\n\nconst FINDS_NEAR: bool = false;\n";
    let _ = writeln!(text, "const HAS_LISTS: bool = {};", !listed.is_empty() || !sided.is_empty());
    unit("generated/lists.wgsl", text)
}

/// What a segment is near, and one of the shapes in lists against a piece, by its place among what may be near: those that end rays,
/// those that rays cross, and the structure in parts, whose bit is the highest.
pub(in crate::program) fn near(
    scene: &Scene,
    Analysis { regions, structure }: &Analysis,
    (listed, sided): (&[&Solid], &[&Solid]),
    is_processor: bool,
) -> Unit {
    let (mut bits, mut fractions, mut primitives) = (String::new(), String::new(), String::new());
    let mut first = 0;
    let lists = listed.iter().map(|solid| (solid, false)).chain(sided.iter().map(|solid| (solid, true)));
    for (solid, sided) in lists {
        let (name, code, count) = (solid.name, solid.name.to_uppercase(), count_of(scene, regions, solid, sided));
        let test = if solid.lists.as_ref().is_some_and(|lists| lists.flat) { "near_flat" } else { "near_ball" };
        for i in 0..count {
            let place = first + i;
            // Who is on the wrong side of a surface meets it wherever it is.
            let known = if sided { format!(" || is_inside(sided_{name}_list[{i}u].bit)") } else { String::new() };
            let _ =
                writeln!(bits, "    near |= select(0u, {}u, {test}(surroundings[{place}u], c){known});", 1u32 << place);
        }
        let item = if first == 0 { "item".to_owned() } else { format!("item - {first}u") };
        // All cases are computed where that is faster than to branch, and then none may be beyond its list.
        let place = if is_processor { format!("min({item}, {}u)", count - 1) } else { item.clone() };
        let (call, primitive) = if sided {
            let call = format!("cross_{name}(sided_{name}_list[{place}], a, d)");
            (call, format!("{code} | ({code}_COUNT + {item})"))
        } else {
            let primitive = format!("{code} | ({item})");
            (format!("hit_{name}({name}_list[{place}], {primitive}, a, d)"), primitive)
        };
        let last = first + count;
        let range = if first == 0 { format!("item < {last}u") } else { format!("item >= {first}u && item < {last}u") };
        let _ = if is_processor {
            writeln!(fractions, "    t = select(t, {call}, {range});")
        } else {
            writeln!(fractions, "    if {range} {{\n        return {call};\n    }}")
        };
        let _ = writeln!(primitives, "    primitive = select(primitive, {primitive}, {range});");
        first = last;
    }
    let parts = if structure.solids.is_empty() { 0 } else { PARTS };
    for place in first..first + parts {
        let _ = writeln!(bits, "    near |= select(0u, NEAR_STRUCTURE, near_ball(surroundings[{place}u], c));");
    }
    if is_processor {
        fractions = format!("    var t: Real = 2.0;\n{fractions}    return t;\n");
    } else {
        fractions += "    return 2.0;\n";
    }
    let count = first + parts;
    let text = format!(
        "const NEAR_COUNT: u32 = {count}u;\nconst FINDS_NEAR: bool = true;\nconst HAS_LISTS: bool = {};\n\n\
         fn items_near(s: Segment) -> u32 {{\n    let c = chordal(s);\n    var near = 0u;\n{bits}    return near;\n}}\n\n\
         fn listed_fraction(item: u32, a: Real3, d: Real3) -> Real {{\n{fractions}}}\n\n\
         fn listed_primitive(item: u32) -> u32 {{\n    var primitive = NOTHING;\n{primitives}    return primitive;\n}}\n",
        first > 0
    );
    unit("generated/near.wgsl", text)
}

/// A piece against the list of a solid: item by item, or in a loop where it is not said how many there are.
fn list_hit(name: &str, sided: bool, count: Option<usize>) -> String {
    let code = name.to_uppercase();
    let item = |i: &str| {
        if sided {
            // Behind the opaque ones.
            let primitive = format!("{code} | ({code}_COUNT + {i})");
            format!("    hit = nearer_hit(hit, cross_{name}(sided_{name}_list[{i}], a, d), {primitive});\n")
        } else {
            let primitive = format!("{code} | {i}");
            format!("    hit = nearer_hit(hit, hit_{name}({name}_list[{i}], {primitive}, a, d), {primitive});\n")
        }
    };
    let Some(count) = count else {
        let count = if sided { format!("SIDED_{code}_COUNT") } else { format!("{code}_COUNT") };
        return format!("    for (var i = 0u; i < {count}; i++) {{\n    {}    }}\n", item("i"));
    };
    (0..count).map(|i| item(&format!("{i}u"))).collect()
}

/// How many shapes of a solid at rest rays go on from, or end on.
pub(super) fn count_of(scene: &Scene, regions: &Regions, solid: &Solid, sided: bool) -> usize {
    let is = |(i, object): &(usize, &Object)| {
        object.solid() == solid && regions.bit(*i).is_some() == sided && object.travel.is_none()
    };
    scene.objects.iter().enumerate().filter(is).count()
}
