// The stars of a catalog, sorted into buckets on the faces of a cube, so that the stars in a part of the sky are a few ranges of the list.

struct Star {
    // The position on the face of its bucket, from -1 to 1.
    place: vec2f,
    // The illuminance of its light, in lux.
    flux: f32,
    kelvins: f32,
}

// For each sky its stars, sorted by face, row and column; then its light in coarser buckets: those eight times as wide, those twice as wide
// again, and so on up to a whole face.
var<storage, read> star_list: array<vec4f>;
// The first star of each bucket of each sky, and the end of the last one.
var<storage, read> star_buckets: array<u32>;

const FINEST_MEAN: u32 = 8u;

fn star_at(n: u32) -> Star {
    let row = star_list[n];
    return Star(row.xy, row.z, row.w);
}

// Returns the components of a direction along a face, and towards it. The faces are +x, -x, +y, -y, +z and -z, and the axes along a face
// follow its own in the order x, y, z, x, y.
fn on_face(face: u32, d: vec3f) -> vec3f {
    let turned = select(select(d.xyz, d.zxy, face >= 4u), d.yzx, (face >> 1u) == 1u);
    let towards = select(turned.x, -turned.x, (face & 1u) == 1u);
    return vec3f(turned.yz, towards);
}

// Returns the direction of a place on a face.
fn from_face(face: u32, place: vec2f) -> vec3f {
    let towards = select(1.0, -1.0, (face & 1u) == 1u);
    let d = vec3f(towards, place);
    return select(select(d.xyz, d.yzx, face >= 4u), d.zxy, (face >> 1u) == 1u);
}

// Returns the faces that a cell may cover, as bits. bulge: how far the cell may extend beyond its corners.
fn faces_of(corners: array<vec3f, 4>, bulge: f32) -> u32 {
    let center = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    let near = max(distance(corners[0], center), distance(corners[1], center));
    let far = max(near, max(distance(corners[2], center), distance(corners[3], center)));
    let size = abs(center);
    // Two components are equal at the edge of a face.
    let least = max(size.x, max(size.y, size.z)) - 2.0 * (far + bulge) - BOX_ROUNDING;
    let toward = vec3u(center >= vec3f(least));
    let away = vec3u(-center >= vec3f(least));
    return dot(toward, vec3u(1u, 4u, 16u)) + dot(away, vec3u(2u, 8u, 32u));
}

// The part of a face that a cell of the grid covers: its first and last buckets. `count` is 0 if it does not cover any.
struct FaceBox {
    first: vec2u,
    last: vec2u,
    count: u32,
    // The range of places on the face.
    low: vec2f,
    high: vec2f,
    // The places of the corners, and how far the cell may extend beyond them.
    corners: array<vec2f, 4>,
    slack: f32,
}

// corners: directions less than half a radian apart. bulge: how far the cell may extend beyond them.
fn face_box(face: u32, corners: array<vec3f, 4>, buckets: u32, bulge: f32) -> FaceBox {
    let a = on_face(face, corners[0]);
    let b = on_face(face, corners[1]);
    let c = on_face(face, corners[2]);
    let d = on_face(face, corners[3]);
    let ahead = min(min(a.z, b.z), min(c.z, d.z));
    let pa = a.xy / a.z;
    let pb = b.xy / b.z;
    let pc = c.xy / c.z;
    let pd = d.xy / d.z;
    let slack = BOX_ROUNDING + 2.0 * bulge / max(ahead * ahead, LEAST_AHEAD);
    let low = min(min(pa, pb), min(pc, pd)) - slack;
    let high = max(max(pa, pb), max(pc, pd)) + slack;
    if !(ahead > LEAST_AHEAD) || any(low > vec2f(1.0)) || any(high < vec2f(-1.0)) {
        return FaceBox();
    }
    let scale = 0.5 * f32(buckets);
    let last = vec2f(f32(buckets - 1u));
    let first_place = vec2u(clamp(floor((low + 1.0) * scale), vec2f(0.0), last));
    let last_place = vec2u(clamp(floor((high + 1.0) * scale), vec2f(0.0), last));
    let size = last_place - first_place + 1u;
    return FaceBox(first_place, last_place, size.x * size.y, low, high, array<vec2f, 4>(pa, pb, pc, pd), slack);
}

// The sides of a cell on a face, as lines (n, c): a place p inside has n·p + c ≥ −slack for each.
struct FaceSides {
    lines: array<vec3f, 4>,
    slack: f32,
}

// Returns the sides of a cell. If it is folded, they exclude no place.
fn face_sides(within: FaceBox) -> FaceSides {
    let p = within.corners;
    let turns = vec4f(
        wedge(p[1] - p[0], p[3] - p[1]),
        wedge(p[3] - p[1], p[2] - p[3]),
        wedge(p[2] - p[3], p[0] - p[2]),
        wedge(p[0] - p[2], p[1] - p[0]),
    );
    let turn = select(0.0, 1.0, all(turns > vec4f(0.0))) - select(0.0, 1.0, all(turns < vec4f(0.0)));
    return FaceSides(
        array<vec3f, 4>(side_line(p[0], p[1], turn), side_line(p[1], p[3], turn), side_line(p[3], p[2], turn), side_line(p[2], p[0], turn)),
        within.slack,
    );
}

fn wedge(a: vec2f, b: vec2f) -> f32 {
    return a.x * b.y - a.y * b.x;
}

// Returns the line through two points, whose positive side is to the left if `turn` is 1, and to the right if it is −1.
fn side_line(p: vec2f, q: vec2f, turn: f32) -> vec3f {
    let along = (q - p) * (turn / max(distance(p, q), 1e-30));
    return vec3f(-along.y, along.x, -wedge(along, p));
}

fn between_sides(sides: FaceSides, p: vec2f) -> bool {
    let at = vec3f(p, 1.0);
    let near = min(dot(sides.lines[0], at), dot(sides.lines[1], at));
    let far = min(dot(sides.lines[2], at), dot(sides.lines[3], at));
    return min(near, far) >= -sides.slack;
}

// A scan of the stars in a part of a face, row by row.
struct StarScan {
    // The first and the last bucket of the row, and the number of rows that follow.
    first: u32,
    last: u32,
    rows: u32,
    // The stars in the row that are left.
    star: u32,
    until: u32,
}

fn star_scan(face: u32, within: FaceBox, own: StarSky) -> StarScan {
    let row = own.first_bucket + (face * own.buckets + within.first.y) * own.buckets;
    let first = row + within.first.x;
    let last = row + within.last.x;
    let star = star_buckets[first];
    let until = select(star, star_buckets[last + 1u], within.count > 0u);
    return StarScan(first, last, within.last.y - within.first.y, star, until);
}

// Returns the scan with the stars of the next row, if there is one.
fn next_row(scan: StarScan, buckets: u32) -> StarScan {
    let step = select(0u, 1u, scan.rows > 0u);
    let first = scan.first + step * buckets;
    let last = scan.last + step * buckets;
    let until = star_buckets[last + 1u];
    return StarScan(first, last, scan.rows - step, select(until, star_buckets[first], step == 1u), until);
}

fn scan_ended(scan: StarScan) -> bool {
    return scan.star >= scan.until && scan.rows == 0u;
}

// A cell that covers a part of a face is ahead of it by more than this.
const LEAST_AHEAD: f32 = 0.05;
// The rounding error of a place on a face.
const BOX_ROUNDING: f32 = 5e-7;
