// Every pixel whose ray still lives (W04 §4.1's mask), over the whole grid of pixels; passes stop when none lives.

@group(0) @binding(5) var<storage, read_write> living_out: Living;

var<workgroup> any_alive: atomic<u32>;

fn living_pixel(own: Invocation) -> Place {
    return grid_pixel(own);
}

fn ray_wanted(code: u32) -> bool {
    return code == ALIVE;
}

// The next segment's passes run over the whole grid if one ray lives, else over nothing.
fn keep_living(alive: bool, pixel: vec2u, lane: u32) {
    if alive {
        atomicStore(&any_alive, 1u);
    }
    workgroupBarrier();
    if lane == 0u && atomicLoad(&any_alive) == 1u {
        let groups = (frame.size + group_extent() - 1u) / group_extent();
        atomicMax(&living_out.x, groups.x);
        atomicMax(&living_out.y, groups.y);
        atomicMax(&living_out.z, 1u);
    }
}
