// Runs passes over the whole grid of pixels, for every pixel whose ray is alive (the mask of W04 §4.1), until none is alive; or for every
// pixel in every pass, ended or not: W04 without its early termination (masks off).

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

// The passes of the next segment run over the whole grid if one ray is alive, else over nothing.
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
