//! From linear light to what a screen shows: exposure, tone map, the sRGB curve.
//!
//! A pixel with a component that is negative, infinite or not a number is the mark of a fault somewhere; it is shown
//! in magenta rather than clamped to look like the others. The arithmetic is in `f64`, where no `f32` overflows.

use std::sync::LazyLock;

use crate::scene::Tonemap;

/// The mapped value of a linear one, from 0 to 1: cut off at 1, or bent by Narkowicz's fit of the ACES film curve (2015),
/// `x(2.51x + 0.03) / (x(2.43x + 0.59) + 0.14)`, per channel.
#[must_use]
pub fn tonemapped(tonemap: Tonemap, x: f64) -> f64 {
    let mapped = match tonemap {
        Tonemap::None => x,
        Tonemap::Filmic => x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14),
    };
    mapped.clamp(0.0, 1.0)
}

/// What is shown for a pixel that cannot be right.
const FAULT: [f64; 3] = [1.0, 0.0, 1.0];

/// The sRGB encoding (IEC 61966-2-1) of a linear value from 0 to 1.
#[must_use]
pub fn srgb_from_linear(x: f64) -> f64 {
    match x {
        // Which rounding would miss.
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

/// The linear values, from 0 to 1, that are shown of a linear color multiplied by `gain`.
#[must_use]
pub fn shown(color: [f32; 3], gain: f64, tonemap: Tonemap) -> [f64; 3] {
    if color.iter().any(|c| !c.is_finite() || *c < 0.0) {
        return FAULT;
    }
    color.map(|c| tonemapped(tonemap, f64::from(c) * gain))
}

/// Their sRGB values, from 0 to 1.
#[must_use]
pub fn display(color: [f32; 3], gain: f64, tonemap: Tonemap) -> [f64; 3] {
    shown(color, gain, tonemap).map(srgb_from_linear)
}

/// The sRGB encoding in whole numbers of 8 bits, rounded: to the bit what [`srgb_from_linear`] has, by a table in place of its power.
///
/// The curve is steepest at 0, where it rises by 12.92 · 255, less than the table has cells: no cell has more than one of the places
/// where the rounded value changes.
pub struct SrgbBytes {
    /// The byte of each cell's lower end.
    byte: Vec<u8>,
    /// The least value of each byte.
    from: [f64; 257],
}

impl SrgbBytes {
    const CELLS: usize = 4096;

    /// The table, which is made when it is first asked for.
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
            // Between two numbers side by side the bits of non-negative floats are in order.
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

    /// The byte of a linear value from 0 to 1.
    #[must_use]
    pub fn of(&self, x: f64) -> u8 {
        let lower = self.byte[(x * Self::CELLS as f64) as usize];
        lower + u8::from(x >= self.from[usize::from(lower) + 1])
    }
}
