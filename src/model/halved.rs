//! Root finding by bisection.

/// Returns the ends of an interval after `times` bisections: `is_beyond` is `false` at the first and `true` at the second.
pub(super) fn halved(mut low: f64, mut high: f64, times: u32, is_beyond: impl Fn(f64) -> bool) -> [f64; 2] {
    for _ in 0..times {
        let middle = low.midpoint(high);
        *(if is_beyond(middle) { &mut high } else { &mut low }) = middle;
    }
    [low, high]
}
