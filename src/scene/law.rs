//! `[law]`: how light travels.

use super::Medium;
use glam::DVec3;

/// `[law]`: how light travels.
#[derive(Debug, Clone, PartialEq)]
pub enum Law {
    /// Straight lines.
    Straight,
    /// A Schwarzschild black hole (W04 §5.4).
    Schwarzschild {
        /// Mass M: the horizon is at r = 2M.
        mass: f64,
        /// The hole's place.
        center: DVec3,
        /// Which equation is integrated.
        form: SchwarzschildForm,
    },
    /// Any number of force centres, whose accelerations add (G95 §2.1, W04 §5.2).
    Sources(Vec<Source>),
    /// A dynamical system's vector field F (G95 §2.2, W04 §5.1).
    Flow {
        /// Which field.
        field: FlowField,
        /// What the field is to the ray.
        order: FlowOrder,
    },
    /// A medium that fills all space (W04 §5.3).
    Medium(Medium),
}

impl Law {
    /// The only centre, if there is one: rays then stay in a plane through it.
    #[must_use]
    pub fn only_center(&self) -> Option<DVec3> {
        match self {
            Self::Schwarzschild { form: SchwarzschildForm::Path, center, .. } => Some(*center),
            Self::Sources(sources) => match sources.as_slice() {
                [only] => Some(only.position),
                _ => None,
            },
            _ => None,
        }
    }

    /// The velocity that a given one at x stands for, where the law does not take it as it is: a medium's is as long as its index
    /// (as 1, where the host does not know that).
    #[must_use]
    pub fn starting_velocity(&self, x: DVec3, v: DVec3) -> DVec3 {
        match self {
            Self::Medium(medium) => medium.index(x).unwrap_or(1.0) * v.normalize_or_zero(),
            _ => v,
        }
    }

    /// Does its one centre pull by an inverse power, so that an orbit has an asymptote in closed form?
    #[must_use]
    pub fn is_free_far_away(&self) -> bool {
        match self {
            Self::Schwarzschild { .. } => true,
            Self::Sources(sources) => sources.iter().all(|source| source.falloff == Falloff::InverseSquare),
            _ => false,
        }
    }
}

/// The two equations of light round a Schwarzschild hole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SchwarzschildForm {
    /// x″ = −3M h² x/r⁵, h = |x × v|: the geodesic with the null condition put in.
    Path,
    /// The geodesic equation as the 2004 paper integrates it, ṫ carried along.
    Geodesic,
}

/// One force centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Source {
    /// The centre.
    pub position: DVec3,
    /// Positive attracts, negative repels.
    pub strength: f64,
    /// How the force falls off.
    pub falloff: Falloff,
    /// A ray that comes this near moving inwards is captured; zero for none.
    pub capture: f64,
}

/// A force's fall-off with distance r from its centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Falloff {
    /// 1/r².
    InverseSquare,
    /// 2r³/R³ − 3r²/R² + 1 inside R, else 0.
    Cubic {
        /// R.
        radius: f64,
    },
    /// e^(−μr)(1 + μr)/r².
    Yukawa {
        /// μ.
        mu: f64,
    },
}

/// The dynamical systems.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FlowField {
    /// (σ(y−x), ρx − y − xz, xy − βz).
    Lorenz {
        /// σ, by default 10.
        sigma: f64,
        /// ρ, by default 28.
        rho: f64,
        /// β, by default 8/3.
        beta: f64,
    },
    /// (−(y+z), x + αy, β + z(x−γ)).
    Rossler {
        /// α, by default 3/8.
        alpha: f64,
        /// β, by default 2.
        beta: f64,
        /// γ, by default 4.
        gamma: f64,
    },
}

/// What a vector field F is to the ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlowOrder {
    /// dx/dτ = F(x): the ray is an orbit (G95 §2.2).
    Velocity,
    /// d²x/dτ² = F(x): W04's Eq. 1 read literally.
    Acceleration,
}
