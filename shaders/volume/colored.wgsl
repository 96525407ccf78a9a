// The light of matter in color: it is added to the light of the path after each step, or after several of an orbit, and its absorption to
// the path's throughput.

// The depth from which errors are relative to it: only light behind shows it.
const LEAST_DEPTH: Real = 1.0;

// Light below this, in units of white, is not seen.
const LEAST_LIGHT: f32 = 1e-4;

// Returns the light of the path before the current step, in the units of the step's light.
fn earlier_light(k: u32) -> Real {
    if !CARRIES_LIGHT {
        return 1.0;
    }
    return Real((carried.gathered[k] + LEAST_LIGHT) / max(carried.share * carried.camera * carried.throughput[k], 1e-30));
}

fn start_transfer(pixel: vec2u) {
}

fn load_transfer(pixel: vec2u) {
    transferred = Light();
}

fn store_transfer(pixel: vec2u) {
}

fn add_step() {
    note_doubts();
    let depth = vec3f(f32(transferred.depth[0]), f32(transferred.depth[1]), f32(transferred.depth[2]));
    if SEES_GLOW {
        let light = vec3f(f32(transferred.light[0]), f32(transferred.light[1]), f32(transferred.light[2]));
        let share = select(0.0, carried.share, glow_counts);
        carried.gathered += share * carried.camera * carried.throughput * light;
    }
    scale_throughput(exp(-min(depth, vec3f(80.0))));
    transferred = Light();
}

fn fail_transfer() {
    // A path counts once.
    if !scale_throughput(vec3f(1.0)) {
        tally_at_once(UNDEFINED);
    }
    scale_throughput(vec3f(0.0));
    if CARRIES_LIGHT {
        carried.gathered = vec3f(0.0);
    }
}
