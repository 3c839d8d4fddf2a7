//! What a session finds in one step, in an order that does not depend on the method.

use ccd::{Contact, Coordinate, Kind, Pair, PerKind, Session, State};

#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Candidates of both [`KINDS`], sorted.
    pub pairs: [Vec<Pair>; 2],
    pub contacts: Vec<Contact>,
    pub filtered: PerKind,
    pub toi: Option<f64>,
}

pub const KINDS: [Kind; 2] = [Kind::VertexFace, Kind::EdgeEdge];

impl Found {
    pub fn of<T: Coordinate>(session: &mut Session, x0: &[[f64; 3]], x1: &[[f64; 3]]) -> Self {
        let [x0, x1] =
            [x0, x1].map(|x| x.iter().map(|p| p.map(T::from_f64)).collect::<Vec<[T; 3]>>());
        let listed = session.candidates(&x0, &x1).expect("candidates");
        let mut pairs = [listed.vf.to_vec(), listed.ee.to_vec()];
        pairs.iter_mut().for_each(|pairs| pairs.sort_unstable());
        assert!(pairs.iter().all(|pairs| pairs.windows(2).all(|p| p[0] != p[1])), "a pair twice");
        let earliest = session.earliest_toi(&x0, &x1).expect("a step");
        let report = session.step(&x0, &x1).expect("a step");
        let counts = [report.candidates.vf, report.candidates.ee];
        assert_eq!(counts, pairs.each_ref().map(|pairs| pairs.len() as u64));
        // Of certain contacts: an undecided one may be shown to be none in a shorter step.
        let mut hits = report.contacts.iter().filter(|c| c.state == State::Hit);
        assert!(hits.all(|c| earliest.is_some_and(|toi| toi <= c.toi)), "later than a contact");
        assert_eq!(earliest.is_some(), report.toi.is_some());
        let (contacts, filtered) = (report.contacts.clone(), report.filtered);
        Self { pairs, contacts, filtered, toi: report.toi }
    }

    /// Without pairs that are not wanted, and without the counts of filters.
    pub fn less(&self, wants: impl Fn(Kind, u32, u32) -> bool) -> Self {
        let mut out = Self { filtered: PerKind::default(), ..self.clone() };
        for (kind, pairs) in KINDS.into_iter().zip(&mut out.pairs) {
            pairs.retain(|pair| wants(kind, pair.a, pair.b));
        }
        out.contacts.retain(|c| wants(c.kind, c.a, c.b));
        out.toi = out.contacts.iter().map(|c| c.toi).reduce(f64::min);
        out
    }
}
