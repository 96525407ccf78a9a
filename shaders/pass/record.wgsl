// Writes the position of each ray as numbers, for `trace`: ended rays at their end, others at the end of their last segment so far.

struct Record {
    x: Real3,
    tau: Real,
    v: Real3,
    segments: Real,
    status: u32,
    steps: u32,
    rejected: u32,
    // The index of the object in the scene file, from 1; 0 for none.
    object: u32,
    // The start of the ray's last segment, or the start of the ray before its first segment.
    from_x: Real3,
    from_v: Real3,
}

var<storage, read_write> records: array<Record>;

@compute @workgroup_size(GROUP)
fn record(own: Invocation) {
    let spot = grid_pixel(own);
    let pixel = spot.pixel;
    if spot.valid {
        load_region(pixel);
        let ray = load_ended(pixel);
        let seen = recorded_at(ray, load_hit(pixel));
        if IS_SPECTRAL {
            load_throughput(pixel);
            if COUNTS_TRANSFER {
                note_glow();
            }
            transfer_end(pixel, ray, seen.end);
            var behind = vec3f(0.0);
            if ray.status == ESCAPED || ray.status == MISSED {
                if KNOWS_SHIFT {
                    note_frequency(pixel, ray);
                }
                behind = sky_radiance(vec3f(normalize(seen.end.v))) * end_throughput(seen.end.x);
            }
            end_transfer(pixel, behind, seen.end.x);
            store_transfer(pixel);
        }
        if KEEPS_CROSSINGS {
            if ray.status == HIT {
                add_crossing(pixel, hit_surface(load_hit(pixel).primitive, seen.end.x), seen.end);
            }
        }
        let segments = Real(ray.index) + seen.end.fraction;
        let i = place_in_tile(pixel);
        records[i] = Record(
            seen.end.x, seen.end.tau, seen.end.v, segments, ray.status, ray.steps, ray.rejected, seen.object,
            ray.phase[0].xyz, ray.phase[1].xyz,
        );
        tally_status(ray.status);
    }
    workgroupBarrier();
    total_statuses(own.lane);
}
