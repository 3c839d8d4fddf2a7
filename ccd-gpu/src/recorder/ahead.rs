//! Submission of what was recorded. A frame mostly has the commands of the one before, so these are
//! encoded again while the device works on them.

use super::{Bench, Command, Recorder};
use crate::device::Device;
use crate::error::Error;

/// Commands, and the same as wgpu has them.
pub struct Encoded {
    commands: Vec<Command>,
    groups: Vec<wgpu::BindGroup>,
    buffer: wgpu::CommandBuffer,
    stages: Vec<&'static str>,
}

impl Bench {
    /// Submits what `work` records. `goal`: whether the next recording of this goal is likely to be
    /// the same.
    fn submit(
        &mut self,
        device: &Device,
        goal: Option<u32>,
        work: impl FnOnce(&mut Recorder),
    ) -> Result<Vec<&'static str>, Error> {
        let done = device.guarded("a frame", 0, || {
            let mut recorder = self.record();
            work(&mut recorder);
            let commands = recorder.prepare()?;
            let ahead = goal.and_then(|goal| self.ahead.remove(&goal));
            let encoded = match ahead.filter(|ahead| ahead.commands == commands) {
                Some(ahead) => ahead,
                None => {
                    let groups = self.bind_groups(&commands)?;
                    self.encoded(commands, groups)
                }
            };
            let Encoded { commands, groups, buffer, stages } = encoded;
            device.queue().submit([buffer]);
            if let Some(goal) = goal {
                let again = self.encoded(commands, groups);
                self.ahead.insert(goal, again);
            }
            Ok(stages)
        });
        if done.is_err() {
            // Of what was encoded for the next frame nothing is known.
            self.ahead.clear();
        }
        done?
    }

    fn encoded(&self, commands: Vec<Command>, groups: Vec<wgpu::BindGroup>) -> Encoded {
        let label = wgpu::CommandEncoderDescriptor { label: Some("ccd") };
        let mut encoder = self.device.wgpu().create_command_encoder(&label);
        let stages = self.encode(&commands, groups.clone(), &mut encoder);
        Encoded { commands, groups, buffer: encoder.finish(), stages }
    }
}

/// Records with `work`, submits, and returns the stages.
pub fn submit(
    device: &Device,
    bench: &mut Bench,
    work: impl FnOnce(&mut Recorder),
) -> Result<Vec<&'static str>, Error> {
    bench.submit(device, None, work)
}

/// The same of a frame, of which the next one is likely to repeat the commands if it has the same
/// goal: a number of the caller's.
pub fn submit_frame(
    device: &Device,
    bench: &mut Bench,
    goal: u32,
    work: impl FnOnce(&mut Recorder),
) -> Result<Vec<&'static str>, Error> {
    bench.submit(device, Some(goal), work)
}
