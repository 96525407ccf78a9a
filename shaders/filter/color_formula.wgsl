// A colour that the user wrote as formulas of the place: from 0 to 1, or it is none.

const COLOR_FORMULA: u32 = 2u;

fn density_color_formula(filter_at: Filter, q: Real3) -> vec3f {
    let color = filter_formula(filter_at.which, q);
    return select(vec3f(-1.0), density_of(color), color >= vec3f(0.0) & color <= vec3f(1.0 + 1e-6));
}
