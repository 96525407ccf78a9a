//! The conversion of linear light to display values: exposure, tone map, sRGB curve.
//!
//! A pixel with a negative, infinite or NaN component indicates an error; it is shown in magenta instead of being clamped to a plausible
//! color. The arithmetic uses `f64`, in which no `f32` overflows.

use std::sync::LazyLock;

use crate::scene::Tonemap;

/// Returns the tone-mapped value, from 0 to 1, of a linear one: clipped at 1, or by Narkowicz's fit of the ACES film curve (2015),
/// `x(2.51x + 0.03) / (x(2.43x + 0.59) + 0.14)`, per channel.
#[must_use]
pub fn tonemapped(tonemap: Tonemap, x: f64) -> f64 {
    let mapped = match tonemap {
        Tonemap::None => x,
        Tonemap::Filmic => x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14),
    };
    mapped.clamp(0.0, 1.0)
}

/// The color of an invalid pixel.
const FAULT: [f64; 3] = [1.0, 0.0, 1.0];

/// Returns the sRGB encoding (IEC 61966-2-1) of a linear value from 0 to 1.
#[must_use]
pub fn srgb_from_linear(x: f64) -> f64 {
    match x {
        // Rounding would miss this value.
        1.0 => 1.0,
        _ if x <= 0.003_130_8 => 12.92 * x,
        _ => 1.055 * x.powf(1.0 / 2.4) - 0.055,
    }
}

/// Returns the linear value, from 0 to 1, of its sRGB encoding.
#[must_use]
pub fn linear_from_srgb(x: f64) -> f64 {
    if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
}

/// Returns the linear display values, from 0 to 1, of a linear color multiplied by `gain`.
#[must_use]
pub fn shown(color: [f32; 3], gain: f64, tonemap: Tonemap) -> [f64; 3] {
    if color.iter().any(|c| !c.is_finite() || *c < 0.0) {
        return FAULT;
    }
    color.map(|c| tonemapped(tonemap, f64::from(c) * gain))
}

/// Returns the sRGB display values, from 0 to 1.
#[must_use]
pub fn display(color: [f32; 3], gain: f64, tonemap: Tonemap) -> [f64; 3] {
    shown(color, gain, tonemap).map(srgb_from_linear)
}

/// The rounded 8-bit sRGB encoding, identical to [`srgb_from_linear`], by a table instead of a power.
///
/// The curve is steepest at 0, where its slope of 12.92 · 255 is less than the number of cells: no cell contains more than one threshold of
/// the rounded value.
pub struct SrgbBytes {
    /// The byte at the lower end of each cell.
    byte: Vec<u8>,
    /// The least value of each byte.
    from: [f64; 257],
}

impl SrgbBytes {
    const CELLS: usize = 4096;

    /// Returns the table, which is created on first use.
    #[must_use]
    pub fn table() -> &'static Self {
        static TABLE: LazyLock<SrgbBytes> = LazyLock::new(SrgbBytes::new);
        &TABLE
    }

    fn new() -> Self {
        let byte = |x: f64| (srgb_from_linear(x) * 255.0).round();
        let mut from = [f64::INFINITY; 257];
        from[0] = 0.0;
        for k in 1..=255_u8 {
            // The bits of non-negative floats are in the order of their values.
            let (mut below, mut above) = (0_u64, 1.0_f64.to_bits());
            while above - below > 1 {
                let middle = below.midpoint(above);
                *(if byte(f64::from_bits(middle)) < f64::from(k) { &mut below } else { &mut above }) = middle;
            }
            from[usize::from(k)] = f64::from_bits(above);
        }
        let cells = (0..=Self::CELLS).map(|cell| byte(cell as f64 / Self::CELLS as f64) as u8).collect();
        Self { byte: cells, from }
    }

    /// Returns the byte of a linear value from 0 to 1.
    #[must_use]
    pub fn of(&self, x: f64) -> u8 {
        let lower = self.byte[(x * Self::CELLS as f64) as usize];
        lower + u8::from(x >= self.from[usize::from(lower) + 1])
    }
}
