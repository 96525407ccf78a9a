// Lights whose paths are found by the shooting method (G95 §6, an open problem there): each path from the light to a position under the
// scene's law is an image of the light there, with its own direction and brightness, and a shadow if something opaque is on it.

struct ShotLight {
    position: vec3f,
    // 1 if its brightness is inversely proportional to the area of the ray bundle.
    falls: u32,
    color: vec3f,
    // The minimum size of a ray bundle, which would vanish at a caustic.
    size: f32,
}

var<storage, read> shot_lights: array<ShotLight>;

fn lit_by_shot(material: Material, color: vec3f, lit: Lit) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < arrayLength(&shot_lights); i++) {
        let light = shot_lights[i];
        let source = Real3(light.position);
        var reached = false;
        forget_shots();
        for (var k = 0u; k < SHOTS; k++) {
            let shot = shot_at(source, lit.start, k);
            reached = reached || shot.found;
            let to_light = -vec3f(shot.arrives);
            if shot.found && dot(lit.normal, to_light) > 0.0 && shot_clear(source, shot.leaves, lit.start) {
                let narrowest = PI * light.size * light.size;
                let strength = select(1.0, 1.0 / max(f32(shot.spread), narrowest), light.falls == 1u);
                sum += strength * light.color * blinn_phong(material, color, to_light, lit.normal, lit.view);
            }
        }
        if !reached {
            tally_status(UNLIT);
        }
    }
    return sum;
}
