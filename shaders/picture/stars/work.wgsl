// Lists the cells of the grid in which there are stars.

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

var<storage, read_write> star_work_out: StarWork;
var<storage, read> star_work_in: StarWorkRead;
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
        vec3f(grid_rays[place].place),
        vec3f(grid_rays[place + 1u].place),
        vec3f(grid_rays[below].place),
        vec3f(grid_rays[below + 1u].place),
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
    let sides = face_sides(within);
    var scan = star_scan(face, within, own);
    var found = false;
    loop {
        if scan.star < scan.until {
            let at = star_list[scan.star].xy;
            found = all(at >= within.low) & all(at <= within.high) & between_sides(sides, at);
            scan.star++;
        } else {
            scan = next_row(scan, own.buckets);
        }
        continuing {
            break if found || scan_ended(scan);
        }
    }
    return found;
}

// Returns how far the sides of a cell in one direction of the grid are curved, from the rays before and after them.
fn bent(pixel: vec2u, stride: u32, a: vec3f, b: vec3f, end: u32) -> f32 {
    let place = place_in_tile(pixel);
    let before = grid_rays[place - stride];
    let after = grid_rays[place + 2u * stride];
    let first = select(0.0, distance(vec3f(before.place) + b, 2.0 * a), before.end == end);
    let last = select(0.0, distance(a + vec3f(after.place), 2.0 * b), after.end == end);
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

// Finds the images in the n-th cell of the list.
fn light_listed_cell(n: u32) {
    let packed = star_work_in.cells[n];
    let pixel = vec2u(packed & 0xffffu, packed >> 16u);
    star_heads[place_in_tile(pixel)] = images_in_cell(pixel);
}
