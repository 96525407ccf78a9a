//! The interior of a closed mesh: its faces are wound outward, and overlapping parts are separated.
//!
//! *Theory.* The interior depends on the surface, not on its winding in a file. Each shell bounds a solid or a cavity in one, depending
//! on its nesting; solids are then wound outward, and cavities inward. A ray stores for each mesh only whether it is inside, so
//! overlapping solids become separate meshes, as if they were several objects.
//!
//! *Practice.* The interior is computed when it is first needed: opaque
//! meshes cost nothing. A mesh of one shell takes one pass over its edges.

mod meet;
mod nesting;
mod shells;
mod tree;

use std::sync::{Arc, OnceLock};

use super::{Mesh, Vertex};
use nesting::nesting;
use shells::{NONE, Shells};

/// The cached interior of a mesh. It is ignored when meshes are compared, and copies start without it, because they may be changed.
#[derive(Debug, Default)]
pub(super) struct Inside(OnceLock<Interior>);

impl Clone for Inside {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for Inside {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// The interior of a mesh.
#[derive(Debug)]
struct Interior {
    /// Meshes in which no point is inside more than once, wound outward; empty if the mesh is already such a mesh.
    solids: Result<Vec<Arc<Mesh>>, String>,
    /// The difference from the mesh that it was made from, as a message.
    remark: Option<String>,
}

impl Mesh {
    /// Returns the reason why light cannot be inside the mesh, if any: it is open, or its outside cannot be determined.
    #[must_use]
    pub fn opening(&self) -> Option<&str> {
        self.found().solids.as_ref().err().map(String::as_str)
    }

    /// Returns the meshes that together enclose the same volume, each wound outward and without overlaps; empty if this mesh is closed
    /// and already such a mesh, or not closed.
    #[must_use]
    pub fn solids(&self) -> &[Arc<Self>] {
        self.found().solids.as_ref().map_or(&[], Vec::as_slice)
    }

    /// Returns the difference from the mesh that [`solids`](Self::solids) made it from, if it is the first of them.
    #[must_use]
    pub fn remark(&self) -> Option<&str> {
        self.inside.0.get()?.remark.as_deref()
    }

    fn found(&self) -> &Interior {
        self.inside.0.get_or_init(|| Interior { solids: solids(self), remark: None })
    }
}

/// Splits a mesh into its solids.
fn solids(mesh: &Mesh) -> Result<Vec<Arc<Mesh>>, String> {
    let shells = Shells::of(mesh)?;
    let nesting = nesting(mesh, &shells)?;
    let turns = |shell: usize| (shells.all[shell].volume > 0.0) == nesting.cavity[shell];
    let is_turned = |i: usize| shells.of[i] != NONE && shells.turned[i] ^ turns(shells.of[i] as usize);
    let count = mesh.triangles.len();
    let turned = (0..count).filter(|i| is_turned(*i)).count();
    let layers = nesting.layer.iter().max().map_or(0, |last| last + 1);
    if turned == 0 && layers == 1 && !shells.of.contains(&NONE) {
        return Ok(Vec::new());
    }
    let mut remark = remark(turned, count, layers);
    let layer = |layer: u32| {
        let is_in = |i: &usize| shells.of[*i] != NONE && nesting.layer[shells.of[*i] as usize] == layer;
        let part = mesh.part((0..count).filter(is_in).map(|i| (i, is_turned(i))));
        part.inside.0.get_or_init(|| Interior { solids: Ok(Vec::new()), remark: remark.take() });
        Arc::new(part)
    };
    Ok((0..layers).map(layer).collect())
}

/// Returns a message about a mesh whose solids differ from it.
fn remark(turned: usize, count: usize, layers: u32) -> Option<String> {
    let turned =
        (turned > 0).then(|| format!("{turned} of its {count} triangles have inward winding and are reversed"));
    let layers = (layers > 1).then(|| format!("its parts overlap and are treated as {layers} objects"));
    turned.into_iter().chain(layers).reduce(|a, b| format!("{a}; {b}"))
}

impl Mesh {
    /// Returns a mesh of some of the triangles, each given with whether its winding
    /// is reversed. Normals that would then be on the back are reversed too.
    fn part(&self, triangles: impl Iterator<Item = (usize, bool)>) -> Self {
        let (mut vertices, mut colors): (Vec<Vertex>, _) = (Vec::new(), Vec::new());
        // The new index of each vertex, as it is and with its normal reversed.
        let mut numbers = vec![[u32::MAX; 2]; self.vertices.len()];
        let mut own = Vec::new();
        for (i, is_turned) in triangles {
            let [first, second, third] = self.triangles[i];
            let corners = if is_turned { [first, third, second] } else { [first, second, third] };
            let [p, q, r] = corners.map(|corner| self.vertices[corner as usize].position);
            let across = (q - p).cross(r - p);
            own.push(corners.map(|corner| {
                let vertex = self.vertices[corner as usize];
                let is_behind = is_turned && vertex.normal.dot(across) < 0.0;
                let number = &mut numbers[corner as usize][usize::from(is_behind)];
                if *number == u32::MAX {
                    *number = vertices.len() as u32;
                    vertices.push(if is_behind { Vertex { normal: -vertex.normal, ..vertex } } else { vertex });
                    colors.extend(self.colors.get(corner as usize));
                }
                *number
            }));
        }
        Self { origin: self.origin, colors, color_flaw: self.color_flaw.clone(), ..Self::new(vertices, own) }
    }
}
