// Measures arithmetic throughput: sixteen independent chains of fused multiply-adds in registers.

const ITERATIONS: u32 = 1024u;

@group(0) @binding(190) var<storage, read_write> sums: array<f32>;

@compute @workgroup_size(64)
fn ceiling(@builtin(global_invocation_id) id: vec3u) {
    let factor = vec4f(0.9999);
    let start = vec4f(f32(id.x), 1.0, 2.0, 3.0);
    var a = start;
    var b = start + 4.0;
    var c = start + 8.0;
    var d = start + 12.0;
    for (var i = 0u; i < ITERATIONS; i++) {
        a = fma(a, factor, start);
        b = fma(b, factor, start);
        c = fma(c, factor, start);
        d = fma(d, factor, start);
    }
    sums[id.x] = dot(a + b + c + d, vec4f(1.0));
}
