// The state of every pixel's ray between passes, in the paper's two textures (W04 §3.1): X = (x, tau), V = (v, h), each in slots
// that ping-pong. Passes know a slot by its role: what they read and write, a segment's start and end, or its number.

@group(0) @binding(10) var x_in: texture_2d<f32>;
@group(0) @binding(11) var v_in: texture_2d<f32>;
@group(0) @binding(12) var x_start: texture_2d<f32>;
@group(0) @binding(13) var v_start: texture_2d<f32>;
@group(0) @binding(14) var x_end: texture_2d<f32>;
@group(0) @binding(15) var v_end: texture_2d<f32>;
@group(0) @binding(16) var x_0: texture_2d<f32>;
@group(0) @binding(17) var v_0: texture_2d<f32>;
@group(0) @binding(18) var x_1: texture_2d<f32>;
@group(0) @binding(19) var v_1: texture_2d<f32>;
@group(0) @binding(20) var x_2: texture_2d<f32>;
@group(0) @binding(21) var v_2: texture_2d<f32>;
@group(0) @binding(22) var x_out: StateTexture;
@group(0) @binding(23) var v_out: StateTexture;

fn load_state(pixel: vec2u) -> State {
    return State(textureLoad(x_in, pixel, 0), textureLoad(v_in, pixel, 0));
}

fn start_state(pixel: vec2u) -> State {
    return State(textureLoad(x_start, pixel, 0), textureLoad(v_start, pixel, 0));
}

fn end_state(pixel: vec2u) -> State {
    return State(textureLoad(x_end, pixel, 0), textureLoad(v_end, pixel, 0));
}

fn state_at_0(pixel: vec2u) -> State {
    return State(textureLoad(x_0, pixel, 0), textureLoad(v_0, pixel, 0));
}

fn state_at_1(pixel: vec2u) -> State {
    return State(textureLoad(x_1, pixel, 0), textureLoad(v_1, pixel, 0));
}

fn state_at_2(pixel: vec2u) -> State {
    return State(textureLoad(x_2, pixel, 0), textureLoad(v_2, pixel, 0));
}

fn put_state(pixel: vec2u, state: State) {
    textureStore(x_out, pixel, state[0]);
    textureStore(v_out, pixel, state[1]);
}

// ṫ, for laws that carry time.
@group(0) @binding(24) var clock_in: texture_2d<f32>;
@group(0) @binding(25) var clock_0: texture_2d<f32>;
@group(0) @binding(26) var clock_1: texture_2d<f32>;
@group(0) @binding(27) var clock_2: texture_2d<f32>;
@group(0) @binding(28) var clock_out: texture_storage_2d<r32float, write>;

fn load_clock(pixel: vec2u) -> Real {
    return textureLoad(clock_in, pixel, 0).x;
}

fn clock_at_0(pixel: vec2u) -> Real {
    return textureLoad(clock_0, pixel, 0).x;
}

fn clock_at_1(pixel: vec2u) -> Real {
    return textureLoad(clock_1, pixel, 0).x;
}

fn clock_at_2(pixel: vec2u) -> Real {
    return textureLoad(clock_2, pixel, 0).x;
}

fn put_clock(pixel: vec2u, a: Real) {
    textureStore(clock_out, pixel, vec4f(a));
}

// The last accepted step's error, for controls that remember it.
@group(0) @binding(29) var error_in: texture_2d<f32>;
@group(0) @binding(30) var error_0: texture_2d<f32>;
@group(0) @binding(31) var error_1: texture_2d<f32>;
@group(0) @binding(32) var error_2: texture_2d<f32>;
@group(0) @binding(33) var error_out: texture_storage_2d<r32float, write>;

fn load_error(pixel: vec2u) -> Real {
    return textureLoad(error_in, pixel, 0).x;
}

fn error_at_0(pixel: vec2u) -> Real {
    return textureLoad(error_0, pixel, 0).x;
}

fn error_at_1(pixel: vec2u) -> Real {
    return textureLoad(error_1, pixel, 0).x;
}

fn error_at_2(pixel: vec2u) -> Real {
    return textureLoad(error_2, pixel, 0).x;
}

fn put_error(pixel: vec2u, a: Real) {
    textureStore(error_out, pixel, vec4f(a));
}

// The size of the step taken last.
@group(0) @binding(34) var taken: texture_storage_2d<r32float, read_write>;

fn load_taken(pixel: vec2u) -> Real {
    return textureLoad(taken, pixel).x;
}

fn put_taken(pixel: vec2u, h: Real) {
    textureStore(taken, pixel, vec4f(h));
}
