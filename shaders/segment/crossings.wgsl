// Stores where a ray crosses translucent surfaces, and the surface on which it ends: CROSSINGS_KEPT of them at most. Light from the first one forms
// the direct image, of order 0. Later branches of a ray cross the same surfaces, so that the first one stores them all.

const CROSSINGS_KEPT: u32 = 4u;

// Rows of a crossing.
const CROSSING_ROWS: u32 = 3u;

// The start of the path with its distance from the start of the ray, and the rows of each crossing: (x, τ), (dx/dλ, g) and (n, object), with
// the affine parameter λ in which light has frequency 1 at the camera, the surface normal n, and the index of the object from 1; 0 for
// none. Without a frequency g is 0, and λ is τ.
var<storage, read_write> pixel_crossings: array<array<Real4, 13>>;
// The number of crossings so far.
var<storage, read_write> pixel_crossed: array<u32>;

// x is where the path starts, at a distance from the start of the ray if that is outside of the bounding sphere.
fn begin_crossings(pixel: vec2u, x: Real3, away: Real) {
    if sample_of(pixel) + frame.branch == 0u {
        let place = place_in_tile(pixel);
        pixel_crossed[place] = 0u;
        pixel_crossings[place][0] = Real4(x, away);
    }
}

fn add_crossing(pixel: vec2u, surface: Surface, end: PathPoint) {
    let place = place_in_tile(pixel);
    let count = pixel_crossed[place];
    if sample_of(pixel) + frame.branch != 0u || count >= CROSSINGS_KEPT {
        return;
    }
    var along = end.v;
    var g: Real = 0.0;
    if KNOWS_SHIFT {
        note_kept(pixel);
        note_matter(materials[surface.material], end);
        along = matter_scale * end.v;
        g = seen_shift;
    }
    let row = 1u + CROSSING_ROWS * count;
    pixel_crossings[place][row] = Real4(end.x, end.tau);
    pixel_crossings[place][row + 1u] = Real4(along, g);
    pixel_crossings[place][row + 2u] = Real4(surface.normal, Real(surface.object + 1u));
    pixel_crossed[place] = count + 1u;
}
