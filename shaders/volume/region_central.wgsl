// The regions of volumes that are spheres around the center of an orbit, or all of space: their surfaces are crossed at a distance from the
// center, for which no angle is needed.

// The inverse of r, its slope by the fraction of the stretch, and the distances from the surfaces of the volumes: negative inside.
struct RegionPlace {
    u: Real,
    slope: Real,
    gaps: array<Real, VOLUMES>,
}

fn region_gap(step: Stretch, v: u32, f: Real) -> Real {
    return volume_gap(v, stretch_reach(step, f));
}

fn region_place(step: Stretch, f: Real) -> RegionPlace {
    let rise = stretch_rise(step, f);
    let reach = stretch_reach(step, f);
    var place: RegionPlace;
    place.u = rise.x;
    place.slope = rise.y;
    for (var v = 0u; v < VOLUMES; v++) {
        place.gaps[v] = volume_gap(v, reach);
    }
    return place;
}

// Compares the ends of a piece, and cuts it where it crosses a surface: a piece belongs to the volumes that contain its start. Between its
// ends, a path comes nearer to the center only around a pericenter, where 1/r is below the tangents at both ends.
fn region_cut(step: Stretch, start: RegionPlace, behind: RegionPlace, a: Real, b: Real) -> RegionCut {
    var cut = RegionCut(0u, b, false, VOLUMES, 0.0);
    let outer = max(start.u, behind.u);
    let rise = 0.25 * (b - a) * (start.slope - behind.slope);
    let turns = (start.slope > 0.0) & (behind.slope < 0.0);
    let dip = select(Real(0.0), rise / (outer * (outer + rise)), turns);
    for (var v = 0u; v < VOLUMES; v++) {
        let one = start.gaps[v];
        let two = behind.gaps[v];
        cut.unclear = cut.unclear || (min(one, two) >= 0.0 && min(one, two) < dip);
        cut_at(&cut, step, v, one, two, a);
    }
    return cut;
}
