//! Boxes on their way to the device: checked and copied by all threads of the host.
//!
//! Twin: none; a CPU reads boxes where they are.

use crate::device::Device;
use crate::error::Error as DeviceError;
use ccd_core::math::aabb::GREATEST;
use ccd_core::model::error::check_boxes;
use ccd_core::{Aabb, Error};
use std::thread;

/// Boxes that are worth a thread: starting one takes as long as checking some thousand.
const SHARE: usize = 1 << 15;

/// Checks bounds and number of boxes.
pub fn check(boxes: &[Aabb]) -> Result<(), Error> {
    let (count, limit) = (boxes.len() as u64, Error::MAX_ELEMENTS);
    if count > limit {
        return Err(Error::TooMany { element: "boxes", count, limit });
    }
    let share = share(boxes.len());
    if share >= boxes.len() {
        return check_boxes(boxes, GREATEST as f64);
    }
    let checked: Vec<Result<(), Error>> = thread::scope(|scope| {
        let parts: Vec<_> = boxes
            .chunks(share)
            .map(|part| scope.spawn(|| check_boxes(part, GREATEST as f64)))
            .collect();
        parts.into_iter().map(|part| part.join().unwrap_or_else(resume)).collect()
    });
    // The first by number, whichever thread was first.
    for (first, result) in (0..).step_by(share).zip(checked) {
        result.map_err(|e| match e {
            Error::Box { at, axis, min, max } => Error::Box { at: first + at, axis, min, max },
            e => e,
        })?;
    }
    Ok(())
}

/// Sends boxes to the place of a buffer that begins at byte `at`. Each thread copies a part into
/// memory that the device reads.
pub fn send(
    device: &Device,
    buffer: &wgpu::Buffer,
    at: u64,
    boxes: &[Aabb],
) -> Result<(), DeviceError> {
    let share = share(boxes.len());
    let write = |at, part| device.write("boxes", buffer, at, bytemuck::cast_slice(part));
    if share >= boxes.len() {
        return write(at, boxes);
    }
    thread::scope(|scope| {
        let parts = (0..).step_by(share).zip(boxes.chunks(share)).map(|(first, part)| {
            let write = &write;
            scope.spawn(move || write(at + (first * size_of::<Aabb>()) as u64, part))
        });
        let parts: Vec<_> = parts.collect();
        let join = |part: thread::ScopedJoinHandle<'_, _>| part.join().unwrap_or_else(resume);
        parts.into_iter().map(join).fold(Ok(()), Result::and)
    })
}

/// Boxes of each thread.
fn share(n: usize) -> usize {
    let threads = thread::available_parallelism().map_or(1, |n| n.get());
    n.div_ceil(threads).max(SHARE)
}

fn resume<T>(panic: Box<dyn std::any::Any + Send>) -> T {
    std::panic::resume_unwind(panic)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_bad_box_is_named_whichever_thread_sees_it() {
        let mut boxes = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 5 * SHARE];
        assert_eq!(check(&boxes), Ok(()));
        for at in [4 * SHARE + 7, 3 * SHARE, SHARE - 1] {
            boxes[at].max[1] = f32::NAN;
            let Err(Error::Box { at: named, axis: 1, .. }) = check(&boxes) else {
                panic!("{:?}", check(&boxes))
            };
            assert_eq!(named, at);
        }
    }
}
