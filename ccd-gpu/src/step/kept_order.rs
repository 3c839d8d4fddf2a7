//! For how long steps keep the order of boxes: sorting takes a quarter of a small step, and boxes
//! that were near one another mostly stay so.
//!
//! A step that keeps the order only fits boxes to what was built. How good that still is shows in
//! the pairs of blocks that are left for the last level, whose number is read back with the results
//! anyway: it is the work that a better order would save. The pairs themselves do not depend on it.

/// So many times as many pairs of nodes as after the last sort, and the next step sorts again.
const LOOSEST: f64 = 1.25;
/// Steps after which the next one sorts again in any case: pairs of nodes may have become fewer for
/// other reasons than a good order, small meshes have as many in any order, and some methods do not
/// count them. It costs a few hundredths of what keeping the order saves.
const MOST_STEPS: u32 = 32;

/// What is known of the order of boxes on the device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KeptOrder {
    sorted: Option<Sorted>,
}

/// A sort, and how it lasts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Sorted {
    /// Pairs of nodes in the step that sorted.
    work: u64,
    /// Steps since then.
    steps: u32,
    is_good: bool,
}

impl KeptOrder {
    /// Whether the next step keeps the order.
    pub fn holds(&self) -> bool {
        self.sorted.is_some_and(|sorted| sorted.is_good)
    }

    /// The next step sorts, whatever was.
    pub fn forget(&mut self) {
        self.sorted = None;
    }

    /// A step has come to its end, with the order `kept` or new. `work`: pairs of nodes of its last
    /// level; `None` if its source has no order that outlasts motion.
    pub fn took(&mut self, kept: bool, work: Option<u64>) {
        self.sorted = match (work, self.sorted.filter(|_| kept)) {
            (None, _) => None,
            (Some(work), None) => Some(Sorted { work, steps: 0, is_good: true }),
            (Some(work), Some(last)) => {
                let steps = last.steps + 1;
                let is_good = steps < MOST_STEPS && work as f64 <= last.work as f64 * LOOSEST;
                Some(Sorted { work: last.work, steps, is_good })
            }
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Which of the steps with so much work keep the order.
    fn kept(work: &[Option<u64>]) -> Vec<bool> {
        let mut order = KeptOrder::default();
        let mut step = |&work| {
            let kept = order.holds();
            order.took(kept, work);
            kept
        };
        work.iter().map(&mut step).collect()
    }

    #[test]
    fn an_order_is_kept_while_its_work_stays_near_that_of_the_sort() {
        let of = |work: &[u64]| kept(&work.iter().map(|&w| Some(w)).collect::<Vec<_>>());
        assert_eq!(
            of(&[100, 125, 126, 150, 187, 188, 1]),
            [false, true, true, false, true, true, false]
        );
        assert_eq!(of(&[0, 0, 1, 1]), [false, true, true, false]);
    }

    #[test]
    fn it_is_never_kept_for_long() {
        let steps = kept(&[Some(7); 100]);
        let sorts: Vec<usize> = (0..100).filter(|&i| !steps[i]).collect();
        assert_eq!(sorts, [0, 33, 66, 99]);
    }

    #[test]
    fn what_has_no_order_keeps_none() {
        assert_eq!(
            kept(&[None, None, Some(1), None, Some(1), Some(1)]),
            [false, false, false, true, false, true]
        );
        let mut order = KeptOrder::default();
        order.took(false, Some(5));
        assert!(order.holds());
        order.forget();
        assert!(!order.holds());
    }
}
