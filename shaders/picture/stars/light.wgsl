// The images of stars in a cell of the grid, and the mean light of many stars.

struct StarCounts {
    // The number of images.
    images: atomic<u32>,
    // Those whose brightness the size of the star's disk limits.
    limited: atomic<u32>,
    // The number of cells that show the mean light of many stars.
    averaged: atomic<u32>,
    // The number of images without room.
    lost: atomic<u32>,
    // The number of images of the grid, and of lights that fill their cells.
    listed: atomic<u32>,
}

var<storage, read_write> star_counts: StarCounts;

// The images in the cell so far, as in `star_heads`.
var<private> first_image: u32;

// Returns a value between those at the corners.
fn between(values: vec4f, at: vec2f) -> f32 {
    return mix(mix(values.x, values.y, at.x), mix(values.z, values.w, at.x), at.y);
}

fn weight_at(at: vec2f) -> vec3f {
    let upper = mix(corner_rays[0].weight, corner_rays[1].weight, at.x);
    return mix(upper, mix(corner_rays[2].weight, corner_rays[3].weight, at.x), at.y);
}

fn shift_at(at: vec2f) -> f32 {
    let shifts = vec4f(corner_rays[0].shift, corner_rays[1].shift, corner_rays[2].shift, corner_rays[3].shift);
    return between(shifts, at);
}

// Returns the color of a star with the luminance of its unshifted light as unit. A star of unknown color, with 0 kelvins, is white.
fn star_color(kelvins: f32, g: f32) -> vec3f {
    if kelvins > 0.0 {
        return black_body_color(kelvins * g, kelvins);
    }
    return vec3f(g * g * g * g);
}

// Returns the smallest area that the disk of a star allows: within its radius of a critical curve, the brightness does not grow further.
fn least_area(point: PatchPoint, at: vec2f) -> f32 {
    let slope = vec2f(
        mix(corner_areas.y - corner_areas.x, corner_areas.w - corner_areas.z, at.y),
        mix(corner_areas.z - corner_areas.x, corner_areas.w - corner_areas.y, at.x),
    );
    let steepest = length(slope);
    let across = length(point.across * slope.x + point.down * slope.y);
    return select(0.0, 0.5 * steepest * steepest * cell_sky.radius / across, across > 0.0);
}

fn add_image(star: Star, way: vec3f, start: vec2f) {
    let place = patch_place(way, start);
    let point = place.point;
    let at = place.at;
    let own = abs(patch_area(point));
    let least = least_area(point, at);
    let area = max(own, least);
    let within = clamp(at, vec2f(0.0), vec2f(1.0));
    let color = star.flux * star_color(star.kelvins, shift_at(within));
    let light = weight_at(within) * color / area;
    if !(area > 0.0) || !finite(Real3(light)) {
        return;
    }
    add_light(light, within);
    atomicAdd(&star_counts.images, 1u);
    if own < least {
        atomicAdd(&star_counts.limited, 1u);
    }
}

// Adds an image to the cell.
fn add_light(light: vec3f, at: vec2f) {
    let n = atomicAdd(&star_counts.listed, 1u);
    if n < arrayLength(&star_images) {
        star_images[n] = StarImage(light, first_image, at);
        first_image = n + 1u;
    } else {
        atomicAdd(&star_counts.lost, 1u);
    }
}

// Returns light that is even over a part of the sky, as the observer sees it.
fn shifted_mean(mean: vec3f, g: f32) -> vec3f {
    if BEAMS {
        seen_shift = Real(g);
        return beamed(mean);
    }
    return mean;
}

// Adds light that fills the area of the cell.
fn fill_cell(light: vec3f) {
    add_light(light, vec2f(EVERYWHERE));
    atomicAdd(&star_counts.averaged, 1u);
}

// Adds the mean light of the whole sky to a cell at the edge of an object or of a black hole, for each of its rays that reach the sky.
fn add_edge() {
    var light = vec3f(0.0);
    for (var k = 0u; k < 4u; k++) {
        let ray = corner_rays[k];
        if ray.end != 0u {
            light += 0.25 * ray.weight * shifted_mean(star_sky(ray.end).mean, ray.shift);
        }
    }
    fill_cell(light);
}

// Adds the mean light of the stars in a wide cell, which fills its area. The buckets of the mean are about a quarter as wide as the cell.
fn add_mean(corners: array<vec3f, 4>) {
    let ahead = corners[0] + corners[1] + corners[2] + corners[3];
    let size = abs(ahead);
    let axis = select(select(2u, 1u, size.y >= size.z), 0u, size.x >= max(size.y, size.z));
    let face = 2u * axis + u32(ahead[axis] < 0.0);
    var buckets = max(cell_sky.buckets / FINEST_MEAN, 1u);
    var first = cell_sky.first_mean;
    var within = face_box(face, corners, buckets, 0.0);
    loop {
        let coarser = within.count > MOST_MEANS && buckets > 1u;
        first += select(0u, 6u * buckets * buckets, coarser);
        buckets = select(buckets, buckets / 2u, coarser);
        within = face_box(face, corners, buckets, 0.0);
        continuing {
            break if !coarser;
        }
    }
    var light = vec3f(0.0);
    var area = 0.0;
    let columns = within.last.x - within.first.x + 1u;
    for (var k = 0u; k < within.count; k++) {
        let bucket = within.first + vec2u(k % columns, k / columns);
        light += star_list[first + (face * buckets + bucket.y) * buckets + bucket.x].xyz;
        let place = (2.0 * vec2f(bucket) + 1.0) / f32(buckets) - 1.0;
        let far2 = 1.0 + dot(place, place);
        area += 4.0 / (f32(buckets * buckets) * far2 * sqrt(far2));
    }
    if !(area > 0.0) {
        return;
    }
    fill_cell(weight_at(vec2f(0.5)) * shifted_mean(light / area, shift_at(vec2f(0.5))));
}

// A cell that covers more buckets of a mean than this uses the next coarser level.
const MOST_MEANS: u32 = 36u;
