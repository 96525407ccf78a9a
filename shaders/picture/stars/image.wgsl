// The images of stars, in a list for each cell of the grid, and the light that they give to the pixels around them.

struct StarImage {
    // The radiance that fills an area of one pixel with the light of the image.
    light: vec3f,
    // The next image in the cell, counted from 1; 0 after the last.
    next: u32,
    // The position in the cell, from 0 to 1, or EVERYWHERE.
    at: vec2f,
}

var<storage, read_write> star_images: array<StarImage>;
// The first image in each cell, counted from 1; 0 if there is none.
var<storage, read_write> star_heads: array<u32>;

// The position of light that fills its cell.
const EVERYWHERE: f32 = -1.0;

// Returns the weight of the k-th of four pixels in a row for an image at t between the second and the third: a cubic B-spline, or its mean
// over the cell.
fn star_weight(t: f32, k: u32) -> f32 {
    let x = abs(t + 1.0 - f32(k));
    let outer = max(2.0 - x, 0.0);
    let inner = max(1.0 - x, 0.0);
    let spline = (outer * outer * outer - 4.0 * inner * inner * inner) / 6.0;
    return select(spline, select(1.0, 11.0, k == 1u || k == 2u) / 24.0, t == EVERYWHERE);
}

// Returns the first image in the k-th of the 16 cells around a pixel.
fn star_head(pixel: vec2u, k: u32) -> u32 {
    return star_heads[place_in_tile(pixel + 1u - vec2u(k & 3u, k >> 2u))];
}

// Returns the light that a pixel receives from the images in the 16 cells around it.
fn starlight(pixel: vec2u) -> vec3f {
    // The cells with images, as bits.
    var cells = 0u;
    for (var k = 0u; k < 16u; k++) {
        cells |= min(star_head(pixel, k), 1u) << k;
    }
    var sum = vec3f(0.0);
    var cell = 0u;
    var next = 0u;
    loop {
        if next == 0u && cells != 0u {
            cell = firstTrailingBit(cells);
            next = star_head(pixel, cell);
            cells &= cells - 1u;
        }
        if next != 0u {
            let image = star_images[next - 1u];
            sum += star_weight(image.at.x, cell & 3u) * star_weight(image.at.y, cell >> 2u) * image.light;
            next = image.next;
        }
        continuing {
            break if next == 0u && cells == 0u;
        }
    }
    return sum;
}
