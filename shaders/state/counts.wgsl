// Counts the steps of each ray, accepted and rejected, for the steps layer and for `trace`.

var<storage, read_write> pixel_step_count: array<u32>;
var<storage, read_write> pixel_rejected_count: array<u32>;

fn load_counts(pixel: vec2u) -> vec2u {
    if !KEEPS_COUNTS {
        return vec2u(0u);
    }
    return vec2u(pixel_step_count[place_in_tile(pixel)], pixel_rejected_count[place_in_tile(pixel)]);
}

fn store_counts(pixel: vec2u, ray: Ray) {
    if KEEPS_COUNTS {
        pixel_step_count[place_in_tile(pixel)] = ray.steps;
        pixel_rejected_count[place_in_tile(pixel)] = ray.rejected;
    }
}
