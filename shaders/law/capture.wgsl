// Captures rays that are inside a sphere and move inwards. For a Schwarzschild black hole the sphere is the horizon, or a larger one up to
// the photon sphere r = 3M if it contains nothing of the scene: a ray that moves inwards there never returns. Around a nearly extremal
// black hole rays that turn before the horizon are not captured. A custom metric may specify the capture surface by a formula.

struct CaptureSphere {
    center: Real3,
    radius: Real,
    // The direction or spin that the kind of source needs, and the kind.
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

// Returns `true` if x is inside one of the spheres, in whatever direction it moves.
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

// Returns the capture radius around the only center.
fn captured_within() -> Real {
    if !CAPTURES {
        return 0.0;
    }
    return capture_spheres[0].radius;
}

// Returns the outward normal and the signed distance of the nearest sphere.
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
