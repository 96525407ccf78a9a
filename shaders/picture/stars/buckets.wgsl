// The stars of a catalog, sorted into buckets on the faces of a cube, so that the stars in a part of the sky are a few ranges of the list.

struct Star {
    // The position on the face of its bucket, from -1 to 1.
    place: vec2f,
    // The illuminance of its light, in lux.
    flux: f32,
    kelvins: f32,
}

// Sorted by face, row and column.
var<storage, read> star_list: array<Star>;
// The first star of each bucket of each sky, and the end of the last one.
var<storage, read> star_buckets: array<u32>;
// The light of each sky in coarser buckets: those eight times as wide, those twice as wide again, and so on up to a whole face.
var<storage, read> star_means: array<vec3f>;

const FINEST_MEAN: u32 = 8u;

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
        return FaceBox(vec2u(0u), vec2u(0u), 0u, vec2f(0.0), vec2f(0.0));
    }
    let scale = 0.5 * f32(buckets);
    let last = vec2f(f32(buckets - 1u));
    let first_place = vec2u(clamp(floor((low + 1.0) * scale), vec2f(0.0), last));
    let last_place = vec2u(clamp(floor((high + 1.0) * scale), vec2f(0.0), last));
    let size = last_place - first_place + 1u;
    return FaceBox(first_place, last_place, size.x * size.y, low, high);
}

// A scan of the stars near a part of the sky, range by range.
struct StarScan {
    // The faces that are left, as bits, the face, its part, and the next row of buckets there.
    faces: u32,
    face: u32,
    within: FaceBox,
    row: u32,
    // The range of stars.
    star: u32,
    until: u32,
    // `false` after the last range.
    more: bool,
}

fn star_scan(corners: array<vec3f, 4>, bulge: f32) -> StarScan {
    return StarScan(faces_of(corners, bulge), 0u, FaceBox(), 1u, 0u, 0u, true);
}

// Returns the scan with the next range of stars, which may be empty.
fn next_range(scan: StarScan, corners: array<vec3f, 4>, own: StarSky, bulge: f32) -> StarScan {
    var next = scan;
    if scan.within.count > 0u && scan.row <= scan.within.last.y {
        let bucket = own.first_bucket + (scan.face * own.buckets + scan.row) * own.buckets;
        next.star = star_buckets[bucket + scan.within.first.x];
        next.until = star_buckets[bucket + scan.within.last.x + 1u];
        next.row++;
    } else {
        next.more = scan.faces != 0u;
        next.face = min(firstTrailingBit(scan.faces), 5u);
        next.faces &= scan.faces - 1u;
        next.within = face_box(next.face, corners, own.buckets, bulge);
        next.row = next.within.first.y;
    }
    return next;
}

// A cell that covers a part of a face is ahead of it by more than this.
const LEAST_AHEAD: f32 = 0.05;
// The rounding error of a place on a face.
const BOX_ROUNDING: f32 = 5e-7;
