// Finds where a path crosses the surfaces of volumes.

// The volumes that contain a piece, how far it leads before a surface is crossed, and whether it may cross one unseen.
struct RegionCut {
    within: u32,
    until: Real,
    unclear: bool,
    // The volume whose surface is crossed there, if any, and the distance from it on the far side.
    crossed: u32,
    gap: Real,
}

// The largest number of positions at which a crossing is searched.
const CROSSING_LOOKS: u32 = 100u;

// Returns the end of a piece that a surface cuts, on the far side of that surface in spite of rounding.
fn region_behind(step: Stretch, cut: RegionCut) -> RegionPlace {
    var place = region_place(step, cut.until);
    for (var v = 0u; v < VOLUMES; v++) {
        place.gaps[v] = select(place.gaps[v], cut.gap, v == cut.crossed);
    }
    return place;
}

// Cuts a piece from a at the surface of a volume, from whose surface its ends are `one` and `two` away.
fn cut_at(cut: ptr<function, RegionCut>, step: Stretch, v: u32, one: Real, two: Real, a: Real) {
    (*cut).within |= select(0u, 1u << v, one < 0.0);
    if (one < 0.0) != (two < 0.0) {
        let crossing = region_crossing(step, v, one, two, a, (*cut).until);
        if crossing.x < (*cut).until {
            (*cut).until = crossing.x;
            (*cut).crossed = v;
            (*cut).gap = crossing.y;
        }
    }
}

// Returns where a piece crosses the surface of a volume, and the distance from it: by false position with the Illinois rule (Dowell and
// Jarratt 1971), and by halving where that hardly advances.
fn region_crossing(step: Stretch, v: u32, one: Real, two: Real, a: Real, b: Real) -> Real2 {
    var before = a;
    var behind = b;
    var near = one;
    var far = two;
    var beyond = two;
    var moved = 0u;
    var slow = false;
    var i = 0u;
    loop {
        let size = behind - before;
        let line = before + size * near / (near - far);
        let middle = before + 0.5 * size;
        let at = select(middle, line, line > before && line < behind && !slow);
        let gap = region_gap(step, v, at);
        if (gap < 0.0) == (one < 0.0) {
            before = at;
            near = gap;
            far *= select(Real(1.0), 0.5, moved == 1u);
            moved = 1u;
        } else {
            behind = at;
            far = gap;
            beyond = gap;
            near *= select(Real(1.0), 0.5, moved == 2u);
            moved = 2u;
        }
        slow = behind - before > 0.5 * size;
        i += 1u;
        continuing {
            break if i >= CROSSING_LOOKS || behind - before <= 4.0 * LAST_PART * b;
        }
    }
    return Real2(behind, select(beyond, select(Real(-1e-30), 1e-30, two > 0.0), beyond == 0.0));
}
