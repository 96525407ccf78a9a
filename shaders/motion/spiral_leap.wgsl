// One step to the sphere about the centre that the object is, or into the middle where the ray is captured: ln(R/r)/sin ψ, with no
// trigonometry at all. An exact circle goes nowhere.

fn stride(p: Phase) -> Stride {
    let s = spiral_of(p);
    let rise = log_ratio(here().radius, s.r);
    let fall = log_ratio(s.r, 0.5 * media[place].capture);
    let sigma = select(fall, rise, s.climb > 0.0) / abs(s.climb);
    return Stride(select(0.0, max(sigma, 0.0), s.climb != 0.0), false);
}
