// Measures texture writes: writes every texel once and does nothing else.

@group(0) @binding(191) var texels: texture_storage_2d<rgba32float, write>;

@compute @workgroup_size(8, 8)
fn ceiling(@builtin(global_invocation_id) id: vec3u) {
    textureStore(texels, id.xy, vec4f(f32(id.x)));
}
