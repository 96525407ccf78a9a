// Intersects flat circular disks, optionally with a circular hole: hole² ≤ x² + z² ≤ 1 in y = 0 of object space.

struct DiskSpace {
    row_x: Real4,
    row_y: Real4,
    row_z: Real4,
    // The radius of the hole, in object space; 0 for none.
    hole: Real,
}

var<storage, read> disks: array<Placed>;
var<uniform> disk_list: array<DiskSpace, DISK_COUNT>;

fn ring_fraction(space: LocalSpace, hole: Real, a: Real3, v: Real3) -> Real {
    let p = local_point(space, a);
    let d = local_vector(space, v);
    let t = -p.y / d.y;
    let q = p.xz + t * d.xz;
    let rr = dot(q, q);
    let met = d.y != 0.0 && t >= -overlap() && t <= 1.0 + OVERLAP && rr <= 1.0 && rr >= hole * hole;
    return select(2.0, t, met);
}

fn hit_disk(own: DiskSpace, primitive: u32, a: Real3, d: Real3) -> Real {
    let space = LocalSpace(own.row_x, own.row_y, own.row_z);
    return select(ring_fraction(space, own.hole, a, d), 2.0, is_last_hit(primitive));
}

fn disk_fraction(i: u32, a: Real3, d: Real3) -> Real {
    return hit_disk(DiskSpace(disks[i].row_x, disks[i].row_y, disks[i].row_z, disks[i].radius), DISK | i, a, d);
}

fn surface_disk(i: u32, x: Real3) -> Surface {
    let p = local_point(local_space(disks[i]), x);
    let g = disks[i].row_y.xyz;
    let steep = length(g);
    let n = g / steep;
    let v = (1.0 - length(p.xz)) / (1.0 - disks[i].radius);
    return Surface(p.y / steep, 0.0, n, vec3f(n), vec2f(turn_round(p), f32(v)), disks[i].material, disks[i].object);
}
