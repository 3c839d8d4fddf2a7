//! Recorded commands on their way into an encoder of wgpu: passes, bind groups, timestamps.

use super::{Bench, Command, MAX_STAGES, PARAMS_STRIDE, Timing};
use ccd_core::backend::kernel::Id;
use std::vec;

/// Commands on their way into an encoder.
pub struct Encoding<'a> {
    bench: &'a Bench,
    /// The bind groups of the kernels that are still to come.
    groups: vec::IntoIter<wgpu::BindGroup>,
    encoder: &'a mut wgpu::CommandEncoder,
    pass: Option<wgpu::ComputePass<'static>>,
    stages: Vec<&'static str>,
    /// The stage that begins with the next kernel: one without kernels is not listed.
    next_stage: Option<&'static str>,
    /// Where the parameters of the next dispatch begin.
    offset: u32,
    /// Whether the timestamp at the end of the whole is recorded.
    ended: bool,
}

impl<'a> Encoding<'a> {
    /// `groups`: of the kernels that will be encoded, in their order.
    pub fn new(
        bench: &'a Bench,
        groups: Vec<wgpu::BindGroup>,
        encoder: &'a mut wgpu::CommandEncoder,
    ) -> Self {
        let groups = groups.into_iter();
        let (pass, stages, next_stage) = (None, Vec::new(), None);
        Self { bench, groups, encoder, pass, stages, next_stage, offset: 0, ended: false }
    }

    /// Encodes a command.
    pub fn encode(&mut self, command: Command) {
        match command {
            Command::Stage(name) => {
                if self.stages.len() < MAX_STAGES as usize {
                    self.next_stage = Some(name);
                }
            }
            Command::EndOfWork => self.end_of_work(),
            Command::Clear { buffer, bytes } => {
                self.pass = None;
                self.encoder.clear_buffer(&buffer, 0, Some(bytes));
            }
            Command::Copy { from, to, bytes } => {
                self.pass = None;
                self.encoder.copy_buffer_to_buffer(&from.0, from.1, &to.0, to.1, bytes);
            }
            Command::Run { id, groups, .. } => self.run(id, groups),
        }
    }

    fn end_of_work(&mut self) {
        self.pass = None;
        if self.bench.timing == Timing::Whole
            && !self.stages.is_empty()
            && !self.ended
            && let Some(timer) = &self.bench.timer
        {
            let writes = wgpu::ComputePassTimestampWrites {
                query_set: &timer.queries,
                beginning_of_pass_write_index: None,
                end_of_pass_write_index: Some(1),
            };
            self.encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                label: Some("end"),
                timestamp_writes: Some(writes),
            });
        }
        self.ended = true;
    }

    fn run(&mut self, id: Id, groups: u32) {
        let bench = self.bench;
        let pipeline = bench.device.pipeline(id);
        let takes_params = id.row().params.is_some();
        let group = self.groups.next();
        if let Some(name) = self.next_stage.take() {
            self.pass = None;
            self.stages.push(name);
        }
        let pass = self.pass.get_or_insert_with(|| {
            let writes = match bench.timing {
                Timing::Off => None,
                // With the first kernel, because uploads arrive until then.
                Timing::Whole if self.stages.is_empty() => {
                    self.stages.push("whole");
                    Some((0, None))
                }
                Timing::Whole => None,
                Timing::Stages | Timing::Kernels => {
                    let last = self.stages.len().checked_sub(1).map(|last| 2 * last as u32);
                    last.map(|at| (at, Some(at + 1)))
                }
            };
            let timestamp_writes = bench.timer.as_ref().zip(writes).map(|(timer, (begin, end))| {
                wgpu::ComputePassTimestampWrites {
                    query_set: &timer.queries,
                    beginning_of_pass_write_index: Some(begin),
                    end_of_pass_write_index: end,
                }
            });
            self.encoder
                .begin_compute_pass(&wgpu::ComputePassDescriptor {
                    label: Some("ccd"),
                    timestamp_writes,
                })
                .forget_lifetime()
        });
        pass.set_pipeline(&pipeline.pipeline);
        if takes_params {
            pass.set_bind_group(0, group.as_ref(), &[self.offset]);
            self.offset += PARAMS_STRIDE as u32;
        } else {
            pass.set_bind_group(0, group.as_ref(), &[]);
        }
        // Folded: the kernels take the number of a workgroup from both dimensions.
        let x = groups.min(bench.fold);
        pass.dispatch_workgroups(x, groups.div_ceil(x), 1);
    }

    /// Lets the timestamps be read; returns the stages.
    pub fn finish(self) -> Vec<&'static str> {
        if let Some(timer) = &self.bench.timer
            && !self.stages.is_empty()
        {
            let n = self.stages.len() as u32;
            self.encoder.resolve_query_set(&timer.queries, 0..2 * n, &timer.resolved, 0);
            self.encoder.copy_buffer_to_buffer(&timer.resolved, 0, &timer.read, 0, n as u64 * 16);
        }
        self.stages
    }
}
