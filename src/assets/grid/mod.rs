//! Grids: an index of refraction as samples on a regular grid, from NRRD files or from bare numbers.
//!
//! *Practice.* Samples lie at the grid's points, x fastest. Stored values become an index by a factor and an offset when they are
//! read, and are kept in 32 bits, 4 bytes a sample.

mod nrrd;
#[cfg(test)]
mod tests;

use crate::document::{SceneError, read_bytes};
use crate::progress::Stage;
use glam::DVec3;
use std::path::{Path, PathBuf};

/// Samples of an index.
#[derive(Debug, Clone, PartialEq)]
pub struct IndexGrid {
    /// Samples along x, y and z: 2 or more.
    pub size: [u32; 3],
    /// Where the first sample is, in scene units.
    pub origin: DVec3,
    /// From one sample to the next along x, y and z, in scene units.
    pub cell: DVec3,
    /// n at each point, above 0; x fastest, then y.
    pub samples: Vec<f32>,
    /// The file that the samples are in, if the header is in another.
    pub data: Option<PathBuf>,
}

/// How numbers are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stored {
    /// Whole numbers of 8 bits with a sign.
    I8,
    /// Whole numbers of 8 bits.
    U8,
    /// Whole numbers of 16 bits with a sign.
    I16,
    /// Whole numbers of 16 bits.
    U16,
    /// Whole numbers of 32 bits with a sign.
    I32,
    /// Whole numbers of 32 bits.
    U32,
    /// Whole numbers of 64 bits with a sign.
    I64,
    /// Whole numbers of 64 bits.
    U64,
    /// Floating-point numbers of 32 bits.
    F32,
    /// Floating-point numbers of 64 bits.
    F64,
}

impl Stored {
    /// Each by its name in a scene.
    pub const NAMES: &[(&str, Self)] = &[
        ("i8", Self::I8),
        ("u8", Self::U8),
        ("i16", Self::I16),
        ("u16", Self::U16),
        ("i32", Self::I32),
        ("u32", Self::U32),
        ("i64", Self::I64),
        ("u64", Self::U64),
        ("f32", Self::F32),
        ("f64", Self::F64),
    ];

    /// How many bytes a number has.
    pub(super) fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// The number in so many bytes as it has; `little` end first.
    pub(super) fn number(self, bytes: &[u8], little: bool) -> f64 {
        let mut ordered = [0; 8];
        ordered[..bytes.len()].copy_from_slice(bytes);
        if !little {
            ordered[..bytes.len()].reverse();
        }
        let [a, b, c, d, ..] = ordered;
        match self {
            Self::I8 => f64::from(i8::from_le_bytes([a])),
            Self::U8 => f64::from(a),
            Self::I16 => f64::from(i16::from_le_bytes([a, b])),
            Self::U16 => f64::from(u16::from_le_bytes([a, b])),
            Self::I32 => f64::from(i32::from_le_bytes([a, b, c, d])),
            Self::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
            Self::I64 => i64::from_le_bytes(ordered) as f64,
            Self::U64 => u64::from_le_bytes(ordered) as f64,
            Self::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
            Self::F64 => f64::from_le_bytes(ordered),
        }
    }
}

/// What a file of bare numbers does not say itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bare {
    /// Samples along x, y and z.
    pub size: [u32; 3],
    /// What each is.
    pub stored: Stored,
    /// Does the least byte come first?
    pub little: bool,
}

/// What a scene says of a grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Use {
    /// Of a file of bare numbers.
    pub bare: Option<Bare>,
    /// Where its first and its last sample are; as the file says, if the scene does not.
    pub corners: Option<[DVec3; 2]>,
    /// n is the offset and the stored value times this.
    pub scale: f64,
    /// See scale.
    pub offset: f64,
}

/// Numbers and where they belong, as far as a file says.
#[derive(Debug)]
struct Volume {
    bare: Bare,
    /// The first sample's place, and the way to the next.
    place: Option<(DVec3, DVec3)>,
    bytes: Vec<u8>,
    /// The file of the bytes, if the header is in another.
    data: Option<PathBuf>,
}

/// More than 32-bit places could count.
const MOST_SAMPLES: u64 = 1 << 30;

impl IndexGrid {
    /// Reads the samples of a file.
    pub fn load(path: &Path, used: &Use) -> Result<Self, SceneError> {
        Self::read(path, used, &Stage::unwatched())
    }

    /// As [`load`](Self::load); samples are reported to `stage`, whose one unit they are together.
    pub(super) fn read(path: &Path, used: &Use, stage: &Stage) -> Result<Self, SceneError> {
        let bytes = read_bytes(path)?;
        let unusable = |problem: String| SceneError::Grid { path: path.to_owned(), problem };
        let volume = match used.bare {
            Some(bare) => Volume { bare, place: None, bytes, data: None },
            None => nrrd::read(&bytes, path)?,
        };
        Self::from_volume(&volume, used, stage).map_err(unusable)
    }

    /// What it takes of memory.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        size_of_val(&self.samples[..]) as u64
    }

    fn from_volume(volume: &Volume, used: &Use, stage: &Stage) -> Result<Self, String> {
        let Bare { size, stored, little } = volume.bare;
        if size.iter().any(|count| *count < 2) {
            return Err(format!("it has {size:?} samples, and two are needed along each side"));
        }
        let count = count(size).ok_or("it has more than 2^30 samples")?;
        let (found, needed) = (volume.bytes.len(), count * stored.bytes());
        if found != needed {
            return Err(format!(
                "it has {found} bytes of samples, and {size:?} of {} bytes are {needed}",
                stored.bytes()
            ));
        }
        let steps = DVec3::from_array(size.map(|n| f64::from(n - 1)));
        let (origin, cell) = match (used.corners, volume.place) {
            (Some([min, max]), _) => (min, (max - min) / steps),
            (None, Some(place)) => place,
            (None, None) => return Err("it does not say where it is: give min and max".to_owned()),
        };
        let mut samples = Vec::with_capacity(count);
        for (i, bytes) in volume.bytes.chunks_exact(stored.bytes()).enumerate() {
            let value = stored.number(bytes, little);
            let n = (used.offset + used.scale * value) as f32;
            if !(n.is_finite() && n > 0.0) {
                let (nx, ny) = (size[0] as usize, size[1] as usize);
                let place = [i % nx, i / nx % ny, i / nx / ny];
                return Err(format!(
                    "the sample {place:?} (from 0) is {value}, which makes n = {n}: n must be above 0"
                ));
            }
            samples.push(n);
            stage.reach(samples.len() as f64 / count as f64);
        }
        Ok(Self { size, origin, cell, samples, data: volume.data.clone() })
    }
}

/// Samples in all; none if there are too many.
fn count(size: [u32; 3]) -> Option<usize> {
    let count = size.iter().try_fold(1_u64, |all, n| all.checked_mul(u64::from(*n)))?;
    usize::try_from(count).ok().filter(|_| count <= MOST_SAMPLES)
}
