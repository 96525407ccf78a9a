//! What a scene's surfaces do to rays: which of them reflect, transmit, scatter or show light.

use super::{Branches, FanRay, Gloss, Material, Object, Scene};

impl Scene {
    /// The material of an object, if it is opaque.
    #[must_use]
    pub fn material_of(&self, object: &Object) -> Option<&Material> {
        Some(&self.materials[object.material()?])
    }

    /// Does a ray continue from the surface of an object that is opaque?
    #[must_use]
    pub fn continues_from(&self, object: &Object) -> bool {
        self.material_of(object).is_some_and(|material| material.surface.facts().continues)
    }

    /// Does a ray end on the surface of an object, and go on behind it as well?
    #[must_use]
    pub fn shows_through(&self, object: &Object) -> bool {
        self.material_of(object).is_some_and(|material| material.surface.facts().opacity < 1.0)
    }

    /// Is there such a surface?
    #[must_use]
    pub fn has_translucent(&self) -> bool {
        self.objects.iter().any(|object| self.shows_through(object))
    }

    /// Can it be told of which crossing of a translucent surface light is? So where rays branch nowhere else, and not at random.
    #[must_use]
    pub fn has_orders(&self) -> bool {
        let counts = matches!(self.rays.branches, Branches::Enumerated(_)) && self.image.adaptive.is_none();
        self.has_translucent() && counts && !self.splits() && self.fans().is_empty()
    }

    /// Are pictures and patterns averaged over what a pixel sees of them, and is there anything to average?
    #[must_use]
    pub fn has_footprints(&self) -> bool {
        let varies = |material: &Material| material.color.is_averaged();
        self.image.footprints && (!self.pictures.is_empty() || self.used_materials().any(varies))
    }

    /// The materials of its objects, each as often as it is used.
    pub fn used_materials(&self) -> impl Iterator<Item = &Material> {
        self.objects.iter().filter_map(|object| self.material_of(object))
    }

    /// Does a ray continue from some surface?
    #[must_use]
    pub fn scatters(&self) -> bool {
        let goes_on = |object: &Object| self.continues_from(object) || self.shows_through(object);
        self.rays.paths.is_some() || self.splits() || self.objects.iter().any(goes_on)
    }

    /// What surfaces send rays on in several directions by a law of the user's own, by their materials' places.
    #[must_use]
    pub fn fans(&self) -> Vec<(usize, &[FanRay])> {
        let used = |i: usize| self.objects.iter().any(|object| object.material() == Some(i));
        let all = self.materials.iter().enumerate().filter(|(i, _)| used(*i));
        all.filter_map(|(i, material)| Some((i, material.surface.facts().fan?))).collect()
    }

    /// Is there a surface from which a ray goes on in more than one way?
    #[must_use]
    pub fn branches(&self) -> bool {
        self.splits() || self.has_translucent() || self.fans().iter().any(|(_, rays)| rays.len() > 1)
    }

    /// Is there a surface from which a ray goes on in a direction that is drawn from a lobe?
    #[must_use]
    pub fn has_lobes(&self) -> bool {
        self.used_materials().any(|material| material.surface.facts().has_lobe) || self.has_rough_glass()
    }

    /// How rough its clear objects are.
    pub fn glosses(&self) -> impl Iterator<Item = Gloss> {
        self.objects.iter().filter_map(|object| Some(object.interior()?.gloss))
    }

    /// Is there a clear object with a rough surface?
    #[must_use]
    pub fn has_rough_glass(&self) -> bool {
        self.glosses().any(|gloss| gloss != Gloss::Smooth)
    }

    /// Is there a surface that both reflects and transmits?
    #[must_use]
    pub fn splits(&self) -> bool {
        self.objects.iter().any(|object| object.interior().is_some())
    }

    /// Is there a surface that shows a light?
    #[must_use]
    pub fn is_lit(&self) -> bool {
        let lit = |object: &Object| self.material_of(object).is_some_and(|material| material.surface.facts().is_lit);
        !self.lights.is_empty() && self.objects.iter().any(lit)
    }
}
