//! Timestamps of stages on their way to the host.

use super::{Bench, Timer};
use crate::error::Error;
use crate::readback::Mapping;
use std::future::poll_fn;
use std::sync::Arc;
use std::task::{Context, Poll};

impl Bench {
    /// Asks for the timestamps of the stages that were submitted last, if there are any.
    pub fn begin_times(&self, stages: Vec<&'static str>) -> Result<Times, Error> {
        let timer = self.timer.as_ref().filter(|_| !stages.is_empty());
        // After a step that was dropped in flight they may be those of that step.
        let spoiled = &Arc::default();
        let bytes = stages.len() as u64 * 16;
        let begin = |timer: &Timer| Mapping::new(&self.device, &timer.read, spoiled, bytes);
        Ok(Times {
            mapping: timer.map(begin).transpose()?,
            period: self.device.queue().get_timestamp_period() as f64 * 1e-6,
            stages,
        })
    }
}

/// Timestamps that are not here yet.
pub struct Times {
    stages: Vec<&'static str>,
    mapping: Option<Mapping>,
    /// Milliseconds of a tick.
    period: f64,
}

impl Times {
    /// Whether they are here, or an error.
    pub fn poll(&self, context: &mut Context) -> Poll<Result<(), Error>> {
        self.mapping.as_ref().map_or(Poll::Ready(Ok(())), |mapping| mapping.poll(context))
    }

    /// Waits for them and returns what [`Times::take`] does.
    pub async fn read(self) -> Result<Vec<(&'static str, f64)>, Error> {
        poll_fn(|context| self.poll(context)).await?;
        self.take()
    }

    /// Milliseconds between the first and the last timestamp of each stage, when they are here.
    pub fn take(self) -> Result<Vec<(&'static str, f64)>, Error> {
        let Self { stages, mapping, period } = self;
        let Some(mapping) = mapping else { return Ok(Vec::new()) };
        mapping.read(|bytes| {
            let ticks = bytes
                .chunks_exact(8)
                .map(|b| u64::from_le_bytes(b.try_into().unwrap_or_default()))
                .collect::<Vec<_>>();
            let times = stages.iter().zip(ticks.chunks_exact(2));
            times.map(|(name, t)| (*name, t[1].saturating_sub(t[0]) as f64 * period)).collect()
        })
    }
}
