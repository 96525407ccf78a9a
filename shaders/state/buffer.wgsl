// The state of every pixel's ray between passes in 64 bits, which no texture holds: X = (x, tau) and V = (v, h) in buffers, in
// slots that ping-pong. Passes know a slot by its role: what they read and write, a segment's start and end, or its number.

fn place_of(pixel: vec2u) -> u32 {
    return pixel.y * frame.size.x + pixel.x;
}

@group(0) @binding(10) var<storage, read> x_in: array<Real4>;
@group(0) @binding(11) var<storage, read> v_in: array<Real4>;
@group(0) @binding(12) var<storage, read> x_start: array<Real4>;
@group(0) @binding(13) var<storage, read> v_start: array<Real4>;
@group(0) @binding(14) var<storage, read> x_end: array<Real4>;
@group(0) @binding(15) var<storage, read> v_end: array<Real4>;
@group(0) @binding(16) var<storage, read> x_0: array<Real4>;
@group(0) @binding(17) var<storage, read> v_0: array<Real4>;
@group(0) @binding(18) var<storage, read> x_1: array<Real4>;
@group(0) @binding(19) var<storage, read> v_1: array<Real4>;
@group(0) @binding(20) var<storage, read> x_2: array<Real4>;
@group(0) @binding(21) var<storage, read> v_2: array<Real4>;
@group(0) @binding(22) var<storage, read_write> x_out: array<Real4>;
@group(0) @binding(23) var<storage, read_write> v_out: array<Real4>;

fn load_state(pixel: vec2u) -> State {
    return State(x_in[place_of(pixel)], v_in[place_of(pixel)]);
}

fn start_state(pixel: vec2u) -> State {
    return State(x_start[place_of(pixel)], v_start[place_of(pixel)]);
}

fn end_state(pixel: vec2u) -> State {
    return State(x_end[place_of(pixel)], v_end[place_of(pixel)]);
}

fn state_at_0(pixel: vec2u) -> State {
    return State(x_0[place_of(pixel)], v_0[place_of(pixel)]);
}

fn state_at_1(pixel: vec2u) -> State {
    return State(x_1[place_of(pixel)], v_1[place_of(pixel)]);
}

fn state_at_2(pixel: vec2u) -> State {
    return State(x_2[place_of(pixel)], v_2[place_of(pixel)]);
}

fn put_state(pixel: vec2u, state: State) {
    x_out[place_of(pixel)] = state[0];
    v_out[place_of(pixel)] = state[1];
}

// ṫ, for laws that carry time.
@group(0) @binding(24) var<storage, read> clock_in: array<Real>;
@group(0) @binding(25) var<storage, read> clock_0: array<Real>;
@group(0) @binding(26) var<storage, read> clock_1: array<Real>;
@group(0) @binding(27) var<storage, read> clock_2: array<Real>;
@group(0) @binding(28) var<storage, read_write> clock_out: array<Real>;

fn load_clock(pixel: vec2u) -> Real {
    return clock_in[place_of(pixel)];
}

fn clock_at_0(pixel: vec2u) -> Real {
    return clock_0[place_of(pixel)];
}

fn clock_at_1(pixel: vec2u) -> Real {
    return clock_1[place_of(pixel)];
}

fn clock_at_2(pixel: vec2u) -> Real {
    return clock_2[place_of(pixel)];
}

fn put_clock(pixel: vec2u, a: Real) {
    clock_out[place_of(pixel)] = a;
}

// The last accepted step's error, for controls that remember it.
@group(0) @binding(29) var<storage, read> error_in: array<Real>;
@group(0) @binding(30) var<storage, read> error_0: array<Real>;
@group(0) @binding(31) var<storage, read> error_1: array<Real>;
@group(0) @binding(32) var<storage, read> error_2: array<Real>;
@group(0) @binding(33) var<storage, read_write> error_out: array<Real>;

fn load_error(pixel: vec2u) -> Real {
    return error_in[place_of(pixel)];
}

fn error_at_0(pixel: vec2u) -> Real {
    return error_0[place_of(pixel)];
}

fn error_at_1(pixel: vec2u) -> Real {
    return error_1[place_of(pixel)];
}

fn error_at_2(pixel: vec2u) -> Real {
    return error_2[place_of(pixel)];
}

fn put_error(pixel: vec2u, a: Real) {
    error_out[place_of(pixel)] = a;
}

// The size of the step taken last.
@group(0) @binding(34) var<storage, read_write> taken: array<Real>;

fn load_taken(pixel: vec2u) -> Real {
    return taken[place_of(pixel)];
}

fn put_taken(pixel: vec2u, h: Real) {
    taken[place_of(pixel)] = h;
}
