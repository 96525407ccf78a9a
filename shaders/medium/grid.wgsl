// An index given by samples on a regular grid. Between them it is the tricubic Catmull–Rom spline, which passes through the samples and has
// a continuous gradient; the gradient is that of the spline. Beyond the grid the index is the one at the border.

struct Medium {
    // The position of the first sample.
    origin: Real3,
    // The distance between samples along each axis.
    cell: Real3,
    // The number of samples along each axis, at least 2, and the index of the first one in the list of all grids' samples.
    size: vec4u,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;
var<storage, read> index_samples: array<f32>;

// Returns the weights of the four samples around a position, at a fraction t between the inner two, or their derivatives by t.
fn sample_weights(t: Real) -> Real4 {
    let s = t - 1.0;
    return 0.5 * Real4(-t * s * s, s * (3.0 * t * t - 2.0 * t - 2.0), -t * (3.0 * t * t - 4.0 * t - 1.0), t * t * s);
}

fn sample_slopes(t: Real) -> Real4 {
    return 0.5 * Real4(-(3.0 * t - 1.0) * (t - 1.0), t * (9.0 * t - 10.0), 1.0 + t * (8.0 - 9.0 * t), t * (3.0 * t - 2.0));
}

// Returns four samples along x; beyond the border they repeat the last one.
fn sample_row(size: vec4u, i: i32, j: u32, k: u32) -> Real4 {
    let start = size.w + size.x * (j + size.y * k);
    let last = i32(size.x) - 1;
    return Real4(
        Real(index_samples[start + u32(clamp(i - 1, 0, last))]),
        Real(index_samples[start + u32(clamp(i, 0, last))]),
        Real(index_samples[start + u32(clamp(i + 1, 0, last))]),
        Real(index_samples[start + u32(clamp(i + 2, 0, last))]),
    );
}

// Returns ∇n and n.
fn index_spline(x: Real3) -> Real4 {
    let medium = media[place];
    let last = Real3(medium.size.xyz - 1u);
    let p = (x - medium.origin) / medium.cell;
    let q = clamp(p, Real3(0.0), last);
    let base = min(floor(q), last - 1.0);
    let f = q - base;
    let i = vec3i(base);
    let wx = sample_weights(f.x);
    let wy = sample_weights(f.y);
    let wz = sample_weights(f.z);
    let sx = sample_slopes(f.x);
    let sy = sample_slopes(f.y);
    let sz = sample_slopes(f.z);
    let border = vec3i(medium.size.xyz) - 1;
    var sum = Real4(0.0);
    for (var row = 0; row < 16; row++) {
        let b = row & 3;
        let c = row >> 2u;
        let j = u32(clamp(i.y + b - 1, 0, border.y));
        let k = u32(clamp(i.z + c - 1, 0, border.z));
        let values = sample_row(medium.size, i.x, j, k);
        let n = dot(wx, values);
        sum += Real4(dot(sx, values) * wy[b] * wz[c], n * sy[b] * wz[c], n * wy[b] * sz[c], n * wy[b] * wz[c]);
    }
    // Beyond the border the index is constant along that axis.
    let slope = select(Real3(0.0), sum.xyz / medium.cell, p == q);
    return Real4(slope, sum.w);
}

fn medium_index(x: Real3) -> Real {
    return limited_index(index_spline(x).w);
}

// Returns ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    return limited_pull(index_spline(x));
}

// Returns the characteristic length of the index: a cell.
fn medium_length(x: Real3) -> Real {
    let cell = media[place].cell;
    return min(cell.x, min(cell.y, cell.z));
}
