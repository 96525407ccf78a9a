// The light of volumes in color: it is added to the light of the path after each step, and their absorption to its throughput.

fn load_transfer(pixel: vec2u) {
    transferred = Light();
}

fn store_transfer(pixel: vec2u) {
}

fn add_step() {
    let light = vec3f(f32(transferred.light[0]), f32(transferred.light[1]), f32(transferred.light[2]));
    let depth = vec3f(f32(transferred.depth[0]), f32(transferred.depth[1]), f32(transferred.depth[2]));
    if glow_counts {
        carried.gathered += carried.share * carried.camera * carried.throughput * light;
    }
    scale_throughput(exp(-min(depth, vec3f(80.0))));
    transferred = Light();
}

fn fail_transfer() {
    tally_at_once(UNDEFINED);
    carried.throughput = vec3f(0.0);
    carried.gathered = vec3f(0.0);
}
