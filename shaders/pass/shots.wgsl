// The paths from lights to places, as numbers, for `bentray light`: each ray that is given is a place, and in place of a velocity its
// light; and SHOTS in a row are one pair, of which each looks for one path.

struct ShotRecord {
    // Unit directions, at the light and at the place.
    leaves: Real3,
    spread: Real,
    arrives: Real3,
    found: u32,
    // 1 if nothing opaque is on the path.
    clear: u32,
}

@group(0) @binding(181) var<storage, read_write> records: array<ShotRecord>;

@compute @workgroup_size(GROUP)
fn shots(own: Invocation) {
    begin_work(own.lane);
    let spot = grid_pixel(own);
    let pair = picture_ray(spot.pixel);
    let i = spot.pixel.y * frame.size.x + spot.pixel.x;
    forget_shots();
    let shot = shot_at(pair.d, pair.x, i % SHOTS);
    var clear = false;
    if shot.found {
        clear = shot_clear(pair.d, shot.leaves, pair.x);
    }
    if spot.valid {
        records[i] = ShotRecord(shot.leaves, shot.spread, shot.arrives, u32(shot.found), u32(clear));
        tally_status(lit_status(HIT, EXHAUSTED));
    }
    workgroupBarrier();
    total_statuses(own.lane);
}
