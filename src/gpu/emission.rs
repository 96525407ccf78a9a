//! Computes the paths that leave a light.

use glam::DVec3;

use crate::scene::{Beam, Light, LightSource, Scene};

/// The starts and directions of a light's paths, and their flux. From a point light of intensity 1 they fill the directions into the
/// bounding sphere evenly; from a directional light of irradiance 1 they fill the disk of the bounding sphere evenly. From an emitter they
/// start in the ellipsoid inscribed in its box, and lead into the bounding sphere of a target object or of the scene.
#[derive(Debug, Clone, Copy)]
pub struct Emission {
    source: LightSource,
    /// The corners of the box of an emitter, if the light is one.
    emitter: Option<[DVec3; 2]>,
    /// The sphere that the paths lead into: center and radius.
    into: (DVec3, f64),
    /// The center of the bounding sphere.
    center: DVec3,
    radius: f64,
}

impl Emission {
    /// Creates the emission of a light of the scene.
    #[must_use]
    pub fn new(scene: &Scene, light: &Light) -> Self {
        let bound = &scene.rays.bounding_sphere;
        let (center, radius) = (bound.center, bound.radius);
        Self { source: light.source, emitter: None, into: (center, radius), center, radius }
    }

    /// Creates the emission of an emitter.
    #[must_use]
    pub fn of_lamp(scene: &Scene, beam: &Beam) -> Self {
        let bound = &scene.rays.bounding_sphere;
        let (center, radius) = (bound.center, bound.radius);
        let into = beam.through.map_or((center, radius), |object| scene.objects[object].ball());
        let (lo, hi) = scene.objects[beam.emitter.object].bounds();
        Self { source: LightSource::Point(beam.emitter.center), emitter: Some([lo, hi]), into, center, radius }
    }

    /// Returns the flux of all paths together.
    #[must_use]
    pub fn flux(&self) -> f64 {
        use std::f64::consts::PI;
        match self.source {
            LightSource::Point(position) => 2.0 * PI * (1.0 - self.widest(position)),
            LightSource::Directional(_) => PI * self.radius * self.radius,
        }
    }

    /// Returns the cosine of the largest angle between a path from `position` and the center of the target sphere.
    fn widest(&self, position: DVec3) -> f64 {
        let part = self.into.1 / position.distance(self.into.0);
        if part < 1.0 { (1.0 - part * part).sqrt() } else { -1.0 }
    }

    /// Returns the start and the direction of the k-th path, for a point of the unit square.
    #[must_use]
    pub fn path(&self, k: u32, [even, turn]: [f64; 2]) -> [f64; 6] {
        let turn = std::f64::consts::TAU * turn;
        let (x, d) = match self.source {
            LightSource::Point(center) => {
                let position = self.emitter.map_or(center, |[lo, hi]| lo + place_in_box(k) * (hi - lo));
                let axis = (self.into.0 - position).normalize_or(DVec3::Z);
                let cosine = 1.0 - even * (1.0 - self.widest(position));
                let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
                let d = cosine * axis + sine * about(axis, turn);
                (position + self.way_in(position, d) * d, d)
            }
            LightSource::Directional(d) => {
                let off = self.radius * even.sqrt() * about(d, turn);
                let back = (self.radius * self.radius - off.length_squared()).max(0.0).sqrt();
                (self.center + off - (1.0 - INSIDE) * back * d, d)
            }
        };
        [x.x, x.y, x.z, d.x, d.y, d.z]
    }

    /// Returns the distance to the bounding sphere for a point outside of it, because nothing bends light before that.
    fn way_in(&self, x: DVec3, d: DVec3) -> f64 {
        let off = x - self.center;
        let b = off.dot(d);
        let c = off.length_squared() - self.radius * self.radius;
        if c > 0.0 { -b - (1.0 - INSIDE) * (b * b - c).max(0.0).sqrt() } else { 0.0 }
    }
}

/// The shift of path starts into the bounding sphere, as a fraction of half the chord.
const INSIDE: f64 = 1e-6;
/// The number of strata along each side of the unit square.
const SIDE: u32 = 64;

/// The strata of the unit square that paths are sent through, and the number of paths in each.
///
/// *Theory.* Most directions from a light do not lead to the region of interest. A few pilot paths determine which strata do; these and
/// their neighbors then share all paths equally.
///
/// *Practice.* Within a stratum, paths use the first two Sobol dimensions with Owen scrambling: they are more even than random points, and
/// have no lattice pattern that voxels would show. The paths of a stratum have consecutive numbers and run side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct Aim {
    strata: Vec<u32>,
    each: u32,
}

impl Aim {
    /// Creates an aim through all strata, with at least `paths` paths.
    #[must_use]
    pub fn everywhere(paths: u32) -> Self {
        Self::through((0..SIDE * SIDE).collect(), paths)
    }

    fn through(strata: Vec<u32>, paths: u32) -> Self {
        let each = paths.div_ceil(strata.len() as u32);
        Self { strata, each }
    }

    /// Returns an aim with at least `paths` paths through those strata whose paths `reach` the target and their neighbors, as far as this
    /// aim has them; through all strata of this aim if none does.
    #[must_use]
    pub fn narrowed(&self, reach: impl Iterator<Item = bool>, paths: u32) -> Self {
        let mut wanted = vec![false; (SIDE * SIDE) as usize];
        for (k, _) in (0..).zip(reach).filter(|(_, reaches)| *reaches) {
            let (row, column) = self.stratum(k);
            for row in row.saturating_sub(1)..(row + 2).min(SIDE) {
                // All azimuths meet at the ends of the axis.
                let columns = if row == 0 || row + 1 == SIDE { 0..SIDE } else { column + SIDE - 1..column + SIDE + 2 };
                columns.for_each(|column| wanted[(row * SIDE + column % SIDE) as usize] = true);
            }
        }
        let strata: Vec<u32> = self.strata.iter().copied().filter(|stratum| wanted[*stratum as usize]).collect();
        if strata.is_empty() { self.again(paths) } else { Self::through(strata, paths) }
    }

    /// Returns an aim with at least `paths` paths through the same strata.
    #[must_use]
    pub fn again(&self, paths: u32) -> Self {
        Self::through(self.strata.clone(), paths)
    }

    /// Returns the number of paths.
    #[must_use]
    pub fn paths(&self) -> u32 {
        self.strata.len() as u32 * self.each
    }

    /// Returns the fraction of the light's flux that each path carries.
    #[must_use]
    pub fn share(&self) -> f64 {
        1.0 / (f64::from(SIDE * SIDE) * f64::from(self.each))
    }

    /// Returns the row and column of a path's stratum.
    fn stratum(&self, k: u32) -> (u32, u32) {
        let stratum = self.strata[(k / self.each) as usize];
        (stratum / SIDE, stratum % SIDE)
    }

    /// Returns the point of a path in the unit square.
    #[must_use]
    pub fn point(&self, k: u32) -> [f64; 2] {
        let (row, column) = self.stratum(k);
        let [x, y] = even_point(k % self.each, row * SIDE + column);
        [(f64::from(row) + x) / f64::from(SIDE), (f64::from(column) + y) / f64::from(SIDE)]
    }
}

/// Returns a unit vector perpendicular to `axis` at the azimuth `turn`, in radians.
fn about(axis: DVec3, turn: f64) -> DVec3 {
    let (a, b) = axis.any_orthonormal_pair();
    turn.cos() * a + turn.sin() * b
}

/// Returns the k-th position in an emitter, as a fraction of its box: a point of the inscribed ellipsoid.
fn place_in_box(k: u32) -> DVec3 {
    let ([x, y], [z, _]) = (even_point(k, SIDE * SIDE), even_point(k, SIDE * SIDE + 1));
    let off = DVec3::new(x, y, z) - 0.5;
    0.5 + off * (0.5 / off.length()).min(1.0)
}

/// Returns the k-th point of a (0,2)-sequence in the unit square; each seed gives another sequence.
fn even_point(k: u32, seed: u32) -> [f64; 2] {
    let mut second = 0;
    let mut direction = 1_u32 << 31;
    for bit in 0..32 - k.leading_zeros() {
        second ^= if k >> bit & 1 == 1 { direction } else { 0 };
        direction ^= direction >> 1;
    }
    let seeds = [hashed(2 * seed), hashed(2 * seed + 1)];
    let dimensions = [k.reverse_bits(), second];
    [0, 1].map(|i| (f64::from(scrambled(dimensions[i], seeds[i])) + 0.5) / 2.0_f64.powi(32))
}

/// Computes the output function of PCG.
pub(crate) fn hashed(seed: u32) -> u32 {
    let state = seed.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    word >> 22 ^ word
}

/// Flips each bit depending on the higher bits and the seed: the Laine–Karras hash, with the constants of Vegdahl.
fn scrambled(x: u32, seed: u32) -> u32 {
    let mut v = x.reverse_bits();
    v ^= v.wrapping_mul(0x3d20_adea);
    v = v.wrapping_add(seed);
    v = v.wrapping_mul(seed >> 16 | 1);
    v ^= v.wrapping_mul(0x0552_6c56);
    v ^= v.wrapping_mul(0x53a2_2864);
    v.reverse_bits()
}
