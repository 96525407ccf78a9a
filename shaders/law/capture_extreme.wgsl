// Rays that move inwards near the horizon of a hole that spins nearly as fast as it may are captured if they do not turn before it.

struct CaptureSphere {
    center: Real3,
    radius: Real,
    // What its kind has besides a position, and its kind.
    along: Real3,
    kind: u32,
}

@group(0) @binding(61) var<uniform> capture_spheres: array<CaptureSphere, CAPTURE_COUNT>;

fn capture_offset(x: Real3) -> Real3 {
    return anchor_offset(capture_spheres[0].kind, x - capture_spheres[0].center, capture_spheres[0].along);
}

fn law_captured(x: Real3, v: Real3) -> bool {
    let d = capture_offset(x);
    if dot(d, d) < capture_spheres[0].radius * capture_spheres[0].radius && dot(d, v) < 0.0 {
        return !orbit_turns(orbit_of(x, v));
    }
    return false;
}

fn inside_capture(x: Real3) -> bool {
    let d = capture_offset(x);
    return dot(d, d) < capture_spheres[0].radius * capture_spheres[0].radius;
}

fn captured_within() -> Real {
    return capture_spheres[0].radius;
}

fn capture_gap(x: Real3) -> Real4 {
    let d = capture_offset(x);
    let r = length(d);
    return Real4(d / r, r - capture_spheres[0].radius);
}
