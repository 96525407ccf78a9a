// Samples on regular grids as functions of position in the formulas of volumes: trilinear between the samples, so that values stay between
// theirs, and 0 outside.

struct VolumeGrid {
    // The position of the first sample.
    origin: Real3,
    // The distance between samples along each axis.
    cell: Real3,
    // The number of samples along each axis, at least 2, and the index of the first one in the list of all samples.
    size: vec4u,
}

var<uniform> volume_grids: array<VolumeGrid, VOLUME_GRIDS>;
var<storage, read> volume_samples: array<f32>;

// Returns the value of a grid at a position in the coordinates of the formulas.
fn grid_value(k: u32, x: Real3) -> Real {
    let grid = volume_grids[k];
    let p = (x - grid.origin) / grid.cell;
    let last = Real3(grid.size.xyz - 1u);
    let base = clamp(floor(p), Real3(0.0), last - 1.0);
    let f = p - base;
    let i = vec3u(base);
    let start = grid.size.w + i.x + grid.size.x * (i.y + grid.size.y * i.z);
    let above = grid.size.x * grid.size.y;
    let near = mix(grid_row(start, f.x), grid_row(start + grid.size.x, f.x), f.y);
    let far = mix(grid_row(start + above, f.x), grid_row(start + above + grid.size.x, f.x), f.y);
    let is_outside = any(p < Real3(0.0)) || any(p > last);
    return select(mix(near, far, f.z), 0.0, is_outside);
}

fn grid_row(start: u32, f: Real) -> Real {
    return mix(Real(volume_samples[start]), Real(volume_samples[start + 1u]), f);
}
