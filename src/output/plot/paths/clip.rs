//! What of lines, areas and curves lies in a rectangle, so that nothing is drawn outside of it.

use glam::DVec2;

/// A cubic Bézier arc on paper.
pub(super) type Arc = [DVec2; 4];

/// How often an arc that crosses the edge is halved: beyond that it is a point.
const HALVINGS: u32 = 16;

/// A rectangle with its edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Window {
    pub low: DVec2,
    pub high: DVec2,
}

impl Window {
    pub fn contains(&self, p: DVec2) -> bool {
        p.cmpge(self.low).all() && p.cmple(self.high).all()
    }

    /// The parts of an arc within, in order.
    pub fn arc(&self, arc: &Arc) -> Vec<Arc> {
        let mut parts: Vec<[f64; 2]> = Vec::new();
        self.halve(arc, [0.0, 1.0], HALVINGS, &mut parts);
        parts.into_iter().map(|[from, to]| part(arc, from, to)).collect()
    }

    /// Finds the stretches of the parameter within, by the boxes of control points.
    fn halve(&self, arc: &Arc, [from, to]: [f64; 2], left: u32, parts: &mut Vec<[f64; 2]>) {
        let low = arc.iter().fold(DVec2::INFINITY, |low, p| low.min(*p));
        let high = arc.iter().fold(DVec2::NEG_INFINITY, |high, p| high.max(*p));
        if high.cmplt(self.low).any() || low.cmpgt(self.high).any() {
            return;
        }
        if self.contains(low) && self.contains(high) {
            match parts.last_mut() {
                Some(last) if last[1] >= from => last[1] = to,
                _ => parts.push([from, to]),
            }
        } else if left > 0 {
            let middle = f64::midpoint(from, to);
            let [first, second] = halves(arc);
            self.halve(&first, [from, middle], left - 1, parts);
            self.halve(&second, [middle, to], left - 1, parts);
        }
    }

    /// The parts of a line within (Liang and Barsky 1984), each with at least two points.
    pub fn line(&self, points: &[DVec2]) -> Vec<Vec<DVec2>> {
        let mut parts: Vec<Vec<DVec2>> = Vec::new();
        for ends in points.windows(2) {
            let Some([from, to]) = self.stretch(ends[0], ends[1]) else { continue };
            match parts.last_mut() {
                Some(part) if part.last() == Some(&from) => part.push(to),
                _ => parts.push(vec![from, to]),
            }
        }
        parts
    }

    fn stretch(&self, a: DVec2, b: DVec2) -> Option<[DVec2; 2]> {
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (start, along, low, high) in
            [(a.x, b.x - a.x, self.low.x, self.high.x), (a.y, b.y - a.y, self.low.y, self.high.y)]
        {
            if along == 0.0 {
                if start < low || start > high {
                    return None;
                }
                continue;
            }
            let ends = [(low - start) / along, (high - start) / along];
            from = from.max(ends[0].min(ends[1]));
            to = to.min(ends[0].max(ends[1]));
        }
        let place = |t: f64| match t {
            0.0 => a,
            1.0 => b,
            _ => a.lerp(b, t).clamp(self.low, self.high),
        };
        (from < to).then(|| [place(from), place(to)])
    }

    /// The part of an area within (Sutherland and Hodgman 1974).
    pub fn area(&self, corners: &[DVec2]) -> Vec<DVec2> {
        let sides: [&dyn Fn(DVec2) -> f64; 4] =
            [&|p| p.x - self.low.x, &|p| self.high.x - p.x, &|p| p.y - self.low.y, &|p| self.high.y - p.y];
        let kept = sides.into_iter().fold(corners.to_vec(), |corners, inside| {
            let mut kept = Vec::with_capacity(corners.len() + 4);
            for (i, &to) in corners.iter().enumerate() {
                let from = corners[(i + corners.len() - 1) % corners.len()];
                let (a, b) = (inside(from), inside(to));
                if (a < 0.0) != (b < 0.0) {
                    kept.push(from.lerp(to, a / (a - b)));
                }
                if b >= 0.0 {
                    kept.push(to);
                }
            }
            kept
        });
        kept.into_iter().map(|p| p.clamp(self.low, self.high)).collect()
    }
}

/// Both halves of an arc (de Casteljau).
fn halves(arc: &Arc) -> [Arc; 2] {
    let [a, b, c, d] = *arc;
    let [ab, bc, cd] = [a.midpoint(b), b.midpoint(c), c.midpoint(d)];
    let [abc, bcd] = [ab.midpoint(bc), bc.midpoint(cd)];
    let middle = abc.midpoint(bcd);
    [[a, ab, abc, middle], [middle, bcd, cd, d]]
}

/// An arc between two values of its parameter, by its polar form.
fn part(arc: &Arc, from: f64, to: f64) -> Arc {
    if from <= 0.0 && to >= 1.0 {
        return *arc;
    }
    let [a, b, c, d] = *arc;
    let at = |s: f64, t: f64, u: f64| {
        let [ab, bc, cd] = [a.lerp(b, s), b.lerp(c, s), c.lerp(d, s)];
        ab.lerp(bc, t).lerp(bc.lerp(cd, t), u)
    };
    [at(from, from, from), at(from, from, to), at(from, to, to), at(to, to, to)]
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Window = Window { low: DVec2::new(-1.0, -2.0), high: DVec2::new(3.0, 2.0) };

    #[test]
    fn an_arc_is_cut_where_it_leaves() {
        // x = 10 t, y = 24 (t − 1/2)² − 3: in the window for y ≥ −2 (|t − 1/2| ≥ √(1/24)) and y ≤ 2, x ≤ 3.
        let arc =
            [DVec2::new(0.0, 3.0), DVec2::new(10.0 / 3.0, -5.0), DVec2::new(20.0 / 3.0, -5.0), DVec2::new(10.0, 3.0)];
        let parts = WINDOW.arc(&arc);
        assert_eq!(parts.len(), 1, "{parts:?}");
        let [start, .., end] = parts[0];
        let at = |t: f64| DVec2::new(10.0 * t, 24.0 * (t - 0.5).powi(2) - 3.0);
        let enters = at(0.5 - (5.0_f64 / 24.0).sqrt());
        let leaves = at(0.5 - (1.0_f64 / 24.0).sqrt());
        assert!(start.distance(enters) < 1e-3 && end.distance(leaves) < 1e-3, "{start} {enters} {end} {leaves}");
        assert!(parts[0].iter().all(|p| WINDOW.contains(*p)));
        assert_eq!(WINDOW.arc(&arc.map(|p| p + DVec2::X * 20.0)), Vec::<Arc>::new());
        let inside = arc.map(|p| p / 10.0);
        assert_eq!(WINDOW.arc(&inside), [inside]);
    }

    #[test]
    fn a_line_through_is_cut_twice_and_one_along_an_edge_stays() {
        let line = |points: &[[f64; 2]]| WINDOW.line(&points.iter().map(|p| DVec2::from(*p)).collect::<Vec<_>>());
        let through = line(&[[-5.0, 0.0], [0.0, 0.0], [5.0, 0.0]]);
        assert_eq!(through.len(), 1);
        let expected = [[-1.0, 0.0], [0.0, 0.0], [3.0, 0.0]].map(DVec2::from);
        assert!(through[0].iter().zip(expected).all(|(p, q)| p.distance(q) < 1e-12), "{through:?}");
        assert_eq!(line(&[[-1.0, -1.0], [-1.0, 1.0]]).len(), 1);
        assert_eq!(line(&[[0.0, 0.0], [0.0, 5.0], [1.0, 5.0], [1.0, 0.0]]).len(), 2);
        assert!(line(&[[-5.0, 0.0], [0.0, 9.0]]).is_empty());
    }

    #[test]
    fn an_area_round_the_window_becomes_the_window() {
        let corners = [[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]].map(DVec2::from);
        let mut kept = WINDOW.area(&corners);
        kept.sort_by(|a, b| (a.x, a.y).partial_cmp(&(b.x, b.y)).unwrap());
        assert_eq!(kept, [[-1.0, -2.0], [-1.0, 2.0], [3.0, -2.0], [3.0, 2.0]].map(DVec2::from));
        assert!(WINDOW.area(&corners.map(|p| p + DVec2::X * 20.0)).is_empty());
    }
}
