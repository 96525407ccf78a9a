// Path guiding: before the render, paths from the lights left their light in grids, one for each light, or for each mirror and transparent
// object that it illuminates. Gröller's approximate direction (G95 §6), −F/|F|, becomes the proposal of an exact method: a von Mises–Fisher
// lobe about it, with the width that |F|/φ implies for the spread of directions.

// The narrowest lobe, at which 32-bit rounding of directions does not show, and the widest.
const NARROWEST: f32 = 2e4;
const WIDEST: f32 = 1e-2;
// The factor on the sampling frequency: a lobe hits its light less often than the cone around an emitter does.
const MORE: f32 = 15.0;

// A lobe about an axis.
struct Guide {
    axis: vec3f,
    kappa: f32,
    // The brightness of the light from the lobe.
    brightness: f32,
    // The brightness times the density of the lobe along its axis.
    peak: f32,
}

// The lobes of the vertex that was evaluated last, so that each is looked up once.
var<private> guides: array<Guide, GUIDES>;

fn guide_at(light: GridLight, vertex: PathVertex) -> Guide {
    let x = (vec3f(vertex.x) - light.lo) / light.h;
    let fine = x + LIGHT_OFF / f32(light.refine) * vertex.normal;
    let brick = light_brick_at(light, fine);
    let f = light_field[light_place(light, select(fine, x + LIGHT_OFF * vertex.normal, brick == 0u), brick)];
    let strength = length(f.xyz);
    let r = min(strength / max(f.w, 1e-30), 1.0);
    let kappa = clamp(r * (3.0 - r * r) / max(1.0 - r * r, 1e-6), WIDEST, NARROWEST);
    let axis = select(vertex.normal, -f.xyz / strength, strength > 0.0);
    let brightness = MORE * light.color.x * f.w;
    return Guide(axis, kappa, brightness, brightness * kappa / (2.0 * f32(PI) * (1.0 - exp(-2.0 * kappa))));
}

fn guiding_brightness(vertex: PathVertex) -> f32 {
    var sum = 0.0;
    for (var i = 0u; i < GUIDES; i++) {
        guides[i] = guide_at(grid_lights[i], vertex);
        sum += guides[i].brightness;
    }
    return sum;
}

// One number chooses the lobe and, rescaled, the angle to its axis.
fn guiding_way(vertex: PathVertex, total: f32, u: vec2f) -> vec3f {
    var chosen = Guide(vertex.normal, WIDEST, 0.0, 0.0);
    var at = 0.0;
    var sum = 0.0;
    for (var i = 0u; i < GUIDES; i++) {
        let guide = guides[i];
        if guide.brightness > 0.0 && u.x * total >= sum {
            chosen = guide;
            at = clamp((u.x * total - sum) / guide.brightness, 0.0, 1.0);
        }
        sum += guide.brightness;
    }
    let off = min(-log(max(1.0 - at * (1.0 - exp(-2.0 * chosen.kappa)), 1e-30)) / chosen.kappa, 2.0);
    return way_about(chosen.axis, 1.0 - off, sqrt(off * (2.0 - off)), u.y);
}

fn guiding_density(vertex: PathVertex, total: f32, d: vec3f) -> f32 {
    var sum = 0.0;
    for (var i = 0u; i < GUIDES; i++) {
        let guide = guides[i];
        // One minus the cosine.
        let apart = d - guide.axis;
        sum += guide.peak * exp(-0.5 * guide.kappa * dot(apart, apart));
    }
    return sum / max(total, 1e-30);
}
