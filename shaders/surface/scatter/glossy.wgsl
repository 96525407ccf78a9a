// Glossy reflection (T 2.2.3): rays are spread around the mirror direction. Rays that would be below the surface are dropped, and
// their light is lost: under uniform light such a ball is as bright as the fraction of the lobe above the surface, which is half at its
// limb.

const GLOSSY: u32 = 5u;

fn scatter_glossy(material: Material, surface: Surface, end: PathPoint, index: u32, pixel: vec2u) -> Scattered {
    let mirrored = end.v - (2.0 * dot(end.v, surface.normal)) * surface.normal;
    let way = lobe_way(vec3f(normalize(mirrored)), material.exponent, lobe_point(pixel, index));
    let normal = vec3f(surface.normal);
    let above = dot(way, normal) * dot(vec3f(mirrored), normal) > 0.0;
    return Scattered(length(end.v) * Real3(way), pattern_color(material, surface.uv), !above, true);
}
