// The regions of volumes: where a path enters and leaves them. A convex shape has a norm, which is 1 on its surface; a length that is
// shorter than the distances of both its ends from the surface does not cross it.

struct VolumeRegion {
    // The rows of the map from the scene to the shape's own coordinates.
    x: Real4,
    y: Real4,
    z: Real4,
    // The smallest half side of the shape.
    least: Real,
    // The origin of formulas.
    origin: Real3,
}

var<uniform> volumes: array<VolumeRegion, VOLUMES>;

// A position, and its distances from the surfaces of the volumes: negative inside.
struct RegionPlace {
    x: Real3,
    gaps: array<Real, VOLUMES>,
}

fn own_place(region: VolumeRegion, x: Real3) -> Real3 {
    return Real3(dot(region.x.xyz, x) + region.x.w, dot(region.y.xyz, x) + region.y.w, dot(region.z.xyz, x) + region.z.w);
}

fn norm_sphere(p: Real3) -> Real {
    return length(p);
}

fn norm_box(p: Real3) -> Real {
    let q = abs(p);
    return max(q.x, max(q.y, q.z));
}

fn norm_cylinder(p: Real3) -> Real {
    return max(length(p.xz), abs(p.y));
}

// The deviations of the middle, and of all else from it, with a reserve.
const BENDS: Real = 4.0;

// Returns the distance of a position from the surface of a volume, or less.
fn own_gap(v: u32, x: Real3) -> Real {
    return volumes[v].least * (volume_norm(v, own_place(volumes[v], x)) - 1.0);
}

fn region_gap(step: Stretch, v: u32, f: Real) -> Real {
    return own_gap(v, stretch_place(step, f));
}

fn region_place(step: Stretch, f: Real) -> RegionPlace {
    let x = stretch_place(step, f);
    var place: RegionPlace;
    place.x = x;
    for (var v = 0u; v < VOLUMES; v++) {
        place.gaps[v] = own_gap(v, x);
    }
    return place;
}

// Compares the ends of a piece. If it crosses a surface, it is cut there: a piece belongs to the volumes that contain its start. A piece
// whose ends are outside may still pass through. Along a line the distance is convex, so that its value in the middle may exclude that; a
// path deviates from the line about as much as its middle does.
fn region_cut(step: Stretch, start: RegionPlace, behind: RegionPlace, a: Real, b: Real) -> RegionCut {
    var cut = RegionCut(0u, b, false, VOLUMES, 0.0);
    let passed = length(behind.x - start.x);
    let middle = stretch_place(step, 0.5 * (a + b));
    let bend = BENDS * distance(middle, 0.5 * (start.x + behind.x));
    for (var v = 0u; v < VOLUMES; v++) {
        let one = start.gaps[v];
        let two = behind.gaps[v];
        if min(one, two) >= 0.0 && passed + bend > one + two {
            let between = own_gap(v, middle);
            // If a path has just left the volume, rounding decides nothing.
            let slack = select(Real(0.0), 1e-6 * passed, one < 1e-5 * passed);
            cut.unclear = cut.unclear || 2.0 * between - max(one, two) - bend < -slack;
        }
        cut_at(&cut, step, v, one, two, a);
    }
    return cut;
}
