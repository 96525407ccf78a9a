// How far a place lies in the light of a grid that does not fall off.

// Of what is expected of a place: so dark is a shadow, and so much brighter is lit.
const SHADE: f32 = 0.25;
const FADE: f32 = 0.5;

// Of the fluence that comes to x, in voxels, as much as comes to the brightest place around, or on a straight way.
fn even_share(light: GridLight, x: vec3f, lit: Lit, fluence: f32, cut: f32) -> f32 {
    let way = lit.x - light.position;
    let expected = min(1.0 / dot(way, way), brightest_around(light, x + 1.5 / cut * lit.normal, cut));
    return clamp((fluence / expected - SHADE) / FADE, 0.0, 1.0);
}

// The greatest fluence about a place: near a shadow that of what is not in it, where light is spread wide or in focus about the place's own.
fn brightest_around(light: GridLight, x: vec3f, cut: f32) -> f32 {
    let corner = floor(x * cut);
    var most = 0.0;
    for (var k = 0u; k < 27u; k++) {
        let by = vec3f(vec3u(k % 3u, (k / 3u) % 3u, k / 9u)) - 1.0;
        most = max(most, light_in(light, corner + by, cut).w);
    }
    return most;
}
