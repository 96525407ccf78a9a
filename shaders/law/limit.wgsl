// Ends paths at a given tau (G95 limits the length of rays): the last step is shortened to it.

struct Limit {
    length: Real,
}

var<uniform> limit: Limit;

fn limited_step(h: Real, ray: Ray) -> Real {
    if !IS_LIMITED {
        return h;
    }
    return min(h, (limit.length - ray.tau) - ray.rest);
}

// A last step of the size of a rounding error would move nothing.
fn length_reached(tau: Real) -> bool {
    if !IS_LIMITED {
        return false;
    }
    return limit.length - tau <= LAST_PART * limit.length;
}
