// Lights whose light was left in voxels on its way (G95 §6, his grid of light directions). In each voxel lies the light vector F, the sum of
// what every path through it carries, along the path; what a surface receives of all of them is −F·n, as long as all come from its front.

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

@group(0) @binding(145) var<storage, read> grid_lights: array<GridLight>;

// For each voxel the number of its brick, from 1, or 0.
@group(0) @binding(146) var<storage, read> light_bricks: array<u32>;

// F and the fluence, the sum of the same without directions: for light of intensity 1, or of irradiance 1 if it comes from far away.
@group(0) @binding(147) var<storage, read> light_field: array<vec4f>;

// In voxels: where light is looked for, off the surface, so that none of the voxels asked is mostly behind it.
const LIGHT_OFF: f32 = 0.9;

fn lit_by_grid(material: Material, color: vec3f, lit: Lit) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < arrayLength(&grid_lights); i++) {
        work += 1u;
        let light = grid_lights[i];
        let x = (vec3f(lit.x) - light.lo) / light.h;
        // In bricks as far as there are any where the light is looked for.
        let fine = f32(light.refine);
        let near = x + LIGHT_OFF / fine * lit.normal;
        let refined = light_brick_at(light, near) != 0u;
        let cut = select(1.0, fine, refined);
        let f = light_between(light, x, lit.normal, cut);
        let strength = length(f.xyz);
        if strength > 0.0 {
            let answer = light.color * blinn_phong(material, color, -f.xyz / strength, lit.normal, lit.view);
            sum += grid_strength(light, x, lit, f, cut) * answer;
        }
    }
    return sum;
}

fn light_brick_at(light: GridLight, x: vec3f) -> u32 {
    let voxel = vec3u(clamp(x, vec3f(0.0), vec3f(light.count) - 0.5));
    return light_bricks[light.first_brick + (voxel.z * light.count.y + voxel.y) * light.count.x + voxel.x];
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

// Trilinear between the middles of parts, off a surface at x. Of a part that it cuts, light had only what lies before it.
fn light_between(light: GridLight, x: vec3f, normal: vec3f, cut: f32) -> vec4f {
    let surface = x * cut - 0.5;
    let at = surface + LIGHT_OFF * normal;
    let corner = floor(at);
    let part = at - corner;
    let across = abs(normal.x) + abs(normal.y) + abs(normal.z);
    var sum = vec4f(0.0);
    var open = 0.0;
    for (var k = 0u; k < 8u; k++) {
        work += 1u;
        let by = vec3f(vec3u(k & 1u, (k >> 1u) & 1u, k >> 2u));
        let shares = mix(1.0 - part, part, by);
        let share = shares.x * shares.y * shares.z;
        sum += share * light_in(light, corner + by, cut);
        open += share * clamp(0.5 + dot(corner + by - surface, normal) / across, 0.0, 1.0);
    }
    return sum / open;
}
