// Transparent objects with a microfacet surface (Walter et al. 2007), whose slopes have the Trowbridge–Reitz distribution (GGX) of width a.
// A ray meets one facet of those visible to it, is reflected or refracted there as by a smooth surface, and is weighted by the fraction of
// its outgoing direction that other facets leave open. A ray that would be on the wrong side is dropped: its light would be scattered a
// second time.

const MICROFACET: u32 = 8u;

fn scatter_microfacet(material: Material, surface: Surface, end: PathPoint, index: u32, pixel: vec2u) -> Scattered {
    let bits = inside;
    let near_medium = medium_object();
    let n1 = medium_index(end.x);
    enter_set(set_beyond(1u << material.bit, surface, end.x));
    let n2 = medium_index(end.x);
    if medium_object() == near_medium {
        return Scattered(end.v, vec3f(1.0), false, true);
    }
    let way = normalize(end.v);
    let axis = vec3f(select(surface.normal, -surface.normal, dot(surface.normal, way) > 0.0));
    let facet = seen_facet(-vec3f(way), axis, material.roughness, lobe_point(pixel, index));
    let both = refraction(n1 * way, Real3(facet), n1, n2);
    if both.reflectance == 0.0 {
        return Scattered(both.transmitted, vec3f(1.0), false, true);
    }
    var taken = Branch(true, 1.0, false);
    if both.reflectance < 1.0 {
        taken = chosen_branch(pixel, index, f32(both.reflectance));
    }
    if taken.reflects {
        enter_set(bits);
    }
    let onward = select(both.transmitted, both.reflected, taken.reflects);
    let height = dot(normalize(vec3f(onward)), axis);
    let lost = (height > 0.0) != taken.reflects;
    return Scattered(onward, vec3f(taken.throughput * open_facets(height, material.roughness)), taken.cut || lost, true);
}

// Returns the normal of a facet, drawn from those visible from the direction `view` (Heitz 2018, by the spherical caps of Dupuy and Benyoub
// 2023). u: a point of the unit square; 0, for rays that draw nothing, gives the geometric normal.
fn seen_facet(view: vec3f, axis: vec3f, a: f32, u: vec2f) -> vec3f {
    let frame_of = frame_about(axis);
    let local = view * frame_of;
    // Where facets are stretched to a hemisphere it is a direction of the visible cap.
    let stretched = normalize(vec3f(a * local.xy, local.z));
    let z = (1.0 - u.x) * (1.0 + stretched.z) - stretched.z;
    let sine = sqrt(clamp(1.0 - z * z, 0.0, 1.0));
    let phi = 2.0 * f32(PI) * u.y;
    let h = stretched + vec3f(sine * cos(phi), sine * sin(phi), z);
    let facet = normalize(frame_of * vec3f(a * h.xy, max(h.z, 0.0)));
    return select(facet, axis, all(u == vec2f(0.0)));
}

// Returns the Smith fraction of the facets that others leave open in a direction of this cosine.
fn open_facets(cosine: f32, a: f32) -> f32 {
    let c2 = max(cosine * cosine, 1e-12);
    return 2.0 / (1.0 + sqrt(1.0 + a * a * (1.0 - c2) / c2));
}
