//! Schedulers of clusters: the shard and the threads that the environment of a task states.

use crate::cli::args::values::ShardChoice;
use crate::cli::exit::{Result, usage_error};
use crate::render::Shard;

/// A scheduler, and its numbering of the tasks of an array.
struct Scheduler {
    name: &'static str,
    /// Name of the environment variable with the number of the scheduler's task.
    task: &'static str,
    range: TaskRange,
}

/// Numbering of the tasks of a scheduler's array: bounds in environment variables, or a fixed first number.
enum TaskRange {
    /// Names of the environment variables with the first number of a task, the last one and the step.
    Bounds([&'static str; 3]),
    /// Number of the first task, and the name of the environment variable with the number of tasks if the scheduler has
    /// one.
    From(usize, Option<&'static str>),
}

/// Schedulers whose tasks are recognised. (Manuals: Slurm `sbatch`, Grid Engine `qsub`, Kubernetes "Indexed Job", AWS
/// Batch "Array jobs", HyperQueue "Task arrays", PBS Professional "Job arrays".)
const SCHEDULERS: &[Scheduler] = &[
    Scheduler {
        name: "Slurm",
        task: "SLURM_ARRAY_TASK_ID",
        range: TaskRange::Bounds(["SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX", "SLURM_ARRAY_TASK_STEP"]),
    },
    Scheduler {
        name: "Grid Engine",
        task: "SGE_TASK_ID",
        range: TaskRange::Bounds(["SGE_TASK_FIRST", "SGE_TASK_LAST", "SGE_TASK_STEPSIZE"]),
    },
    Scheduler { name: "Kubernetes", task: "JOB_COMPLETION_INDEX", range: TaskRange::From(0, None) },
    Scheduler {
        name: "AWS Batch",
        task: "AWS_BATCH_JOB_ARRAY_INDEX",
        range: TaskRange::From(0, Some("AWS_BATCH_JOB_ARRAY_SIZE")),
    },
    Scheduler { name: "HyperQueue", task: "HQ_TASK_ID", range: TaskRange::From(1, None) },
    Scheduler { name: "PBS", task: "PBS_ARRAY_INDEX", range: TaskRange::From(1, None) },
];

/// A shard, and the words about the scheduler that chose it.
#[derive(Debug, PartialEq)]
pub struct Resolved {
    /// Shard of the picture that this process renders.
    pub shard: Shard,
    /// Line that states what was recognised; `None` for a shard that the command line states.
    pub note: Option<String>,
}

/// Resolves `--shard`; `environment_variable` returns a variable of the environment.
///
/// # Errors
/// A usage error if `auto` is asked for and no scheduler states the shard.
pub fn resolve(choice: ShardChoice, environment_variable: impl Fn(&str) -> Option<String>) -> Result<Resolved> {
    let count = match choice {
        ShardChoice::Exact(shard) => return Ok(Resolved { shard, note: None }),
        ShardChoice::Auto(count) => count,
    };
    // Grid Engine sets the variable to a word for a task outside of arrays.
    let number = |name: &str| environment_variable(name).and_then(|text| text.trim().parse::<usize>().ok());
    let Some((scheduler, task)) = SCHEDULERS.iter().find_map(|known| Some((known, number(known.task)?))) else {
        let names: Vec<&str> = SCHEDULERS.iter().map(|scheduler| scheduler.task).collect();
        return usage_error(format!(
            "`--shard auto` found no array task in the environment ({}); state the shard: `--shard 3/16`",
            names.join(", ")
        ));
    };
    let (name, variable_name) = (scheduler.name, scheduler.task);
    let (first, step, tasks) = match scheduler.range {
        TaskRange::Bounds([first, last, step]) => {
            let (first, last, step) = (number(first).unwrap_or(1), number(last), number(step).unwrap_or(1).max(1));
            (first, step, last.and_then(|last| Some(last.checked_sub(first)? / step + 1)))
        }
        TaskRange::From(first, size) => (first, 1, size.and_then(number)),
    };
    let Some(count) = count.or(tasks) else {
        return usage_error(format!("{name} does not state the number of tasks; state it: `--shard auto/16`"));
    };
    let offset = task.checked_sub(first).filter(|offset| offset.is_multiple_of(step)).map(|offset| offset / step);
    match offset {
        Some(offset) if offset < count => {
            let shard = Shard { index: offset + 1, count };
            let note = format!("shard {} of {count} ({name}: {variable_name}={task})\n", shard.index);
            Ok(Resolved { shard, note: Some(note) })
        }
        _ => usage_error(format!("{name}: {variable_name}={task} is not one of {count} tasks that begin at {first}")),
    }
}

/// Returns the number of processors that Slurm assigned to the task; `None` elsewhere.
pub fn assigned_threads(environment_variable: impl Fn(&str) -> Option<String>) -> Option<u16> {
    environment_variable("SLURM_CPUS_PER_TASK")?.trim().parse().ok().filter(|threads| *threads > 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Resolves `--shard` in an environment of `NAME=VALUE` words.
    fn shard(choice: ShardChoice, environment: &str) -> Option<(usize, usize)> {
        let variable = |name: &str| {
            let mut words = environment.split(' ').filter_map(|word| word.split_once('='));
            words.find(|(key, _)| *key == name).map(|(_, value)| value.to_string())
        };
        resolve(choice, variable).ok().map(|resolved| (resolved.shard.index, resolved.shard.count))
    }

    #[test]
    fn array_tasks_of_schedulers_are_recognised() {
        let auto = |environment: &str| shard(ShardChoice::Auto(None), environment);
        let slurm = "SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_MAX=15 SLURM_ARRAY_TASK_STEP=1 SLURM_ARRAY_TASK_ID=";
        assert_eq!(auto(&format!("{slurm}0")), Some((1, 16)));
        assert_eq!(auto(&format!("{slurm}15")), Some((16, 16)));
        assert_eq!(auto(&format!("{slurm}16")), None);
        let sge = "SGE_TASK_FIRST=1 SGE_TASK_LAST=10 SGE_TASK_STEPSIZE=3 SGE_TASK_ID=";
        assert_eq!([1, 4, 10].map(|id| auto(&format!("{sge}{id}"))), [Some((1, 4)), Some((2, 4)), Some((4, 4))]);
        assert_eq!(auto(&format!("{sge}2")), None);
        assert_eq!(auto("SGE_TASK_ID=undefined"), None);
        assert_eq!(auto("AWS_BATCH_JOB_ARRAY_INDEX=2 AWS_BATCH_JOB_ARRAY_SIZE=3"), Some((3, 3)));
        assert_eq!(auto("JOB_COMPLETION_INDEX=2"), None);
    }

    #[test]
    fn a_stated_number_of_shards_suffices() {
        let of_16 = |environment: &str| shard(ShardChoice::Auto(Some(16)), environment);
        assert_eq!(of_16("JOB_COMPLETION_INDEX=0"), Some((1, 16)));
        assert_eq!(of_16("HQ_TASK_ID=16"), Some((16, 16)));
        assert_eq!(of_16("PBS_ARRAY_INDEX=0"), None);
        assert_eq!(of_16(""), None);
        let exact = ShardChoice::Exact(Shard { index: 2, count: 5 });
        assert_eq!(shard(exact, "SLURM_ARRAY_TASK_ID=3"), Some((2, 5)));
    }
}
