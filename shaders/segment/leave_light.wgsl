// Deposits the light of a ray from a light source in the voxels that it passes (G95 §6, the grid of light directions): in each voxel the
// length of its path, by axis and in total. The numbers are integers, whose sums do not depend on the order of rays.

struct LightVolume {
    lo: vec3f,
    // The side of a voxel.
    h: f32,
    count: vec3u,
    // The number of parts of a brick, a subdivided voxel, along each axis; 1 while there are no bricks.
    refine: u32,
}

var<storage, read> light_volume: LightVolume;

// The index of each voxel's brick, from 1, or 0.
var<storage, read> volume_bricks: array<u32>;

// Four words per voxel: x, y and z as signed numbers, and the length, for the voxels themselves or for the bricks.
var<storage, read_write> light_sums: array<atomic<u32>>;

// For each path 1 if it deposited light anywhere.
var<storage, read_write> light_reaches: array<u32>;

var<private> reaches: bool;

// The fraction of the ray's light at the start of the segment, which matter weakens up to its end.
var<private> weight_before: f32;

// The side of a voxel in these numbers.
const LIGHT_UNIT: f32 = 1024.0;
// The largest distance of chords from an arc, in voxels, and their largest number.
const CHORD_OFF: Real = 0.02;
const MOST_CHORDS: f32 = 64.0;
// The offset in voxels at which the voxel of a point between two voxels is determined.
const NUDGE: f32 = 1e-3;

fn light_size() -> f32 {
    return light_volume.h / f32(light_volume.refine);
}

fn keep_reach(pixel: vec2u) {
    let i = place_in_tile(pixel);
    light_reaches[i] = select(light_reaches[i], 1u, reaches);
}

fn note_weight() {
    weight_before = light_weight();
}

// Returns the factor by which light declines along the segment, as a power of 2: matter counts as uniform along it.
fn weight_decline() -> f32 {
    if !TRANSFERS {
        return 0.0;
    }
    // Nothing passes matter that is not defined.
    if transfer_invalid {
        return -1e3;
    }
    return log2(max(light_weight(), 1e-30) / max(weight_before, 1e-30));
}

// s: a segment that a ray has passed up to the fraction `until`.
fn leave_light(s: Segment, until: Real) {
    if !finite(s.x0) || !finite(s.x1) {
        return;
    }
    let lo = Real3(light_volume.lo);
    let off = length(segment_bulge(s)) / (CHORD_OFF * Real(light_size()));
    let chords = u32(clamp(ceil(sqrt(f32(min(off, 1e8)))), 1.0, MOST_CHORDS));
    let decline = weight_decline() / f32(chords);
    var a = vec3f((s.x0 - lo) / Real(light_volume.h));
    for (var k = 1u; k <= chords; k++) {
        let b = vec3f((segment_point(s, until * Real(k) / Real(chords)) - lo) / Real(light_volume.h));
        leave_chord(a, b, weight_before * exp2(f32(k - 1u) * decline), decline);
        a = b;
    }
}

// Deposits along the chord from a to b, in voxels; the share of light at its start declines by a power of 2.
fn leave_chord(a: vec3f, b: vec3f, share: f32, decline: f32) {
    let d = b - a;
    let size = length(d);
    let still = abs(d) < vec3f(1e-12);
    let inverse = 1.0 / select(d, vec3f(1e-12), still);
    let to_lo = -a * inverse;
    let to_hi = (vec3f(light_volume.count) - a) * inverse;
    let enters = min(to_lo, to_hi);
    let leaves = max(to_lo, to_hi);
    var t = max(0.0, max(enters.x, max(enters.y, enters.z)));
    let last = min(1.0, min(leaves.x, min(leaves.y, leaves.z)));
    let nudge = NUDGE / max(size, NUDGE);
    while t < last {
        if is_spent() {
            tally_at_once(LOST);
            break;
        }
        let place = a + (t + nudge) * d;
        let voxel = min(vec3u(max(place, vec3f(0.0))), light_volume.count - 1u);
        let brick = light_brick(voxel);
        let cut = select(1.0, f32(light_volume.refine), brick != 0u);
        let corner = vec3f(floor(place * cut));
        let out = select((select(corner, corner + 1.0, d > vec3f(0.0)) / cut - a) * inverse, vec3f(1e30), still);
        let next = min(last, max(min(out.x, min(out.y, out.z)), t + nudge));
        let passed = LIGHT_UNIT * cut * share * exp2(0.5 * (t + next) * decline) * (next - t);
        let refine = light_volume.refine;
        let fine = min(vec3u(max(corner - cut * vec3f(voxel), vec3f(0.0))), vec3u(refine - 1u));
        let part = (brick - 1u) * refine * refine * refine + light_index(fine, vec3u(refine));
        if refine == 1u || brick != 0u {
            leave_at(select(part, light_index(voxel, light_volume.count), refine == 1u), passed * d, passed * size);
        }
        t = next;
    }
}

fn light_brick(voxel: vec3u) -> u32 {
    let last = arrayLength(&volume_bricks) - 1u;
    return volume_bricks[min(light_index(voxel, light_volume.count), last)];
}

fn light_index(voxel: vec3u, count: vec3u) -> u32 {
    return (voxel.z * count.y + voxel.y) * count.x + voxel.x;
}

fn leave_at(index: u32, along: vec3f, size: f32) {
    reaches = true;
    let whole = vec3i(round(along));
    let n = u32(round(size));
    atomicAdd(&light_sums[4u * index], bitcast<u32>(whole.x));
    atomicAdd(&light_sums[4u * index + 1u], bitcast<u32>(whole.y));
    atomicAdd(&light_sums[4u * index + 2u], bitcast<u32>(whole.z));
    // Half the range of the numbers, which is the limit of the signed ones.
    if atomicAdd(&light_sums[4u * index + 3u], n) + n > 0x7fffffffu {
        tally_at_once(LOST);
    }
}
