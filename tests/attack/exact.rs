//! Decisions by integers of degenerate queries, against rational arithmetic and Sturm chains: the
//! same answer, and the time to the last bit.

use super::{Counts, Place, fewest};
use ccd_testkit::degenerate::{FAMILIES, KINDS, Outcome, Query};
use ccd_testkit::grazing::random::Random;
use serde::{Deserialize, Serialize};

/// Queries of each kind of each family in a case: 110 of each family.
const OF_EACH: usize = 10;

/// Seeds of queries, each with its family and kind.
#[derive(Clone, Serialize, Deserialize)]
pub struct Case {
    queries: Vec<(usize, usize, u64)>,
}

impl super::Case for Case {
    const NAME: &str = "exact";

    fn make(_: &Place, _: u64, mut random: Random, _: &mut Counts) -> Self {
        let n = OF_EACH * FAMILIES.len() * KINDS.len();
        let one = |i: usize| (i % FAMILIES.len(), i / FAMILIES.len() % KINDS.len(), random.bits());
        Self { queries: (0..n).map(one).collect() }
    }

    fn check(&self, _: &Place, counts: &mut Counts) -> Result<(), String> {
        for &(family, kind, seed) in &self.queries {
            let query = Query::new(family, kind, &mut Random::new(seed));
            let word = match query.judged()? {
                Outcome::Miss => "misses",
                Outcome::Contact => "contacts",
                Outcome::Several => "of several contacts the first",
            };
            let moved = if query.moved { ", moved a little" } else { "" };
            counts.add(FAMILIES[family], 1);
            counts.add(&format!("\n  {}, {}{moved}: {word}", FAMILIES[family], KINDS[kind]), 1);
        }
        Ok(())
    }

    fn shrunk(self, fails: &dyn Fn(&Self) -> bool) -> Self {
        let with = |queries: &[_]| Self { queries: queries.to_vec() };
        with(&fewest(&self.queries, |queries| fails(&with(queries))))
    }
}
