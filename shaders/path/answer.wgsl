// The reflection of surfaces on paths: Lambertian for matte ones, f = rho/pi; surfaces with a matte and a glossy part are reciprocal: f =
// rho/pi + k (e + 2)/(2 pi) cosᵉ a, where a is the angle to the mirror direction (Lafortune and Willems 1994). The albedo of the glossy
// part is k along the normal and less elsewhere.

// The exponent above which a lobe finds its light without next-event estimation.
const NARROW: f32 = 500.0;

// Returns the probability of the matte part.
fn matte_share(answer: Answer) -> f32 {
    let matte = max(answer.diffuse.x, max(answer.diffuse.y, answer.diffuse.z));
    let glossy = max(answer.gloss.x, max(answer.gloss.y, answer.gloss.z));
    return matte / max(matte + glossy, 1e-30);
}

// Returns cosᵉ of the angle to the mirror direction.
fn lobe(vertex: PathVertex, way: vec3f) -> f32 {
    let cosine = dot(vertex.mirror, way);
    return select(0.0, pow(max(cosine, 1e-30), vertex.answer.exponent), cosine > 0.0);
}

// Returns f cos theta for light that comes from `way`.
fn answered(vertex: PathVertex, way: vec3f) -> vec3f {
    if !IS_GLOSSY {
        return answer_density(vertex, way) * vertex.answer.diffuse;
    }
    let gloss = (vertex.answer.exponent + 2.0) / 2.0 * lobe(vertex, way) * vertex.answer.gloss;
    return max(dot(vertex.normal, way), 0.0) / f32(PI) * (vertex.answer.diffuse + gloss);
}

// Returns the density of a direction that the surface chooses, per solid angle.
fn answer_density(vertex: PathVertex, way: vec3f) -> f32 {
    if !IS_GLOSSY {
        return max(dot(vertex.normal, way), 0.0) / f32(PI);
    }
    let matte = matte_share(vertex.answer);
    let glossy = (vertex.answer.exponent + 1.0) / (2.0 * f32(PI)) * lobe(vertex, way);
    return matte * max(dot(vertex.normal, way), 0.0) / f32(PI) + (1.0 - matte) * glossy;
}

fn answer_way(vertex: PathVertex, u: vec2f, choice: f32) -> vec3f {
    if !IS_GLOSSY {
        return way_about(vertex.normal, sqrt(1.0 - u.x), sqrt(u.x), u.y);
    }
    if choice < matte_share(vertex.answer) {
        return way_about(vertex.normal, sqrt(1.0 - u.x), sqrt(u.x), u.y);
    }
    return lobe_way(vertex.mirror, vertex.answer.exponent, u);
}

// Returns `true` if next-event estimation is worthwhile here.
fn answers_widely(vertex: PathVertex) -> bool {
    if !IS_GLOSSY {
        return true;
    }
    return any(vertex.answer.diffuse > vec3f(0.0)) || vertex.answer.exponent < NARROW;
}
