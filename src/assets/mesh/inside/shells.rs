//! Shells: the connected parts of a closed surface, each wound consistently.
//!
//! *Theory.* Two triangles at an edge belong to one shell. If more than two meet, the pairs that bound one wedge of the solid belong
//! together. A shell is orientable if its triangles can be wound so that each edge is traversed once in each direction; its signed volume
//! (the sum of a·(b × c)/6) is then above 0 if it is wound outward.
//!
//! *Practice.* The shells and the triangles with reversed winding are found together, by a union–find structure that stores the parity
//! between each triangle and its root. Copies of one triangle count once, and two copies of opposite winding cancel.

use foldhash::{HashMap, HashMapExt};
use glam::{DVec3, Vec3};

use super::super::Mesh;
use super::super::edges::{Edges, Side, directions, welded};

/// The shell of a triangle that bounds nothing.
pub(super) const NONE: u32 = u32::MAX;
/// A signed volume below this fraction of the absolute sum of its terms has no certain sign: positions are in 32 bits.
const LEAST_VOLUME: f64 = 1e-7;
/// A shell is flat if it is thinner than this fraction of its extent.
const LEAST_THICKNESS: f64 = 1e-7;

/// The shells of a mesh.
pub(super) struct Shells {
    /// The shell of each triangle, or [`NONE`].
    pub of: Vec<u32>,
    /// Whether each triangle is wound against the majority of its shell.
    pub turned: Vec<bool>,
    pub all: Vec<Shell>,
}

/// A connected part of the surface.
#[derive(Debug, Clone)]
pub(super) struct Shell {
    /// The signed volume, with the winding of the majority of its triangles.
    pub volume: f64,
    /// The corners of the bounding box.
    pub lo: Vec3,
    pub hi: Vec3,
    /// The index of one of its triangles.
    pub first: u32,
}

impl Shells {
    /// Finds the shells of a mesh; if it is not closed, or not orientable, the error contains the position.
    pub fn of(mesh: &Mesh) -> Result<Self, String> {
        let same = welded(mesh.vertices.iter().map(|vertex| vertex.position));
        let corners: Vec<_> =
            mesh.triangles.iter().map(|corners| corners.map(|corner| same[corner as usize])).collect();
        let all = (0..).zip(corners.iter().copied());
        let mut edges = Edges::of(&all, same.len());
        let mut counts = vec![true; corners.len()];
        if cancel(&edges, &corners, &mut counts) {
            edges = Edges::of(&all.filter(|(i, _)| counts[*i as usize]), same.len());
        }
        let mut groups = Groups::new(corners.len());
        let mut faults = [None, None];
        for (start, sides) in edges.iter() {
            let fault = match sides {
                [a, b] if groups.join(a, b) => continue,
                [_, _] => 0,
                [_] => 1,
                _ if directions(sides)[0] == directions(sides)[1] => {
                    let pairs = wedges(mesh, start, sides);
                    if pairs.into_iter().all(|[a, b]| groups.join(a, b)) {
                        continue;
                    }
                    0
                }
                _ => 1,
            };
            let first = sides.iter().map(|side| side.corner).min();
            faults[fault] = faults[fault].into_iter().chain(first).min();
        }
        let place = |corner: u32| mesh.middle(corner);
        match faults {
            [_, Some(corner)] => {
                let [x, y, z] = place(corner);
                Err(format!(
                    "the mesh is not closed: the edge at [{x:.4}, {y:.4}, {z:.4}] belongs to only one triangle"
                ))
            }
            [Some(corner), _] => {
                let [x, y, z] = place(corner);
                Err(format!("the mesh has only one side: at [{x:.4}, {y:.4}, {z:.4}] its winding cannot be consistent"))
            }
            _ => groups.shells(mesh, &counts),
        }
    }
}

/// Marks the triangles that do not count, because they are copies of others or cancel each other. Returns whether there are any.
fn cancel(edges: &Edges, corners: &[[u32; 3]], counts: &mut [bool]) -> bool {
    let mut by_corners: HashMap<[u32; 3], Vec<u32>> = HashMap::new();
    let crowded = edges.iter().filter(|(_, sides)| sides.len() > 2);
    let mut suspects: Vec<u32> = crowded.flat_map(|(_, sides)| sides).map(|side| side.corner / 3).collect();
    suspects.sort_unstable();
    suspects.dedup();
    for triangle in suspects {
        let mut key = corners[triangle as usize];
        key.sort_unstable();
        by_corners.entry(key).or_default().push(triangle);
    }
    let mut some = false;
    for copies in by_corners.values().filter(|copies| copies.len() > 1) {
        some = true;
        let ways = |i: &&u32| is_even(corners[**i as usize]);
        let even = copies.iter().filter(ways).count();
        let more = (2 * even).cmp(&copies.len());
        let kept = copies.iter().find(|i| match more {
            std::cmp::Ordering::Greater => ways(i),
            std::cmp::Ordering::Less => !ways(i),
            std::cmp::Ordering::Equal => false,
        });
        for i in copies {
            counts[*i as usize] = Some(i) == kept;
        }
    }
    some
}

/// Returns `true` if three numbers are in ascending order, up to a rotation.
fn is_even([a, b, c]: [u32; 3]) -> bool {
    [(a < b), (b < c), (c < a)].into_iter().filter(|rises| *rises).count() == 2
}

/// Returns the sides at an edge in pairs that bound a wedge of the solid: in a turn around the edge, a wedge begins at a triangle that
/// traverses the edge backward, and ends at one that traverses it forward.
fn wedges<'a>(mesh: &Mesh, start: u32, sides: &'a [Side]) -> Vec<[&'a Side; 2]> {
    let position = |vertex: u32| mesh.vertices[vertex as usize].position.as_dvec3();
    let origin = position(start);
    let axis = (position(sides[0].end) - origin).normalize_or_zero();
    let across = axis.any_orthonormal_vector();
    let angle = |side: &Side| {
        let third = mesh.triangles[side.triangle()][(side.corner as usize + 2) % 3];
        let away = position(third) - origin;
        away.dot(axis.cross(across)).atan2(away.dot(across))
    };
    let mut around: Vec<_> = sides.iter().map(|side| (angle(side), !side.along, side)).collect();
    // At equal angles a wedge ends before the next begins.
    around.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let (mut open, mut pairs) = (Vec::new(), Vec::new());
    // Wedges that began before the first angle end in the second turn.
    for (round, (.., side)) in [0, 1].into_iter().flat_map(|round| around.iter().map(move |one| (round, one))) {
        if !side.along && round == 0 {
            open.push(side);
        } else if side.along && !pairs.iter().any(|[_, known]: &[&Side; 2]| known.corner == side.corner) {
            pairs.extend(open.pop().map(|other| [*other, *side]));
        }
    }
    pairs
}

/// Sets of triangles, each with the parity of every member relative to the set's root.
struct Groups {
    parents: Vec<u32>,
    odd: Vec<bool>,
}

impl Groups {
    fn new(count: usize) -> Self {
        Self { parents: (0..count as u32).collect(), odd: vec![false; count] }
    }

    /// Returns the root of a triangle's set, and whether the triangle has the opposite winding.
    fn root(&mut self, triangle: u32) -> (u32, bool) {
        let (mut at, mut odd) = (triangle as usize, false);
        while self.parents[at] as usize != at {
            let parent = self.parents[at] as usize;
            // Path halving.
            self.odd[at] ^= self.odd[parent];
            self.parents[at] = self.parents[parent];
            odd ^= self.odd[at];
            at = self.parents[at] as usize;
        }
        (at as u32, odd)
    }

    /// Joins the sets of two triangles that share an edge. Returns `false` if their windings contradict each other.
    fn join(&mut self, a: &Side, b: &Side) -> bool {
        let ((first, first_odd), (second, second_odd)) = (self.root(a.corner / 3), self.root(b.corner / 3));
        let odd = first_odd ^ second_odd ^ (a.along == b.along);
        if first == second {
            return !odd;
        }
        let (low, high) = (first.min(second), first.max(second));
        self.parents[high as usize] = low;
        self.odd[high as usize] = odd;
        true
    }

    fn shells(mut self, mesh: &Mesh, counts: &[bool]) -> Result<Shells, String> {
        let count = counts.len();
        let (mut of, mut turned) = (vec![NONE; count], vec![false; count]);
        let mut sums: Vec<Sum> = Vec::new();
        for triangle in 0..count {
            if !counts[triangle] {
                continue;
            }
            let (root, odd) = self.root(triangle as u32);
            // A root has the lowest index of its set.
            if root as usize == triangle {
                of[triangle] = sums.len() as u32;
                sums.push(Sum::new(mesh, triangle));
            }
            of[triangle] = of[root as usize];
            turned[triangle] = odd;
            sums[of[triangle] as usize].add(mesh, triangle, odd);
        }
        let (mut all, mut numbers) = (Vec::new(), Vec::with_capacity(sums.len()));
        for sum in &sums {
            let shell = sum.shell()?;
            numbers.push(if shell.is_some() { all.len() as u32 } else { NONE });
            all.extend(shell);
        }
        for (shell, turned) in of.iter_mut().zip(&mut turned).filter(|(shell, _)| **shell != NONE) {
            *turned ^= sums[*shell as usize].is_mostly_odd();
            *shell = numbers[*shell as usize];
        }
        if all.is_empty() { Err("the mesh encloses no volume".to_owned()) } else { Ok(Shells { of, turned, all }) }
    }
}

/// The sums over a shell's triangles, wound as its root.
struct Sum {
    first: u32,
    origin: DVec3,
    six_volumes: f64,
    /// The sum of the terms' absolute values.
    terms: f64,
    two_areas: f64,
    lo: Vec3,
    hi: Vec3,
    triangles: usize,
    odd: usize,
}

impl Sum {
    fn new(mesh: &Mesh, first: usize) -> Self {
        let origin = mesh.vertices[mesh.triangles[first][0] as usize].position;
        Self {
            first: first as u32,
            origin: origin.as_dvec3(),
            six_volumes: 0.0,
            terms: 0.0,
            two_areas: 0.0,
            lo: origin,
            hi: origin,
            triangles: 0,
            odd: 0,
        }
    }

    fn add(&mut self, mesh: &Mesh, triangle: usize, odd: bool) {
        let corners = mesh.triangles[triangle].map(|corner| mesh.vertices[corner as usize].position);
        self.lo = corners.into_iter().fold(self.lo, Vec3::min);
        self.hi = corners.into_iter().fold(self.hi, Vec3::max);
        let [a, b, c] = corners.map(|corner| corner.as_dvec3() - self.origin);
        let term = a.dot(b.cross(c));
        self.six_volumes += if odd { -term } else { term };
        self.terms += term.abs();
        self.two_areas += (b - a).cross(c - a).length();
        self.triangles += 1;
        self.odd += usize::from(odd);
    }

    fn is_mostly_odd(&self) -> bool {
        2 * self.odd > self.triangles
    }

    /// Returns the shell, or `None` if it is flat.
    fn shell(&self) -> Result<Option<Shell>, String> {
        let extent = (self.hi - self.lo).as_dvec3().max_element();
        if self.terms <= LEAST_THICKNESS * extent * self.two_areas {
            return Ok(None);
        }
        if self.six_volumes.abs() <= LEAST_VOLUME * self.terms {
            let [x, y, z] = self.origin.to_array();
            return Err(format!(
                "the outside of the mesh is ambiguous: the part at [{x:.4}, {y:.4}, {z:.4}] encloses equal volumes on \
                 both sides"
            ));
        }
        let volume = if self.is_mostly_odd() { -self.six_volumes } else { self.six_volumes } / 6.0;
        Ok(Some(Shell { volume, lo: self.lo, hi: self.hi, first: self.first }))
    }
}
