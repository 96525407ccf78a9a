// Phase for laws that carry time: the columns are (x, t) and (v, ṫ). The scene is stationary, so that only ṫ is kept
// between passes (W04 App. A), in a pair of textures of its own.

alias Phase = mat2x4f;

@group(0) @binding(20) var clock_in: texture_2d<f32>;
@group(0) @binding(21) var clock_out: texture_storage_2d<r32float, write>;

fn unpack_phase(x: vec4f, v: vec4f, pixel: vec2u) -> Phase {
    return Phase(vec4f(x.xyz, 0.0), vec4f(v.xyz, textureLoad(clock_in, pixel, 0).x));
}

fn unpack_slot(x: vec4f, v: vec4f, slot: u32, pixel: vec2u) -> Phase {
    return Phase(vec4f(x.xyz, 0.0), vec4f(v.xyz, slot_clock(slot, pixel)));
}

fn store_clock(pixel: vec2u, p: Phase) {
    textureStore(clock_out, pixel, vec4f(p[1].w));
}

// The same bits, behind which no compiler sees: a step's result must not be simplified together with what uses it (x₁ − x₀
// to h v), or passes that are cut differently would round differently.
fn opaque_phase(p: Phase) -> Phase {
    let x = bitcast<vec4f>(bitcast<vec4u>(p[0]) ^ vec4u(frame.zero));
    let v = bitcast<vec4f>(bitcast<vec4u>(p[1]) ^ vec4u(frame.zero));
    return Phase(x, v);
}
