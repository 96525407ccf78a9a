// An index given by samples on a regular grid. Between them it is the tri-cubic Catmull–Rom spline, which goes through the samples
// and whose gradient is continuous; the gradient is the spline's own. Beyond the grid the index is that at its border.

struct Medium {
    // The first sample's place.
    origin: Real3,
    // From one sample to the next along each axis.
    cell: Real3,
    // Samples along each axis, 2 or more, and the place of the first in the list of all grids' samples.
    size: vec4u,
}

var<uniform> media: array<Medium, MEDIA_COUNT>;
var<storage, read> index_samples: array<f32>;

// What the four samples round a place weigh, at a fraction t between the inner two; and how that changes with t.
fn sample_weights(t: Real) -> Real4 {
    let s = t - 1.0;
    return 0.5 * Real4(-t * s * s, s * (3.0 * t * t - 2.0 * t - 2.0), -t * (3.0 * t * t - 4.0 * t - 1.0), t * t * s);
}

fn sample_slopes(t: Real) -> Real4 {
    return 0.5 * Real4(-(3.0 * t - 1.0) * (t - 1.0), t * (9.0 * t - 10.0), 1.0 + t * (8.0 - 9.0 * t), t * (3.0 * t - 2.0));
}

// Four samples along x, those beyond the border being the last.
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

// ∇n and n.
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
    // Beyond the border nothing changes along that axis.
    let slope = select(Real3(0.0), sum.xyz / medium.cell, p == q);
    return Real4(slope, sum.w);
}

fn medium_index(x: Real3) -> Real {
    return limited_index(index_spline(x).w);
}

// ∇(n²/2).
fn medium_pull(x: Real3) -> Real3 {
    return limited_pull(index_spline(x));
}

// The length over which the index changes: a cell.
fn medium_length(x: Real3) -> Real {
    let cell = media[place].cell;
    return min(cell.x, min(cell.y, cell.z));
}
