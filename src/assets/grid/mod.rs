//! Grids: samples on a regular grid, from NRRD files or from raw numbers: a refractive index, or quantities of matter.
//!
//! *Practice.* Samples are at the grid points, x fastest. Stored values are converted by a factor and an offset when they are read, and are
//! stored in 32 bits, 4 bytes per sample.

mod nrrd;
#[cfg(test)]
mod tests;

use crate::document::{SceneError, read_bytes};
use crate::progress::Stage;
use glam::DVec3;
use std::path::{Path, PathBuf};

/// Samples of a function of position.
#[derive(Debug, Clone, PartialEq)]
pub struct SampledGrid {
    /// The number of samples along x, y and z; 2 or more.
    pub size: [u32; 3],
    /// The position of the first sample, in scene units.
    pub origin: DVec3,
    /// The distance between samples along x, y and z, in scene units.
    pub cell: DVec3,
    /// The value at each point; x fastest, then y.
    pub samples: Vec<f32>,
    /// The file with the samples, if it is not the header's.
    pub data: Option<PathBuf>,
}

/// The number type of stored samples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stored {
    /// A signed 8-bit integer.
    I8,
    /// An unsigned 8-bit integer.
    U8,
    /// A signed 16-bit integer.
    I16,
    /// An unsigned 16-bit integer.
    U16,
    /// A signed 32-bit integer.
    I32,
    /// An unsigned 32-bit integer.
    U32,
    /// A signed 64-bit integer.
    I64,
    /// An unsigned 64-bit integer.
    U64,
    /// A 32-bit floating-point number.
    F32,
    /// A 64-bit floating-point number.
    F64,
}

impl Stored {
    /// The types with their names in a scene.
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

    /// Returns the size of a number in bytes.
    pub(super) fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// Decodes a number from its bytes; `little` is `true` for little-endian order.
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

/// The format of a file of raw numbers, which the file itself does not specify.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RawGridLayout {
    /// The number of samples along x, y and z.
    pub size: [u32; 3],
    /// The type of the numbers.
    pub stored: Stored,
    /// Whether the byte order is little-endian.
    pub little: bool,
}

/// The use of a grid in a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GridUse {
    /// The format of a file of raw numbers.
    pub bare: Option<RawGridLayout>,
    /// The positions of the first and the last sample; `None` to use the file's.
    pub corners: Option<[DVec3; 2]>,
    /// The factor of stored values: a sample is offset + scale · value.
    pub scale: f64,
    /// The offset of samples, see `scale`.
    pub offset: f64,
    /// Is `true` for a refractive index, which must be above 0.
    pub is_index: bool,
}

/// Stored numbers, with their position if the file specifies it.
#[derive(Debug)]
struct Volume {
    bare: RawGridLayout,
    /// The position of the first sample, and the distance to the next.
    place: Option<(DVec3, DVec3)>,
    bytes: Vec<u8>,
    /// The file with the bytes, if it is not the header's.
    data: Option<PathBuf>,
}

/// The largest number of samples; 32-bit indices could not count more.
const MOST_SAMPLES: u64 = 1 << 30;

impl SampledGrid {
    /// Reads the samples of a file.
    ///
    /// # Errors
    ///
    /// Returns [`SceneError::Read`] if the file cannot be read, and [`SceneError::Grid`] if its samples do not fit `used`, have no known
    /// position, are not finite, or make an index that is not above 0.
    pub fn load(path: &Path, used: &GridUse) -> Result<Self, SceneError> {
        Self::read(path, used, &Stage::unwatched())
    }

    /// Reads the samples of a file as [`load`](Self::load) does, and reports its progress to `stage`; all samples together are one unit.
    pub(super) fn read(path: &Path, used: &GridUse, stage: &Stage) -> Result<Self, SceneError> {
        let bytes = read_bytes(path)?;
        let unusable = |problem: String| SceneError::Grid { path: path.to_owned(), problem };
        let volume = match used.bare {
            Some(bare) => Volume { bare, place: None, bytes, data: None },
            None => nrrd::read(&bytes, path)?,
        };
        Self::from_volume(&volume, used, stage).map_err(unusable)
    }

    /// Returns the position of the last sample, in scene units.
    #[must_use]
    pub fn end(&self) -> DVec3 {
        self.origin + self.cell * DVec3::from_array(self.size.map(|n| f64::from(n - 1)))
    }

    /// Returns the value at a position, trilinear between the samples and 0 outside the grid.
    #[must_use]
    pub fn value(&self, x: DVec3) -> f64 {
        let p = (x - self.origin) / self.cell;
        let last = DVec3::from_array(self.size.map(|n| f64::from(n - 1)));
        if p.cmplt(DVec3::ZERO).any() || p.cmpgt(last).any() {
            return 0.0;
        }
        let base = p.floor().min(last - 1.0);
        let part = p - base;
        let first = base.to_array().map(|at| at as usize);
        let [width, height, _] = self.size.map(|n| n as usize);
        let corner = |c: usize| {
            let steps = [c & 1, c >> 1 & 1, c >> 2];
            let weight = |axis: usize| if steps[axis] == 1 { part[axis] } else { 1.0 - part[axis] };
            let at = [0, 1, 2].map(|axis| first[axis] + steps[axis]);
            weight(0) * weight(1) * weight(2) * f64::from(self.samples[at[0] + width * (at[1] + height * at[2])])
        };
        (0..8).map(corner).sum()
    }

    /// Returns the memory that the grid takes, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        size_of_val(&self.samples[..]) as u64
    }

    fn from_volume(volume: &Volume, used: &GridUse, stage: &Stage) -> Result<Self, String> {
        let RawGridLayout { size, stored, little } = volume.bare;
        if size.iter().any(|count| *count < 2) {
            return Err(format!("the grid has {size:?} samples, and at least two are required along each axis"));
        }
        let count = count(size).ok_or("the grid has more than 2^30 samples")?;
        let (found, needed) = (volume.bytes.len(), count * stored.bytes());
        if found != needed {
            return Err(format!(
                "the file has {found} bytes of samples, and {size:?} samples of {} bytes require {needed}",
                stored.bytes()
            ));
        }
        let steps = DVec3::from_array(size.map(|n| f64::from(n - 1)));
        let (origin, cell) = match (used.corners, volume.place) {
            (Some([min, max]), _) => (min, (max - min) / steps),
            (None, Some(place)) => place,
            (None, None) => return Err("the position of the grid is unknown: give `min` and `max`".to_owned()),
        };
        let mut samples = Vec::with_capacity(count);
        for (i, bytes) in volume.bytes.chunks_exact(stored.bytes()).enumerate() {
            let value = stored.number(bytes, little);
            let n = (used.offset + used.scale * value) as f32;
            if !n.is_finite() || used.is_index && n <= 0.0 {
                let (nx, ny) = (size[0] as usize, size[1] as usize);
                let place = [i % nx, i / nx % ny, i / nx / ny];
                let wrong = if used.is_index { "n = " } else { "" };
                let right = if used.is_index { "above 0" } else { "finite" };
                return Err(format!(
                    "sample {place:?}, counted from 0, is {value} and makes {wrong}{n}, which must be {right}"
                ));
            }
            samples.push(n);
            stage.reach(samples.len() as f64 / count as f64);
        }
        Ok(Self { size, origin, cell, samples, data: volume.data.clone() })
    }
}

/// Returns the total number of samples; `None` if there are too many.
fn count(size: [u32; 3]) -> Option<usize> {
    let count = size.iter().try_fold(1_u64, |all, n| all.checked_mul(u64::from(*n)))?;
    usize::try_from(count).ok().filter(|_| count <= MOST_SAMPLES)
}
