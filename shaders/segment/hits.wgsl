// Stores the hit of each pixel's ray: the primitive and the fraction of its last segment. It is not part of the state: it is written once.

var<storage, read_write> pixel_hit_primitive: array<u32>;
var<storage, read_write> pixel_hit_t: array<f32>;

fn store_hit(pixel: vec2u, hit: Hit) {
    if HAS_OBJECTS {
        pixel_hit_primitive[place_in_tile(pixel)] = hit.primitive;
        pixel_hit_t[place_in_tile(pixel)] = f32(hit.t);
    }
}

fn load_hit(pixel: vec2u) -> Hit {
    if !HAS_OBJECTS {
        return Hit(0.0, NOTHING);
    }
    return Hit(Real(pixel_hit_t[place_in_tile(pixel)]), pixel_hit_primitive[place_in_tile(pixel)]);
}

fn clear_hit(pixel: vec2u) {
    if HAS_OBJECTS {
        store_hit(pixel, Hit(0.0, NOTHING));
    }
}
