// A custom scattering law: a ray is split into several directions at once, each with a weight (G95 §6). Every direction except the last is
// one split: taken, or one of the later directions.

const FAN: u32 = 4u;

// Makes each choice at a surface independent of the others.
const NEXT_CHOICE: u32 = 0x10000u;

fn scatter_fan(material: Material, surface: Surface, end: PathPoint, index: u32, pixel: vec2u) -> Scattered {
    let speed = length(end.v);
    let d = end.v / speed;
    let n = select(surface.normal, -surface.normal, dot(surface.normal, d) > 0.0);
    let count = fan_count(material.fan);
    var total: Real = 0.0;
    for (var i = 0u; i < count; i++) {
        total += max(fan_ray(material.fan, i, d, n).w, 0.0);
    }
    var taken = Real4(0.0);
    var branch = Branch(true, 1.0, false);
    var share = 1.0;
    var rest = total;
    for (var i = 0u; i < count; i++) {
        let own = fan_ray(material.fan, i, d, n);
        let part = max(own.w, 0.0) / rest;
        if !(part > 0.0) {
            continue;
        }
        taken = own;
        if part > 0.999999 {
            break;
        }
        branch = chosen_branch(pixel, index + i * NEXT_CHOICE, f32(part));
        share *= branch.throughput;
        if branch.cut || branch.reflects {
            break;
        }
        rest -= own.w;
    }
    let length = length(taken.xyz);
    let lost = branch.cut || !(length > 0.0) || !(total > 0.0);
    let onward = taken.xyz / max(length, 1e-30);
    if !lost && dot(onward, n) < 0.0 {
        pass_through(surface.object);
    }
    return Scattered(speed * onward, f32(total) * share * pattern_color(material, surface.uv), lost, true);
}

// A ray that passes a closed surface enters or leaves it; one that passes an open surface is on its other side.
fn pass_through(object: u32) {
    if HAS_REGIONS {
        let bit = object_bits[object];
        if bit != NO_BIT {
            enter_set(region_bits() ^ (1u << bit));
        }
    }
}
