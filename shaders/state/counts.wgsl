// Steps per ray, accepted and rejected, for the steps layer and for trace.

@group(0) @binding(35) var step_count: texture_storage_2d<r32uint, read_write>;
@group(0) @binding(36) var rejected_count: texture_storage_2d<r32uint, read_write>;

fn load_counts(pixel: vec2u) -> vec2u {
    if !KEEPS_COUNTS {
        return vec2u(0u);
    }
    return vec2u(textureLoad(step_count, pixel).x, textureLoad(rejected_count, pixel).x);
}

fn store_counts(pixel: vec2u, ray: Ray) {
    if KEEPS_COUNTS {
        textureStore(step_count, pixel, vec4u(ray.steps));
        textureStore(rejected_count, pixel, vec4u(ray.rejected));
    }
}
