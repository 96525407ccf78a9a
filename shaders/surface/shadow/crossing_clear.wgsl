// What has an interior lets light through: as much as is transmitted by Fresnel's law, of light that asks for that.

fn crossing_share(shadows: u32, hit: ptr<function, Hit>, x: Real3, way: Real3) -> f32 {
    let surface = met_surface(hit, x);
    let own = materials[surface.material];
    if shadows == SHUT_OUT || !is_clear(own.kind) {
        return 0.0;
    }
    let near_medium = medium_object();
    let n1 = medium_index(x);
    enter_set(set_beyond(1u << own.bit, surface, x));
    if shadows != WEAKENED || medium_object() == near_medium {
        return 1.0;
    }
    let n2 = medium_index(x);
    // A line that is not bent meets the surface at one angle from both sides. It is taken for that in the thinner medium, or light would
    // be reflected totally where it has come in through the same glass.
    let thin = min(n1, n2);
    return f32(1.0 - refraction(thin * normalize(way), surface.across, thin, max(n1, n2)).reflectance);
}
