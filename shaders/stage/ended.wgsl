// The state of a ray at the start of its last segment, from the slot that its status names.

fn load_ended(pixel: vec2u) -> Ray {
    let word = load_status(pixel);
    let slot = status_slot(word);
    let x = slot_x(slot, pixel);
    let v = slot_v(slot, pixel);
    let counts = load_counts(pixel);
    let phase = unpack_slot(x, v, slot, pixel);
    let memory = slot_memory(slot, pixel, v.w, phase);
    return Ray(phase, x.w, memory, 0.0, status_index(word), counts.x, counts.y, status_code(word));
}
