//! From launch to the first pixel: what a start took, part by part, and the line that says so.

use std::fmt;
use std::time::{Duration, Instant};

/// How a line that says them begins.
const WORDS: &str = "first pixel after ";

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

    /// The seconds of a line that it wrote: the whole, then its parts.
    #[must_use]
    pub fn read(line: &str) -> Option<Vec<f64>> {
        let (whole, parts) = line.strip_prefix(WORDS)?.split_once(" s:")?;
        let part = |part: &str| part.rsplit_once(' ')?.1.parse().ok();
        let parts: Vec<f64> = parts.split(',').map(part).collect::<Option<_>>()?;
        (parts.len() == Self::PARTS.len()).then(|| [vec![whole.parse().unwrap_or(f64::NAN)], parts].concat())
    }
}

impl fmt::Display for StartUp {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{WORDS}{:.3} s", self.parts.iter().sum::<Duration>().as_secs_f64())?;
        for (i, (name, time)) in Self::PARTS.iter().zip(&self.parts).enumerate() {
            write!(f, "{} {name} {:.3}", if i == 0 { ":" } else { "," }, time.as_secs_f64())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_says_what_can_be_read_back() {
        let mut launch = StartUp::default();
        for _ in StartUp::PARTS {
            assert!(!launch.is_complete());
            launch.next();
        }
        launch.parts = vec![Duration::from_millis(250); StartUp::PARTS.len()];
        assert!(launch.is_complete());
        assert_eq!(StartUp::read(&launch.to_string()), Some(vec![1.25, 0.25, 0.25, 0.25, 0.25, 0.25]));
        assert_eq!(StartUp::read("first pixel after a while: scene 1"), None);
    }
}
