// The voxels of a light's grid (G95 §6). Each stores the light vector F, the sum over all paths through it of the light that they carry,
// along the path.

struct GridLight {
    lo: vec3f,
    // The side of a voxel.
    h: f32,
    count: vec3u,
    // The number of parts of a brick, a subdivided voxel, along each axis.
    refine: u32,
    color: vec3f,
    // 1 if its brightness is proportional to the number of its paths, 0 if it is equal wherever a path comes.
    falls: u32,
    // The start of its voxels in light_bricks and in light_field; its bricks follow them there.
    first_brick: u32,
    first: u32,
    // The position of the light.
    position: vec3f,
}

var<storage, read> grid_lights: array<GridLight>;

// The index of each voxel's brick, from 1, or 0.
var<storage, read> light_bricks: array<u32>;

// F and the fluence, the sum without directions: for light of intensity 1, or of irradiance 1 if it comes from infinity.
var<storage, read> light_field: array<vec4f>;

// The distance from the surface, in voxels, at which light is looked up, so that none of the voxels read is mostly behind the surface.
const LIGHT_OFF: f32 = 0.9;

fn light_brick_at(light: GridLight, x: vec3f) -> u32 {
    let voxel = vec3u(clamp(x, vec3f(0.0), vec3f(light.count) - 0.5));
    return light_bricks[light.first_brick + (voxel.z * light.count.y + voxel.y) * light.count.x + voxel.x];
}

// Returns the index in light_field of a point in units of voxels: in the part of the brick that contains it, or in its whole voxel if
// `brick` is 0.
fn light_place(light: GridLight, x: vec3f, brick: u32) -> u32 {
    let place = clamp(x, vec3f(0.0), vec3f(light.count) - 1e-3);
    let voxel = vec3u(place);
    let n = light.refine;
    let part = min(vec3u((place - vec3f(voxel)) * f32(n)), vec3u(n - 1u));
    let all = light.count.x * light.count.y * light.count.z;
    let own = (voxel.z * light.count.y + voxel.y) * light.count.x + voxel.x;
    return light.first + select(all + (brick - 1u) * n * n * n + (part.z * n + part.y) * n + part.x, own, brick == 0u);
}

// Returns the content of a part of a voxel, divided into `cut` along each axis, or of all of it if it has no brick.
fn light_in(light: GridLight, part: vec3f, cut: f32) -> vec4f {
    let place = clamp((part + 0.5) / cut, vec3f(0.0), vec3f(light.count) - 1e-3);
    let voxel = vec3u(place);
    let brick = light_brick_at(light, place);
    let own = (voxel.z * light.count.y + voxel.y) * light.count.x + voxel.x;
    if cut == 1.0 || brick == 0u {
        return light_field[light.first + own];
    }
    let n = light.refine;
    let fine = min(vec3u((place - vec3f(voxel)) * cut), vec3u(n - 1u));
    let all = light.count.x * light.count.y * light.count.z;
    return light_field[light.first + all + (brick - 1u) * n * n * n + (fine.z * n + fine.y) * n + fine.x];
}
