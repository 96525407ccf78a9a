// Instances of meshes. A primitive is one triangle of one instance: the instance's first primitive, plus the index of the triangle in the
// mesh.

// Replaces a kind and an index: there are more of them than four bits leave room for.
const INSTANCE: u32 = 0x80000000u;
const INSTANCE_INDEX: u32 = 0x7fffffffu;

struct Instance {
    // The rows of the affine map from the scene's space to the mesh's space.
    row_x: Real4,
    row_y: Real4,
    row_z: Real4,
    // The first node of its mesh.
    root: u32,
    // The first triangle of its mesh.
    first: u32,
    // The node after the leaf that holds it.
    next: u32,
    object: u32,
    // The number of triangles of all instances before it.
    primitives: u32,
    // The number of nodes of all instances before it.
    places: u32,
    material: u32,
}

var<storage, read> instances: array<Instance>;

fn instance_space(i: u32) -> LocalSpace {
    return LocalSpace(instances[i].row_x, instances[i].row_y, instances[i].row_z);
}

// Returns the last instance that begins no later than `number`, among primitives or among the positions of a walk.
fn instance_of(number: u32, of_walk: bool) -> u32 {
    let last = arrayLength(&instances) - 1u;
    var found = 0u;
    for (var bit = 1u << firstLeadingBit(last + 1u); bit > 0u; bit >>= 1u) {
        let next = min(found + bit, last);
        let begins = select(instances[next].primitives, instances[next].places, of_walk);
        found = select(found, next, begins <= number);
    }
    return found;
}

fn surface_instance(primitive: u32, x: Real3) -> Surface {
    let own = instances[instance_of(primitive, false)];
    let space = LocalSpace(own.row_x, own.row_y, own.row_z);
    let triangle = own.first + primitive - own.primitives;
    let place = corners[triangle];
    let v = mesh_vertices(triangle);
    let at = local_point(space, x);
    let n = cross(place.q - place.p, place.r - place.p);
    let steep = scene_gradient(space, n);
    let share = triangle_shares(place.p, place.q, place.r, at);
    let normal = share.x * normalize(scene_gradient(space, v[0].normal))
        + share.y * normalize(scene_gradient(space, v[1].normal))
        + share.z * normalize(scene_gradient(space, v[2].normal));
    let uv = share.x * v[0].uv + share.y * v[1].uv + share.z * v[2].uv;
    let signed_distance = dot(n, at - place.p) / length(steep);
    if HAS_VERTEX_COLORS {
        note_corners(triangle, share);
    }
    return Surface(signed_distance, 0.0, normalize(steep), vec3f(normalize(normal)), vec2f(uv), own.material, own.object);
}
