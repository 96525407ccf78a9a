// The path's parameter. Where paths end by it, in 32 bits, it is summed with what each sum rounds away (Knuth's two-sum): thousands of short
// steps would each lose up to half of the sum's last digit. What is left is kept between passes beside the state.

@group(0) @binding(37) var rest_in: texture_2d<f32>;
@group(0) @binding(38) var rest_0: texture_2d<f32>;
@group(0) @binding(39) var rest_1: texture_2d<f32>;
@group(0) @binding(40) var rest_2: texture_2d<f32>;
@group(0) @binding(41) var rest_out: texture_storage_2d<r32float, write>;

fn later(ray: Ray, passed: Real) -> Ray {
    var next = ray;
    if COMPENSATES_TAU {
        let more = opaque(passed + ray.rest);
        next.tau = opaque(ray.tau + more);
        let added = opaque(next.tau - ray.tau);
        next.rest = opaque((ray.tau - opaque(next.tau - added)) + (more - added));
    } else {
        // One by one: compilers may sum up those of several steps otherwise where a program goes on otherwise.
        next.tau = opaque(ray.tau + passed);
    }
    return next;
}

fn load_rest(pixel: vec2u) -> Real {
    if !COMPENSATES_TAU {
        return 0.0;
    }
    return textureLoad(rest_in, pixel, 0).x;
}

fn rest_at_0(pixel: vec2u) -> Real {
    return textureLoad(rest_0, pixel, 0).x;
}

fn rest_at_1(pixel: vec2u) -> Real {
    return textureLoad(rest_1, pixel, 0).x;
}

fn rest_at_2(pixel: vec2u) -> Real {
    return textureLoad(rest_2, pixel, 0).x;
}

fn ended_rest(slot: u32, pixel: vec2u) -> Real {
    if !COMPENSATES_TAU {
        return 0.0;
    }
    return slot_rest(slot, pixel);
}

fn store_rest(pixel: vec2u, ray: Ray) {
    if COMPENSATES_TAU {
        textureStore(rest_out, pixel, vec4f(ray.rest));
    }
}
