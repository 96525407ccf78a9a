//! Generation of the tests against a scene's shapes, in lists and in its acceleration structure.

use std::fmt::Write as _;

use super::switch::{switch, unit};
use crate::model::shape::{Primitive, SOLIDS};
use crate::program::regions::Regions;
use crate::program::unit::Unit;
use crate::program::{Analysis, PARTS, constant};
use crate::scene::{Object, Scene};

/// Returns the code of a solid, its index in the table of all solids, in the upper bits of a primitive.
///
/// # Panics
///
/// If the table does not contain the solid.
#[must_use]
pub fn solid_code(solid: &Primitive) -> u32 {
    let place = SOLIDS.iter().position(|other| other.name == solid.name);
    let place = place.unwrap_or_else(|| panic!("{} is in no table", solid.name));
    place as u32 * (constant("segment/ray", "PRIMITIVE_INDEX") as u32 + 1)
}

/// Returns the codes as WGSL.
#[must_use]
pub fn solid_codes(solids: &[&Primitive]) -> String {
    let code = |solid: &&Primitive| format!("const {}: u32 = {:#x}u;\n", solid.name.to_uppercase(), solid_code(solid));
    solids.iter().map(code).collect()
}

/// Generates the intersection of a piece with an item of the acceleration structure or a moving object, and the surface of a primitive;
/// the surface of a moving object is at rest.
pub(in crate::program) fn shapes(
    Analysis { structure, .. }: &Analysis,
    all: &[&Primitive],
    moving: &[&Primitive],
) -> Unit {
    // An instanced item needs more than a kind and an index.
    let has_kind = |solid: &&&Primitive| !(structure.once && solid.lists.is_none());
    let case = |solid: &&Primitive, call: String| (solid.name.to_uppercase(), call);
    let surface = |solid: &&Primitive| format!("surface_{}(primitive & PRIMITIVE_INDEX, x)", solid.name);
    let fraction = |solid: &&Primitive| format!("{}_fraction(item & PRIMITIVE_INDEX, a, d)", solid.name);
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

/// Generates a function of a primitive and some arguments that calls
/// `instance` for instanced items, and otherwise the call of the item's kind.
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

/// The signature of a function of a primitive.
struct Head {
    name: &'static str,
    primitive: &'static str,
    /// The other parameters, first as declared and then as arguments.
    rest: &'static str,
    arguments: &'static str,
    result: &'static str,
}

/// Generates the first hit of a straight piece among the shapes in lists: the shapes that end rays and the shapes that rays cross.
pub(in crate::program) fn lists(
    scene: &Scene,
    Analysis { regions, structure }: &Analysis,
    listed: &[&Primitive],
    sided: &[&Primitive],
) -> Unit {
    let mut text =
        String::from("fn piece_hit(a: Real3, b: Real3, best: Hit) -> Hit {\n    let d = b - a;\n    var hit = best;\n");
    let lists = listed.iter().map(|solid| (solid, false)).chain(sided.iter().map(|solid| (solid, true)));
    for (solid, sided) in lists {
        let count = structure.written_out.then(|| count_of(scene, regions, solid, sided));
        text += &list_hit(solid.name, sided, count);
    }
    text += "    return hit;\n}\n\n";
    // No culling: every segment is tested against everything (the crossbar of W04 §5.4).
    text += "fn items_near(s: Segment) -> u32 {\n    return 0xffffffffu;\n}\n\nconst FINDS_NEAR: bool = false;\n";
    let _ = writeln!(text, "const HAS_LISTS: bool = {};", !listed.is_empty() || !sided.is_empty());
    unit("generated/lists.wgsl", text)
}

/// Generates the shapes near a segment, and the intersection of a piece with one of the shapes in lists, by its index among the near ones:
/// shapes that end rays, shapes that rays cross, and the parts of the acceleration structure, whose bits are the highest.
pub(in crate::program) fn near(
    scene: &Scene,
    Analysis { regions, structure }: &Analysis,
    (listed, sided): (&[&Primitive], &[&Primitive]),
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
            // A ray on the wrong side of a surface can meet it anywhere.
            let known = if sided { format!(" || is_inside(sided_{name}_list[{i}u].bit)") } else { String::new() };
            let _ =
                writeln!(bits, "    near |= select(0u, {}u, {test}(surroundings[{place}u], c){known});", 1u32 << place);
        }
        let item = if first == 0 { "item".to_owned() } else { format!("item - {first}u") };
        // If branches are slower, all cases are computed, and no index may be beyond the end of its list.
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
    if !is_processor {
        bits = format!("    if !may_meet_objects(s) {{\n        return 0u;\n    }}\n{bits}");
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

/// Generates the intersection of a piece with the list of a solid: item by item, or in a loop if `count` is `None`.
fn list_hit(name: &str, sided: bool, count: Option<usize>) -> String {
    let code = name.to_uppercase();
    let item = |i: &str| {
        if sided {
            // These follow the opaque shapes.
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

/// Counts the static shapes of a solid that scatter rays, if `sided`, or end them.
pub(super) fn count_of(scene: &Scene, regions: &Regions, solid: &Primitive, sided: bool) -> usize {
    let is = |(i, object): &(usize, &Object)| {
        object.solid() == solid && regions.bit(*i).is_some() == sided && object.travel.is_none()
    };
    scene.objects.iter().enumerate().filter(is).count()
}
