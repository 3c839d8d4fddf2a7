//! The rules of bodies as both backends read them: a word a vertex, and a table for what words do
//! not say.

use crate::broad_phase::candidate::bodies_meet;
use crate::broad_phase::pair_rules::{HEADER, classes_meet, is_excluded};
use crate::math::real::{Num, Real};
use crate::model::bodies::Bodies;
use crate::model::contact::Kind;
use crate::model::error::Error;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

/// The rules of [`Bodies`], to be read.
///
/// ```
/// use ccd::Bodies;
/// use ccd_core::backend::rules::Rules;
///
/// // Two bodies without self-contact, the first fixed.
/// let rules = Rules::new(&Bodies::new(&[0, 0, 1]).with_fixed(0, true).with_self_contacts(false))?;
/// assert!(rules.wants(0, 2) && !rules.wants(0, 1));
/// // So simple that words say all of it.
/// assert_eq!((rules.still(), rules.has_table()), (&[0, 1][..], false));
/// # Ok::<(), ccd::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Rules {
    words: Vec<u32>,
    table: Vec<u32>,
    excludes_features: bool,
    worlds: Option<u32>,
    still: Vec<u32>,
    may_move: bool,
}

impl Rules {
    /// Most classes of bodies, those with equal groups and the same excluded partners: their matrix
    /// has 2 MiB.
    pub const MAX_CLASSES: usize = 4096;
    /// Most bodies: a word has two bits besides the number of a body.
    pub const MAX_BODIES: usize = 1 << 30;

    /// What these bodies say.
    ///
    /// # Errors
    ///
    /// [`Error::TooMany`] bodies, or classes of bodies.
    pub fn new(bodies: &Bodies) -> Result<Self, Error> {
        let all = bodies.all();
        let too_many = |element, count: usize, limit: usize| Error::TooMany {
            element,
            count: count as u64,
            limit: limit as u64,
        };
        if all.len() > Self::MAX_BODIES {
            return Err(too_many("bodies", all.len(), Self::MAX_BODIES));
        }
        let word = |&number: &u32| {
            let body = &all[number as usize];
            number << 2 | (body.self_contact as u32) << 1 | body.is_still() as u32
        };
        let words: Vec<u32> = bodies.numbers().iter().map(word).collect();
        let (excluded, features) = (bodies.excluded_bodies(), bodies.excluded_features());
        let n_worlds = all.iter().map(|body| body.world).max().unwrap_or(0) + 1;
        let mut classes = Classes::new(bodies, excluded);
        if classes.first.len() > Self::MAX_CLASSES {
            return Err(too_many("classes of bodies", classes.first.len(), Self::MAX_CLASSES));
        }
        let simple = classes.meet_all(bodies, excluded) && n_worlds == 1 && features.is_empty();
        let table = if simple { Vec::new() } else { classes.table(bodies, features) };
        Ok(Self {
            still: (0..words.len() as u32).filter(|&v| words[v as usize] & 1 == 1).collect(),
            words,
            table,
            excludes_features: !features.is_empty(),
            worlds: (n_worlds > 1).then_some(n_worlds),
            may_move: bodies.fixed_may_move(),
        })
    }

    /// Per vertex four times a number of its body, plus two if it has self-contact, plus one if it
    /// stands still: see [`bodies_meet`].
    pub fn words(&self) -> &[u32] {
        &self.words
    }

    /// The word of vertex `v`.
    #[inline(always)]
    pub fn word(&self, v: u32) -> u32 {
        self.words[v as usize]
    }

    /// What words do not say, see [`pair_rules`](crate::broad_phase::pair_rules); empty where they
    /// say all.
    pub fn table(&self) -> &[u32] {
        &self.table
    }

    /// Whether there is more than words say.
    #[inline(always)]
    pub fn has_table(&self) -> bool {
        !self.table.is_empty()
    }

    /// Whether bodies with these words may meet, by the table, which there must be.
    #[inline(always)]
    pub fn classes_meet(&self, a: u32, b: u32) -> bool {
        classes_meet(a, b, &self.table, 0)
    }

    /// Whether the bodies of two vertices are looked at: as [`Bodies::wants`].
    #[inline]
    pub fn wants(&self, v: u32, w: u32) -> bool {
        let (a, b) = (self.word(v), self.word(w));
        bodies_meet(a, b) && (!self.has_table() || self.classes_meet(a, b))
    }

    /// Whether pairs of features are excluded by themselves.
    #[inline(always)]
    pub fn excludes_features(&self) -> bool {
        self.excludes_features
    }

    /// Whether this pair is: as [`Bodies::excludes`].
    #[inline]
    pub fn excludes(&self, kind: Kind, a: u32, b: u32) -> bool {
        self.excludes_features && is_excluded(kind as u32, a, b, &self.table, 0)
    }

    /// How many worlds there may be, if more than one: all are below this.
    pub fn worlds(&self) -> Option<u32> {
        self.worlds
    }

    /// The world of vertex `v`.
    #[inline]
    pub fn world(&self, v: u32) -> u32 {
        let number = (self.word(v) >> 2) as usize;
        if self.has_table() { self.table[HEADER + 2 * number + 1] } else { 0 }
    }

    /// Whether vertex `v` is of a body that is fixed or sleeps.
    #[inline(always)]
    pub fn is_still(&self, v: u32) -> bool {
        self.word(v) & 1 == 1
    }

    /// The vertices of bodies that are fixed or sleep, in order.
    pub fn still(&self) -> &[u32] {
        &self.still
    }

    /// Whether these may move, see [`Bodies::with_fixed_motion`].
    pub fn may_move(&self) -> bool {
        self.may_move
    }

    /// Fails with the first vertex that moves and must not: of these runs, if others are known to
    /// stand still. Coordinates that are no numbers are found by those who check them.
    ///
    /// # Errors
    ///
    /// [`Error::FixedMoves`].
    pub fn check_still<T: Real>(
        &self,
        x0: &[[T; 3]],
        x1: &[[T; 3]],
        runs: Option<&[Range<u32>]>,
    ) -> Result<(), Error> {
        if self.may_move {
            return Ok(());
        }
        let begin = |v: u32| self.still.partition_point(|&still| still < v);
        let all = 0..u32::MAX;
        for run in runs.unwrap_or(core::slice::from_ref(&all)) {
            let moves = |&&v: &&u32| moves(x0[v as usize], x1[v as usize]);
            if let Some(&vertex) = self.still[begin(run.start)..begin(run.end)].iter().find(moves) {
                return Err(Error::FixedMoves { vertex: vertex as usize });
            }
        }
        Ok(())
    }
}

/// Whether a vertex moves; false where a coordinate is NaN.
#[inline]
pub fn moves<T: Real>(p: [T; 3], q: [T; 3]) -> bool {
    // Not `!=`, which NaN passes.
    let differ = |k: usize| Num::abs(p[k].to_f64() - q[k].to_f64()) > 0.0;
    differ(0) || differ(1) || differ(2)
}

/// Bodies that are alike to all others.
struct Classes {
    /// By body.
    of_body: Vec<u32>,
    /// A body of each.
    first: Vec<u32>,
    /// By class: a bit for each class that it meets.
    matrix: Vec<u32>,
}

impl Classes {
    fn new(bodies: &Bodies, excluded: &[[u32; 2]]) -> Self {
        let all = bodies.all();
        // Excluded partners of each body, one body after the other.
        let both = |&[a, b]: &[u32; 2]| [[a, b], [b, a]];
        let mut partners: Vec<[u32; 2]> = excluded.iter().flat_map(both).collect();
        partners.sort_unstable();
        let of_body = |i: u32| {
            let from = partners.partition_point(|p| p[0] < i);
            let to = partners.partition_point(|p| p[0] <= i);
            partners[from..to].iter().map(|p| p[1])
        };
        let compare = |&i: &u32, &j: &u32| {
            let groups = |i: u32| all[i as usize].groups;
            groups(i).cmp(&groups(j)).then_with(|| of_body(i).cmp(of_body(j)))
        };
        let mut order: Vec<u32> = (0..all.len() as u32).collect();
        order.sort_unstable_by(compare);
        let (mut of_body, mut first) = (vec![0; all.len()], Vec::<u32>::new());
        for &i in &order {
            if first.last().is_none_or(|last| compare(last, &i).is_ne()) {
                first.push(i);
            }
            of_body[i as usize] = first.len() as u32 - 1;
        }
        Self { of_body, first, matrix: Vec::new() }
    }

    /// Fills the matrix; whether every class meets every other.
    fn meet_all(&mut self, bodies: &Bodies, excluded: &[[u32; 2]]) -> bool {
        let (all, n) = (bodies.all(), self.first.len());
        let row = n.div_ceil(32);
        self.matrix = vec![0; n * row];
        let mut every = true;
        for i in 0..n {
            for j in 0..n {
                let [a, b] = [self.first[i], self.first[j]];
                // Bodies of one class are not excluded from each other: none is its own partner.
                let apart = i != j && excluded.binary_search(&[a.min(b), a.max(b)]).is_ok();
                let meet = all[a as usize].groups.meet(all[b as usize].groups) && !apart;
                every &= meet;
                self.matrix[i * row + j / 32] |= (meet as u32) << (j % 32);
            }
        }
        every
    }

    fn table(&self, bodies: &Bodies, features: &[(Kind, [u32; 2])]) -> Vec<u32> {
        let n = self.of_body.len();
        let from = HEADER + 2 * n + self.matrix.len();
        let mut table = vec![
            n as u32,
            self.first.len().div_ceil(32) as u32,
            features.len() as u32,
            from as u32,
        ];
        for (class, body) in self.of_body.iter().zip(bodies.all()) {
            table.extend([*class, body.world]);
        }
        table.extend(&self.matrix);
        table.extend(features.iter().flat_map(|&(kind, [a, b])| [kind as u32, a, b]));
        table
    }
}

#[cfg(test)]
mod tests;
