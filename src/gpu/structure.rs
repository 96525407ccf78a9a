//! Builds the acceleration structure that segments search, over the items of a scene.
//!
//! *Practice.* The grid has about two cells per item, in the proportions of the scene's box (Cleary and Wyvill 1988). It has fewer if the
//! items are so large that they would overlap many cells.

use std::collections::BTreeMap;

use glam::{DVec3, Vec3};

use super::hierarchy::{Item, Node, hierarchy};
use super::ray_tree;
use crate::program::{Extent, PARTS, Search, constant};

/// A grid of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// The lower corner.
    pub lo: DVec3,
    /// The upper corner.
    pub hi: DVec3,
    /// The size of a cell.
    pub cell: DVec3,
    /// The number of cells along each axis.
    pub count: [u32; 3],
    /// The index of each cell's first item, and finally the number of entries.
    pub cells: Vec<u32>,
}

/// An acceleration structure over items.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct AccelStructure {
    /// The primitives of the items, in the order in which the structure refers to them.
    pub items: Vec<u32>,
    /// The nodes, if it is a hierarchy.
    pub nodes: Vec<Node>,
    /// The grid, if it is one.
    pub grid: Option<Grid>,
    /// The index in `over` of each item, in the order of a hierarchy's leaves.
    pub order: Vec<u32>,
    /// The items that it was built over.
    over: Vec<Item>,
    /// The top nodes, which contain all items: a hierarchy opened down to `PARTS` nodes.
    top: Vec<Node>,
}

impl AccelStructure {
    /// Builds a structure over items, whose primitives are renumbered kind by kind in the order of a hierarchy's leaves, whatever the
    /// search: neighbors in space are neighbors in memory, and all structures choose the same one of two coincident hits. No leaf has more
    /// than `leaf` items. `before` is reused if it was built over the same items, as between frames in which nothing moves.
    #[must_use]
    pub fn new(over: Vec<Item>, search: Search, leaf: u32, before: Option<Self>) -> Self {
        if over.is_empty() {
            return Self::default();
        }
        if let Some(same) = before.filter(|before| before.search() == search && before.over == over) {
            return same;
        }
        let (nodes, order) = hierarchy(&over, leaf);
        let top = opened(&nodes, PARTS);
        let mut ordered: Vec<Item> = order.iter().map(|&i| over[i as usize]).collect();
        let mask = constant("segment/ray", "PRIMITIVE_INDEX") as u32;
        let mut next = BTreeMap::<u32, u32>::new();
        for item in &mut ordered {
            let kind = item.primitive & !mask;
            let index = next.entry(kind).or_default();
            item.primitive = kind | *index;
            *index += 1;
        }
        let built = match search {
            Search::Grid => grid(&ordered),
            Search::Hierarchy => Self { items: primitives(&ordered), nodes, ..Self::default() },
            Search::List => Self { items: primitives(&ordered), ..Self::default() },
        };
        Self { order, over, top, ..built }
    }

    /// Returns the search that it supports.
    #[must_use]
    pub fn search(&self) -> Search {
        match &self.grid {
            Some(_) => Search::Grid,
            None if self.nodes.is_empty() => Search::List,
            None => Search::Hierarchy,
        }
    }

    /// Returns boxes that together enclose all items closely.
    #[must_use]
    pub fn coarse(&self) -> Vec<(Vec3, Vec3)> {
        ray_tree::coarse(&self.over, &self.nodes)
    }

    /// Returns `PARTS` boxes that together contain all items; boxes are repeated if there are fewer.
    pub fn parts(&self) -> impl Iterator<Item = [DVec3; 2]> {
        self.top
            .iter()
            .cycle()
            .take(if self.top.is_empty() { 0 } else { PARTS })
            .map(|n| [n.lo.as_dvec3(), n.hi.as_dvec3()])
    }

    /// Returns the earlier indices of the items with the kind `code`, in their present order.
    pub fn moved(&self, code: u32) -> impl Iterator<Item = usize> {
        let mask = constant("segment/ray", "PRIMITIVE_INDEX") as u32;
        let own = self.order.iter().map(|&i| self.over[i as usize].primitive);
        own.filter(move |own| own & !mask == code).map(move |own| (own & mask) as usize)
    }

    /// Returns the nodes that follow the leaves with an item of the kind `code`, in the present order of the items, if each leaf has one
    /// item.
    pub fn behind(&self, code: u32) -> impl Iterator<Item = u32> {
        let mask = constant("segment/ray", "PRIMITIVE_INDEX") as u32;
        let held = self.nodes.iter().filter_map(|node| Some((node.items()?.0, node.skip)));
        held.filter(move |(item, _)| self.items[*item as usize] & !mask == code).map(|(_, skip)| skip)
    }

    /// Returns the limit of a search. In a hierarchy it counts all nodes that equally many items could need, so that frames agree; in a
    /// grid, the cells along one path and every cell of each item.
    #[must_use]
    pub fn extent(&self) -> Extent {
        let items = self.items.len() as u64;
        let places = match (self.search(), &self.grid) {
            (_, Some(grid)) => grid.count.iter().map(|&n| u64::from(n)).sum(),
            (Search::Hierarchy, _) => 2 * items,
            _ => items,
        };
        Extent { places, items }
    }
}

/// Returns the top `count` nodes of a hierarchy, opening the largest one first.
fn opened(nodes: &[Node], count: usize) -> Vec<Node> {
    let mut open: Vec<usize> = (!nodes.is_empty()).then_some(0).into_iter().collect();
    let size = |i: usize| nodes[i].lo.distance(nodes[i].hi);
    while open.len() < count {
        let inner = (0..open.len()).filter(|&at| nodes[open[at]].leaf == 0);
        let Some(largest) = inner.max_by(|&a, &b| size(open[a]).total_cmp(&size(open[b]))) else { break };
        let first = open[largest] + 1;
        open[largest] = first;
        open.push(nodes[first].skip as usize);
    }
    open.into_iter().map(|i| nodes[i]).collect()
}

fn primitives(items: &[Item]) -> Vec<u32> {
    items.iter().map(|item| item.primitive).collect()
}

/// The approximate number of cells per item.
const DENSITY: f64 = 2.0;
/// The maximum number of entries in cells per item.
const ENTRIES: usize = 32;
/// The maximum number of cells along an axis.
const FINEST: f64 = 512.0;

fn grid(items: &[Item]) -> AccelStructure {
    let (lo, hi) = items.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |all, i| (all.0.min(i.lo), all.1.max(i.hi)));
    let (lo, hi) = (lo.as_dvec3(), hi.as_dvec3());
    // Give a flat scene some thickness, and keep items in the outermost faces inside.
    let margin = 1e-4 * (hi - lo).max_element().max(lo.abs().max(hi.abs()).max_element() * 1e-2).max(1e-30);
    let (lo, hi) = (lo - margin, hi + margin);
    let mut finest = (DENSITY * items.len() as f64 / (hi - lo).element_product()).cbrt();
    loop {
        let count = ((hi - lo) * finest).round().clamp(DVec3::ONE, DVec3::splat(FINEST));
        let cell = (hi - lo) / count;
        let grid = Grid { lo, hi, cell, count: count.as_uvec3().to_array(), cells: Vec::new() };
        if let Some(built) = filled(grid, items) {
            return built;
        }
        finest /= 2.0;
    }
}

/// Puts every item into the cells that its box overlaps, or returns `None` if there are too many entries.
fn filled(mut grid: Grid, items: &[Item]) -> Option<AccelStructure> {
    let [nx, ny, nz] = grid.count;
    let last = DVec3::new(f64::from(nx - 1), f64::from(ny - 1), f64::from(nz - 1));
    // An item that rounding may move into a neighboring cell is put into both.
    let place = |x: DVec3, off: f64| ((x - grid.lo) / grid.cell + off).floor().clamp(DVec3::ZERO, last).as_uvec3();
    let range = |item: &Item| {
        let off = 1e-3 + (4e-6 * item.lo.abs().max(item.hi.abs()).as_dvec3() / grid.cell).max_element();
        (place(item.lo.as_dvec3(), -off), place(item.hi.as_dvec3(), off))
    };
    let overlapped = |item: &Item| {
        let (from, to) = range(item);
        (from.z..=to.z).flat_map(move |z| {
            (from.y..=to.y).flat_map(move |y| (from.x..=to.x).map(move |x| (x + nx * (y + ny * z)) as usize))
        })
    };
    let entries = |item: &Item| {
        let (from, to) = range(item);
        (to - from + 1).as_u64vec3().element_product()
    };
    let all: u64 = items.iter().map(entries).sum();
    if all > (ENTRIES * items.len()) as u64 && grid.count != [1; 3] {
        return None;
    }
    let mut cells = vec![0_u32; (nx * ny * nz) as usize + 1];
    for cell in items.iter().flat_map(overlapped) {
        cells[cell + 1] += 1;
    }
    for i in 1..cells.len() {
        cells[i] += cells[i - 1];
    }
    let mut next = cells.clone();
    let mut filled = vec![0; all as usize];
    for item in items {
        for cell in overlapped(item) {
            filled[next[cell] as usize] = item.primitive;
            next[cell] += 1;
        }
    }
    grid.cells = cells;
    Some(AccelStructure { items: filled, grid: Some(grid), ..AccelStructure::default() })
}
