//! From launch to the first pixel: what a start took, part by part.

use std::fmt;
use std::time::{Duration, Instant};

/// What the parts of a start took.
#[derive(Debug, Clone, PartialEq)]
pub struct StartUp {
    last: Instant,
    parts: Vec<Duration>,
}

impl Default for StartUp {
    /// Launched now.
    fn default() -> Self {
        Self { last: Instant::now(), parts: Vec::new() }
    }
}

impl StartUp {
    /// The parts, in order.
    pub const PARTS: [&'static str; 5] = ["scene", "device", "method", "program", "first picture"];

    /// The next part is done.
    pub fn next(&mut self) {
        let now = Instant::now();
        self.parts.push(now - self.last);
        self.last = now;
    }

    /// Are all of them?
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.parts.len() >= Self::PARTS.len()
    }

    /// What each of those took that are done.
    pub fn parts(&self) -> impl Iterator<Item = (&'static str, Duration)> {
        Self::PARTS.into_iter().zip(self.parts.iter().copied())
    }
}

impl fmt::Display for StartUp {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "first pixel after {:.3} s", self.parts.iter().sum::<Duration>().as_secs_f64())?;
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
        for _ in StartUp::PARTS {
            assert!(!launch.is_complete());
            launch.next();
        }
        launch.parts = vec![Duration::from_millis(250); StartUp::PARTS.len()];
        assert!(launch.is_complete());
        let said =
            "first pixel after 1.250 s: scene 0.250, device 0.250, method 0.250, program 0.250, first picture 0.250";
        assert_eq!(launch.to_string(), said);
        assert_eq!(launch.parts().last(), Some(("first picture", Duration::from_millis(250))));
    }
}
