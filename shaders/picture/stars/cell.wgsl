// Finds the images of stars in a cell of the grid, the square between the centers of four pixels.
//
// A star is a sky of radiance F δ(Ω − Ω_s), so that an image at p has the radiance F w K(x − p)/|J(p)|: w is the factor of the sky's light on
// its way, J = Ω·(∂Ω/∂x × ∂Ω/∂y) the solid angle of the sky per area of the image, and K a filter whose weights over the pixels sum to 1. The
// filter is the cubic B-spline, with which stars that move over the pixels do not twinkle on a screen.

// The largest distance of directions within one smooth bundle of light.
const WIDEST_CELL: f32 = 0.5;
// A cell that covers more buckets than this shows the mean light of its stars.
const MOST_BUCKETS: u32 = 64u;
// Cells are divided if the areas at their corners differ by more than this factor.
const UNEVEN: f32 = 3.0;
// The number of parts of such cells along each side.
const PARTS: u32 = 4u;

// The sky of the cell.
var<private> cell_sky: StarSky;
// The rays at its corners, in reading order, and the one that is missing; 4 if all are there.
var<private> corner_rays: array<GridRay, 4>;
var<private> corner_missing: u32;
// The areas at its corners.
var<private> corner_areas: vec4f;

// Returns the position in the grid of one of the 16 rays around a cell.
fn patch_place_at(pixel: vec2u, k: u32) -> u32 {
    return place_in_tile(pixel + vec2u(k & 3u, k >> 2u) - 1u);
}

// Reads the patch around a cell. Returns `false` if the cell does not show one smooth part of a sky.
fn load_patch(pixel: vec2u) -> bool {
    for (var k = 0u; k < 4u; k++) {
        let place = patch_place_at(pixel, 5u + (k & 1u) + 4u * (k >> 1u));
        corner_rays[k] = grid_rays[place];
        corner_rays[k].end = star_end(place);
    }
    let a = corner_rays[0];
    let b = corner_rays[1];
    let c = corner_rays[2];
    let d = corner_rays[3];
    let end = select(d.end, a.end, a.end == b.end || a.end == c.end || a.end == d.end);
    let there = vec4u(a.end, b.end, c.end, d.end) == vec4u(end);
    let missing = vec4u(!there);
    corner_missing = select(dot(missing, vec4u(0u, 1u, 2u, 3u)), 4u, all(there));
    if end == 0u || missing.x + missing.y + missing.z + missing.w > 1u {
        return false;
    }
    // The rest of a parallelogram.
    if corner_missing < 4u {
        let opposite = corner_rays[3u - corner_missing];
        var filled = opposite;
        filled.end = 0u;
        filled.place = b.place + c.place - opposite.place;
        if corner_missing == 1u || corner_missing == 2u {
            filled.place = a.place + d.place - opposite.place;
        }
        corner_rays[corner_missing] = filled;
    }
    var own = 0u;
    for (var k = 0u; k < 16u; k++) {
        let ray = grid_rays[patch_place_at(pixel, k)];
        patch_ways[k] = vec3f(ray.place);
        own |= select(0u, 1u, ray.end == end) << k;
    }
    for (var k = 0u; k < 4u; k++) {
        patch_ways[5u + (k & 1u) + 4u * (k >> 1u)] = vec3f(corner_rays[k].place);
    }
    extend_patch(own);
    return spread(cell_corners()) < WIDEST_CELL;
}

// Returns the directions at the corners of the cell.
fn cell_corners() -> array<vec3f, 4> {
    return array<vec3f, 4>(patch_ways[5], patch_ways[6], patch_ways[9], patch_ways[10]);
}

// Returns the largest distance of four directions.
fn spread(p: array<vec3f, 4>) -> f32 {
    let sides = max(max(distance(p[0], p[1]), distance(p[2], p[3])), max(distance(p[0], p[2]), distance(p[1], p[3])));
    return max(sides, max(distance(p[0], p[3]), distance(p[1], p[2])));
}

// Continues the directions of a cell in straight lines to neighbors that do not belong to it. own: the rays with the end of the cell, as
// bits.
fn extend_patch(own: u32) {
    for (var i = 0u; i < 2u; i++) {
        let row = 4u + 4u * i;
        continue_patch(own, row, row + 1u, row + 2u);
        continue_patch(own, row + 3u, row + 2u, row + 1u);
        continue_patch(own, 1u + i, 5u + i, 9u + i);
        continue_patch(own, 13u + i, 9u + i, 5u + i);
    }
    for (var i = 0u; i < 4u; i++) {
        let k = 3u * (i & 1u) + 12u * (i >> 1u);
        let beside = select(k - 1u, k + 1u, (i & 1u) == 0u);
        let below = select(k - 4u, k + 4u, i < 2u);
        let corner = beside + below - k;
        let straight = patch_ways[beside] + patch_ways[below] - patch_ways[corner];
        patch_ways[k] = select(straight, patch_ways[k], belongs(own, k, corner));
    }
}

fn continue_patch(own: u32, k: u32, near: u32, far: u32) {
    patch_ways[k] = select(2.0 * patch_ways[near] - patch_ways[far], patch_ways[k], belongs(own, k, near));
}

fn belongs(own: u32, k: u32, near: u32) -> bool {
    return extractBits(own, k, 1u) == 1u && distance(patch_ways[k], patch_ways[near]) < WIDEST_CELL;
}

// Returns the area at a corner of the cell.
fn corner_area(k: u32) -> f32 {
    return patch_area(patch_point(vec2f(vec2u(k & 1u, k >> 1u))));
}

// Finds the light of a cell, and returns its first image.
fn images_in_cell(pixel: vec2u) -> u32 {
    first_image = 0u;
    if load_patch(pixel) {
        cell_sky = star_sky(corner_rays[select(0u, 3u, corner_missing == 0u)].end);
        find_images();
    } else {
        add_edge();
    }
    return first_image;
}

fn find_images() {
    let whole = cell_corners();
    var faces = faces_of(whole, 0.0);
    var buckets = 0u;
    loop {
        buckets += face_box(min(firstTrailingBit(faces), 5u), whole, cell_sky.buckets, 0.0).count;
        faces &= faces - 1u;
        continuing {
            break if faces == 0u;
        }
    }
    if buckets > MOST_BUCKETS {
        add_mean(whole);
        return;
    }
    for (var k = 0u; k < 4u; k++) {
        corner_areas[k] = corner_area(k);
    }
    let least = min(min(corner_areas.x, corner_areas.y), min(corner_areas.z, corner_areas.w));
    let most = max(max(corner_areas.x, corner_areas.y), max(corner_areas.z, corner_areas.w));
    let uneven = max(most, -least) > UNEVEN * max(least, -most) && corner_missing == 4u;
    let parts = select(1u, PARTS, uneven);
    var part = 0u;
    loop {
        let at = vec2f(vec2u(part % parts, part / parts));
        scan_part(at / f32(parts), 1.0 / f32(parts));
        part++;
        continuing {
            break if part >= parts * parts;
        }
    }
}
