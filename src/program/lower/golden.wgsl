// ---- input.wgsl
const ONE: u32 = 1u;
const TWO: u32 = 2u;
struct Law { a: f32, n: vec4f }
struct Frame { zero: u32 }
@group(0) @binding(3) var<uniform> frame: Frame;
@group(0) @binding(0) var<storage, read_write> out: array<f32>;

fn rate(x: f32) -> f32 {
    return law.a * one.a + pair_1.n.x + uniforms_entry.list[own_frame.zero].a * x;
}

// The entry point {of the pass}.
@compute @workgroup_size(1)
fn entry() { read_uniforms();
    out[0] = rate(1.0);
}

// ---- generated/bindings.wgsl
struct Uniforms {
    @align(32) law: Law,
    @align(32) one: array<Law, ONE>,
    @align(32) pair: array<Law, TWO>,
    @align(32) list: array<Law, TWO>,
}

@group(0) @binding(500) var<uniform> uniforms_entry: Uniforms;
var<private> own_frame: Frame;
var<private> law: Law;
var<private> one: Law;
var<private> pair_0: Law;
var<private> pair_1: Law;

fn read_uniforms() {
    own_frame = frame;
    law = uniforms_entry.law;
    one = uniforms_entry.one[0];
    pair_0 = uniforms_entry.pair[0];
    pair_1 = uniforms_entry.pair[1];
}
