// From a spinning hole: as long as Kerr's r, which is the same all over a flattened spheroid, and square to that. `along` is the spin a.

fn offset_spheroid(d: Real3, along: Real3) -> Real3 {
    let k = 0.5 * (dot(d, d) - dot(along, along));
    let height = dot(along, d);
    let root = sqrt(k * k + height * height);
    let r = sqrt(max(select(height * height / (root - k), k + root, k > 0.0), 1e-30));
    return r * normalize(r * d + (height / r) * along);
}
