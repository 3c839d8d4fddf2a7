//! Which of the pairs whose boxes overlap are looked at: rules of bodies, and a filter of the
//! caller's.

use crate::broad_phase::keep;
use crate::simd::WIDTH;
use ccd_core::Error;
use ccd_core::broad_phase::candidate::bodies_meet;
use ccd_core::layout::Pair;
use ccd_core::model::contact::Kind;
use ccd_core::model::options::Options;
use ccd_core::model::rules::Rules;
use std::fmt;

/// Whether a pair of features is wanted: by its kind and ids, of edges the lesser first.
pub type Filter = dyn Fn(Kind, u32, u32) -> bool + Send + Sync;

/// What selects pairs.
#[derive(Default)]
pub struct Selection {
    pub rules: Option<Rules>,
    pub filter: Option<Box<Filter>>,
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

    /// The lanes of `mask` whose bodies, those of vertices `w`, are looked at against that of `v`.
    #[inline(always)]
    pub fn of_bodies(&self, v: u32, w: &[u32; WIDTH], mask: u32) -> u32 {
        let Some(rules) = &self.rules else { return mask };
        let word = rules.word(v);
        let mask = keep(mask, |j| bodies_meet(word, rules.word(w[j])));
        if !rules.has_table() {
            return mask;
        }
        // Most neighbours are of the body itself, and need no table.
        let others = keep(mask, |j| rules.word(w[j]) != word);
        if others == 0 { mask } else { mask & !others | of_classes(rules, word, w, others) }
    }

    /// Whether pairs of features are selected one by one.
    #[inline(always)]
    pub fn is_of_features(&self) -> bool {
        self.filter.is_some() || self.rules.as_ref().is_some_and(Rules::excludes_features)
    }

    /// The lanes of `mask` in which feature `id` with that of `ids` is wanted.
    #[inline(never)]
    pub fn of_features(&self, kind: Kind, id: u32, ids: &[u32; WIDTH], mask: u32) -> u32 {
        keep(mask, |j| match kind {
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

#[inline(never)]
fn of_classes(rules: &Rules, word: u32, w: &[u32; WIDTH], mask: u32) -> u32 {
    keep(mask, |j| rules.classes_meet(word, rules.word(w[j])))
}
