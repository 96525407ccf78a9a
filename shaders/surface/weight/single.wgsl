// One throughput for all colors. A camera ray has the one of surface/weight/colored.wgsl, if nothing on its way has a color. A ray from a
// light carries the fraction of its light that surfaces leave; for caustics it is negative until a surface has scattered the ray, which
// deposits no light before that.

var<storage, read_write> pixel_weight: array<f32>;

var<private> weight: f32;

fn load_weight(pixel: vec2u) {
    if DRAWS_WAVELENGTH {
        draw_wavelength(pixel);
    }
    weight = pixel_weight[place_in_tile(pixel)];
}

fn store_weight(pixel: vec2u) {
    pixel_weight[place_in_tile(pixel)] = weight;
}

fn start_weight(x: Real3) {
    if FINDS_CAUSTICS {
        weight = -1.0;
    } else if LEAVES_LIGHT {
        weight = 1.0;
    } else {
        let n = medium_index(x);
        weight = f32(n * n);
    }
}

fn note_sent() {
    weight = abs(weight);
}

fn scale_weight(factor: vec3f) -> bool {
    if LEAVES_LIGHT {
        weight *= (factor.x + factor.y + factor.z) / 3.0;
    } else {
        weight *= factor.x;
    }
    return weight < DARK;
}

fn end_weight(x: Real3) -> vec3f {
    if LEAVES_LIGHT {
        return vec3f(light_weight());
    }
    let n = medium_index(x);
    return sure_weight(vec3f(weight / f32(n * n)));
}

fn light_weight() -> f32 {
    if FINDS_CAUSTICS {
        return max(weight, 0.0);
    }
    return weight;
}
