// Phase for laws of space alone: the columns are x and v.

alias Phase = mat2x3f;

fn unpack_phase(x: vec4f, v: vec4f, pixel: vec2u) -> Phase {
    return Phase(x.xyz, v.xyz);
}

fn unpack_slot(x: vec4f, v: vec4f, slot: u32, pixel: vec2u) -> Phase {
    return Phase(x.xyz, v.xyz);
}

fn store_clock(pixel: vec2u, p: Phase) {
}

// The same bits, behind which no compiler sees: a step's result must not be simplified together with what uses it (x₁ − x₀
// to h v), or passes that are cut differently would round differently.
fn opaque_phase(p: Phase) -> Phase {
    let x = bitcast<vec3f>(bitcast<vec3u>(p[0]) ^ vec3u(frame.zero));
    let v = bitcast<vec3f>(bitcast<vec3u>(p[1]) ^ vec3u(frame.zero));
    return Phase(x, v);
}
