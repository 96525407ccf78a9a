//! Scenes as plain values: what a TOML file says, checked, with its meshes and pictures loaded.
//!
//! *Theory.* A scene is a law of light, a way to follow it, a camera, things to hit and a sky to escape to. Lengths
//! are in scene units, angles in degrees, colours linear, G = c = 1.
//!
//! *Practice.* [`Scene::load`] reads a file in three steps: `document` (the TOML as written, every value with its place in
//! the file), then `check` (documents to the values below, all mistakes found in one run), with `mesh` and
//! `picture` loading what the file names. Nothing here knows of a GPU.

mod camera;
mod check;
mod cut;
mod document;
mod error;
mod expression;
mod grid;
mod inside;
mod medium;
mod mesh;
mod picture;
mod profile;
mod rays;
mod reference;
mod transform;

#[cfg(test)]
mod tests;

pub use camera::{Camera, CameraKind, Corners, Frame, Stereo, StereoLayout};
pub use cut::{CORNERS, CutPlane, Landmark, Outline};
pub use document::Override;
pub use error::{Mistake, SceneError};
pub use expression::{Axis, Formula, FormulaError, Function, Graph, Id, Node};
pub use grid::IndexGrid;
pub use medium::{COMMON, Explosion, Ingoing, Interior, Medium, Noise};
pub use mesh::{Mesh, Vertex};
pub use picture::Picture;
pub use profile::{Profile, ProfilePoint};
pub use rays::{Accuracy, Bound, Branches, Control, DoublingRule, Method, Precision, Rays, Segment};
pub use reference::{KeyReference, REFERENCE, TEMPLATE, reference_markdown};
pub use transform::Transform;

use glam::{DVec2, DVec3};

/// A whole scene: the values of one TOML file, complete and consistent.
#[derive(Debug, Clone)]
pub struct Scene {
    /// What the picture is.
    pub image: Image,
    /// Where rays start; a scene made only for `trace` may have none.
    pub camera: Option<Camera>,
    /// How light travels.
    pub law: Law,
    /// How light is followed.
    pub rays: Rays,
    /// What an escaped ray sees.
    pub sky: Sky,
    /// How radiance becomes a picture file.
    pub output: Output,
    /// In the order of the file; [`Substance::Opaque`] indexes it.
    pub materials: Vec<Material>,
    /// In the order of the file; the object id of every output is the index here.
    pub objects: Vec<Object>,
    /// In the order of the file.
    pub lights: Vec<Light>,
    /// Every picture that a material or the sky uses, each loaded once.
    pub pictures: Vec<Picture>,
}

/// `[image]`: size and sampling.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Rays per pixel; more than one are multi-jittered.
    pub samples: u32,
}

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

impl Scene {
    /// The accuracy that the scene asks for, in radians; none if it names a method. A plane camera's pixels have no angle:
    /// there, and without a camera, a pixel is a thousandth of a radian.
    #[must_use]
    pub fn accuracy(&self) -> Option<f64> {
        Some(match self.rays.auto? {
            Accuracy::Radians(angle) => angle,
            Accuracy::Pixels(part) => part * self.pixel_angle().unwrap_or(1e-3),
        })
    }

    /// Every medium: of all space, and of objects.
    pub fn media(&self) -> impl Iterator<Item = &Medium> {
        let all = match &self.law {
            Law::Medium(medium) => Some(medium),
            _ => None,
        };
        all.into_iter().chain(self.objects.iter().filter_map(|object| Some(&object.interior()?.medium)))
    }

    /// The angle of a pixel at the picture's centre, in radians.
    #[must_use]
    pub fn pixel_angle(&self) -> Option<f64> {
        self.camera.as_ref()?.pixel_angle(self.image.size)
    }

    /// Does its picture have pixels that show nothing, so that its files carry alpha?
    #[must_use]
    pub fn is_transparent(&self) -> bool {
        self.camera.as_ref().is_some_and(Camera::is_transparent)
    }
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

/// `[sky]`.
#[derive(Debug, Clone, PartialEq)]
pub enum Sky {
    /// One colour; black unless the scene says otherwise.
    Color(DVec3),
    /// An equirectangular picture: index into [`Scene::pictures`], and a factor on its radiance.
    Equirectangular(usize, f64),
    /// Six faces +x −x +y −y +z −z, seen from inside: indices into [`Scene::pictures`], and a factor.
    Faces([usize; 6], f64),
}

/// `[output]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Output {
    /// Stops: radiance is multiplied by 2^exposure for PNG.
    pub exposure: f64,
    /// The curve for PNG.
    pub tonemap: Tonemap,
    /// Bits per channel of a PNG, 8 or 16.
    pub bits: u8,
}

/// Tone curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tonemap {
    /// Clip.
    None,
    /// A filmic shoulder.
    Filmic,
}

/// `[materials.NAME]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// The name in the file.
    pub name: String,
    /// The colour that its kind uses, over the surface.
    pub color: Pattern,
    /// How it answers light.
    pub kind: MaterialKind,
}

/// How a material answers light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MaterialKind {
    /// Reflects rays, with its colour as the part that it gives back.
    Mirror,
    /// Radiates its colour.
    Emissive,
    /// Ambient, diffuse and Blinn–Phong specular terms (W04 §3.4), with its colour as the diffuse one.
    Phong {
        /// Fraction of the colour that is always there.
        ambient: f64,
        /// Colour of the highlight.
        specular: DVec3,
        /// Blinn's exponent.
        shininess: f64,
        /// Radiance of its own, added.
        emission: DVec3,
    },
}

/// A colour over a surface's (u, v).
#[derive(Debug, Clone, PartialEq)]
pub enum Pattern {
    /// The same everywhere.
    Constant(DVec3),
    /// Two colours in turn.
    Checker {
        /// The two colours.
        colors: [DVec3; 2],
        /// Cells along u and v.
        repeat: DVec2,
    },
    /// A picture: index into [`Scene::pictures`].
    Picture {
        /// Which.
        picture: usize,
        /// How often it repeats along u and v.
        repeat: DVec2,
    },
}

/// `[[objects]]`: a shape in its own space, where it is, and what it is made of.
#[derive(Debug, Clone)]
pub struct Object {
    /// The shape.
    pub shape: Shape,
    /// From the shape's own space to the scene's.
    pub transform: Transform,
    /// What it is made of.
    pub substance: Substance,
}

/// What an object is made of.
#[derive(Debug, Clone, PartialEq)]
pub enum Substance {
    /// A surface: index into [`Scene::materials`].
    Opaque(usize),
    /// A medium that light goes through.
    Clear(Interior),
}

impl Object {
    /// The index of its material, if it has one.
    #[must_use]
    pub fn material(&self) -> Option<usize> {
        match self.substance {
            Substance::Opaque(material) => Some(material),
            Substance::Clear(_) => None,
        }
    }

    /// What it is filled with, if light goes through it.
    #[must_use]
    pub fn interior(&self) -> Option<&Interior> {
        match &self.substance {
            Substance::Opaque(_) => None,
            Substance::Clear(interior) => Some(interior),
        }
    }
}

/// Shapes, each in its own space; `Object::transform` holds the file's center, radius, size and so on.
#[derive(Debug, Clone)]
pub enum Shape {
    /// The unit sphere. u runs round y, v from the south to the north pole.
    Sphere,
    /// The square |x| ≤ 1, |z| ≤ 1 in y = 0, its normal +y. (u, v) = ((x+1)/2, (1−z)/2).
    Plane,
    /// The cube |x|, |y|, |z| ≤ 1; each face has (u, v) in [0, 1].
    Box,
    /// The cylinder x² + z² ≤ 1, |y| ≤ 1 with both faces. u runs round y; v runs upwards, over each of the lower face (from
    /// its middle to the rim), the mantle and the upper face (from the rim to its middle).
    Cylinder,
    /// The disk x² + z² ≤ 1 in y = 0, its normal +y. u runs round y, v from the rim to the middle, or to the hole.
    Disk {
        /// The radius of a round hole in it, below 1; zero for none.
        hole: f64,
    },
    /// Triangles.
    Mesh(std::sync::Arc<Mesh>),
}

/// `[[lights]]`, shining in straight lines without fall-off (W04 §3.4: "fake" illumination, for testing).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Light {
    /// At a place.
    Point {
        /// Where.
        position: DVec3,
        /// Radiance.
        color: DVec3,
    },
    /// From far away.
    Directional {
        /// Unit vector the light travels along.
        direction: DVec3,
        /// Radiance.
        color: DVec3,
    },
}
