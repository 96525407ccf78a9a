// Ambient occlusion along straight lines, whatever the law.

fn open_share(lit: Lit, way: vec3f) -> Share {
    return light_share(ambient.shadows, dot(way, lit.normal) > 0.0, lit.start, ambient.distance * Real3(way));
}
