// From a line: the part of d = x - p that is perpendicular to its unit direction (G95 §2.1).

fn offset_line(d: Real3, along: Real3) -> Real3 {
    return d - dot(d, along) * along;
}
