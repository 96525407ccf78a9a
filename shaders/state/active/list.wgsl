// Compacts the active rays to a list of pixels: passes run over it by indirect dispatch, so that ended rays cost nothing. Each group counts
// its active rays and reserves room for all of them at once; the leader raises the next pass's group count. The first segments of a round
// need no list: nearly all of its rays are alive.

struct ActiveRead {
    x: u32,
    y: u32,
    z: u32,
    count: u32,
}

var<storage, read> active_in: ActiveRead;
var<storage, read_write> active_out: ActiveList;
var<storage, read> list_in: array<u32>;
var<storage, read_write> list_out: array<u32>;

// The number of groups in one row of a dispatch with several rows: below the limit of WebGPU for any number of pixels.
const ROW: u32 = 32768u;

var<workgroup> group_active: atomic<u32>;
var<workgroup> group_first: u32;

fn active_pixel(own: Invocation) -> Place {
    if dispatch.first == 1u && frame.listed == 0u {
        return grid_pixel(own);
    }
    let i = (own.group.y * ROW + own.group.x) * GROUP + own.lane;
    let packed = list_in[min(i, arrayLength(&list_in) - 1u)];
    let valid = i < active_in.count;
    return Place(select(vec2u(0u), vec2u(packed & 0xffffu, packed >> 16u), valid), valid);
}

fn ray_wanted(code: u32) -> bool {
    return code == ALIVE;
}

fn keep_active(alive: bool, pixel: vec2u, lane: u32) {
    var mine = 0u;
    if alive {
        mine = atomicAdd(&group_active, 1u);
    }
    workgroupBarrier();
    if lane == 0u {
        let count = atomicLoad(&group_active);
        if count > 0u {
            let first = atomicAdd(&active_out.count, count);
            let needed = (first + count + GROUP - 1u) / GROUP;
            atomicMax(&active_out.x, min(needed, ROW));
            atomicMax(&active_out.y, (needed + ROW - 1u) / ROW);
            atomicMax(&active_out.z, 1u);
            group_first = first;
        }
    }
    workgroupBarrier();
    if alive {
        list_out[group_first + mine] = pixel.x | (pixel.y << 16u);
    }
}
