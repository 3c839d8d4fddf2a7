//! How many entries of a list are read with a frame's results: about as many as the last frame had,
//! so that mostly nothing is left for a reading of its own.

/// What is expected of a list.
#[derive(Clone, Debug, Default)]
pub struct Expected {
    last: u32,
    asked: u32,
}

impl Expected {
    /// How many the last frame had.
    pub fn last(&self) -> u32 {
        self.last
    }

    /// A frame has so many.
    pub fn found(&mut self, n: u32) {
        self.last = n;
    }

    /// How many to ask for: as many as before, while that is about right, because then the frame
    /// has the commands of the one before.
    pub fn ask(&mut self) -> u32 {
        let most = self.last.saturating_add(self.last / 8).saturating_add(256);
        let about = most - most / 16..=most.saturating_add(most / 8);
        if !about.contains(&self.asked) {
            self.asked = most;
        }
        self.asked
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_than_the_last_frame_had_and_mostly_as_many_as_before() {
        let mut expected = Expected::default();
        let (mut asked, mut n_changes) = (0, 0);
        for i in 0..1000u32 {
            // Up and down by a fiftieth.
            let n = 100_000 + 2_000 * (i % 3);
            expected.found(n);
            let now = expected.ask();
            assert!(now >= n && now < n + n / 3 + 1000, "{n}: {now}");
            n_changes += (now != asked) as u32;
            asked = now;
        }
        assert_eq!(n_changes, 1);
        for n in [0, 1, 300, 5_000, 1 << 31, u32::MAX, 7] {
            expected.found(n);
            assert!(expected.ask() >= n, "{n}");
        }
    }
}
