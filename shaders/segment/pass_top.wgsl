// Moves the start of a path over its highest point: light that leaves a surface and is bent back to it may rise and fall within one piece,
// whose chord then crosses the surface where the path began. If the path rises from there, it is followed over its top, so that it is hit
// where it comes down.

// The first distance as a fraction of a step; it doubles each time.
const RISE: Real = 1e-3;
const RISES: u32 = 11u;
// Relative to the numbers that the position was computed from: nearer than the start of a path that left a surface for good.
const ON_SURFACE: Real = 4e-6;

fn pass_top(code: u32, hit: Hit, step: LastStep, h: ptr<function, Real>) {
    if !ends_on_surface(code) {
        return;
    }
    let start = step.phase[0].xyz;
    let surface = hit_surface(hit.primitive, start);
    // The side on which it began; unknown if it began on the surface itself.
    let side = select(surface.signed_distance, 0.0, abs(surface.signed_distance) < ON_SURFACE * (length(start) + surface.depth));
    var further = RISE * step.h;
    for (var i = 0u; i < RISES; i++) {
        let p = retaken_step(step.phase, *h);
        if side * dot(stop_distance(code, hit, p[0].xyz).xyz, p[1].xyz) <= 0.0 {
            break;
        }
        *h = min(*h + further, step.h);
        further *= 2.0;
    }
}
