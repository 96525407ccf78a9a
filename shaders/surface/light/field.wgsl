// The voxels of a light's grid (G95 §6), and what lies in them. In each lies the light vector F, the sum of what every path through it
// carries, along the path.

struct GridLight {
    lo: vec3f,
    // A voxel's side.
    h: f32,
    count: vec3u,
    // A brick is a voxel cut into so many along each axis.
    refine: u32,
    color: vec3f,
    // 1 where it is as bright as its paths are many, 0 as bright wherever one comes.
    falls: u32,
    // Where its voxels begin in light_bricks and in light_field; its bricks follow them there.
    first_brick: u32,
    first: u32,
    // Where it is.
    position: vec3f,
}

var<storage, read> grid_lights: array<GridLight>;

// For each voxel the number of its brick, from 1, or 0.
var<storage, read> light_bricks: array<u32>;

// F and the fluence, the sum of the same without directions: for light of intensity 1, or of irradiance 1 if it comes from far away.
var<storage, read> light_field: array<vec4f>;

// In voxels: where light is looked for, off the surface, so that none of the voxels asked is mostly behind it.
const LIGHT_OFF: f32 = 0.9;

fn light_brick_at(light: GridLight, x: vec3f) -> u32 {
    let voxel = vec3u(clamp(x, vec3f(0.0), vec3f(light.count) - 0.5));
    return light_bricks[light.first_brick + (voxel.z * light.count.y + voxel.y) * light.count.x + voxel.x];
}

// Of a point, counted in voxels, in the light's field: in the part of the brick about it, or in all of its voxel if that is 0.
fn light_place(light: GridLight, x: vec3f, brick: u32) -> u32 {
    let place = clamp(x, vec3f(0.0), vec3f(light.count) - 1e-3);
    let voxel = vec3u(place);
    let n = light.refine;
    let part = min(vec3u((place - vec3f(voxel)) * f32(n)), vec3u(n - 1u));
    let all = light.count.x * light.count.y * light.count.z;
    let own = (voxel.z * light.count.y + voxel.y) * light.count.x + voxel.x;
    return light.first + select(all + (brick - 1u) * n * n * n + (part.z * n + part.y) * n + part.x, own, brick == 0u);
}

// What lies in a part of a voxel, each cut into `cut` along each axis, or in all of it where it is no brick.
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
