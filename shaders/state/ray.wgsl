// A ray as the state holds it, and a word of status beside it.

// What a slot holds of a ray: X = (x, tau) and V = (v, h).
alias State = mat2x4<Real>;

fn chosen_state(a: State, b: State, second: bool) -> State {
    return State(select(a[0], b[0], second), select(a[1], b[1], second));
}

@group(0) @binding(4) var status: texture_storage_2d<r32uint, read_write>;

fn load_status(pixel: vec2u) -> u32 {
    return textureLoad(status, pixel).x;
}

fn store_status(pixel: vec2u, word: u32) {
    textureStore(status, pixel, vec4u(word));
}

fn load_ray(pixel: vec2u, word: u32) -> Ray {
    let state = load_state(pixel);
    let phase = unpack_phase(state, pixel);
    return unpacked(state, load_rest(pixel), phase, load_memory(pixel, state[1].w, phase), word, pixel);
}

// The state of a ray at the start of its last segment, from the slot that its status names.
fn load_ended(pixel: vec2u) -> Ray {
    let word = load_status(pixel);
    let slot = status_slot(word);
    let state = slot_state(slot, pixel);
    let phase = unpack_slot(state, slot, pixel);
    return unpacked(state, ended_rest(slot, pixel), phase, slot_memory(slot, pixel, state[1].w, phase), word, pixel);
}

fn unpacked(state: State, rest: Real, phase: Phase, memory: Memory, word: u32, pixel: vec2u) -> Ray {
    let counts = load_counts(pixel);
    return Ray(phase, state[0].w, rest, memory, 0.0, status_index(word), counts.x, counts.y, status_code(word));
}

fn store_ray(pixel: vec2u, ray: Ray) {
    put_state(pixel, State(Real4(ray.phase[0].xyz, ray.tau), Real4(ray.phase[1].xyz, ray.memory.h)));
    store_rest(pixel, ray);
    store_clock(pixel, ray.phase);
    store_memory(pixel, ray.memory);
}

// A segment between two slots of the state, for the schedules that integrate and intersect in different passes.
fn load_segment(pixel: vec2u) -> Segment {
    let start = start_state(pixel);
    let end = end_state(pixel);
    let before = path_velocity(start[1].xyz);
    let after = path_velocity(end[1].xyz);
    return Segment(start[0].xyz, before, end[0].xyz, after, taken_step(pixel));
}

fn load_tau(pixel: vec2u) -> Real {
    return end_state(pixel)[0].w;
}

fn load_start_tau(pixel: vec2u) -> Real {
    return start_state(pixel)[0].w;
}
