// Rays inside a sphere and moving inwards are captured. For a Schwarzschild hole the sphere is the horizon, or wider, up to
// the photon sphere r = 3M, where nothing of the scene lies between: what moves inwards there never comes back. Round
// a hole that spins nearly as fast as it may, what turns before the horizon is not captured. A line element may say by a formula where rays
// that move further in end.

struct CaptureSphere {
    center: Real3,
    radius: Real,
    // What its kind has besides a position, and its kind.
    along: Real3,
    kind: u32,
}

var<uniform> capture_spheres: array<CaptureSphere, CAPTURE_COUNT>;

fn law_captured(x: Real3, v: Real3) -> bool {
    if CAPTURES_BY_FORMULA {
        let gap = metric_gap(metric_place(x));
        return gap.w < 0.0 && dot(gap.xyz, v) < 0.0;
    }
    if !CAPTURES {
        return false;
    }
    var captured = false;
    for (var i = 0u; i < CAPTURE_COUNT; i++) {
        let d = anchor_offset(capture_spheres[i].kind, x - capture_spheres[i].center, capture_spheres[i].along);
        captured = captured || (dot(d, d) < capture_spheres[i].radius * capture_spheres[i].radius && dot(d, v) < 0.0);
    }
    if IS_EXTREME {
        if captured {
            captured = !orbit_turns(orbit_of(x, v));
        }
    }
    return captured;
}

// Is x inside of one of the spheres, wherever it moves?
fn inside_capture(x: Real3) -> bool {
    if CAPTURES_BY_FORMULA {
        return metric_gap(metric_place(x)).w < 0.0;
    }
    if !CAPTURES {
        return false;
    }
    var within = false;
    for (var i = 0u; i < CAPTURE_COUNT; i++) {
        let d = anchor_offset(capture_spheres[i].kind, x - capture_spheres[i].center, capture_spheres[i].along);
        within = within | (dot(d, d) < capture_spheres[i].radius * capture_spheres[i].radius);
    }
    return within;
}

// About the only centre.
fn captured_within() -> Real {
    if !CAPTURES {
        return 0.0;
    }
    return capture_spheres[0].radius;
}

// The outward normal and the signed distance of the nearest of the spheres.
fn capture_gap(x: Real3) -> Real4 {
    if CAPTURES_BY_FORMULA {
        let gap = metric_gap(metric_place(x));
        let steep = length(gap.xyz);
        return Real4(gap.xyz / steep, gap.w / steep);
    }
    if !CAPTURES {
        return Real4(0.0);
    }
    var nearest = Real4(0.0, 0.0, 0.0, 1e30);
    for (var i = 0u; i < CAPTURE_COUNT; i++) {
        let d = anchor_offset(capture_spheres[i].kind, x - capture_spheres[i].center, capture_spheres[i].along);
        let gap = length(d) - capture_spheres[i].radius;
        if gap < nearest.w {
            nearest = Real4(normalize(d), gap);
        }
    }
    return nearest;
}
