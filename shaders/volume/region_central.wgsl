// The regions of volumes that are spheres around the center of an orbit, or all of space: their surfaces are crossed at a distance from the
// center, for which no angle is needed.

// The distances from the surfaces of the volumes: negative inside.
struct RegionPlace {
    gaps: array<Real, VOLUMES>,
}

fn region_gap(step: Stretch, v: u32, f: Real) -> Real {
    return volume_gap(v, stretch_reach(step, f));
}

fn region_place(step: Stretch, f: Real) -> RegionPlace {
    let reach = stretch_reach(step, f);
    var place: RegionPlace;
    for (var v = 0u; v < VOLUMES; v++) {
        place.gaps[v] = volume_gap(v, reach);
    }
    return place;
}

// Compares the ends of a piece, and cuts it where it crosses a surface: a piece belongs to the volumes that contain its start. Along a path
// that is bent little the distance is convex.
fn region_cut(step: Stretch, start: RegionPlace, behind: RegionPlace, a: Real, b: Real) -> RegionCut {
    var cut = RegionCut(0u, b, false, VOLUMES, 0.0);
    let middle = stretch_reach(step, 0.5 * (a + b));
    for (var v = 0u; v < VOLUMES; v++) {
        let one = start.gaps[v];
        let two = behind.gaps[v];
        cut.unclear = cut.unclear || (min(one, two) >= 0.0 && 2.0 * volume_gap(v, middle) - max(one, two) < -1e-6 * two);
        cut_at(&cut, step, v, one, two, a);
    }
    return cut;
}
