// Packs a ray into the stored state, with a status word.

// The content of a slot: the columns are X, V and W.
alias State = mat3x4<Real>;

fn chosen_state(a: State, b: State, second: bool) -> State {
    return State(select(a[0], b[0], second), select(a[1], b[1], second), select(a[2], b[2], second));
}

// Returns the state in one of two or three slots: `paper` keeps the start of a segment while the other two ping-pong under its steps.
fn slot_state(slot: u32, pixel: vec2u) -> State {
    let first = chosen_state(state_at_0(pixel), state_at_1(pixel), slot == 1u);
    if !HAS_THREE_SLOTS {
        return first;
    }
    return chosen_state(first, state_at_2(pixel), slot == 2u);
}

var<storage, read_write> pixel_status: array<u32>;

fn load_status(pixel: vec2u) -> u32 {
    return pixel_status[place_in_tile(pixel)];
}

fn store_status(pixel: vec2u, word: u32) {
    pixel_status[place_in_tile(pixel)] = word;
}

fn load_ray(pixel: vec2u, word: u32) -> Ray {
    return unpacked(load_state(pixel), word, pixel);
}

// Returns the ray at the start of its last segment, from the slot that its status names.
fn load_ended(pixel: vec2u) -> Ray {
    let word = load_status(pixel);
    return unpacked(slot_state(status_slot(word), pixel), word, pixel);
}

fn unpacked(state: State, word: u32, pixel: vec2u) -> Ray {
    let phase = unpack_phase(state);
    let counts = load_counts(pixel);
    let memory = recalled(state[1].w, state[2].y, phase);
    return Ray(phase, state[0].w, state[2].z, memory, 0.0, status_index(word), counts.x, counts.y, status_code(word));
}

fn store_ray(pixel: vec2u, ray: Ray) {
    let times = phase_times(ray.phase);
    put_state(pixel, State(
        Real4(ray.phase[0].xyz, ray.tau),
        Real4(ray.phase[1].xyz, ray.memory.h),
        Real4(times.x, remembered_error(ray.memory), ray.rest, times.y),
    ));
}

// Returns a segment between two slots of the state, for the schedules that integrate and intersect in different passes.
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

// The size of the step that a pass took, for the pass that intersects: the tangents of an arc need it, and a chord only its ends.
var<storage, read_write> pixel_taken: array<Real>;

fn store_taken(pixel: vec2u, h: Real) {
    if KEEPS_TAKEN {
        pixel_taken[place_in_tile(pixel)] = h;
    }
}

fn taken_step(pixel: vec2u) -> Real {
    if KEEPS_TAKEN {
        return pixel_taken[place_in_tile(pixel)];
    }
    return 0.0;
}
