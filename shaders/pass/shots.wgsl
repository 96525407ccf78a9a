// Writes the paths from lights to positions as numbers, for `bentray light`: each given ray is a position, with its light instead of a
// velocity. Pairs of light and position next to each other search for their first paths, then for their second, and so on: invocations that
// run in step share a limit of loop iterations, and do similar work.

const ABREAST: u32 = 8u;

struct ShotRecord {
    // Unit directions, at the light and at the position.
    leaves: Real3,
    spread: Real,
    arrives: Real3,
    error: Real,
    // The offset of the search.
    offset: Real3,
    gap: Real,
    passed: Real,
    parts: u32,
    found: u32,
    // 1 if nothing opaque blocks the path.
    clear: u32,
}

var<storage, read_write> records: array<ShotRecord>;

// Runs repeatedly until every search is over: each run does one part of a search, and tests the path that it found.
@compute @workgroup_size(GROUP)
fn shots(own: Invocation) {
    let spot = grid_pixel(own);
    let pair = picture_ray(spot.pixel);
    let i = place_in_tile(spot.pixel);
    let r = records[i];
    var search = ShotSearch(Shot(r.found == 1u, r.leaves, r.arrives, r.spread, r.error), r.offset, r.gap, r.passed, r.parts);
    var clear = r.clear;
    var over = false;
    forget_shots();
    // A row is padded with positions at their light.
    if spot.valid && any(pair.d != pair.x) && r.parts <= SEARCHED {
        if r.parts < SEARCHED {
            search = continued_search(search, pair.d, pair.x, (i / ABREAST) % SHOTS);
            over = unfinished || (search.parts == SEARCHED && !search.shot.found);
        } else {
            clear = u32(shot_clear(pair.d, search.shot.leaves, pair.x));
            over = true;
        }
        search.parts = select(search.parts, SEARCHED + 1u, over);
        let shot = search.shot;
        let found = u32(shot.found);
        records[i] = ShotRecord(shot.leaves, shot.spread, shot.arrives, shot.error, search.offset, search.gap, search.passed, search.parts, found, clear);
    }
    if over {
        tally_status(lit_status(HIT, EXHAUSTED));
    }
    workgroupBarrier();
    total_statuses(own.lane);
}
