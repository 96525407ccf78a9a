// Interpolates the directions of a cell of the grid and its neighbors: a bicubic (Catmull–Rom) patch, whose derivatives at the corners are
// central differences. Its Jacobian determinant is accurate near critical curves, where the corners of a cell span no area.

// The directions around a cell, row by row; the corners of the cell are 5, 6, 9 and 10.
var<private> patch_ways: array<vec3f, 16>;

struct PatchPoint {
    way: vec3f,
    across: vec3f,
    down: vec3f,
}

// Returns the weights of four points at the parameter t between the second and the third.
fn cubic_weights(t: f32) -> vec4f {
    let t2 = t * t;
    let t3 = t2 * t;
    return 0.5 * vec4f(2.0 * t2 - t - t3, 3.0 * t3 - 5.0 * t2 + 2.0, t + 4.0 * t2 - 3.0 * t3, t3 - t2);
}

// Returns the derivatives of these weights.
fn cubic_slopes(t: f32) -> vec4f {
    let t2 = t * t;
    return 0.5 * vec4f(4.0 * t - 1.0 - 3.0 * t2, 9.0 * t2 - 10.0 * t, 1.0 + 8.0 * t - 9.0 * t2, 3.0 * t2 - 2.0 * t);
}

fn patch_row(row: u32, weights: vec4f) -> vec3f {
    let first = 4u * row;
    return weights.x * patch_ways[first] + weights.y * patch_ways[first + 1u] + weights.z * patch_ways[first + 2u]
        + weights.w * patch_ways[first + 3u];
}

fn patch_columns(weights: vec4f, rows: vec4f) -> vec3f {
    return rows.x * patch_row(0u, weights) + rows.y * patch_row(1u, weights) + rows.z * patch_row(2u, weights)
        + rows.w * patch_row(3u, weights);
}

// Returns the direction at a point of the cell. At a corner it is exactly the corner's own.
fn patch_way(at: vec2f) -> vec3f {
    return patch_columns(cubic_weights(at.x), cubic_weights(at.y));
}

fn patch_point(at: vec2f) -> PatchPoint {
    let x = cubic_weights(at.x);
    let y = cubic_weights(at.y);
    return PatchPoint(patch_columns(x, y), patch_columns(cubic_slopes(at.x), y), patch_columns(x, cubic_slopes(at.y)));
}

// Returns the solid angle of the sky per area of the image, in pixels, with the sign of the parity.
fn patch_area(point: PatchPoint) -> f32 {
    let length2 = dot(point.way, point.way);
    return dot(point.way, cross(point.across, point.down)) / (length2 * sqrt(length2));
}

// A position in the cell, and the patch there.
struct PatchPlace {
    at: vec2f,
    point: PatchPoint,
}

// Finds the point of the patch at which the direction is `s`, by Newton's method from `start`.
fn patch_place(s: vec3f, start: vec2f) -> PatchPlace {
    let first = normalize(cross(s, select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0), abs(s.x) > 0.6)));
    let second = cross(s, first);
    var at = start;
    var point: PatchPoint;
    var i = 0u;
    var settled = false;
    loop {
        point = patch_point(at);
        let off = vec2f(dot(point.way - s, first), dot(point.way - s, second));
        let across = vec2f(dot(point.across, first), dot(point.across, second));
        let down = vec2f(dot(point.down, first), dot(point.down, second));
        let area = across.x * down.y - across.y * down.x;
        let change = vec2f(off.x * down.y - off.y * down.x, across.x * off.y - across.y * off.x) / area;
        i++;
        settled = all(abs(change) < vec2f(LAST_CHANGE)) || i >= NEWTON_ROUNDS;
        let next = at - clamp(change, vec2f(-0.5), vec2f(0.5));
        // Without a solution near the start, the start itself is the best one.
        let is_near = all(abs(next - start) <= vec2f(1.0));
        at = select(select(start, next, is_near), at, settled);
        continuing {
            break if settled;
        }
    }
    return PatchPlace(at, point);
}

const NEWTON_ROUNDS: u32 = 5u;
// A change of the position that no longer matters.
const LAST_CHANGE: f32 = 1e-4;
