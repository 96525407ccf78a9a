// Pictures as they are, each alone in its texture.

fn image_size(image: u32) -> vec2u {
    return image_extent(image);
}

// uv from the top left of the picture; outside it the picture repeats, or its edges go on.
fn image_sample(image: u32, uv: vec2f, repeats: bool) -> vec3f {
    return image_bilinear(image, vec2u(0u), image_size(image), uv, repeats);
}
