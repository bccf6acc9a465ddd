//! Times and memory. Other programs disturb elapsed time. So the least of many rounds is taken, for long
//! work the processor time of this process, and for a quotient the median of many.

use crate::row::ratio;
use std::hint::black_box;
use std::time::{Duration, Instant};

const ROUNDS: usize = 100;
const LONGEST: Duration = Duration::from_millis(800);

/// Rounds as short as this are often not disturbed.
const SHORT: Duration = Duration::from_millis(5);

/// The least elapsed time of many short rounds, or the least processor time of long ones.
pub fn fastest<T>(mut work: impl FnMut() -> T) -> Duration {
    let begin = Instant::now();
    black_box(work());
    if begin.elapsed() > SHORT {
        return on_processor(2, work);
    }
    let mut least = Duration::MAX;
    for round in 0..ROUNDS {
        if round > 0 && begin.elapsed() > LONGEST {
            break;
        }
        let start = Instant::now();
        black_box(work());
        least = least.min(start.elapsed());
    }
    least
}

/// The elapsed time of one run.
pub fn elapsed<T>(work: impl FnOnce() -> T) -> Duration {
    let start = Instant::now();
    black_box(work());
    start.elapsed()
}

/// The median quotient of two times, and the least of the second. The two take turns, because a processor
/// changes its speed, and a quotient of times from different moments would contain that.
pub fn compare(work: impl Fn() -> Duration, unit: impl Fn() -> Duration) -> (f64, Duration) {
    let begin = Instant::now();
    let (mut quotients, mut least) = (Vec::new(), Duration::MAX);
    while quotients.len() < 5 || (quotients.len() < ROUNDS && begin.elapsed() < 2 * LONGEST) {
        let (time, one) = (work(), unit());
        quotients.push(ratio(time, one));
        least = least.min(one);
    }
    quotients.sort_by(f64::total_cmp);
    (quotients[quotients.len() / 2], least)
}

/// The time on processors of one run.
pub fn once<T>(work: impl FnOnce() -> T) -> (Duration, T) {
    let start = processor_time();
    let value = black_box(work());
    (processor_time().saturating_sub(start), value)
}

/// The least time on processors of several rounds. The kernel counts it by its ticks of some
/// milliseconds, so that a round repeats short work for a fifth of a second.
pub fn on_processor<T>(rounds: usize, mut work: impl FnMut() -> T) -> Duration {
    let start = Instant::now();
    black_box(work());
    let times = repetitions(start.elapsed());
    let round = |_| once(|| (0..times).for_each(|_| drop(black_box(work())))).0 / times;
    (0..rounds).map(round).min().unwrap_or_default()
}

/// How often to repeat work of this length.
pub fn repetitions(length: Duration) -> u32 {
    let times = 0.2 / length.as_secs_f64().max(1e-5);
    times.ceil() as u32
}

/// The time that all threads of this process have spent on a processor.
pub fn processor_time() -> Duration {
    let tasks = std::fs::read_dir("/proc/self/task").expect("Linux");
    let nanoseconds = tasks.filter_map(|task| {
        let text = std::fs::read_to_string(task.ok()?.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse::<u64>().ok()
    });
    Duration::from_nanos(nanoseconds.sum())
}

/// The time that ended children of this process have spent on a processor, in ticks of a hundredth of a second.
pub fn processor_time_of_children() -> Duration {
    let text = std::fs::read_to_string("/proc/self/stat").expect("Linux");
    // The name, in parentheses, may contain blanks. After it come the state and 50 numbers; user and system time of
    // children are the numbers 13 and 14.
    let (_, rest) = text.rsplit_once(')').expect("a name");
    let words = rest.split_whitespace().skip(13).take(2);
    let ticks: u64 = words.filter_map(|word| word.parse::<u64>().ok()).sum();
    Duration::from_millis(10 * ticks)
}

/// The most memory that this process has had, in MB, from the kernel.
pub fn peak_megabytes() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kibibytes = line.and_then(|rest| rest.split_whitespace().next()?.parse::<f64>().ok());
    kibibytes.unwrap_or(0.0) * 1024.0 / 1e6
}
