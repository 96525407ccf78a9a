//! `--part auto`: the part that a job queue assigns to this job.
//!
//! *Practice.* Each queue gives its jobs their number in a different environment variable. Some count from 0, some from any number and in
//! any steps, and only some give the number of jobs. The variables of a queue are either all used or rejected: otherwise a part that no
//! job renders would be missing without an error.
/// Part `number`, from 0, of `count`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Share {
    pub number: u32,
    pub count: u32,
}

/// The environment variables of a queue.
struct Queue {
    name: &'static str,
    /// The variable with the number of this job.
    number: &'static str,
    numbers: Numbers,
}

/// The numbering of jobs in a queue.
enum Numbers {
    /// Consecutive numbers from this one, with the variable for their count, if there is one.
    From(u32, Option<&'static str>),
    /// Numbers that the user chooses.
    Asked { first: &'static str, last: &'static str, step: &'static str, count: Option<&'static str> },
}

const QUEUES: [Queue; 7] = [
    Queue::asked(
        "Slurm",
        "SLURM_ARRAY_TASK_ID",
        ["SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX", "SLURM_ARRAY_TASK_STEP"],
        Some("SLURM_ARRAY_TASK_COUNT"),
    ),
    Queue::from("Kubernetes", "JOB_COMPLETION_INDEX", 0, None),
    Queue::from("AWS Batch", "AWS_BATCH_JOB_ARRAY_INDEX", 0, Some("AWS_BATCH_JOB_ARRAY_SIZE")),
    Queue::from("PBS", "PBS_ARRAY_INDEX", 1, None),
    Queue::from("Torque", "PBS_ARRAYID", 1, None),
    Queue::asked("SGE", "SGE_TASK_ID", ["SGE_TASK_FIRST", "SGE_TASK_LAST", "SGE_TASK_STEPSIZE"], None),
    Queue::from("GNU parallel", "PARALLEL_SEQ", 1, None),
];

/// A function that returns the value of an environment variable.
type Variables<'a> = &'a dyn Fn(&str) -> Option<String>;

/// Returns the part of this job, from the variables of its queue; `asked` is the number of parts, if the user gave it.
pub(super) fn share(variables: Variables, asked: Option<u32>) -> Result<Share, String> {
    let mut there = Vec::new();
    for queue in &QUEUES {
        there.extend(number(variables, queue.number)?.map(|own| (queue, own)));
    }
    match there[..] {
        [(queue, own)] => queue.share(own, variables, asked).map_err(|problem| format!("--part auto: {problem}")),
        [] => {
            let names: Vec<_> = QUEUES.iter().map(Queue::named).collect();
            Err(format!("--part auto requires one of the variables {}; or use --part 3/64", names.join(", ")))
        }
        _ => {
            let names: Vec<_> = there.iter().map(|(queue, _)| queue.named()).collect();
            Err(format!("--part auto: {} disagree about the number of this job; use --part 3/64", names.join(" and ")))
        }
    }
}

/// Returns the number in a variable; `None` if the variable is unset, or has the value that SGE sets outside an array.
fn number(variables: Variables, name: &str) -> Result<Option<u32>, String> {
    let Some(text) = variables(name).filter(|text| !text.is_empty() && text != "undefined") else { return Ok(None) };
    text.trim().parse().map(Some).map_err(|_| format!("--part auto: expected a whole number in {name}, found `{text}`"))
}

impl Queue {
    const fn from(name: &'static str, number: &'static str, first: u32, size: Option<&'static str>) -> Self {
        Self { name, number, numbers: Numbers::From(first, size) }
    }

    const fn asked(
        name: &'static str,
        number: &'static str,
        [first, last, step]: [&'static str; 3],
        count: Option<&'static str>,
    ) -> Self {
        Self { name, number, numbers: Numbers::Asked { first, last, step, count } }
    }

    fn named(&self) -> String {
        format!("{} ({})", self.number, self.name)
    }

    fn share(&self, own: u32, variables: Variables, asked: Option<u32>) -> Result<Share, String> {
        let name = self.name;
        let unsaid = || format!("{name} does not provide the number of parts; use --part auto/64 with their number");
        match self.numbers {
            Numbers::From(first, size) => {
                let size = size.map_or(Ok(None), |size| number(variables, size))?;
                if let Some((size, asked)) = size.zip(asked).filter(|(size, asked)| size != asked) {
                    return Err(format!("{name} runs {size} jobs, but {asked} parts are requested; use --part auto"));
                }
                self.counted(own, first, asked.or(size).ok_or_else(unsaid)?)
            }
            Numbers::Asked { first, last, step, count } => {
                let [first, last, step] = [first, last, step].map(|name| number(variables, name));
                let (first, last, step) = (first?, last?, step?.unwrap_or(1).max(1));
                if let Some(parts) = asked {
                    // Some parts may run again, so each job has the number of its part. Every job checks the numbers of all.
                    let mut all = [first, last, Some(own)].into_iter().flatten();
                    return all
                        .try_fold(None, |_, one| self.counted(one, 1, parts).map(Some))
                        .and_then(|own| own.ok_or_else(unsaid));
                }
                let first = first.unwrap_or(1);
                let last = last.ok_or_else(unsaid)?;
                let (length, said) =
                    (last.saturating_sub(first), count.map_or(Ok(None), |count| number(variables, count))?);
                let jobs = (length / step).saturating_add(1);
                // If the queue gives a count, the last job ends the range; otherwise the end may be between two numbers.
                let is_range = said.is_none_or(|said| said == jobs && length % step == 0);
                let said = said.unwrap_or(jobs);
                let place = own.checked_sub(first).filter(|offset| offset % step == 0).map(|offset| offset / step);
                match place.filter(|place| is_range && *place < jobs) {
                    Some(number) => Ok(Share { number, count: jobs }),
                    None => Err(format!(
                        "{name} reports {said} jobs from {first} to {last} in steps of {step}, and this job is \
                         {own}, so its position is unknown; number the jobs from 1 to {said}, or use --part 3/64, or \
                         --part auto/64 if the jobs have the numbers of the parts, from 1"
                    )),
                }
            }
        }
    }

    /// Returns the part of job `own`, if `count` jobs are numbered consecutively from `first`.
    fn counted(&self, own: u32, first: u32, count: u32) -> Result<Share, String> {
        let number = own.checked_sub(first).filter(|number| *number < count);
        number.map(|number| Share { number, count }).ok_or_else(|| {
            let last = u64::from(first) + u64::from(count) - 1;
            format!(
                "{} has a job with the number {own} ({}), but the {count} parts are numbered from {first} to {last}",
                self.name, self.number
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn auto(set: &[(&str, u32)], asked: Option<u32>) -> Result<(u32, u32), String> {
        let variable = |name: &str| set.iter().find(|(key, _)| *key == name).map(|(_, value)| value.to_string());
        share(&variable, asked).map(|share| (share.number, share.count))
    }

    /// Returns the variables that Slurm sets in task `id` of an array with these numbers and this step.
    fn slurm(id: u32, ids: &[u32], step: u32) -> [(&'static str, u32); 5] {
        [
            ("SLURM_ARRAY_TASK_ID", id),
            ("SLURM_ARRAY_TASK_MIN", ids[0]),
            ("SLURM_ARRAY_TASK_MAX", ids[ids.len() - 1]),
            ("SLURM_ARRAY_TASK_COUNT", ids.len() as u32),
            ("SLURM_ARRAY_TASK_STEP", step),
        ]
    }

    fn sge(id: u32, first: u32, last: u32, step: u32) -> [(&'static str, u32); 4] {
        [("SGE_TASK_ID", id), ("SGE_TASK_FIRST", first), ("SGE_TASK_LAST", last), ("SGE_TASK_STEPSIZE", step)]
    }

    #[test]
    fn queues_tell_the_part() {
        let few = [("SLURM_ARRAY_TASK_ID", 3), ("SLURM_ARRAY_TASK_MIN", 1), ("SLURM_ARRAY_TASK_MAX", 64)];
        assert_eq!(auto(&few, None), Ok((2, 64)));
        assert_eq!(auto(&[("JOB_COMPLETION_INDEX", 0)], Some(5)), Ok((0, 5)));
        assert!(auto(&[("JOB_COMPLETION_INDEX", 0)], None).unwrap_err().contains("use --part auto/64"));
        let batch = [("AWS_BATCH_JOB_ARRAY_INDEX", 4), ("AWS_BATCH_JOB_ARRAY_SIZE", 5)];
        assert_eq!(auto(&batch, None), Ok((4, 5)));
        assert_eq!(auto(&batch, Some(5)), Ok((4, 5)));
        assert!(auto(&batch, Some(9)).unwrap_err().contains("runs 5 jobs, but 9 parts are requested"));
        assert_eq!(auto(&[("PBS_ARRAY_INDEX", 5)], Some(5)), Ok((4, 5)));
        assert!(auto(&[("PBS_ARRAY_INDEX", 6)], Some(5)).unwrap_err().contains("from 1 to 5"));
        assert_eq!(auto(&[("PBS_ARRAYID", 5)], Some(5)), Ok((4, 5)));
        assert!(auto(&[], None).unwrap_err().contains("SGE_TASK_ID (SGE)"));
        assert_eq!(auto(&sge(2, 1, 2, 1), None), Ok((1, 2)));
    }

    #[test]
    fn parts_that_are_run_again_are_numbered_as_before() {
        assert_eq!(auto(&slurm(9, &[3, 9], 1), Some(64)), Ok((8, 64)));
        assert_eq!(auto(&sge(9, 3, 9, 3), Some(64)), Ok((8, 64)));
        // Every job rejects an array that is counted from 0, so that no part is left out while all jobs succeed.
        for id in 0..4 {
            let problem = auto(&slurm(id, &[0, 1, 2, 3], 1), Some(4)).unwrap_err();
            assert!(
                problem.contains("number 0 (SLURM_ARRAY_TASK_ID), but the 4 parts are numbered from 1 to 4"),
                "{problem}"
            );
            assert!(auto(&slurm(id, &[0, 1, 2, 3, 4], 1), Some(4)).is_err());
        }
    }

    #[test]
    fn lists_whose_order_is_unknown_are_refused() {
        for (id, step) in [(1, 1), (4, 1), (9, 1), (1, 3), (4, 3), (9, 3), (4, 4)] {
            let problem = auto(&slurm(id, &[1, 4, 9], step), None).unwrap_err();
            assert!(problem.contains("number the jobs from 1 to 3, or use --part 3/64"), "{problem}");
        }
        // Jobs between two steps, or beyond the last.
        assert!(auto(&slurm(3, &[0, 2, 4], 2), None).is_err());
        assert!(auto(&slurm(6, &[0, 2, 4], 2), None).is_err());
        assert!(auto(&sge(3, 1, 5, 3), None).is_err());
    }

    #[test]
    fn what_is_no_number_or_numbered_twice_is_refused() {
        let set = |name: &str, text: &str| {
            let (name, text) = (name.to_owned(), text.to_owned());
            share(&|asked: &str| (asked == name).then(|| text.clone()), Some(3)).map(|share| share.number)
        };
        assert!(
            set("SLURM_ARRAY_TASK_ID", "1-3")
                .unwrap_err()
                .contains("expected a whole number in SLURM_ARRAY_TASK_ID, found `1-3`")
        );
        // SGE sets this in a job outside an array.
        assert!(set("SGE_TASK_ID", "undefined").unwrap_err().contains("--part auto requires one of the variables"));
        assert_eq!(set("SGE_TASK_ID", "2"), Ok(1));
        let two = [("PARALLEL_SEQ", 1), ("PBS_ARRAY_INDEX", 2)];
        let problem = auto(&two, Some(3)).unwrap_err();
        assert!(problem.contains("PBS_ARRAY_INDEX (PBS) and PARALLEL_SEQ (GNU parallel)"), "{problem}");
    }

    proptest! {
        /// Checks that the jobs of any range with any step are all parts, each once and in order.
        #[test]
        fn every_part_of_a_range_is_some_jobs(first in 0_u32..50, jobs in 1_u32..50, step in 1_u32..9, over in 0_u32..9) {
            let ids: Vec<u32> = (0..jobs).map(|job| first + job * step).collect();
            // Slurm sets the number of the last job; SGE may set the requested end.
            let last = ids[ids.len() - 1] + over % step;
            for (place, id) in (0..).zip(&ids) {
                prop_assert_eq!(auto(&slurm(*id, &ids, step), None), Ok((place, jobs)));
                prop_assert_eq!(auto(&sge(*id, first, last, step), None), Ok((place, jobs)));
            }
        }
    }
}
