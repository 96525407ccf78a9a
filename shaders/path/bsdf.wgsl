// The reflection of surfaces on paths: Lambertian for matte ones, f = rho/pi; surfaces with a matte and a glossy part are reciprocal: f =
// rho/pi + k (e + 2)/(2 pi) cosᵉ a, where a is the angle to the mirror direction (Lafortune and Willems 1994). The albedo of the glossy
// part is k along the normal and less elsewhere.

// The exponent above which a lobe finds its light without next-event estimation.
const NARROW: f32 = 500.0;

// Returns the probability of the matte part.
fn matte_share(bsdf: Bsdf) -> f32 {
    let matte = max(bsdf.diffuse.x, max(bsdf.diffuse.y, bsdf.diffuse.z));
    let glossy = max(bsdf.gloss.x, max(bsdf.gloss.y, bsdf.gloss.z));
    return matte / max(matte + glossy, 1e-30);
}

// Returns cosᵉ of the angle to the mirror direction.
fn lobe(vertex: PathVertex, way: vec3f) -> f32 {
    let cosine = dot(vertex.mirror, way);
    return select(0.0, pow(max(cosine, 1e-30), vertex.bsdf.exponent), cosine > 0.0);
}

// Returns f cos theta for light that comes from `way`.
fn bsdf_cosine(vertex: PathVertex, way: vec3f) -> vec3f {
    if !IS_GLOSSY {
        return bsdf_density(vertex, way) * vertex.bsdf.diffuse;
    }
    let gloss = (vertex.bsdf.exponent + 2.0) / 2.0 * lobe(vertex, way) * vertex.bsdf.gloss;
    return max(dot(vertex.shading_normal, way), 0.0) / f32(PI) * (vertex.bsdf.diffuse + gloss);
}

// Returns the density of a direction that the surface chooses, per solid angle.
fn bsdf_density(vertex: PathVertex, way: vec3f) -> f32 {
    if !IS_GLOSSY {
        return max(dot(vertex.shading_normal, way), 0.0) / f32(PI);
    }
    let matte = matte_share(vertex.bsdf);
    let glossy = (vertex.bsdf.exponent + 1.0) / (2.0 * f32(PI)) * lobe(vertex, way);
    return matte * max(dot(vertex.shading_normal, way), 0.0) / f32(PI) + (1.0 - matte) * glossy;
}

fn sample_bsdf(vertex: PathVertex, u: vec2f, choice: f32) -> vec3f {
    if !IS_GLOSSY {
        return way_about(vertex.shading_normal, sqrt(1.0 - u.x), sqrt(u.x), u.y);
    }
    if choice < matte_share(vertex.bsdf) {
        return way_about(vertex.shading_normal, sqrt(1.0 - u.x), sqrt(u.x), u.y);
    }
    return lobe_way(vertex.mirror, vertex.bsdf.exponent, u);
}

// Returns `true` if next-event estimation is worthwhile here.
fn bsdf_is_wide(vertex: PathVertex) -> bool {
    if !IS_GLOSSY {
        return true;
    }
    return any(vertex.bsdf.diffuse > vec3f(0.0)) || vertex.bsdf.exponent < NARROW;
}
