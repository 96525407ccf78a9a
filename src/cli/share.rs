//! `--part`: one of several equal parts of an animation or an image.
//!
//! *Theory.* An animation is divided between its frames if there are enough of them; with more parts than frames, each frame is divided
//! into bands of rows ([`cuts`](crate::render::Renderer::cuts)). The number of a part alone determines its frames and bands, so that
//! machines share the work without communication.

use std::env;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use super::frame_names::path_of;
use super::queue;
pub(super) use super::queue::Share;
use crate::error::Error;

/// The value of `--part`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PartArg {
    /// The number of the part, from 1, and the number of parts.
    Given(u32, u32),
    /// The part that the queue assigns, with the number of parts if the user gave it.
    Auto(Option<u32>),
}

impl FromStr for PartArg {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("expected a part such as 3/64 (from 1), auto/64 or auto, found `{text}`");
        let (number, count) = text.split_once('/').map_or((text, None), |(number, count)| (number, Some(count)));
        let count = count.map(|count| count.parse().ok().filter(|count| *count > 0).ok_or_else(wrong)).transpose()?;
        if number == "auto" {
            return Ok(Self::Auto(count));
        }
        let number = number.parse().ok().filter(|number| count.is_some_and(|count| (1..=count).contains(number)));
        number.zip(count).map(|(number, count)| Self::Given(number, count)).ok_or_else(wrong)
    }
}

/// A band of an image: its index, from 0, and the number of bands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Band {
    pub number: u32,
    pub count: u32,
}

/// The content of an output file, or of several in different formats: an image, a frame, or a band of either.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Target {
    pub frame: Option<u32>,
    pub band: Option<Band>,
}

impl PartArg {
    /// Returns the share that this value denotes.
    pub(super) fn share(self) -> Result<Share, Error> {
        match self {
            Self::Given(number, count) => Ok(Share { number: number - 1, count }),
            Self::Auto(count) => queue::share(&|name| env::var(name).ok(), count).map_err(Error::Usage),
        }
    }
}

impl Share {
    /// Returns the targets of this share of an image, or of the frames of an animation.
    pub(super) fn of(self, frames: &[Option<u32>]) -> Vec<Target> {
        let (all, number, count) = (frames.len() as u64, u64::from(self.number), u64::from(self.count));
        if count <= all {
            let frames = &frames[(number * all / count) as usize..((number + 1) * all / count) as usize];
            return frames.iter().map(|&frame| Target { frame, band: None }).collect();
        }
        let frame = number * all / count;
        let [first, next] = [frame, frame + 1].map(|frame| (frame * count).div_ceil(all));
        let bands = (next - first) as u32;
        let band = (bands > 1).then_some(Band { number: (number - first) as u32, count: bands });
        vec![Target { frame: frames[frame as usize], band }]
    }
}

impl Target {
    /// Returns the file of this target, if the whole animation or image would go to `path`.
    pub(super) fn path(self, path: &Path) -> PathBuf {
        let path = self.frame.map_or_else(|| path.to_owned(), |frame| path_of(path, frame));
        let Some(Band { number, count }) = self.band else { return path };
        let width = count.to_string().len();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        path.with_file_name(format!("{stem}.part-{:0width$}-of-{count}.exr", number + 1))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn parts_are_read() {
        assert_eq!("3/64".parse(), Ok(PartArg::Given(3, 64)));
        assert_eq!("auto".parse(), Ok(PartArg::Auto(None)));
        assert_eq!("auto/12".parse(), Ok(PartArg::Auto(Some(12))));
        for wrong in ["0/3", "4/3", "3", "3/0", "auto/", "x/3", "-1/3", ""] {
            assert!(wrong.parse::<PartArg>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn files_of_parts_have_names_of_their_own() {
        let film = Path::new("a/film_{frame:3}.png");
        let band = Some(Band { number: 2, count: 12 });
        let path = |frame, band| Target { frame, band }.path(film).display().to_string();
        assert_eq!(path(Some(7), None), "a/film_007.png");
        assert_eq!(path(Some(7), band), "a/film_007.part-03-of-12.exr");
        assert_eq!(Target { frame: None, band }.path(Path::new("b.exr")).display().to_string(), "b.part-03-of-12.exr");
    }

    proptest! {
        /// Checks that every frame belongs to exactly one part, whole or in all of its bands.
        #[test]
        fn shares_make_the_whole(frames in 1_u32..40, count in 1_u32..100) {
            let all: Vec<Option<u32>> = (0..frames).map(Some).collect();
            let shares: Vec<Vec<Target>> = (0..count).map(|number| Share { number, count }.of(&all)).collect();
            let sizes: Vec<usize> = shares.iter().map(Vec::len).collect();
            prop_assert!(sizes.iter().max().unwrap() - sizes.iter().min().unwrap() <= 1);
            for &frame in &all {
                let own: Vec<_> = shares.iter().flatten().filter(|target| target.frame == frame).collect();
                match own[0].band {
                    None => prop_assert_eq!(own.len(), 1),
                    Some(Band { count, .. }) => {
                        let numbers: Vec<u32> = own.iter().map(|target| target.band.unwrap().number).collect();
                        prop_assert_eq!(numbers, (0..count).collect::<Vec<_>>());
                    }
                }
            }
        }
    }
}
