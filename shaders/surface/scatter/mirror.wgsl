// Mirrors that reflect a fraction of the light given by their pattern.

const MIRROR: u32 = 2u;

fn scatter_mirror(material: Material, surface: Surface, end: PathPoint, index: u32, pixel: vec2u) -> Scattered {
    let v = end.v - (2.0 * dot(end.v, surface.normal)) * surface.normal;
    return Scattered(v, pattern_color(material, surface.uv), false, true);
}
