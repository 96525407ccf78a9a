//! The nesting of a mesh's shells: solids, cavities in them, and overlapping solids.
//!
//! *Theory.* A shell that is inside another and touches none is a cavity if an odd number of shells surrounds it, and a solid in a
//! cavity otherwise. Shells in contact are all solids, like two objects that overlap, except shells inside a solid that are wound
//! against it. Overlapping solids are in different layers: within a layer every point is in one solid at most.
//!
//! *Practice.* Layers are colors of a graph whose edges are overlaps, assigned in the order of volume; few meshes need more than three.

use std::collections::VecDeque;
use std::collections::hash_map::Entry;
use std::iter::successors;

use foldhash::{HashMap, HashMapExt, HashSet};
use glam::Vec3;

use super::super::Mesh;
use super::meet::{Contact, contact};
use super::shells::{NONE, Shells};
use super::tree::Tree;

/// The distance at which surfaces touch, as a fraction of the mesh's size, or of its distance from the origin.
const TOUCHES: f64 = 1e-6;

/// The nesting of all shells.
pub(super) struct Nesting {
    /// Whether each shell is a cavity.
    pub cavity: Vec<bool>,
    /// The layer of each shell.
    pub layer: Vec<u32>,
}

/// Determines for each shell of a mesh whether it is a cavity, and its layer.
pub(super) fn nesting(mesh: &Mesh, shells: &Shells) -> Result<Nesting, String> {
    let count = shells.all.len();
    if count == 1 {
        return Ok(Nesting { cavity: vec![false], layer: vec![0] });
    }
    let tree = Tree::new(mesh, shells);
    let far =
        shells.all.iter().flat_map(|shell| [shell.lo, shell.hi]).map(|x| x.abs().max_element()).fold(0.0, f32::max);
    let tolerance = TOUCHES * f64::from(far);
    let contacts = contacts(&tree, tolerance);
    let containers = containers(mesh, shells, &tree, &contacts, tolerance);
    let family = Family::new(shells, &contacts, containers);
    if let Some(shell) = family.overlapping_cavities(&contacts) {
        let [x, y, z] = shells.all[shell as usize].lo.to_array();
        return Err(format!("two cavities of the mesh overlap, one of them at [{x:.4}, {y:.4}, {z:.4}]"));
    }
    let layer = family.layers(&contacts);
    Ok(Nesting { cavity: family.cavity, layer })
}

/// The contacts of shells; each pair has the lower index first.
type Contacts = HashMap<[u32; 2], Contact>;

fn contacts(tree: &Tree, tolerance: f64) -> Contacts {
    let mut contacts = Contacts::new();
    tree.pairs(tolerance as f32, |[t, u], [a, b]| {
        let known = contacts.entry([a.min(b), a.max(b)]);
        if let Entry::Occupied(known) = &known
            && *known.get() == Contact::Cross
        {
            return;
        }
        if let Some(found) = contact(tree.triangle(t), tree.triangle(u), tolerance) {
            known.and_modify(|before| *before = found.max(*before)).or_insert(found);
        }
    });
    contacts
}

/// Returns for each shell the shells around it. A shell that touches another is inside it if none of its vertices is outside.
fn containers(mesh: &Mesh, shells: &Shells, tree: &Tree, contacts: &Contacts, tolerance: f64) -> Vec<Vec<u32>> {
    let met = |a: u32, b: u32| contacts.get(&[a.min(b), a.max(b)]).copied();
    let around = |shell: u32, point: Vec3| {
        let mut windings: HashMap<u32, i32> = HashMap::new();
        tree.crossings(point.as_dvec3(), shell, |other, winding| *windings.entry(other).or_default() += winding);
        windings.retain(|_, winding| *winding != 0);
        windings
    };
    let mut found: Vec<Vec<u32>> = (0..)
        .zip(&shells.all)
        .map(|(i, shell)| {
            let start = mesh.vertices[mesh.triangles[shell.first as usize][0] as usize].position;
            around(i, start).into_keys().filter(|other| met(i, *other).is_none()).collect()
        })
        .collect();
    let touching =
        contacts.iter().filter(|(_, contact)| **contact == Contact::Touch).flat_map(|([a, b], _)| [[*a, *b], [*b, *a]]);
    let within = |[a, b]: &[u32; 2]| {
        let (a, b) = (&shells.all[*a as usize], &shells.all[*b as usize]);
        let slack = Vec3::splat(tolerance as f32);
        a.volume.abs() < b.volume.abs() && a.lo.cmpge(b.lo - slack).all() && a.hi.cmple(b.hi + slack).all()
    };
    let touching: Vec<_> = touching.filter(within).collect();
    let corners = if touching.is_empty() { Vec::new() } else { corners_of(mesh, shells) };
    for [inner, outer] in touching {
        let lies_on = |point: Vec3| {
            let mut lies = false;
            tree.near(point.as_dvec3(), tolerance, |triangle, shell| {
                let is_near = || contact([point.as_dvec3(); 3], tree.triangle(triangle), tolerance).is_some();
                lies |= shell == outer && is_near();
            });
            lies
        };
        let mut decided = corners[inner as usize]
            .iter()
            .filter(|point| !lies_on(**point))
            .map(|point| around(inner, *point).contains_key(&outer))
            .peekable();
        if decided.peek().is_some() && decided.all(|is_inside| is_inside) {
            found[inner as usize].push(outer);
        }
    }
    found
}

/// Returns the positions of each shell's vertices.
fn corners_of(mesh: &Mesh, shells: &Shells) -> Vec<Vec<Vec3>> {
    let mut all = vec![Vec::new(); shells.all.len()];
    let mut is_new = vec![true; mesh.vertices.len()];
    for (corners, shell) in mesh.triangles.iter().zip(&shells.of).filter(|(_, shell)| **shell != NONE) {
        for corner in corners {
            if std::mem::take(&mut is_new[*corner as usize]) {
                all[*shell as usize].push(mesh.vertices[*corner as usize].position);
            }
        }
    }
    all
}

/// The shells ordered by nesting.
struct Family {
    containers: Vec<Vec<u32>>,
    /// The smallest shell around each shell.
    parent: Vec<Option<u32>>,
    cavity: Vec<bool>,
    /// The solid that each shell bounds: its own index or, for a cavity, the index of the solid around it.
    solid: Vec<u32>,
    /// The shells by volume, the largest first.
    order: Vec<u32>,
}

impl Family {
    fn new(shells: &Shells, contacts: &Contacts, mut containers: Vec<Vec<u32>>) -> Self {
        let count = shells.all.len();
        let volume = |i: u32| shells.all[i as usize].volume;
        let mut order: Vec<u32> = (0..count as u32).collect();
        order.sort_by(|a, b| volume(*b).abs().total_cmp(&volume(*a).abs()));
        let mut meets = vec![false; count];
        contacts.keys().flatten().for_each(|shell| meets[*shell as usize] = true);
        let (mut parent, mut cavity, mut solid) = (vec![None; count], vec![false; count], vec![0; count]);
        for shell in &order {
            let at = *shell as usize;
            containers[at].retain(|other| volume(*other).abs() > volume(*shell).abs());
            parent[at] = containers[at].iter().copied().min_by(|a, b| volume(*a).abs().total_cmp(&volume(*b).abs()));
            let is_cavity = |outer: u32| {
                let is_against = (volume(*shell) < 0.0) != (volume(outer) < 0.0);
                !cavity[outer as usize] && (!meets[at] || is_against)
            };
            let outer = parent[at].filter(|outer| is_cavity(*outer));
            cavity[at] = outer.is_some();
            solid[at] = outer.map_or(*shell, |outer| solid[outer as usize]);
        }
        Self { containers, parent, cavity, solid, order }
    }

    /// Returns a cavity that overlaps another of the same solid, if there is one.
    fn overlapping_cavities(&self, contacts: &Contacts) -> Option<u32> {
        let overlap = |([a, b], contact): &(&[u32; 2], &Contact)| {
            let [a, b] = [*a as usize, *b as usize];
            **contact == Contact::Cross && self.cavity[a] && self.cavity[b] && self.solid[a] == self.solid[b]
        };
        contacts.iter().filter(overlap).map(|([a, _], _)| *a).min()
    }

    /// Returns the shells around a solid that is in their cavities, and thus outside the solids that they bound.
    fn with_cavity_around(&self, inner: u32) -> HashSet<u32> {
        let outward = successors(Some(inner), |at| self.parent[*at as usize]);
        outward.filter(|at| self.cavity[*at as usize]).filter_map(|at| self.parent[at as usize]).collect()
    }

    /// Returns the layer of each shell.
    fn layers(&self, contacts: &Contacts) -> Vec<u32> {
        let mut overlaps: Vec<Vec<u32>> = vec![Vec::new(); self.order.len()];
        let mut add = |a: u32, b: u32| {
            if a != b {
                overlaps[a as usize].push(b);
                overlaps[b as usize].push(a);
            }
        };
        for [a, b] in contacts.keys() {
            add(self.solid[*a as usize], self.solid[*b as usize]);
        }
        for shell in self.order.iter().copied().filter(|shell| !self.cavity[*shell as usize]) {
            let outside_of = self.with_cavity_around(shell);
            let solids = self.containers[shell as usize].iter().filter(|outer| !self.cavity[**outer as usize]);
            solids.filter(|outer| !outside_of.contains(outer)).for_each(|outer| add(shell, *outer));
        }
        // Breadth first from the largest shell, so that two layers are found if two suffice.
        let mut layer = vec![None; self.order.len()];
        let mut waiting = VecDeque::new();
        for start in self.order.iter().copied().filter(|shell| !self.cavity[*shell as usize]) {
            waiting.push_back(start);
            while let Some(shell) = waiting.pop_front() {
                let others = &overlaps[shell as usize];
                if layer[shell as usize].is_none() {
                    let taken: HashSet<u32> = others.iter().filter_map(|other| layer[*other as usize]).collect();
                    layer[shell as usize] = (0..=others.len() as u32).find(|own| !taken.contains(own));
                    waiting.extend(others.iter().filter(|other| layer[**other as usize].is_none()));
                }
            }
        }
        self.solid.iter().map(|solid| layer[*solid as usize].unwrap_or(0)).collect()
    }
}
