// A density that the user wrote as formulas of the place.

const FORMULA: u32 = 1u;

fn density_formula(filter_at: Filter, q: Real3) -> vec3f {
    return filter_formula(filter_at.which, q);
}
