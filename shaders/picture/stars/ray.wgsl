// Stores where the rays through the centers of pixels reach the sky, as a grid on which stars are found. Tiles have a margin around them, so
// that the grid continues beyond the edges of the image.

struct SkyRay {
    // The direction at infinity, in the axes of the catalog.
    way: vec3f,
    // The sky, the view and the branch of the ray; 0 if the ray does not reach a sky with stars.
    end: u32,
    // The factor of the light on its way to the camera, except its shift.
    weight: vec3f,
    // The redshift factor.
    shift: f32,
}

// A catalog, oriented in a scene.
struct StarSky {
    // The axes of the catalog in the scene.
    first: vec3f,
    second: vec3f,
    third: vec3f,
    // The number of buckets along the edge of a face of the cube; 0 if this sky has no stars.
    buckets: u32,
    // The positions of its first bucket, star and mean in their lists.
    first_bucket: u32,
    first_mean: u32,
    // The radius of a star's disk, in radians, which limits the brightness on critical curves.
    radius: f32,
    // The mean radiance of the whole sky.
    mean: vec3f,
}

var<storage, read_write> sky_rays: array<SkyRay>;
// The light of stars in each pixel, of all branches of the grid.
var<storage, read_write> pixel_starlight: array<vec3f>;
var<storage, read> star_skies: array<StarSky>;

// Returns the index of the sky that a ray has reached.
fn star_side() -> u32 {
    if HAS_TWO_SKIES {
        return u32(is_beyond);
    }
    return 0u;
}

// The bit of a ray that has reached a sky with stars; no path splits so often that it needs this bit.
const REACHED: u32 = 0x00800000u;
// The number of pixels around a tile in which the grid continues: an image in the next pixel but one spreads into the tile, and the
// interpolation takes one more on each side of its cell.
const STAR_MARGIN: u32 = 3u;

// Returns `true` if a pixel belongs to the tile, and not to its margin.
fn inside_margin(pixel: vec2u) -> bool {
    return all(pixel >= vec2u(STAR_MARGIN)) && all(pixel + STAR_MARGIN < frame.size);
}

// Stores the ray if it belongs to the grid. code: the status of the ray.
fn note_star_grid(pixel: vec2u, code: u32, end: PathPoint) {
    if !IS_ONE_SAMPLE {
        if frame.sample != CENTERS {
            return;
        }
    }
    sky_rays[place_in_tile(pixel)].end = 0u;
    if code == ESCAPED || code == MISSED {
        var weight: vec3f;
        if SEES_GLOW {
            let n = medium_index(end.x);
            weight = carried.camera / f32(n * n) * carried.throughput;
        } else {
            weight = end_throughput(end.x);
        }
        store_sky_ray(pixel, vec3f(normalize(end.v)), weight);
    }
}

// Stores where a ray reaches the sky. weight: the factor of the sky's light.
fn store_sky_ray(pixel: vec2u, d: vec3f, weight: vec3f) {
    let side = star_side();
    let own = star_skies[side];
    var end = REACHED | side | (view_of(sampled_pixel(pixel)) << 1u);
    if ENUMERATES {
        // The lowest three bits are not those of splits.
        end |= (branch_code << 3u) | (branch_code >> 29u);
    }
    let way = vec3f(dot(own.first, d), dot(own.second, d), dot(own.third, d));
    sky_rays[place_in_tile(pixel)] = SkyRay(way, select(end, 0u, own.buckets == 0u), weight, color_shift());
}
