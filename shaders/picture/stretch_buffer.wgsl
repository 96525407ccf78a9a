// ln k of rays between passes, in 64 bits: k times U is light's momentum where the line element changes with t.

@group(0) @binding(174) var<storage, read> stretch_in: array<Real>;
@group(0) @binding(175) var<storage, read> stretch_0: array<Real>;
@group(0) @binding(176) var<storage, read> stretch_1: array<Real>;
@group(0) @binding(177) var<storage, read> stretch_2: array<Real>;
@group(0) @binding(178) var<storage, read_write> stretch_out: array<Real>;

fn load_stretch(pixel: vec2u) -> Real {
    return stretch_in[place_of(pixel)];
}

fn stretch_at_0(pixel: vec2u) -> Real {
    return stretch_0[place_of(pixel)];
}

fn stretch_at_1(pixel: vec2u) -> Real {
    return stretch_1[place_of(pixel)];
}

fn stretch_at_2(pixel: vec2u) -> Real {
    return stretch_2[place_of(pixel)];
}

fn put_stretch(pixel: vec2u, a: Real) {
    stretch_out[place_of(pixel)] = a;
}
