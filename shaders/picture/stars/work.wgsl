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
    let ends = vec4u(sky_rays[place].end, sky_rays[place + 1u].end, sky_rays[below].end, sky_rays[below + 1u].end);
    if any(ends != vec4u(ends.x)) {
        return true;
    }
    if ends.x == 0u {
        return false;
    }
    let corners = array<vec3f, 4>(
        sky_rays[place].way,
        sky_rays[place + 1u].way,
        sky_rays[below].way,
        sky_rays[below + 1u].way,
    );
    let own = star_skies[ends.x & 1u];
    let bulge = bent(pixel, 1u, corners[0], corners[1], ends.x) + bent(pixel, frame.size.x, corners[0], corners[2], ends.x);
    var lit = spread(corners) > WIDEST_CELL;
    var scan = star_scan(corners, bulge);
    loop {
        if scan.star < scan.until {
            let at = star_list[scan.star].place;
            lit |= all(at >= scan.within.low) & all(at <= scan.within.high);
            scan.star++;
        } else {
            scan = next_range(scan, corners, own, bulge);
        }
        continuing {
            break if lit || !scan.more;
        }
    }
    return lit;
}

// Returns how far the sides of a cell in one direction of the grid are curved, from the rays before and after them.
fn bent(pixel: vec2u, stride: u32, a: vec3f, b: vec3f, end: u32) -> f32 {
    let place = place_in_tile(pixel);
    let before = sky_rays[place - stride];
    let after = sky_rays[place + 2u * stride];
    let first = select(0.0, distance(before.way + b, 2.0 * a), before.end == end);
    let last = select(0.0, distance(a + after.way, 2.0 * b), after.end == end);
    // A parabola deviates from its chord by an eighth of the second difference.
    return 0.25 * min(max(first, last), WIDEST_CELL);
}

// Appends a cell to the list. The first cell of each group of the dispatch raises the number of groups.
fn list_cell(pixel: vec2u) {
    let n = atomicAdd(&star_work_out.count, 1u);
    star_work_out.cells[n] = pixel.x | (pixel.y << 16u);
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
        star_slots[place_in_tile(pixel)] = n + 1u;
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
    var sum = vec3f(0.0);
    for (var k = 0u; k < 16u; k++) {
        let slot = star_slots[place_in_tile(pixel + 1u - vec2u(k & 3u, k >> 2u))];
        if slot > 0u {
            let at = 3u * k;
            sum += vec3f(star_cells[slot - 1u].light[at], star_cells[slot - 1u].light[at + 1u], star_cells[slot - 1u].light[at + 2u]);
        }
    }
    return sum;
}
