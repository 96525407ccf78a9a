// Transparent objects with a rough surface (T 2.2.3): the Fresnel reflectance chooses between the two rays of the smooth surface, and
// the chosen one is spread around its direction. A ray that would be on the wrong side is dropped, and its light is lost.

const FROSTED: u32 = 6u;

fn scatter_frosted(material: Material, surface: Surface, end: PathPoint, index: u32, pixel: vec2u) -> Scattered {
    let near_medium = medium_object();
    let passed = scatter_transmissive(material, surface, end, index, pixel);
    let normal = vec3f(surface.normal);
    let reflects = dot(vec3f(passed.v), normal) * dot(vec3f(end.v), normal) < 0.0;
    let exponent = select(material.transmit_exponent, material.exponent, reflects);
    // There is no surface between equal media.
    if exponent == 0.0 || (!reflects && medium_object() == near_medium) {
        return passed;
    }
    let way = lobe_way(vec3f(normalize(passed.v)), exponent, lobe_point(pixel, index));
    let lost = dot(way, normal) * dot(vec3f(passed.v), normal) <= 0.0;
    return Scattered(length(passed.v) * Real3(way), passed.throughput, passed.cut || lost, true);
}
