// Lists the cells of the grid in which there are stars, and stores the light of each for the pixels around it.

struct StarWork {
    // The number of groups of a dispatch over the list.
    x: atomic<u32>,
    y: atomic<u32>,
    z: atomic<u32>,
    count: atomic<u32>,
    // The positions of the cells.
    cells: array<u32>,
}

struct StarWorkRead {
    x: u32,
    y: u32,
    z: u32,
    count: u32,
    cells: array<u32>,
}

// The radiance that a cell gives to the pixels around it, by channel, column and row.
struct StarCell {
    light: array<f32, 48>,
}

var<storage, read_write> star_work_out: StarWork;
var<storage, read> star_work_in: StarWorkRead;
// The number of each cell in the list, counted from 1; 0 if it is not there.
var<storage, read_write> star_slots: array<u32>;
// The light of the cells in the list.
var<storage, read_write> star_cells: array<StarCell>;

// The number of groups in one row of a dispatch with several rows.
const STAR_ROW: u32 = 32768u;

// Returns `true` if a cell has light: from its stars, or as the edge of a sky.
fn is_lit(pixel: vec2u) -> bool {
    if any(pixel < vec2u(1u)) || any(pixel + 2u >= frame.size) {
        return false;
    }
    // A cell between the two views of a stereo image is not a part of either.
    if view_of(sampled_pixel(pixel)) != view_of(sampled_pixel(pixel + 1u)) {
        return false;
    }
    let place = place_in_tile(pixel);
    let below = place + frame.size.x;
    let ends = vec4u(star_end(place), star_end(place + 1u), star_end(below), star_end(below + 1u));
    if any(ends != vec4u(ends.x)) {
        return true;
    }
    if ends.x == 0u {
        return false;
    }
    let corners = array<vec3f, 4>(
        grid_rays[place].place,
        grid_rays[place + 1u].place,
        grid_rays[below].place,
        grid_rays[below + 1u].place,
    );
    let own = star_sky(ends.x);
    let bulge = bent(pixel, 1u, corners[0], corners[1], ends.x) + bent(pixel, frame.size.x, corners[0], corners[2], ends.x);
    // Few cells cover several faces, and are listed without a test.
    let faces = faces_of(corners, bulge);
    return spread(corners) > WIDEST_CELL || countOneBits(faces) != 1u || has_star(corners, own, firstTrailingBit(faces), bulge);
}

// Returns `true` if there is a star in the box of a cell on a face.
fn has_star(corners: array<vec3f, 4>, own: StarSky, face: u32, bulge: f32) -> bool {
    let within = face_box(face, corners, own.buckets, bulge);
    let bucket = own.first_bucket + face * own.buckets * own.buckets;
    var row = within.first.y;
    var star = star_buckets[bucket + row * own.buckets + within.first.x];
    var until = select(star, star_buckets[bucket + row * own.buckets + within.last.x + 1u], within.count > 0u);
    var found = false;
    loop {
        if star < until {
            let at = star_list[star].place;
            found = all(at >= within.low) & all(at <= within.high);
            star++;
        } else {
            row++;
            star = star_buckets[bucket + row * own.buckets + within.first.x];
            until = select(star, star_buckets[bucket + row * own.buckets + within.last.x + 1u], row <= within.last.y);
        }
        continuing {
            break if found || (star >= until && row >= within.last.y);
        }
    }
    return found;
}

// Returns how far the sides of a cell in one direction of the grid are curved, from the rays before and after them.
fn bent(pixel: vec2u, stride: u32, a: vec3f, b: vec3f, end: u32) -> f32 {
    let place = place_in_tile(pixel);
    let before = grid_rays[place - stride];
    let after = grid_rays[place + 2u * stride];
    let first = select(0.0, distance(before.place + b, 2.0 * a), before.end == end);
    let last = select(0.0, distance(a + after.place, 2.0 * b), after.end == end);
    // A parabola deviates from its chord by an eighth of the second difference.
    return 0.25 * min(max(first, last), WIDEST_CELL);
}

// Appends a cell to the list. The first cell of each group of the dispatch raises the number of groups.
fn list_cell(pixel: vec2u) {
    let n = atomicAdd(&star_work_out.count, 1u);
    star_work_out.cells[n] = pixel.x | (pixel.y << 16u);
    star_slots[place_in_tile(pixel)] = n + 1u;
    if n % GROUP == 0u {
        let groups = n / GROUP + 1u;
        atomicMax(&star_work_out.x, min(groups, STAR_ROW));
        atomicMax(&star_work_out.y, (groups + STAR_ROW - 1u) / STAR_ROW);
        atomicMax(&star_work_out.z, 1u);
    }
}

// Computes the light of the n-th cell of the list.
fn light_listed_cell(n: u32) {
    let packed = star_work_in.cells[n];
    let pixel = vec2u(packed & 0xffffu, packed >> 16u);
    let light = light_of_cell(pixel);
    if n < arrayLength(&star_cells) {
        for (var k = 0u; k < 16u; k++) {
            star_cells[n].light[3u * k] = light[k].x;
            star_cells[n].light[3u * k + 1u] = light[k].y;
            star_cells[n].light[3u * k + 2u] = light[k].z;
        }
    } else {
        atomicAdd(&star_counts.lost, 1u);
    }
}

// Returns the light that a pixel receives from the stars in the 16 cells around it.
fn starlight(pixel: vec2u) -> vec3f {
    let last = place_in_tile(pixel + 1u);
    // The cells with light, as bits.
    var cells = 0u;
    for (var k = 0u; k < 16u; k++) {
        cells |= min(star_slots[last - (k & 3u) - (k >> 2u) * frame.size.x], 1u) << k;
    }
    var sum = vec3f(0.0);
    loop {
        if cells != 0u {
            let k = firstTrailingBit(cells);
            let n = star_slots[last - (k & 3u) - (k >> 2u) * frame.size.x] - 1u;
            sum += vec3f(star_cells[n].light[3u * k], star_cells[n].light[3u * k + 1u], star_cells[n].light[3u * k + 2u]);
            cells &= cells - 1u;
        }
        continuing {
            break if cells == 0u;
        }
    }
    return sum;
}
