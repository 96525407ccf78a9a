//! From launch to the first pixel: what a start took, part by part.

use std::fmt;
use std::time::{Duration, Instant};

/// A part of a start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StartPart {
    /// Reading and checking the scene.
    Scene,
    /// Opening the device.
    Device,
    /// Linking and compiling the program, and uploading the scene.
    Program,
    /// Searching for a method, where the scene leaves it open.
    Method,
    /// Rendering the first rows.
    FirstPicture,
}

/// What the parts of a start took.
#[derive(Debug, Clone, PartialEq)]
pub struct StartUp {
    last: Instant,
    took: [Duration; Self::PARTS.len()],
    is_complete: bool,
}

impl Default for StartUp {
    /// Launched now.
    fn default() -> Self {
        Self { last: Instant::now(), took: [Duration::ZERO; Self::PARTS.len()], is_complete: false }
    }
}

impl StartUp {
    /// The parts, in order.
    pub const PARTS: [&'static str; 5] = ["scene", "device", "program", "method", "first picture"];

    /// Counts the time since the last call for this part, which may have had some before.
    pub fn count(&mut self, part: StartPart) {
        let now = Instant::now();
        self.took[part as usize] += now - self.last;
        self.last = now;
        self.is_complete |= part == StartPart::FirstPicture;
    }

    /// Is the first picture there?
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// What each part took.
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
            "first pixel after 1.250 s: scene 0.250, device 0.250, program 0.250, method 0.250, first picture 0.250";
        assert_eq!(launch.to_string(), said);
        assert_eq!(launch.parts().last(), Some(("first picture", Duration::from_millis(250))));
    }
}
