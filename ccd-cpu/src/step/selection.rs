//! Which of the pairs whose boxes overlap are looked at: rules of bodies, and a filter of the
//! caller's.

use crate::broad_phase::keep;
use crate::simd::WIDTH;
use ccd_core::Error;
use ccd_core::backend::broad_phase::candidate::bodies_meet;
use ccd_core::backend::layout::Pair;
use ccd_core::backend::rules::Rules;
use ccd_core::model::contact::Kind;
use ccd_core::model::options::Options;
use ccd_core::model::session::Filter;
use std::fmt;
use std::sync::Arc;

/// What selects pairs.
#[derive(Default)]
pub struct Selection {
    pub rules: Option<Rules>,
    pub filter: Option<Arc<Filter>>,
}

impl fmt::Debug for Selection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rules, filter } = self;
        f.debug_struct("Selection")
            .field("rules", rules)
            .field("filter", &filter.is_some())
            .finish()
    }
}

impl Selection {
    /// By the bodies of these options.
    pub fn new(options: &Options) -> Result<Self, Error> {
        Ok(Self { rules: options.bodies.as_ref().map(Rules::new).transpose()?, filter: None })
    }

    /// The lanes of `mask` whose bodies, those of vertices `w`, are looked at against that of `v`;
    /// `a`, `b`: bodies by block and the block of `v`, of `w`.
    #[inline(always)]
    pub fn of_bodies(
        &self,
        v: u32,
        w: &[u32; WIDTH],
        mask: u32,
        (of_a, a): (&BlockBodies, usize),
        (of_b, b): (&BlockBodies, usize),
    ) -> u32 {
        let Some(rules) = &self.rules else { return mask };
        // Most rows are within a body whose words need not be read one by one.
        let (of_a, of_b) = (of_a.of(a), of_b.of(b));
        if of_a == of_b && of_a != MANY {
            return if bodies_meet(of_a, of_b) { mask } else { 0 };
        }
        of_lanes(rules, rules.word(v), w, mask, of_b)
    }

    /// Whether not all pairs are wanted.
    #[inline(always)]
    pub fn selects(&self) -> bool {
        self.filter.is_some() || self.rules.is_some()
    }

    /// Whether pairs of features are selected one by one.
    #[inline(always)]
    pub fn is_of_features(&self) -> bool {
        self.filter.is_some() || self.rules.as_ref().is_some_and(Rules::excludes_features)
    }

    /// The lanes of `mask` in which feature `id` with that of `ids` is wanted; with `id`: whether
    /// it is that of a face.
    #[inline(never)]
    pub fn of_features(
        &self,
        kind: Kind,
        (id, face_first): (u32, bool),
        ids: &[u32; WIDTH],
        mask: u32,
    ) -> u32 {
        keep(mask, |j| match kind {
            _ if face_first => self.wants(kind, Pair { a: ids[j], b: id }),
            Kind::EdgeEdge => self.wants(kind, Pair::ordered(id, ids[j])),
            _ => self.wants(kind, Pair { a: id, b: ids[j] }),
        })
    }

    /// Whether one pair of features is wanted.
    pub fn wants(&self, kind: Kind, Pair { a, b }: Pair) -> bool {
        let excluded = self.rules.as_ref().is_some_and(|rules| rules.excludes(kind, a, b));
        !excluded && self.filter.as_ref().is_none_or(|filter| filter(kind, a, b))
    }
}

/// Stands for several bodies: hardly a word, and if it is one, that of a body whose lanes are then
/// read one by one.
const MANY: u32 = u32::MAX;

/// Per block of leaves, the word of the one body that all its features belong to, see
/// [`Rules::words`]; empty where there are no rules.
#[derive(Debug, Default)]
pub struct BlockBodies(Vec<u32>);

impl BlockBodies {
    /// Takes blocks by a vertex of each of their features.
    pub fn fill<'a>(
        &mut self,
        rules: Option<&Rules>,
        blocks: impl Iterator<Item = &'a [u32; WIDTH]>,
    ) {
        self.0.clear();
        let Some(rules) = rules else { return };
        self.0.extend(blocks.map(|vertices| {
            let word = rules.word(vertices[0]);
            if vertices.iter().all(|&v| rules.word(v) == word) { word } else { MANY }
        }));
    }

    #[inline(always)]
    fn of(&self, block: usize) -> u32 {
        if block < self.0.len() { self.0[block] } else { MANY }
    }
}

/// The lanes of `mask` whose bodies may meet one by their words and the table; `all`: the word of
/// all lanes, if there is one.
#[inline(never)]
fn of_lanes(rules: &Rules, word: u32, w: &[u32; WIDTH], mask: u32, all: u32) -> u32 {
    // Of one body by itself, the table says nothing.
    let wants = |other: u32| {
        let by_table = !rules.has_table() || other == word || rules.classes_meet(word, other);
        bodies_meet(word, other) && by_table
    };
    if all != MANY {
        return if wants(all) { mask } else { 0 };
    }
    keep(mask, |j| wants(rules.word(w[j])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ccd_core::model::bodies::Bodies;

    #[test]
    fn lanes_are_those_that_the_rules_want() {
        // Bodies of eight vertices and of three, so that blocks of either sort are there; some
        // without self-contact, some that stand still, in two worlds.
        let body: Vec<u32> = (0..400).map(|v| if v < 200 { v / 8 } else { 25 + v / 3 }).collect();
        let n = 25 + 400 / 3 + 1;
        let mut bodies =
            Bodies::new(&body).with_worlds(&(0..n).map(|b| b / 5 % 2).collect::<Vec<u32>>());
        for alone in [4, 100] {
            bodies = bodies.with_self_contact(alone, false);
        }
        for fixed in [3, 7, 120] {
            bodies = bodies.with_fixed(fixed, true);
        }
        let rules = Rules::new(&bodies).unwrap();
        let blocks: Vec<[u32; WIDTH]> =
            (0..50).map(|i| std::array::from_fn(|j| (8 * i + j) as u32)).collect();
        let mut of = BlockBodies::default();
        of.fill(Some(&rules), blocks.iter());
        assert!(of.0[..25].iter().all(|&word| word != MANY) && of.0[25..].contains(&MANY));
        let selection = Selection { rules: Some(rules), filter: None };
        for (a, b) in (0..50).flat_map(|a| (0..50).map(move |b| (a, b))) {
            for v in blocks[a] {
                let got = selection.of_bodies(v, &blocks[b], 0xb7, (&of, a), (&of, b));
                let want = keep(0xb7, |j| bodies.wants(v, blocks[b][j]));
                assert_eq!(got, want, "vertex {v} and block {b}");
            }
        }
    }
}
