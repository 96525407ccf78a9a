//! The light of a scene's surfaces as an instrument at the camera measures it: line profiles, light curves and spectra.
//!
//! *Theory.* Along a ray I/ν³ is constant, so that light emitted with the frequency ν and the intensity I per frequency arrives with gν and
//! g³I, and a spectral line with g⁴ times its total intensity. The flux is the sum over the pixels of an image, each times its solid angle.
//! Every crossing of a surface contributes, times the light that earlier crossings let through.
//!
//! *Practice.* A pixel's light is spread evenly over the range of g that the pixel covers, which its neighbors determine: a histogram of
//! the centers alone is noisy. Only light that goes from a surface to the camera counts: mirrors and glass end or bend rays as in a
//! render, but reflected and scattered light is not included.

mod fluxes;
mod kind;
mod radiation;

use std::collections::VecDeque;

use glam::DVec3;

use crate::gpu::Gpu;
use crate::model::matter;
use crate::program::{Layer, Mode, constant};
use crate::render::{Crossing, Crossings, RenderError, RenderSettings, Starts, Totals, Tracer};
use crate::scene::{Camera, Scene};

pub use fluxes::{InvalidEmissivity, Orders, light_curve, line, planck, spectrum};
pub use kind::{Kind, Point, measure};
pub use radiation::RadiationSpectrum;

/// The light of one crossing of a surface in one pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Emission {
    /// The index of the scene's object.
    pub object: u32,
    /// The order of the image: 0 for the first crossing.
    pub order: usize,
    /// The solid angle of the pixel in steradians, times the surface's opacity and the fraction of light that earlier crossings let through.
    pub weight: f64,
    /// The redshift factor.
    pub g: f64,
    /// The width of the range of g in the pixel.
    pub width: f64,
    /// The radius r, as in [`Crossing`].
    pub radius: f64,
    /// The azimuth φ.
    pub azimuth: f64,
    /// The travel time of the light to the camera; 0 if it is unknown.
    pub time: f64,
    /// The cosine of the angle between the light and the surface normal, in the frame of the surface; 1 if it is unknown.
    pub mu: f64,
    /// The temperature in kelvins; `None` if the surface does not radiate as a black body.
    pub temperature: Option<f64>,
}

/// Renders the crossings of all pixels, and returns the light of each, ordered by pixel, with the totals of the render.
///
/// A pixel is one ray through its center; with n samples it is divided into about √n × √n smaller ones. With `objects`, only these objects emit; others still block light.
///
/// # Errors
///
/// Returns [`RenderError::NoCamera`] without a camera, and the errors of [`trace_pixels`](crate::render::trace_pixels).
pub fn emissions(
    gpu: &Gpu,
    scene: &Scene,
    settings: &RenderSettings,
    objects: Option<&[u32]>,
) -> Result<(Vec<Emission>, Totals), RenderError> {
    let mut scene = scene.clone();
    // Samples are a finer grid.
    let finer = f64::from(scene.image.samples).sqrt().round() as u32;
    scene.image.size = scene.image.size.map(|side| side.saturating_mul(finer));
    scene.image.samples = 1;
    let mut settings = settings.clone();
    settings.options.layers = vec![Layer::CrossingRadius, Layer::CrossingRedshift, Layer::CrossingAngle];
    let mut tracer = Tracer::new(gpu, &scene, settings, Mode::Pixels)?;
    let source = Source::new(&scene, objects).ok_or(RenderError::NoCamera)?;
    let [width, height] = scene.image.size;
    let mut totals = Totals::default();
    let mut found = Vec::new();
    // The rows from `first` on: those next to the current row, and those that were traced together with them.
    let (mut rows, mut first, mut traced): (VecDeque<Vec<Crossings>>, u32, u32) = (VecDeque::new(), 0, 0);
    for y in 0..height {
        if traced < height.min(y + 2) {
            let end = height.min(traced + (AT_ONCE / width).max(2));
            let pixels: Vec<[u32; 2]> = (traced..end).flat_map(|y| (0..width).map(move |x| [x, y])).collect();
            totals.add(&tracer.follow(Starts::Pixels(&pixels, width))?.1);
            rows.extend(tracer.crossings().chunks(width as usize).map(<[_]>::to_vec));
            traced = end;
        }
        let row = |y: Option<u32>| rows.get((y?.checked_sub(first)?) as usize).map(Vec::as_slice);
        if let Some(own) = row(Some(y)) {
            source.add_row(y, own, [row(y.checked_sub(1)), row(Some(y + 1))], &mut found);
        }
        if first < y {
            rows.pop_front();
            first += 1;
        }
    }
    Ok((found, totals))
}

/// The number of pixels that are traced at once.
const AT_ONCE: u32 = 1 << 18;

/// The surfaces and the camera of a scene.
struct Source<'a> {
    scene: &'a Scene,
    camera: &'a Camera,
    objects: Option<&'a [u32]>,
    heat: Option<Heat>,
}

impl<'a> Source<'a> {
    fn new(scene: &'a Scene, objects: Option<&'a [u32]>) -> Option<Self> {
        Some(Self { scene, camera: scene.camera.as_ref()?, objects, heat: Heat::of(scene) })
    }

    /// Appends the emissions of a row, which has neighbors above and below.
    fn add_row(&self, y: u32, row: &[Crossings], near: [Option<&[Crossings]>; 2], found: &mut Vec<Emission>) {
        for (x, own) in row.iter().enumerate() {
            let mut open = self.camera.solid_angle(self.scene.image.size, [x as u32, y]).unwrap_or(0.0);
            for (order, crossing) in own.iter().enumerate().filter_map(|(order, one)| Some((order, one.as_ref()?))) {
                let surface =
                    self.scene.objects[crossing.object as usize].material().map(|k| &self.scene.materials[k].surface);
                let opacity = surface.map_or(1.0, |surface| surface.facts().opacity);
                let beyond = |row: Option<&[Crossings]>, x: Option<usize>| like(row?.get(x?)?, order, crossing);
                let sides = [
                    [beyond(Some(row), x.checked_sub(1)), beyond(Some(row), Some(x + 1))],
                    near.map(|row| beyond(row, Some(x))),
                ];
                if let Some(g) =
                    crossing.redshift.filter(|_| self.objects.is_none_or(|all| all.contains(&crossing.object)))
                {
                    found.push(Emission {
                        object: crossing.object,
                        order,
                        weight: open * opacity,
                        g,
                        width: sides.map(|sides| slope(g, sides)).into_iter().fold(0.0, f64::hypot).min(2.0 * g),
                        radius: crossing.radius,
                        azimuth: crossing.azimuth,
                        time: crossing.time.unwrap_or(0.0),
                        mu: crossing.angle.map_or(1.0, f64::cos),
                        temperature: surface.and_then(|surface| {
                            let orbits = surface.facts().orbits.then_some(self.heat.as_ref()).flatten();
                            Some(surface.temperature()? * orbits.map_or(1.0, |heat| heat.at(crossing.x.into())))
                        }),
                    });
                }
                open *= 1.0 - opacity;
            }
        }
    }
}

/// Returns g of the crossing of a neighboring pixel that belongs to the same image of the same object.
fn like(crossings: &Crossings, order: usize, own: &Crossing) -> Option<f64> {
    crossings[order].filter(|other| other.object == own.object)?.redshift
}

/// Returns the change of g across a pixel from its neighbors on both sides. At a jump, the smaller difference counts.
fn slope(g: f64, sides: [Option<f64>; 2]) -> f64 {
    match sides.map(|side| side.map(|side| (side - g).abs())) {
        [Some(a), Some(b)] => {
            let across = sides.map(|side| side.unwrap_or(g));
            (0.5 * (across[1] - across[0]).abs()).min(2.0 * a.min(b))
        }
        [one, other] => one.or(other).unwrap_or(0.0),
    }
}

/// The temperature of an accretion disk relative to its hottest ring, over the logarithm of the distance from the axis.
struct Heat {
    equator: [DVec3; 2],
    first: f64,
    per_ring: f64,
    rings: Vec<f64>,
}

impl Heat {
    fn of(scene: &Scene) -> Option<Self> {
        let equator = scene.law.equator()?;
        let count = constant("surface/material/accretion", "ORBITS") as usize;
        let (_, orbits) = matter::orbits(&*scene.law, scene.rays.bounding_sphere.radius, count)?;
        let most = orbits.iter().map(|orbit| orbit.flux).fold(0.0, f64::max);
        let [first, second] = [0, 1].map(|k: usize| orbits[k].rho.ln());
        let rings = orbits.iter().map(|orbit| (orbit.flux / most).max(0.0).sqrt()).collect();
        Some(Self { equator, first, per_ring: second - first, rings })
    }

    /// Interpolates the square of the temperature like the material does, because it goes to 0 smoothly at the ISCO.
    fn at(&self, x: DVec3) -> f64 {
        let [center, axis] = self.equator;
        let rho = (x - center).reject_from_normalized(axis).length();
        let place = ((rho.ln() - self.first) / self.per_ring).clamp(0.0, (self.rings.len() - 1) as f64);
        let ring = (place as usize).min(self.rings.len() - 2);
        let part = place - ring as f64;
        (self.rings[ring] * (1.0 - part) + self.rings[ring + 1] * part).sqrt()
    }
}
