//! A frame on its way to the device: what is recorded, submitted and read with it.

use super::Frames;
use crate::broad_phase::pair_source::frame_of;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::HEADER_BYTES;
use crate::readback::{Mapping, Part, Plan};
use crate::recorder::{Times, submit_frame};
use crate::step::Goal;
use crate::step::contact_order::{self, ContactOrder};
use crate::step::kept_order::KeptOrder;
use crate::step::lists::Lists;
use crate::step::triangle_pairs::COUNT_BYTES;
use ccd_core::backend::layout::{PackedTouch, Touch};
use ccd_core::model::options::Options;

/// A frame as it was submitted.
pub struct Attempt {
    /// Contacts that are read with it.
    pub guess: u32,
    /// The order that was kept, which holds on if the frame comes to a good end.
    pub order: KeptOrder,
    pub kept: bool,
    pub parts: Parts,
    pub mapping: Mapping,
    pub times: Times,
}

/// Where results are in the reading of a frame.
pub struct Parts {
    pub earliest: Part,
    pub sample: Part,
    pub lists: Lists<Part>,
    pub contacts: Part,
    /// If they are in order, and so packed: whether some of them are not.
    pub order: Part,
    pub counters: Vec<Part>,
    pub counts: Part,
}

impl Frames {
    /// Makes buffers for the order of as many contacts as are expected, if they are many. Returns
    /// how many are to be read at once.
    fn plan_contacts(&mut self, device: &Device, goal: Goal) -> Result<u32, Error> {
        let Self { buffers, bench, contacts, .. } = self;
        let expected = &mut contacts[goal as usize];
        let is_step = goal == Goal::Contacts;
        let n = if is_step || expected.last() > 0 { expected.ask() } else { 0 };
        let n = n.min(buffers.contacts.capacity());
        let is_ordered = is_step && expected.last() >= contact_order::FEWEST;
        buffers.to_order = if is_ordered { n } else { 0 };
        let frame = frame_of(buffers.count);
        let fits = |order: &ContactOrder| order.fits(&frame, buffers.to_order);
        if buffers.to_order > 0 && !buffers.order.as_ref().is_some_and(fits) {
            device.give_back(buffers.order.take().map_or(0, |old| old.bytes));
            bench.forget();
            // As for lists: some more, or else just enough; where there is no memory even for that,
            // the host sorts.
            let with_some_more = ContactOrder::new(device, &frame, n + n / 4);
            match with_some_more.or_else(|_| ContactOrder::new(device, &frame, n)) {
                Ok(order) => buffers.order = Some(order),
                Err(e) if e.is_of_memory() => buffers.to_order = 0,
                Err(e) => return Err(e),
            }
        }
        Ok(n)
    }

    /// Submits a frame and asks for its results.
    pub(super) fn attempt(
        &mut self,
        device: &Device,
        options: &Options,
        (goal, window): (Goal, [f64; 2]),
    ) -> Result<Attempt, Error> {
        let guess = self.plan_contacts(device, goal)?;
        // Without an order until this frame has come to a good end.
        let order = std::mem::take(&mut self.order);
        let kept = order.holds(self.buffers.n_boxes());
        let Self { buffers, bench, readback, left, .. } = self;
        let wide = device.info().wide;
        buffers.keeps_order = kept;
        // By a minimum distance there is one decision. Zeros in `f64` leave few to a second one.
        let leaves_more = device.info().integers || left[goal as usize] > FEW_LEFT;
        buffers.decides_twice = options.min_distance == 0.0 && leaves_more;
        let frame = buffers.describe(options, window);
        let mut plan = Plan::default();
        let asked = |is: bool, bytes: u64| if is { bytes } else { 0 };
        let of_earliest = plan.part(asked(goal.is_earliest(), 4));
        let of_sample = plan.part(asked(goal == Goal::Earliest, 16));
        let of_lists = buffers.used(goal).map(|used| plan.part(asked(used, HEADER_BYTES)));
        let is_ordered = buffers.to_order > 0;
        let of_one = if is_ordered { size_of::<PackedTouch>() } else { size_of::<Touch>() };
        let of_contacts = plan.part(guess as u64 * of_one as u64);
        let counters = buffers.source.finder().counters();
        let of_counters: Vec<_> =
            counters.iter().map(|(_, range)| plan.part(range.end - range.start)).collect();
        let of_order = plan.part(asked(is_ordered, 4));
        let of_counts = plan.part(buffers.source.triangles().map_or(0, |_| COUNT_BYTES));
        let reading = readback.prepare(device, plan)?;
        let stages = submit_frame(device, bench, goal as u32, |recorder| {
            buffers.record(recorder, &frame, goal, wide);
            recorder.end_of_work();
            recorder.read(&reading, of_earliest, &buffers.earliest, 0);
            recorder.read(&reading, of_sample, &buffers.sample, 0);
            let lists = buffers.lists().zip(of_lists.clone());
            lists.map(|(list, part)| recorder.read(&reading, part, list.buffer(), 0));
            for (part, (counters, range)) in of_counters.iter().zip(&counters) {
                recorder.read(&reading, *part, counters, range.start);
            }
            if let Some(triangles) = buffers.source.triangles() {
                recorder.read(&reading, of_counts, triangles.counts(), 0);
            }
            match &buffers.order {
                Some(order) if is_ordered => {
                    let at = ContactOrder::incomplete_at(&frame);
                    recorder.read(&reading, of_order, &order.table, at);
                    recorder.read(&reading, of_contacts, &order.ordered, 0);
                }
                _ => recorder.read(&reading, of_contacts, buffers.contacts.buffer(), HEADER_BYTES),
            }
        })?;
        let parts = Parts {
            earliest: of_earliest,
            sample: of_sample,
            lists: of_lists,
            contacts: of_contacts,
            order: of_order,
            counters: of_counters,
            counts: of_counts,
        };
        let (mapping, times) = (reading.begin(device)?, bench.begin_times(stages)?);
        Ok(Attempt { guess, order, kept, parts, mapping, times })
    }
}

/// Pairs that the first of two decisions in `f64` leaves and the host decides at once: what a
/// workgroup decides at a time. A second dispatch would take longer, and rejects only what the host
/// does: contacts are the same, and each time within the tolerance, but not always to the last bit.
const FEW_LEFT: u32 = 64;
