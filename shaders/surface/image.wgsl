// Samples images, each in a separate texture, unfiltered or averaged over the footprint of a sample, by bilinear samples of a mipmap
// pyramid (Williams 1983), several along the longer axis (McCormack et al. 1999). For footprints below a texel the result is bit-identical
// to the unfiltered image.

// The largest number of samples along the longer axis.
const MOST_TAPS: f32 = 8.0;

// The footprint of the next sample, along two axes, as fractions of the image.
var<private> spans: array<vec2f, 2>;

fn note_spans(a: vec2f, b: vec2f) {
    spans = array<vec2f, 2>(a, b);
}

// The mipmap levels are next to each other below the image, each half as wide and as high as the one before. (The levels of the texture
// would do, but Mesa's software driver returns wrong values if neighboring invocations ask for several.)
fn image_size(image: u32) -> vec2u {
    let extent = image_extent(image);
    if !FILTERS_IMAGES {
        return extent;
    }
    return vec2u(extent.x, 2u * (extent.y / 3u) + extent.y % 3u);
}

// Returns a sample of the image itself, level 0, or of one of its smaller copies.
fn image_level(image: u32, level: u32, uv: vec2f, repeats: bool) -> vec3f {
    let whole = image_size(image);
    let below = vec2u(whole.x - (whole.x >> (max(level, 1u) - 1u)), whole.y);
    return image_bilinear(image, select(below, vec2u(0u), level == 0u), whole >> vec2u(level), uv, repeats);
}

// uv from the top left of the image; outside it the image repeats, or its edges extend.
fn image_sample(image: u32, uv: vec2f, repeats: bool) -> vec3f {
    let size = image_size(image);
    if !FILTERS_IMAGES {
        return image_bilinear(image, vec2u(0u), size, uv, repeats);
    }
    let seen = spans;
    spans = array<vec2f, 2>();
    let a = seen[0] * vec2f(size);
    let b = seen[1] * vec2f(size);
    let is_first = dot(a, a) >= dot(b, b);
    let longer = length(select(b, a, is_first));
    // The width of the parallelogram across its longer side.
    let wide = max(abs(a.x * b.y - a.y * b.x) / longer, 1.0);
    let is_wide = longer > 1.0;
    let taps = select(1.0, clamp(ceil(longer / wide), 1.0, MOST_TAPS), is_wide);
    let last = f32(firstLeadingBit(min(size.x, size.y)));
    let level = select(0.0, min(log2(max(wide, longer / taps)), last), is_wide);
    let part = fract(level);
    // Each tap is two samples if it is between two levels.
    let rounds = select(1u, 2u, part > 0.0);
    let along = select(vec2f(0.0), select(seen[1], seen[0], is_first), is_wide);
    var sum = vec3f(0.0);
    var k = 0u;
    loop {
        let at = uv + ((f32(k / rounds) + 0.5) / taps - 0.5) * along;
        let is_upper = k % rounds == 1u;
        sum += select(1.0 - part, part, is_upper) * image_level(image, u32(level) + u32(is_upper), at, repeats);
        k++;
        continuing {
            break if k >= rounds * u32(taps);
        }
    }
    return sum / taps;
}

// The bilinear sample of a rectangle of a texture, implemented here: it is equal on every device, and images need no samplers.

// uv from the top left of the rectangle; outside it the rectangle repeats, or its edges extend.
fn image_bilinear(image: u32, corner: vec2u, size: vec2u, uv: vec2f, repeats: bool) -> vec3f {
    let p = uv * vec2f(size) - 0.5;
    let base = floor(p);
    let f = p - base;
    let lo = corner + image_index(base, size, repeats);
    let hi = corner + image_index(base + 1.0, size, repeats);
    let top = mix(image_texel(image, lo), image_texel(image, vec2u(hi.x, lo.y)), f.x);
    let bottom = mix(image_texel(image, vec2u(lo.x, hi.y)), image_texel(image, hi), f.x);
    return mix(top, bottom, f.y);
}

// Returns the texel at a whole position. Remainders of integers are slow on processors.
fn image_index(p: vec2f, size: vec2u, repeats: bool) -> vec2u {
    let n = vec2f(size);
    let rest = p - n * floor(p / n);
    // The quotient may have been rounded.
    let wrapped = select(rest, vec2f(0.0), rest >= n);
    return vec2u(select(clamp(p, vec2f(0.0), n - 1.0), wrapped, repeats));
}
