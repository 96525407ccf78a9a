// Draws directions from a cosᵉ lobe around an axis (T 2.2.3): p = (e + 1)/(2 pi) cosᵉ a, of which T Eq. 8 is the
// unnormalized form.

// Returns two unit vectors perpendicular to a third, which is the last column (Duff et al. 2017).
fn frame_about(n: vec3f) -> mat3x3f {
    let side = select(-1.0, 1.0, n.z >= 0.0);
    let a = -1.0 / (side + n.z);
    let b = n.x * n.y * a;
    return mat3x3f(vec3f(1.0 + side * n.x * n.x * a, side * b, -side * n.x), vec3f(b, side + n.y * n.y * a, -n.y), n);
}

// Returns the direction at an angle with this cosine and sine to an axis, and at an azimuth of `turns` turns.
fn way_about(axis: vec3f, cosine: f32, sine: f32, turns: f32) -> vec3f {
    let phi = 2.0 * f32(PI) * turns;
    return normalize(frame_about(axis) * vec3f(sine * cos(phi), sine * sin(phi), cosine));
}

// u: a point of the unit square.
fn lobe_way(axis: vec3f, exponent: f32, u: vec2f) -> vec3f {
    // cos² a = e^x; near the axis the sine by its series.
    let x = 2.0 * log(max(1.0 - u.x, 1e-30)) / (exponent + 1.0);
    let sine = sqrt(select(1.0 - exp(x), -x * (1.0 + 0.5 * x), x > -1e-3));
    return way_about(axis, exp(0.5 * x), sine, u.y);
}

// The number of this use of random points.
const LOBE: u32 = 8u;

// Returns a new point for every sample: the samples of one pixel are well distributed over the lobe. A ray that is traced follows the axis
// of every lobe.
fn lobe_point(pixel: vec2u, index: u32) -> vec2f {
    if FOLLOWS_PATHS {
        return path_point(pixel, LOBE);
    }
    if !DRAWS {
        return vec2f(0.0);
    }
    let whole = frame.origin + pixel;
    return seeded_point(hashed(whole.x ^ hashed(whole.y ^ hashed(index))));
}
