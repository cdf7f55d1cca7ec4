//! How long things take: by the clock, and in processor time, which other programs disturb less.

use crate::{Context, Failure};
use indicatif::ProgressBar;
use serde::Serialize;
use std::time::{Duration, Instant};

/// What something took, in seconds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(super) struct Took {
    /// By the clock.
    pub(super) seconds: f64,
    /// Of all processors together, by all threads of the program; nothing where the system does not tell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) processor: Option<f64>,
}

/// Does things several times, looks whether it is to stop, and moves the bar.
#[derive(Debug)]
pub(super) struct Timer<'t> {
    /// How often, at least once.
    pub(super) repeat: usize,
    /// Whether the program is to stop.
    pub(super) context: &'t Context,
    /// Moved by one for each time.
    pub(super) bar: &'t ProgressBar,
}

impl Timer<'_> {
    /// Does a thing once and tells what it took.
    ///
    /// # Errors
    /// What keeps it from being done, or the wish to stop.
    pub(super) fn once<T>(&self, work: impl FnOnce() -> Result<T, Failure>) -> Result<(T, Took), Failure> {
        let (started, processor) = (Instant::now(), processor_time());
        let outcome = work()?;
        let seconds = started.elapsed().as_secs_f64();
        let processor = processor_time().zip(processor).map(|(end, start)| end.saturating_sub(start).as_secs_f64());
        self.bar.inc(1);
        if self.context.cancel.is_cancelled() {
            return Err(Failure::Interrupted);
        }
        Ok((outcome, Took { seconds, processor }))
    }

    /// Does a thing several times; gives what came of it last, and the medians of what it took.
    ///
    /// # Errors
    /// What keeps it from being done, or the wish to stop.
    pub(super) fn median<T>(&self, mut work: impl FnMut() -> Result<T, Failure>) -> Result<(T, Took), Failure> {
        let (mut last, first) = self.once(&mut work)?;
        let mut all = vec![first];
        for _ in 1..self.repeat {
            // what came before is gone first, so that memory is there for the next
            drop(last);
            let took;
            (last, took) = self.once(&mut work)?;
            all.push(took);
        }
        let processor: Option<Vec<f64>> = all.iter().map(|took| took.processor).collect();
        let seconds = median(all.into_iter().map(|took| took.seconds).collect());
        Ok((last, Took { seconds, processor: processor.map(median) }))
    }
}

/// The middle one, or the mean of the middle two.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    match values.as_slice() {
        [] => 0.0,
        values if values.len().is_multiple_of(2) => (values[middle - 1] + values[middle]) / 2.0,
        values => values[middle],
    }
}

/// The processor time of all threads of this program so far.
#[cfg(target_os = "linux")]
fn processor_time() -> Option<Duration> {
    let now = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Some(Duration::new(u64::try_from(now.tv_sec).ok()?, u32::try_from(now.tv_nsec).ok()?))
}

#[cfg(not(target_os = "linux"))]
fn processor_time() -> Option<Duration> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians() {
        assert_eq!(median(vec![7.0]), 7.0);
        assert_eq!(median(vec![9.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(vec![9.0, 1.0, 2.0, 4.0]), 3.0);
    }

    /// A thread that sleeps uses no processor, one that works does.
    #[test]
    #[cfg(target_os = "linux")]
    fn processor_time_is_that_of_work() {
        let spent = |work: fn()| {
            let before = processor_time().unwrap();
            work();
            processor_time().unwrap() - before
        };
        let worked = spent(|| {
            let started = processor_time().unwrap();
            while processor_time().unwrap() - started < Duration::from_millis(20) {}
        });
        assert!(worked >= Duration::from_millis(20), "{worked:?}");
    }
}
