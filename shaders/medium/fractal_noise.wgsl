// The noise of T §2.4: the lattice blended by Catmull–Rom splines along all three axes, from 64 points, and the fractal sum of
// its octaves (Eq. 10).
//
// One octave overshoots its lattice values, to 125/64 at most. Its gradient is continuous and analytic here: splines again, with the
// derivatives of the weights.

// Returns a pseudo-random number in [-1, 1] for a point of the lattice, always the same one: a hash of its mixed coordinates.
fn lattice(cell: vec3i, seed: u32) -> Real {
    let c = bitcast<vec3u>(cell);
    let mixed = (c.x * 0x8da6b343u) ^ (c.y * 0xd8163841u) ^ (c.z * 0xcb1ab31fu) ^ (seed * 0x9e3779b1u);
    return Real(hashed(mixed) >> 8u) / 8388607.5 - 1.0;
}

// Returns the weights of four points, at −1, 0, 1 and 2, for t from 0 to 1.
fn spline_weights(t: Real) -> Real4 {
    return 0.5 * Real4(t * (t * (2.0 - t) - 1.0), t * t * (3.0 * t - 5.0) + 2.0, t * (t * (4.0 - 3.0 * t) + 1.0), t * t * (t - 1.0));
}

fn spline_slopes(t: Real) -> Real4 {
    return 0.5 * Real4(t * (4.0 - 3.0 * t) - 1.0, t * (9.0 * t - 10.0), t * (8.0 - 9.0 * t) + 1.0, t * (3.0 * t - 2.0));
}

// Returns four points of the lattice in a row along x.
fn lattice_row(cell: vec3i, seed: u32) -> Real4 {
    return Real4(
        lattice(cell - vec3i(1, 0, 0), seed),
        lattice(cell, seed),
        lattice(cell + vec3i(1, 0, 0), seed),
        lattice(cell + vec3i(2, 0, 0), seed),
    );
}

// Returns the gradient and value of one octave.
fn cubic_noise(p: Real3, seed: u32) -> Real4 {
    let base = floor(p);
    let t = p - base;
    let cell = vec3i(base);
    let across = spline_weights(t.x);
    let across_slope = spline_slopes(t.x);
    let up = spline_weights(t.y);
    let up_slope = spline_slopes(t.y);
    let into = spline_weights(t.z);
    let into_slope = spline_slopes(t.z);
    var sum = Real4(0.0);
    for (var k = 0; k < 4; k++) {
        let layer = cell + vec3i(0, 0, k - 1);
        let a = lattice_row(layer - vec3i(0, 1, 0), seed);
        let b = lattice_row(layer, seed);
        let c = lattice_row(layer + vec3i(0, 1, 0), seed);
        let d = lattice_row(layer + vec3i(0, 2, 0), seed);
        let rows = Real4(dot(a, across), dot(b, across), dot(c, across), dot(d, across));
        let slopes = Real4(dot(a, across_slope), dot(b, across_slope), dot(c, across_slope), dot(d, across_slope));
        let value = dot(rows, up);
        sum += Real4(into[k] * dot(slopes, up), into[k] * dot(rows, up_slope), into_slope[k] * value, into[k] * value);
    }
    return sum;
}

// Returns the gradient and value of Σ 2⁻ʲ noise(2ʲ p). The gradient's factors 2⁻ʲ 2ʲ cancel.
fn fractal_noise(p: Real3, octaves: u32, seed: u32) -> Real4 {
    var sum = Real4(0.0);
    var place_in_octave = p;
    var weight: Real = 1.0;
    for (var j = 0u; j < octaves; j++) {
        let noise = cubic_noise(place_in_octave, seed);
        sum += Real4(noise.xyz, weight * noise.w);
        place_in_octave *= 2.0;
        weight *= 0.5;
    }
    return sum;
}
