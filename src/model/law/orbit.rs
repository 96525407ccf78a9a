//! Global properties of a law's paths: orbits around one center, and throats that lead to another region.

use glam::DVec3;

use super::CharacteristicSurface;

/// The orbit around a law's only center.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orbit {
    /// The center.
    pub center: DVec3,
    /// The variables of a position on the orbit in addition to r.
    pub form: OrbitForm,
    /// Is `true` if the force falls off as an inverse power, so that the asymptote of an orbit has a closed form.
    pub is_free_far_away: bool,
}

/// The variables of an orbit in addition to r.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OrbitForm {
    /// An angle in the ray's plane through the center, with the WGSL module of the force.
    Plane(&'static str),
    /// Angles around the axis of a rotating black hole.
    Separated,
}

impl Orbit {
    /// Returns the WGSL modules of its steps.
    #[must_use]
    pub fn parts(&self) -> Vec<&'static str> {
        match self.form {
            OrbitForm::Plane(pull) => vec!["law/orbit", pull],
            OrbitForm::Separated => vec!["law/separated", "law/turning"],
        }
    }

    /// Returns `true` if a ray stays in a plane through the center.
    #[must_use]
    pub fn is_plane(&self) -> bool {
        matches!(self.form, OrbitForm::Plane(_))
    }
}

/// A connection between two regions of a law's space: rays that enter a sphere around one mouth leave the sphere around the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Throat {
    /// The centers of the spheres, on this side and on the other.
    pub mouths: [DVec3; 2],
    /// The radius of the spheres.
    pub radius: f64,
    /// The depth of the spheres below the radius at which rays move to the other mouth.
    pub depth: f64,
}

impl Throat {
    /// Creates a throat from the radius ρ₀ of the spheres around its mouths.
    #[must_use]
    pub fn new(mouths: [DVec3; 2], radius: f64) -> Self {
        /// The ratio δ/ρ₀: the depth below the throat to which paths are followed before they move to the other side.
        const DEPTH: f64 = 0.01;
        let depth = DEPTH * radius;
        Self { mouths, radius: radius - depth, depth }
    }

    /// Returns ρ₀, the radius of the throat.
    #[must_use]
    pub fn rim(&self) -> f64 {
        self.radius + self.depth
    }

    /// Returns the offset from the nearer mouth, and 1 or, on the other side, −1.
    #[must_use]
    pub fn offset(&self, x: DVec3) -> (DVec3, f64) {
        let [here, there] = self.mouths.map(|mouth| x - mouth);
        if there.length_squared() < here.length_squared() { (there, -1.0) } else { (here, 1.0) }
    }

    /// Returns why rays cannot be followed within a bounding sphere of this radius: the law's invalid key, the problem and the remedy.
    pub(crate) fn refuses_bound(&self, radius: f64) -> Option<(&'static str, [String; 2])> {
        let (apart, enough) = (self.mouths[0].distance(self.mouths[1]), 2.0 * radius);
        let problem = || format!("the bounding spheres around the two mouths overlap: the mouths are {apart} apart");
        (apart <= enough)
            .then(|| ("other_mouth", [problem(), format!("move it to more than {enough} from law.center")]))
    }

    /// Implements [`Law::refuses_eye`](super::Law::refuses_eye).
    pub(super) fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        let (away, rim) = (self.offset(at).0.length(), self.rim());
        let problem = || format!("is inside the sphere of the mouth: {away:.4} ≤ {rim:.4}");
        (away <= rim).then(|| [problem(), "move it out of the throat, which is this sphere".to_owned()])
    }

    /// Returns the spheres of a diagram.
    pub(super) fn landmarks(&self) -> Vec<CharacteristicSurface> {
        self.mouths.map(|center| CharacteristicSurface::sphere("throat", center, self.rim(), false)).into()
    }
}
