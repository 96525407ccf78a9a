// The disturbed air of W04 Fig. 4(d), a noise-based index after an explosion:
// n(x) = 1 + amplitude · ξ(r/R) · Σ 2⁻ʲ noise(2ʲ · frequency · (x − c)), ξ(q) = 2q³ − 3q² + 1, so that n = 1 outside R.
//
// The lattice noise is blended by the quintic 6t⁵ − 15t⁴ + 10t³, whose second derivative has no jumps: with the Catmull–Rom blend of
// T §2.4 ∇n has kinks at the faces of cells, where RK4 would lose its order. ∇n is the analytic derivative.

struct Medium {
    center: Real3,
    radius: Real,
    amplitude: Real,
    frequency: Real,
    octaves: u32,
    seed: u32,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;

// The lattice is rotated and shifted relative to the scene's axes: value noise has no slope across the faces of its cells, and a camera in
// such a plane would see that.
const LATTICE_TURN = mat3x3<Real>(
    Real3(0.36, 0.48, -0.8),
    Real3(-0.8, 0.6, 0.0),
    Real3(0.48, 0.64, 0.6),
);
const LATTICE_SHIFT = Real3(0.317, 0.731, 0.523);

// Returns the gradient and value of the noise.
fn lattice_noise(p: Real3) -> Real4 {
    let base = floor(p);
    let f = p - base;
    let i = vec3i(base);
    let u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    let seed = media[place].seed;
    let a = lattice(i, seed);
    let b = lattice(i + vec3i(1, 0, 0), seed);
    let c = lattice(i + vec3i(0, 1, 0), seed);
    let d = lattice(i + vec3i(1, 1, 0), seed);
    let e = lattice(i + vec3i(0, 0, 1), seed);
    let g = lattice(i + vec3i(1, 0, 1), seed);
    let h = lattice(i + vec3i(0, 1, 1), seed);
    let k = lattice(i + vec3i(1, 1, 1), seed);
    // The trilinear form as a polynomial in u, so that its derivatives can be read off.
    let x = b - a;
    let y = c - a;
    let z = e - a;
    let xy = a - b - c + d;
    let yz = a - c - e + h;
    let zx = a - b - e + g;
    let xyz = b + c + e + k - a - d - g - h;
    let value = a + x * u.x + y * u.y + z * u.z + xy * u.x * u.y + yz * u.y * u.z + zx * u.z * u.x + xyz * u.x * u.y * u.z;
    let slope = Real3(
        x + xy * u.y + zx * u.z + xyz * u.y * u.z,
        y + yz * u.z + xy * u.x + xyz * u.z * u.x,
        z + zx * u.x + yz * u.y + xyz * u.x * u.y,
    );
    return Real4(du * slope, value);
}

// Returns ∇n and n.
fn explosion(x: Real3) -> Real4 {
    let medium = media[place];
    let d = x - medium.center;
    var sum = Real4(0.0);
    var frequency = medium.frequency;
    var weight: Real = 1.0;
    for (var j = 0u; j < medium.octaves; j++) {
        let noise = lattice_noise(LATTICE_TURN * (frequency * d) + LATTICE_SHIFT);
        sum += weight * Real4(frequency * (noise.xyz * LATTICE_TURN), noise.w);
        frequency *= 2.0;
        weight *= 0.5;
    }
    let r = length(d);
    let q = min(r / medium.radius, 1.0);
    let xi = q * q * (2.0 * q - 3.0) + 1.0;
    // ξ′(q) n̂/R = 6 (q − 1) d/R²: no division by r remains.
    let slope = (6.0 * (q - 1.0) / (medium.radius * medium.radius)) * d;
    return Real4(medium.amplitude * (xi * sum.xyz + sum.w * slope), 1.0 + medium.amplitude * xi * sum.w);
}

fn medium_index(x: Real3) -> Real {
    return explosion(x).w;
}

fn medium_pull(x: Real3) -> Real3 {
    let n = explosion(x);
    return n.w * n.xyz;
}

// Returns the characteristic length of the index: a cell of the finest octave inside, the distance to the disturbed region outside.
fn medium_length(x: Real3) -> Real {
    let medium = media[place];
    let cell = 1.0 / (Real(1u << (medium.octaves - 1u)) * medium.frequency);
    return max(min(cell, medium.radius), distance(x, medium.center) - medium.radius);
}
