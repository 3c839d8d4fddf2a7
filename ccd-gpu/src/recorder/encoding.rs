//! Recorded commands on their way into an encoder of wgpu: passes, bind groups, timestamps.

use super::{Bench, Command, MAX_STAGES, PARAMS_STRIDE, Timing};
use ccd_core::backend::kernel::{Access, Id};
use std::iter::empty;
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
    /// Kernels so far, to be repeated.
    done: Vec<Run>,
    /// Whether the timestamp at the end of the whole is recorded.
    ended: bool,
}

/// A kernel as it is encoded.
#[derive(Clone)]
struct Run {
    id: Id,
    group: Option<wgpu::BindGroup>,
    /// Where its parameters begin, if it takes some.
    offset: Option<u32>,
    groups: u32,
}

/// The kernels that commands begin with of which none writes what another reads or writes.
fn independent(commands: &[Command]) -> &[Command] {
    let is_kernel = |command: &&Command| matches!(command, Command::Run { .. });
    let n = commands.iter().take_while(is_kernel).count();
    let meets = |b: &Command, a: &Command| {
        let of_both = [(a, b), (b, a)];
        of_both.into_iter().any(|(a, b)| {
            let mut written = uses(a, Access::Write);
            let used = || uses(b, Access::Read).chain(uses(b, Access::Write));
            written.any(|written| used().any(|used| used == written))
        })
    };
    let end = (1..n).find(|&i| commands[..i].iter().any(|before| meets(&commands[i], before)));
    &commands[..end.unwrap_or(n)]
}

/// The buffers that a kernel only reads, or writes.
fn uses(command: &Command, access: Access) -> impl Iterator<Item = &wgpu::Buffer> {
    let (id, buffers) = match command {
        Command::Run { id, buffers, .. } => (id.row().buffers, &buffers[..]),
        _ => (&[][..], &[][..]),
    };
    id.iter().zip(buffers).filter(move |((_, used), _)| *used == access).map(|(_, buffer)| buffer)
}

impl<'a> Encoding<'a> {
    /// `groups`: of the kernels that will be encoded, in their order.
    pub fn new(
        bench: &'a Bench,
        groups: Vec<wgpu::BindGroup>,
        encoder: &'a mut wgpu::CommandEncoder,
    ) -> Self {
        let groups = groups.into_iter();
        let (stages, done) = (Vec::new(), Vec::new());
        let (pass, next_stage, offset, ended) = (None, None, 0, false);
        Self { bench, groups, encoder, pass, stages, next_stage, offset, done, ended }
    }

    /// Encodes commands.
    pub fn encode(&mut self, commands: &[Command]) {
        let mut next_group = 0;
        for (at, command) in commands.iter().enumerate() {
            if at == next_group {
                let group = independent(&commands[at..]);
                self.wait_for_inputs(group);
                next_group = at + group.len().max(1);
            }
            self.encode_one(command);
        }
    }

    /// Has a device wait once for all that a group of kernels reads. Otherwise each of them waits
    /// for what it reads, and by that for the kernels of the group before it.
    fn wait_for_inputs(&mut self, group: &[Command]) {
        if let (Some(pass), [_, _, ..]) = (&mut self.pass, group) {
            let state = wgpu::BufferUses::STORAGE_READ_ONLY;
            let read = group.iter().flat_map(|command| uses(command, Access::Read));
            let states = read.map(|buffer| wgpu::BufferTransition { buffer, state });
            pass.transition_resources(states, empty());
        }
    }

    fn encode_one(&mut self, command: &Command) {
        match *command {
            Command::Stage(name) => {
                if self.stages.len() < MAX_STAGES as usize {
                    self.next_stage = Some(name);
                }
            }
            Command::EndOfWork => self.end_of_work(),
            Command::Clear { ref buffer, bytes } => {
                self.pass = None;
                self.encoder.clear_buffer(buffer, 0, Some(bytes));
            }
            Command::Copy { ref from, ref to, bytes } => {
                self.pass = None;
                self.encoder.copy_buffer_to_buffer(&from.0, from.1, &to.0, to.1, bytes);
            }
            Command::Run { id, groups, .. } => {
                let takes_params = id.row().params.is_some();
                let offset = takes_params.then_some(self.offset);
                self.offset += offset.map_or(0, |_| PARAMS_STRIDE as u32);
                let run = Run { id, group: self.groups.next(), offset, groups };
                self.run(&run);
                self.done.push(run);
            }
            Command::Repeat { n, times } => {
                let again = self.done[self.done.len() - n..].to_vec();
                (1..times).for_each(|_| again.iter().for_each(|run| self.run(run)));
            }
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

    fn run(&mut self, run: &Run) {
        let bench = self.bench;
        let pipeline = bench.device.pipeline(run.id);
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
        pass.set_bind_group(0, run.group.as_ref(), run.offset.as_slice());
        // Folded: the kernels take the number of a workgroup from both dimensions.
        let x = run.groups.min(bench.fold);
        pass.dispatch_workgroups(x, run.groups.div_ceil(x), 1);
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
