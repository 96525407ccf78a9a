//! The emissive surfaces that next-event estimation samples.

use glam::DVec3;

use super::Scene;

/// The bounding sphere of an emissive surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Emitter {
    /// The index of the object.
    pub object: usize,
    /// The center.
    pub center: DVec3,
    /// The radius.
    pub radius: f64,
    /// The area of its disk times the mean radiance.
    pub power: f64,
}

/// The largest number of sampled emitters, because each adds a few operations to every vertex.
const MOST: usize = 64;

impl Scene {
    /// Returns the sampled emitters in the order of the file, limited to the 64 brightest. Paths hit other emitters by chance.
    #[must_use]
    pub fn emitters(&self) -> Vec<Emitter> {
        if !self.rays.path_tracing.is_some_and(|paths| paths.light_sampling) {
            return Vec::new();
        }
        let emitter = |(i, object): (usize, &super::Object)| {
            let material = self.material_of(object)?;
            let mesh = object.shape.mesh().filter(|_| material.color.has_vertex_colors());
            let vertex_color = mesh.map_or(DVec3::ONE, |mesh| mesh.mean_color());
            let radiance = material.surface.emission(vertex_color * material.color.mean(&self.pictures));
            let mean = radiance.element_sum() / 3.0;
            let (center, radius) = object.ball();
            let power = mean * std::f64::consts::PI * radius * radius;
            (material.surface.facts().is_aimed_at && mean > 0.0).then_some(Emitter { object: i, center, radius, power })
        };
        let mut all: Vec<Emitter> = self.objects.iter().enumerate().filter_map(emitter).collect();
        all.sort_by(|a, b| b.power.total_cmp(&a.power));
        all.truncate(MOST);
        all.sort_by_key(|emitter| emitter.object);
        all
    }
}
