// Tracks the media that a ray is in. The ray carries the set of the transparent objects that it is inside of, as bits in the order of their
// priority: the lowest bit selects the medium around it. Closed mirrors also have bits, after all others, so that a ray has the information
// from which side it meets them. The set changes only where a ray crosses a surface.

struct Region {
    // Elements of a uniform array are 16 bytes apart.
    @align(16) kind: u32,
    // The index of the medium among those of its kind.
    place: u32,
    // The primitive of the object; NOTHING for meshes.
    primitive: u32,
    // 1 if the camera's rays start inside a mesh.
    start: u32,
    // The radius of the sphere on which a leap through the region ends.
    radius: Real,
}

var<uniform> regions: array<Region, REGION_COUNT>;
var<storage, read_write> pixel_inside: array<u32>;

var<private> inside: u32;
// The kind of region, which determines the motion of rays and the index.
var<private> region: u32;
// The index of the medium among those of its kind.
var<private> place: u32;

// The space outside all objects.
const EMPTY_SPACE: Region = Region(0u, 0u, NOTHING, 0u, 0.0);

// Returns the object whose medium a ray is in, if any.
fn medium_object() -> u32 {
    return firstTrailingBit(inside & MEDIA_MASK);
}

fn here() -> Region {
    let object = medium_object();
    if object < REGION_COUNT {
        return regions[object];
    }
    return EMPTY_SPACE;
}

fn enter_set(bits: u32) {
    inside = bits;
    let now = here();
    region = now.kind;
    place = now.place;
}

fn region_bits() -> u32 {
    return inside;
}

fn load_region(pixel: vec2u) {
    enter_set(pixel_inside[place_in_tile(pixel)]);
}

fn store_region(pixel: vec2u) {
    pixel_inside[place_in_tile(pixel)] = inside;
}

// On a surface a ray is on the side that it moves to.
fn start_region(x: Real3, v: Real3, pixel: vec2u) {
    var bits = 0u;
    for (var i = 0u; i < REGION_COUNT; i++) {
        let start = regions[i];
        var within = false;
        if start.primitive != NOTHING {
            let surface = hit_surface(start.primitive, x);
            let near = SURFACE_SLACK * (length(x) + abs(surface.signed_distance));
            within = surface.signed_distance < -near || (surface.signed_distance <= near && dot(surface.normal, v) < 0.0);
        } else {
            within = starts_inside(i, pixel);
        }
        bits |= u32(within) << i;
    }
    enter_set(bits);
}

// The meshes that each given ray starts in, as bits of the set of regions.
var<storage, read> given_sets: array<u32>;

// The rays of a camera all start inside a mesh, or all outside; given rays may each be inside other meshes.
fn starts_inside(region_bit: u32, pixel: vec2u) -> bool {
    if !IS_GIVEN {
        return regions[region_bit].start == 1u;
    }
    let index = pixel.y * frame.image.x + pixel.x;
    return ((given_sets[min(index, arrayLength(&given_sets) - 1u)] >> region_bit) & 1u) == 1u;
}
