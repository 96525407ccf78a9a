//! Measures the time from launch to the first pixel, part by part.

use std::fmt;
use std::time::{Duration, Instant};

/// A part of the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StartPart {
    /// Reading and checking the scene.
    Scene,
    /// Opening the device.
    Device,
    /// Linking and compiling the program, and uploading the scene.
    Program,
    /// Searching for a method, if the scene leaves it open.
    Method,
    /// Rendering the first rows.
    FirstPicture,
}

/// The durations of the parts of a start.
#[derive(Debug, Clone, PartialEq)]
pub struct StartUp {
    last: Instant,
    took: [Duration; Self::PARTS.len()],
    is_complete: bool,
}

impl Default for StartUp {
    /// Starts measuring now.
    fn default() -> Self {
        Self { last: Instant::now(), took: [Duration::ZERO; Self::PARTS.len()], is_complete: false }
    }
}

impl StartUp {
    /// The names of the parts, in order.
    pub const PARTS: [&'static str; 5] = ["scene", "device", "program", "method", "first image"];

    /// Adds the time since the last call to this part.
    pub fn count(&mut self, part: StartPart) {
        let now = Instant::now();
        self.took[part as usize] += now - self.last;
        self.last = now;
        self.is_complete |= part == StartPart::FirstPicture;
    }

    /// Returns `true` if the first rows are rendered.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// Returns the name and the duration of each part.
    pub fn parts(&self) -> impl Iterator<Item = (&'static str, Duration)> {
        Self::PARTS.into_iter().zip(self.took)
    }
}

impl fmt::Display for StartUp {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "first pixel after {:.3} s", self.took.iter().sum::<Duration>().as_secs_f64())?;
        for (i, (name, time)) in self.parts().enumerate() {
            write!(f, "{} {name} {:.3}", if i == 0 { ":" } else { "," }, time.as_secs_f64())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_says_what_its_parts_took() {
        let mut launch = StartUp::default();
        for part in [StartPart::Scene, StartPart::Device, StartPart::Program, StartPart::Method, StartPart::Program] {
            launch.count(part);
            assert!(!launch.is_complete());
        }
        launch.count(StartPart::FirstPicture);
        assert!(launch.is_complete());
        launch.took = [Duration::from_millis(250); StartUp::PARTS.len()];
        let said =
            "first pixel after 1.250 s: scene 0.250, device 0.250, program 0.250, method 0.250, first image 0.250";
        assert_eq!(launch.to_string(), said);
        assert_eq!(launch.parts().last(), Some(("first image", Duration::from_millis(250))));
    }
}
