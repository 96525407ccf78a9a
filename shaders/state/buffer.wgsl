// Stores the state of every pixel's ray between passes in 64 bits, which no texture supports, in buffers: one for each slot. Passes address
// a slot by its role, as in state/texture.wgsl.

var<storage, read> state_in: array<State>;
var<storage, read> state_start: array<State>;
var<storage, read> state_end: array<State>;
var<storage, read> state_0: array<State>;
var<storage, read> state_1: array<State>;
var<storage, read> state_2: array<State>;
var<storage, read_write> state_out: array<State>;

fn load_state(pixel: vec2u) -> State {
    return state_in[place_in_tile(pixel)];
}

fn start_state(pixel: vec2u) -> State {
    return state_start[place_in_tile(pixel)];
}

fn end_state(pixel: vec2u) -> State {
    return state_end[place_in_tile(pixel)];
}

fn state_at_0(pixel: vec2u) -> State {
    return state_0[place_in_tile(pixel)];
}

fn state_at_1(pixel: vec2u) -> State {
    return state_1[place_in_tile(pixel)];
}

fn state_at_2(pixel: vec2u) -> State {
    return state_2[place_in_tile(pixel)];
}

fn put_state(pixel: vec2u, state: State) {
    state_out[place_in_tile(pixel)] = state;
}
