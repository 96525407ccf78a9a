// x″ = −n₀² g² ρ, ρ the part of x − c across the axis.

fn spring_center() -> Real3 {
    return media[place].center;
}

fn spring_axis() -> Real3 {
    return media[place].axis;
}

fn spring_rate() -> Real {
    return media[place].n0 * media[place].g;
}
