//! What a law may say of its paths as a whole: that they are orbits about one center, or that a throat leads on to another place.

use glam::DVec3;

use super::Landmark;

/// The orbit about a law's only center.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orbit {
    /// The center.
    pub center: DVec3,
    /// What else a place on it needs.
    pub form: OrbitForm,
    /// Does the pull fall by an inverse power, so that an orbit has an asymptote in closed form?
    pub is_free_far_away: bool,
}

/// What an orbit is besides its r.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OrbitForm {
    /// An angle in the plane through the center in which a ray stays; and the WGSL part that has its pull.
    Plane(&'static str),
    /// Angles that turn about the axis of a spin.
    Separated,
}

impl Orbit {
    /// The WGSL parts of its steps.
    #[must_use]
    pub fn parts(&self) -> Vec<&'static str> {
        match self.form {
            OrbitForm::Plane(pull) => vec!["law/orbit", pull],
            OrbitForm::Separated => vec!["law/separated", "law/turning"],
        }
    }

    /// Does a ray stay in a plane through the center?
    #[must_use]
    pub fn is_plane(&self) -> bool {
        matches!(self.form, OrbitForm::Plane(_))
    }
}

/// What joins two places of a law's space: a sphere round each, into which rays go at one to come out at the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Throat {
    /// The spheres' centers, on this side and on the other.
    pub mouths: [DVec3; 2],
    /// Their radius.
    pub radius: f64,
    /// How far that is beyond the place from which rays are drawn round the other mouth.
    pub depth: f64,
}

impl Throat {
    /// Of a throat that is drawn as spheres of this radius about its mouths.
    #[must_use]
    pub fn new(mouths: [DVec3; 2], radius: f64) -> Self {
        /// δ over ρ₀: how far beyond the throat paths are followed before they are drawn on its other side.
        const DEPTH: f64 = 0.01;
        let depth = DEPTH * radius;
        Self { mouths, radius: radius - depth, depth }
    }

    /// ρ₀, the radius of the throat's own sphere.
    #[must_use]
    pub fn rim(&self) -> f64 {
        self.radius + self.depth
    }

    /// From the nearer mouth; and 1, or −1 if that is the other side's.
    #[must_use]
    pub fn offset(&self, x: DVec3) -> (DVec3, f64) {
        let [here, there] = self.mouths.map(|mouth| x - mouth);
        if there.length_squared() < here.length_squared() { (there, -1.0) } else { (here, 1.0) }
    }

    /// Returns why rays cannot be followed within a bounding sphere of this radius: the law's key that is wrong beside it, the mistake,
    /// and what to do.
    pub(crate) fn refuses_bound(&self, radius: f64) -> Option<(&'static str, [String; 2])> {
        let (apart, enough) = (self.mouths[0].distance(self.mouths[1]), 2.0 * radius);
        let problem = || format!("the bounding spheres round the two mouths overlap: they are {apart} apart");
        (apart <= enough)
            .then(|| ("other_mouth", [problem(), format!("move it to more than {enough} from law.center")]))
    }

    /// As [`Law::refuses_eye`](super::Law::refuses_eye).
    pub(super) fn refuses_eye(&self, at: DVec3) -> Option<[String; 2]> {
        let (away, rim) = (self.offset(at).0.length(), self.rim());
        let problem = || format!("is inside the mouth's sphere: {away:.4} ≤ {rim:.4}");
        (away <= rim).then(|| [problem(), "move it out: the throat is that sphere".to_owned()])
    }

    /// A drawing's spheres.
    pub(super) fn landmarks(&self) -> Vec<Landmark> {
        self.mouths.map(|center| Landmark::sphere("throat", center, self.rim(), false)).into()
    }
}
