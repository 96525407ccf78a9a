// x″ = −(x − c)/R², about a point.

fn spring_center() -> Real3 {
    return media[place].center;
}

fn spring_axis() -> Real3 {
    return Real3(0.0);
}

fn spring_rate() -> Real {
    return 1.0 / media[place].radius;
}
