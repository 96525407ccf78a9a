// Regions: which media a ray is in. It carries the set of the objects that light goes through and that it is inside of, as bits in
// the order of their priority: the medium around it is that of the lowest bit. Closed mirrors have bits too, behind all
// others, for a ray to know from which side it meets them. The set changes only where a ray crosses a surface.

struct Region {
    // Elements of a uniform array lie 16 bytes apart.
    @align(16) kind: u32,
    // Which medium of that kind.
    place: u32,
    // The object's own primitive; NOTHING for meshes.
    primitive: u32,
    // 1 where a camera's rays start inside of a mesh.
    start: u32,
    // The sphere on which a leap through the region ends.
    radius: Real,
}

var<uniform> regions: array<Region, REGION_COUNT>;
var<storage, read_write> pixel_inside: array<u32>;

var<private> inside: u32;
// The kind of region, which says how rays move and what the index is.
var<private> region: u32;
// Which medium of that kind.
var<private> place: u32;

// Of the space outside of everything.
const EMPTY_SPACE: Region = Region(0u, 0u, NOTHING, 0u, 0.0);

// The object whose medium a ray is in, if it is in one.
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
            let near = SURFACE_SLACK * (length(x) + abs(surface.gap));
            within = surface.gap < -near || (surface.gap <= near && dot(surface.across, v) < 0.0);
        } else {
            within = starts_inside(i, pixel);
        }
        bits |= u32(within) << i;
    }
    enter_set(bits);
}

// For each given ray the meshes that it starts in, as bits of the set of regions.
var<storage, read> given_sets: array<u32>;

// A camera's rays all start inside of a mesh, or all outside; given rays each inside of other meshes.
fn starts_inside(region_bit: u32, pixel: vec2u) -> bool {
    if !IS_GIVEN {
        return regions[region_bit].start == 1u;
    }
    let index = pixel.y * frame.image.x + pixel.x;
    return ((given_sets[min(index, arrayLength(&given_sets) - 1u)] >> region_bit) & 1u) == 1u;
}
