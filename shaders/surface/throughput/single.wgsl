// One throughput for all colors. A camera ray has the one of surface/throughput/colored.wgsl, if nothing on its way has a color. A ray from a
// light carries the fraction of its light that surfaces leave; for caustics it is negative until a surface has scattered the ray, which
// deposits no light before that.

var<storage, read_write> pixel_throughput: array<f32>;

var<private> throughput: f32;

fn load_throughput(pixel: vec2u) {
    if DRAWS_WAVELENGTH {
        draw_wavelength(pixel);
    }
    throughput = pixel_throughput[place_in_tile(pixel)];
}

fn store_throughput(pixel: vec2u) {
    pixel_throughput[place_in_tile(pixel)] = throughput;
}

fn start_throughput(x: Real3) {
    if FINDS_CAUSTICS {
        throughput = -1.0;
    } else if LEAVES_LIGHT {
        throughput = 1.0;
    } else {
        let n = medium_index(x);
        throughput = f32(n * n);
    }
}

fn kept_throughput() -> vec3f {
    return vec3f(throughput);
}

fn restore_throughput(kept: vec3f) {
    throughput = kept.x;
}

fn note_sent() {
    throughput = abs(throughput);
}

fn scale_throughput(factor: vec3f) -> bool {
    if LEAVES_LIGHT {
        throughput *= (factor.x + factor.y + factor.z) / 3.0;
    } else {
        throughput *= factor.x;
    }
    return throughput < DARK;
}

fn end_throughput(x: Real3) -> vec3f {
    if LEAVES_LIGHT {
        return vec3f(light_weight());
    }
    let n = medium_index(x);
    return finite_throughput(vec3f(throughput / f32(n * n)));
}

fn light_weight() -> f32 {
    if FINDS_CAUSTICS {
        return max(throughput, 0.0);
    }
    return throughput;
}
