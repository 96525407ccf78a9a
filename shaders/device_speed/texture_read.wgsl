// Measures texture reads: reads every texel once and does almost nothing else.

@group(0) @binding(190) var<storage, read_write> sums: array<f32>;
@group(0) @binding(191) var texels: texture_2d<f32>;

@compute @workgroup_size(8, 8)
fn ceiling(@builtin(global_invocation_id) id: vec3u) {
    let texel = textureLoad(texels, id.xy, 0);
    // Never true, but compilers cannot deduce that.
    if texel.x + texel.y + texel.z + texel.w == 1.0 {
        sums[0] = 1.0;
    }
}
