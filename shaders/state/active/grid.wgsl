// Every pixel whose ray still lives (W04 §4.1's mask), over the whole grid of pixels, and passes stop when none lives; or every pixel in every
// pass, ended or not: the 2004 paper without its early termination (masks off).

var<storage, read_write> active_out: ActiveList;

var<workgroup> any_active: atomic<u32>;

fn active_pixel(own: Invocation) -> Place {
    return grid_pixel(own);
}

fn ray_wanted(code: u32) -> bool {
    if !SKIPS_ENDED {
        return true;
    }
    return code == ALIVE;
}

// The next segment's passes run over the whole grid if one ray lives, else over nothing.
fn keep_active(alive: bool, pixel: vec2u, lane: u32) {
    if SKIPS_ENDED {
        if alive {
            atomicStore(&any_active, 1u);
        }
    }
    workgroupBarrier();
    if SKIPS_ENDED {
        if lane == 0u && atomicLoad(&any_active) == 1u {
            let groups = (frame.size + group_extent() - 1u) / group_extent();
            atomicMax(&active_out.x, groups.x);
            atomicMax(&active_out.y, groups.y);
            atomicMax(&active_out.z, 1u);
        }
    }
}
