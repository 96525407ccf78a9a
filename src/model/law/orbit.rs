//! What a law may say of its paths as a whole: that they are orbits about one centre, or that a throat leads on to another place.

use glam::DVec3;

/// The orbit about a law's only centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orbit {
    /// The centre.
    pub center: DVec3,
    /// What else a place on it needs.
    pub form: OrbitForm,
    /// Does the pull fall by an inverse power, so that an orbit has an asymptote in closed form?
    pub is_free_far_away: bool,
}

/// What an orbit is besides its r.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OrbitForm {
    /// An angle in the plane through the centre in which a ray stays; and the WGSL part that has its pull.
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
            OrbitForm::Separated => vec!["law/separated"],
        }
    }

    /// Does a ray stay in a plane through the centre?
    #[must_use]
    pub fn is_plane(&self) -> bool {
        self.form != OrbitForm::Separated
    }
}

/// What joins two places of a law's space: a sphere round each, into which rays go at one to come out at the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Throat {
    /// The spheres' centres, on this side and on the other.
    pub mouths: [DVec3; 2],
    /// Their radius.
    pub radius: f64,
    /// How far that is beyond the place from which rays are drawn round the other mouth.
    pub depth: f64,
}
