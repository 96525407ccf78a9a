//! `--frames`: the frames of an animation to render.
//!
//! *Practice.* The list has inclusive ranges, single frames and steps, separated by commas: `0..47`, `7`, `1,3,5-20:2`, `all:10`. Each
//! frame is rendered once, in ascending order, whatever the order of the list.

use std::ops::RangeInclusive;
use std::str::FromStr;

use crate::error::Error;
use crate::scene::Scene;

/// The value of `--frames`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Frames(Vec<Run>);

/// A sequence of equally spaced frames.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Run {
    /// The first and the last frame; `None` for all.
    ends: Option<RangeInclusive<u32>>,
    step: usize,
}

impl FromStr for Frames {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.split(',').map(|word| word.trim().parse()).collect::<Result<_, _>>().map(Self)
    }
}

impl FromStr for Run {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || {
            format!(
                "expected frames such as 0..47 or 0-47 (inclusive), 12, all, or 0..47:2 for every second frame, \
                 found `{text}`"
            )
        };
        let (frames, step) = text.split_once(':').unwrap_or((text, "1"));
        let step = step.trim().parse().ok().filter(|step| *step > 0).ok_or_else(wrong)?;
        if frames.trim() == "all" {
            return Ok(Self { ends: None, step });
        }
        let (first, last) = frames.split_once("..").or_else(|| frames.split_once('-')).unwrap_or((frames, frames));
        match (first.trim().parse(), last.trim().parse()) {
            (Ok(first), Ok(last)) if first <= last => Ok(Self { ends: Some(first..=last), step }),
            (Ok(first), Ok(last)) => Err(format!("the range `{text}` is descending; use {last}..{first}")),
            _ => Err(wrong()),
        }
    }
}

impl Frames {
    /// Returns the frames of the scene's animation, in ascending order.
    pub(super) fn of(&self, scene: &Scene) -> Result<Vec<u32>, Error> {
        let Some(animation) = &scene.animation else {
            return Err(usage!(
                "--frames requires a scene with [animation], such as `[animation] frames = 24`; see `bentray help \
                 films`"
            ));
        };
        let end = animation.frames - 1;
        let mut frames = Vec::new();
        for Run { ends, step } in &self.0 {
            let run = ends.clone().unwrap_or(0..=end);
            if *run.end() > end {
                let beyond = run.end();
                return Err(usage!("--frames: there is no frame {beyond}; the frames of the scene are 0..{end}"));
            }
            frames.extend(run.step_by(*step));
        }
        frames.sort_unstable();
        frames.dedup();
        Ok(frames)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frames(text: &str) -> Result<Vec<u32>, String> {
        let animation = "[rays]\nbounding_sphere = { radius = 9 }\n[animation]\nframes = 24\n\
                         [[animation.tracks]]\nkey = \"sky.color\"\nvalues = [[0, 0, 0], [1, 1, 1]]\n";
        let scene = Scene::parse(animation, "scene.toml".as_ref(), &[]).map_err(|error| error.to_string())?;
        text.parse::<Frames>()?.of(&scene).map_err(|error| error.to_string())
    }

    #[test]
    fn lists_ranges_and_steps_are_read() {
        let all: Vec<u32> = (0..24).collect();
        assert_eq!(frames("all"), Ok(all.clone()));
        assert_eq!(frames("0..23"), Ok(all.clone()));
        assert_eq!(frames("0-23"), Ok(all));
        assert_eq!(frames("7"), Ok(vec![7]));
        assert_eq!(frames("1,3,5-20:2"), Ok(vec![1, 3, 5, 7, 9, 11, 13, 15, 17, 19]));
        assert_eq!(frames("all:10"), Ok(vec![0, 10, 20]));
        assert_eq!(frames("2..3:9"), Ok(vec![2]));
        // The frames are ascending, each once.
        assert_eq!(frames("9, 3..5, 4..6"), Ok(vec![3, 4, 5, 6, 9]));
    }

    #[test]
    fn what_are_no_frames_is_refused() {
        for wrong in
            ["", "x", "1,", ",1", "1..", "..3", "-3", "1-2-3", "1..5:0", "1..5:x", "1..5:", "1:2:3", "1.5", "all,x"]
        {
            let problem = frames(wrong).unwrap_err();
            assert!(problem.contains("expected frames such as 0..47"), "{wrong}: {problem}");
        }
        assert_eq!(frames("5..3"), Err("the range `5..3` is descending; use 3..5".to_owned()));
        let beyond = "--frames: there is no frame 24; the frames of the scene are 0..23";
        assert_eq!(frames("1,24"), Err(beyond.to_owned()));
        assert!(frames("0-4294967295").is_err());
    }
}
