//! `--part`: one of so many equal parts of a film or a picture.
//!
//! *Theory.* A film is cut between its frames as long as there are enough of them; more parts than frames cut each frame into bands of rows
//! ([`cuts`](crate::render::Renderer::cuts)). Which frames and bands a part has follows from its number alone, so that machines which
//! know nothing of each other share the work.
//!
//! *Practice.* Queues of jobs tell each job its number in an environment variable of their own. Some count from 0, and only some say how
//! many jobs there are.

use std::env;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use super::frames::path_of;
use crate::error::Error;

/// `--part` as it was given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// The number, from 1, and how many there are.
    Given(u32, u32),
    /// As the queue says, which may not say how many.
    Auto(Option<u32>),
}

/// A queue's variables.
struct Queue {
    name: &'static str,
    number: &'static str,
    /// The first number, where jobs may be counted from any.
    first: First,
    /// How many jobs there are.
    count: Count,
}

enum First {
    Always(u32),
    In(&'static str),
}

enum Count {
    Unsaid,
    In(&'static str),
    /// The number of the last job.
    Last(&'static str),
}

/// In the order in which they are looked for.
const QUEUES: [Queue; 6] = [
    Queue {
        name: "Slurm",
        number: "SLURM_ARRAY_TASK_ID",
        first: First::In("SLURM_ARRAY_TASK_MIN"),
        count: Count::Last("SLURM_ARRAY_TASK_MAX"),
    },
    Queue { name: "Kubernetes", number: "JOB_COMPLETION_INDEX", first: First::Always(0), count: Count::Unsaid },
    Queue {
        name: "AWS Batch",
        number: "AWS_BATCH_JOB_ARRAY_INDEX",
        first: First::Always(0),
        count: Count::In("AWS_BATCH_JOB_ARRAY_SIZE"),
    },
    Queue { name: "PBS", number: "PBS_ARRAY_INDEX", first: First::Always(1), count: Count::Unsaid },
    Queue {
        name: "SGE",
        number: "SGE_TASK_ID",
        first: First::In("SGE_TASK_FIRST"),
        count: Count::Last("SGE_TASK_LAST"),
    },
    Queue { name: "GNU parallel", number: "PARALLEL_SEQ", first: First::Always(1), count: Count::Unsaid },
];

impl FromStr for Part {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("`{text}` is no part such as 3/64 (from 1), auto/64 or auto");
        let (number, count) = text.split_once('/').map_or((text, None), |(number, count)| (number, Some(count)));
        let count = count.map(|count| count.parse().ok().filter(|count| *count > 0).ok_or_else(wrong)).transpose()?;
        if number == "auto" {
            return Ok(Self::Auto(count));
        }
        let number = number.parse().ok().filter(|number| count.is_some_and(|count| (1..=count).contains(number)));
        number.zip(count).map(|(number, count)| Self::Given(number, count)).ok_or_else(wrong)
    }
}

/// Part `number`, from 0, of `count`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Share {
    pub number: u32,
    pub count: u32,
}

/// A band of a picture: which, from 0, of how many.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Band {
    pub number: u32,
    pub count: u32,
}

/// What one file shows, or several of different formats: a picture or a frame, or a band of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Target {
    pub frame: Option<u32>,
    pub band: Option<Band>,
}

impl Part {
    /// Which part it is.
    pub(super) fn share(self) -> Result<Share, Error> {
        match self {
            Self::Given(number, count) => Ok(Share { number: number - 1, count }),
            Self::Auto(count) => of_queue(&|name| env::var(name).ok(), count).map_err(Error::Usage),
        }
    }
}

/// From the variables of whichever queue there is.
fn of_queue(variable: &dyn Fn(&str) -> Option<String>, asked: Option<u32>) -> Result<Share, String> {
    let number = |name: &str| variable(name).and_then(|text| text.parse::<u32>().ok());
    let Some((queue, own)) = QUEUES.iter().find_map(|queue| Some((queue, number(queue.number)?))) else {
        let names: Vec<_> = QUEUES.iter().map(|queue| format!("{} ({})", queue.number, queue.name)).collect();
        return Err(format!("--part auto: none of these variables is set: {}; or write --part 3/64", names.join(", ")));
    };
    // With the number of parts given, a job may be one of a few that are run again: queues then begin anywhere, and parts count from 1.
    let first = match queue.first {
        First::Always(first) => first,
        First::In(_) if asked.is_some() => 1,
        First::In(name) => number(name).unwrap_or(1),
    };
    let said = match queue.count {
        Count::Unsaid => None,
        Count::In(name) => number(name),
        Count::Last(name) => number(name).map(|last| (last + 1).saturating_sub(first)),
    };
    let (name, variable) = (queue.name, queue.number);
    let count = asked.or(said).ok_or_else(|| {
        format!("--part auto: {name} does not say how many parts there are: write --part auto/64, with their number")
    })?;
    let own_number = own.checked_sub(first).filter(|number| *number < count);
    let share = own_number.map(|number| Share { number, count });
    share.ok_or_else(|| {
        let last = first + count - 1;
        format!("--part auto: {variable} is {own}, and {count} parts are counted from {first} to {last}")
    })
}

impl Share {
    /// What the part has of a picture, or of a film's frames.
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
    /// Its file, where all of a film or a picture would go to `path`.
    pub(super) fn path(self, path: &Path) -> PathBuf {
        let path = self.frame.and_then(|frame| path_of(path, frame)).unwrap_or_else(|| path.to_owned());
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
        assert_eq!("3/64".parse(), Ok(Part::Given(3, 64)));
        assert_eq!("auto".parse(), Ok(Part::Auto(None)));
        assert_eq!("auto/12".parse(), Ok(Part::Auto(Some(12))));
        for wrong in ["0/3", "4/3", "3", "3/0", "auto/", "x/3", "-1/3", ""] {
            assert!(wrong.parse::<Part>().is_err(), "{wrong}");
        }
    }

    fn auto(set: &[(&str, u32)], asked: Option<u32>) -> Result<(u32, u32), String> {
        let set: Vec<(String, String)> = set.iter().map(|(k, v)| ((*k).to_owned(), v.to_string())).collect();
        let variable = move |name: &str| set.iter().find(|(key, _)| key == name).map(|(_, value)| value.clone());
        of_queue(&variable, asked).map(|share| (share.number, share.count))
    }

    #[test]
    fn queues_tell_the_part() {
        let slurm =
            |id, min, max| [("SLURM_ARRAY_TASK_ID", id), ("SLURM_ARRAY_TASK_MIN", min), ("SLURM_ARRAY_TASK_MAX", max)];
        assert_eq!(auto(&slurm(3, 1, 64), None), Ok((2, 64)));
        assert_eq!(auto(&slurm(3, 0, 63), None), Ok((3, 64)));
        // Two parts that failed are run again.
        assert_eq!(auto(&slurm(9, 3, 9), Some(64)), Ok((8, 64)));
        assert_eq!(auto(&[("JOB_COMPLETION_INDEX", 0)], Some(5)), Ok((0, 5)));
        assert!(auto(&[("JOB_COMPLETION_INDEX", 0)], None).unwrap_err().contains("write --part auto/64"));
        let batch = [("AWS_BATCH_JOB_ARRAY_INDEX", 4), ("AWS_BATCH_JOB_ARRAY_SIZE", 5)];
        assert_eq!(auto(&batch, None), Ok((4, 5)));
        assert_eq!(auto(&[("PBS_ARRAY_INDEX", 5)], Some(5)), Ok((4, 5)));
        assert!(auto(&[("PBS_ARRAY_INDEX", 6)], Some(5)).unwrap_err().contains("from 1 to 5"));
        assert!(auto(&[], None).unwrap_err().contains("SGE_TASK_ID (SGE)"));
        let sge = [("SGE_TASK_ID", 2), ("SGE_TASK_FIRST", 1), ("SGE_TASK_LAST", 2)];
        assert_eq!(auto(&sge, None), Ok((1, 2)));
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
        /// Every frame is somebody's, whole or in all of its bands, and nobody else's.
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
