// Stores where the rays through the centers of pixels end: a grid between whose rays bundles of light are measured and stars are found. The
// first sample of an image is the grid if possible. Tiles have a margin around them, so that the grid continues beyond the edges of the image.

struct GridRay {
    // The direction at infinity, or u and v on a surface.
    place: Real3,
    // The kind of the end, HIT or ESCAPED; above it the side of a wormhole, the view of a stereo image, and the object or the branch of the
    // path. 0 if the ray has no such end.
    end: u32,
    // The factor of a sky's light on its way to the camera, except its shift.
    weight: vec3f,
    // The redshift factor.
    shift: f32,
}

var<storage, read_write> grid_rays: array<GridRay>;

// The mask of the kind of an end, and the positions of its other bits.
const END_KIND: u32 = 3u;
const END_SIDE: u32 = 2u;
const END_VIEW: u32 = 3u;
const END_OBJECT: u32 = 4u;
// The numbers of pixels around a tile in which the grid continues. Stars need more: an image in the next pixel but one spreads into the tile,
// and the interpolation takes one more on each side of its cell.
const BUNDLE_MARGIN: u32 = 2u;
const STAR_MARGIN: u32 = 3u;

// Returns `true` if a pixel belongs to the tile, and not to its margin.
fn inside_margin(pixel: vec2u) -> bool {
    var margin = BUNDLE_MARGIN;
    if HAS_STARS {
        margin = STAR_MARGIN;
    }
    return all(pixel >= vec2u(margin)) & all(pixel + margin < frame.size);
}

// Returns `true` if the grid has all neighbors of a pixel.
fn inside_grid(pixel: vec2u) -> bool {
    return all(pixel >= vec2u(1u)) & all(pixel + 1u < frame.size);
}

// Returns the index of the sky that a ray has reached.
fn side_reached() -> u32 {
    if HAS_TWO_SKIES {
        return u32(is_beyond);
    }
    return 0u;
}

fn side_of(end: u32) -> u32 {
    return extractBits(end, END_SIDE, 1u);
}

// Returns the end of a ray on the surface of an object, which is counted from 1.
fn surface_end(pixel: vec2u, object: u32) -> u32 {
    return HIT | (view_of(sampled_pixel(pixel)) << END_VIEW) | (object << END_OBJECT);
}

// Returns the end of a ray that has reached a sky.
fn sky_end(pixel: vec2u) -> u32 {
    let end = ESCAPED | (side_reached() << END_SIDE) | (view_of(sampled_pixel(pixel)) << END_VIEW);
    if ENUMERATES {
        // A path splits at most 20 times.
        return end | (extractBits(branch_code, 0u, MET - END_OBJECT) << END_OBJECT) | (branch_code & ~low_bits(MET));
    }
    return end;
}

// Stores the end of a ray if it belongs to the grid. code: the status of the ray.
fn note_grid(pixel: vec2u, code: u32, seen: Seen) {
    if !is_grid(pixel) {
        return;
    }
    var own: GridRay;
    if code == ESCAPED || code == MISSED {
        own.place = normalize(seen.end.v);
        own.end = sky_end(pixel);
        if HAS_STARS {
            own.place = in_star_axes(own.place, side_reached());
        }
        if KEEPS_SKY_LIGHT {
            own.weight = sky_weight(seen.end.x);
            own.shift = color_shift();
        }
    }
    if KEEPS_FOOTPRINTS {
        if code == HIT {
            own.place = Real3(place_seen);
            own.end = surface_end(pixel, seen.object);
        }
    }
    grid_rays[place_in_tile(pixel)] = own;
}

// Returns the factor of the sky's light at the end of a path.
fn sky_weight(x: Real3) -> vec3f {
    if SEES_GLOW {
        let n = medium_index(x);
        return carried.camera / f32(n * n) * carried.throughput;
    }
    return end_throughput(x);
}
