//! Properties of a scene's surfaces: which of them reflect, transmit, scatter or show light.

use super::{FanRay, Gloss, Material, Object, Scene, Splitting};

impl Scene {
    /// Returns the material of an object, if it is opaque.
    #[must_use]
    pub fn material_of(&self, object: &Object) -> Option<&Material> {
        Some(&self.materials[object.material()?])
    }

    /// Returns `true` if a ray continues from the surface of an opaque object.
    #[must_use]
    pub fn continues_from(&self, object: &Object) -> bool {
        self.material_of(object).is_some_and(|material| material.surface.facts().continues)
    }

    /// Returns `true` if a ray both ends on the surface of an object and continues behind it.
    #[must_use]
    pub fn shows_through(&self, object: &Object) -> bool {
        self.material_of(object).is_some_and(|material| material.surface.facts().opacity < 1.0)
    }

    /// Returns `true` if there is a surface that ends rays and continues them.
    #[must_use]
    pub fn has_translucent(&self) -> bool {
        self.objects.iter().any(|object| self.shows_through(object))
    }

    /// Returns `true` if crossings of a translucent surface can be attributed to orders: rays must not branch elsewhere or at random.
    #[must_use]
    pub fn has_orders(&self) -> bool {
        let counts = matches!(self.rays.max_splits, Splitting::Enumerated(_)) && self.image.adaptive.is_none();
        self.has_translucent() && counts && !self.splits() && self.fans().is_empty()
    }

    /// Returns `true` if the first ray of each pixel crosses all translucent surfaces on its path: it is not chosen at random.
    #[must_use]
    pub fn has_crossings(&self) -> bool {
        let draws = self.rays.max_splits == Splitting::Random && self.scatters();
        !self.objects.is_empty() && !draws && self.rays.path_tracing.is_none() && self.image.adaptive.is_none()
    }

    /// Returns `true` if some sky has stars.
    #[must_use]
    pub fn has_stars(&self) -> bool {
        self.stars.iter().any(Option::is_some)
    }

    /// Returns `true` if pixel footprints average textures or patterns, and there is something to average.
    #[must_use]
    pub fn has_footprints(&self) -> bool {
        self.image.footprints && (!self.pictures.is_empty() || self.filters_surfaces())
    }

    /// Returns `true` if pixel footprints average textures or patterns of surfaces.
    #[must_use]
    pub fn filters_surfaces(&self) -> bool {
        self.image.footprints && self.used_materials().any(|material| material.color.is_averaged())
    }

    /// Returns the materials of its objects, repeated for each use.
    pub fn used_materials(&self) -> impl Iterator<Item = &Material> {
        self.objects.iter().filter_map(|object| self.material_of(object))
    }

    /// Returns `true` if a ray continues from some surface.
    #[must_use]
    pub fn scatters(&self) -> bool {
        let goes_on = |object: &Object| self.continues_from(object) || self.shows_through(object);
        self.rays.path_tracing.is_some() || self.splits() || self.objects.iter().any(goes_on)
    }

    /// Returns the surfaces that split rays into user-defined directions, with the indices of their materials.
    #[must_use]
    pub fn fans(&self) -> Vec<(usize, &[FanRay])> {
        let used = |i: usize| self.objects.iter().any(|object| object.material() == Some(i));
        let all = self.materials.iter().enumerate().filter(|(i, _)| used(*i));
        all.filter_map(|(i, material)| Some((i, material.surface.facts().fan?))).collect()
    }

    /// Returns `true` if there is a surface from which a ray continues in several ways.
    #[must_use]
    pub fn branches(&self) -> bool {
        self.splits() || self.has_translucent() || self.fans().iter().any(|(_, rays)| rays.len() > 1)
    }

    /// Returns `true` if there is a surface from which a ray continues in a direction sampled from a lobe.
    #[must_use]
    pub fn has_lobes(&self) -> bool {
        self.used_materials().any(|material| material.surface.facts().has_lobe) || self.has_rough_glass()
    }

    /// Returns the roughness of its transparent objects.
    pub fn glosses(&self) -> impl Iterator<Item = Gloss> {
        self.objects.iter().filter_map(|object| Some(object.interior()?.gloss))
    }

    /// Returns `true` if there is a transparent object with a rough surface.
    #[must_use]
    pub fn has_rough_glass(&self) -> bool {
        self.glosses().any(|gloss| gloss != Gloss::Smooth)
    }

    /// Returns `true` if there is a surface that both reflects and transmits.
    #[must_use]
    pub fn splits(&self) -> bool {
        self.objects.iter().any(|object| object.interior().is_some())
    }

    /// Returns `true` if there is a surface that shows a light.
    #[must_use]
    pub fn is_lit(&self) -> bool {
        let lit = |object: &Object| self.material_of(object).is_some_and(|material| material.surface.facts().is_lit);
        !self.lights.is_empty() && self.objects.iter().any(lit)
    }
}
