//! Queries of families that are nearly degenerate, against what is known of them by construction
//! and, of a part of them, against exact arithmetic: none is missed, none is late, and what is said
//! to be certain is.
//!
//! On a CPU each is asked by itself or all through a session; on a GPU through a session, in which
//! every query is a body in a world of its own.

use super::query_families::{Batch, Form, Known, Query};
use super::{Counts, Place, fewest};
use ccd::any::Session;
use ccd::exact::{Exact, edge_edge, vertex_face};
use ccd::geometry::Motion;
use ccd::{
    Bodies, Contact, EdgeEdge, Kind, Mesh, Options, Pair, Real, State, TOI_TOLERANCE, Verdict,
    VertexFace,
};
use ccd_core::narrow_phase::query::search;
use ccd_core::narrow_phase::search::Search;
use ccd_testkit::grazing::exact::{self, contact};
use ccd_testkit::grazing::exact_distance::{exact as rational, square};
use ccd_testkit::grazing::random::Random;
use serde::{Deserialize, Serialize};

/// Queries of a batch: what a device needs to be worth a submission, and few enough for all
/// families to come within seconds.
const ON_GPU: usize = 512;
const ON_CPU: usize = 256;
/// Queries with a known answer, one of which is decided by exact arithmetic too.
const EXACT_EVERY: usize = 64;

/// A batch, and how it is asked.
#[derive(Clone, Serialize, Deserialize)]
pub struct Case {
    /// Threads of the session through which it is asked; without a number each by itself.
    threads: Option<usize>,
    /// Every query is decided by exact arithmetic too.
    all_exactly: bool,
    batch: Batch,
}

impl super::Case for Case {
    const NAME: &str = "queries";

    fn make(place: &Place, number: u64, mut random: Random, _: &mut Counts) -> Self {
        let on_gpu = place.backend() == "gpu";
        let batch = Batch::new(&mut random, if on_gpu { ON_GPU } else { ON_CPU });
        let threads = (on_gpu || number % 4 == 3).then(|| 1 + random.below(2));
        Self { threads, all_exactly: false, batch }
    }

    fn check(&self, place: &Place, counts: &mut Counts) -> Result<(), String> {
        let Self { threads, all_exactly, batch } = self;
        let failed = |what: String| format!("{}: {what}", batch.name());
        let verdicts = match (threads, batch.wide) {
            (None, true) => batch.queries.iter().map(|q| alone::<f64>(batch, q)).collect(),
            (None, false) => batch.queries.iter().map(|q| alone::<f32>(batch, q)).collect(),
            (Some(n), true) => together::<f64>(place, *n, batch).map_err(failed)?,
            (Some(n), false) => together::<f32>(place, *n, batch).map_err(failed)?,
        };
        counts.add(batch.name(), batch.queries.len() as u64);
        for (i, (query, verdict)) in batch.queries.iter().zip(verdicts).enumerate() {
            let exactly = query.known == Known::Nothing && i % 4 == 0 || i % EXACT_EVERY == 0;
            let exactly = exactly || *all_exactly;
            judge(batch, query, verdict)
                .and_then(|()| if exactly { judge_exactly(batch, query, verdict) } else { Ok(()) })
                .and_then(|()| judge_decision(batch, query, verdict, exactly))
                .map_err(|what| failed(format!("{what}, known is {:?}", query.known)))?;
            counts.add("exact", exactly as u64);
            let word = match verdict {
                Verdict::Miss => "misses",
                Verdict::Undecided { .. } => "undecided",
                Verdict::Hit { .. } => "hits",
            };
            counts.add(word, 1);
        }
        Ok(())
    }

    /// One query if one is enough, of the least numbers with which it still fails.
    fn shrunk(self, fails: &dyn Fn(&Self) -> bool) -> Self {
        let with_batch = |batch: Batch| Self { batch, all_exactly: true, ..self.clone() };
        let with = |queries: &[Query]| {
            with_batch(Batch { queries: queries.to_vec(), ..self.batch.clone() })
        };
        let mut best = with(&fewest(&self.batch.queries, |queries| fails(&with(queries))));
        let mut smaller = true;
        while smaller {
            smaller = false;
            for i in 0..best.batch.queries.len() {
                let Query { kind, form: Some(form), .. } = best.batch.queries[i] else { continue };
                for change in changes(&form) {
                    let mut next = best.clone();
                    next.batch.queries[i] = next.batch.assembled(kind, change);
                    if fails(&next) {
                        (best, smaller) = (next, true);
                        break;
                    }
                }
            }
            let unit = with_batch(Batch { unit: best.batch.unit / 2, ..best.batch.clone() });
            if best.batch.unit != 0 && fails(&unit) {
                (best, smaller) = (unit, true);
            }
        }
        best
    }
}

impl Case {
    /// Its first certain contact is said to be none, if it has one.
    pub fn with_a_lie(mut self) -> Option<Self> {
        let query = self.batch.queries.iter_mut().find(|q| q.known == Known::At { first: true })?;
        query.known = Known::Free;
        Some(self)
    }

    pub fn n_queries(&self) -> usize {
        self.batch.queries.len()
    }
}

fn unit(batch: &Batch) -> f64 {
    // In two parts: the least numbers are below the range of one power.
    2f64.powi(batch.unit / 2) * 2f64.powi(batch.unit - batch.unit / 2)
}

/// Positions in the unit of the batch, exactly: floating-point ones where they stay exact.
fn ends<R: Real>(batch: &Batch, query: &Query) -> [[[R; 3]; 4]; 2] {
    let unit = if query.form.is_some() { unit(batch) } else { 1.0 };
    [query.t0, query.t1].map(|x| x.map(|p| p.map(|c| R::from_f64(c * unit))))
}

fn distance(batch: &Batch) -> f64 {
    batch.min_distance * unit(batch)
}

fn alone<R: Real>(batch: &Batch, query: &Query) -> Verdict<f64> {
    let [t0, t1] = ends::<R>(batch, query);
    let wanted = Search {
        min_distance: R::from_f64(distance(batch)),
        tolerance: R::from_f64(TOI_TOLERANCE),
        from: R::from_f64(batch.window[0]),
        until: R::from_f64(batch.window[1]),
        latest: R::from_f64(batch.window[1]),
        leaves: batch.leaves,
    };
    let motion = Motion::new(query.kind.patch(), &t0, &t1, R::splat(0.0));
    match search(&motion, query.kind.patch(), &wanted).verdict {
        Verdict::Miss => Verdict::Miss,
        Verdict::Hit { toi } => Verdict::Hit { toi: toi.to_f64() },
        Verdict::Undecided { toi } => Verdict::Undecided { toi: toi.to_f64() },
    }
}

/// A mesh of all queries, four vertices each, and its bodies.
fn mesh(batch: &Batch) -> Result<(Mesh, Bodies), String> {
    let (mut faces, mut edges) = (Vec::new(), Vec::new());
    for (query, v) in batch.queries.iter().zip((0u32..).step_by(4)) {
        match query.kind {
            Kind::VertexFace => faces.push([v + 1, v + 2, v + 3]),
            _ => edges.extend([[v, v + 1], [v + 2, v + 3]]),
        }
    }
    let n = batch.queries.len() as u32;
    let mesh = Mesh::with_edges(4 * n as usize, &faces, &edges).map_err(|e| e.to_string())?;
    let bodies: Vec<u32> = (0..4 * n).map(|v| v / 4).collect();
    let worlds: Vec<u32> = (0..n).collect();
    Ok((mesh, Bodies::new(&bodies).with_worlds(&worlds)))
}

fn together<R: ccd::Coordinate>(
    place: &Place,
    threads: usize,
    batch: &Batch,
) -> Result<Vec<Verdict<f64>>, String> {
    let (mesh, bodies) = mesh(batch)?;
    let options = Options::default()
        .with_threads(threads)
        .with_bodies(bodies)
        .with_min_distance(distance(batch))
        .with_leave_contact(batch.leaves);
    let mut session =
        Session::new(&place.choice, mesh, options).map_err(|e| format!("an error: {e}"))?;
    let [mut x0, mut x1] = [Vec::new(), Vec::new()];
    for query in &batch.queries {
        let [t0, t1] = ends::<R>(batch, query);
        x0.extend(t0);
        x1.extend(t1);
    }
    let report =
        session.step_window(&x0, &x1, batch.window).map_err(|e| format!("an error: {e}"))?;
    let mut verdicts = vec![Verdict::Miss; batch.queries.len()];
    for c in &report.contacts {
        let at = query_of(report.mesh(), c);
        if verdicts[at] != Verdict::Miss {
            return Err(format!("a contact comes twice: {c:?}"));
        }
        verdicts[at] = match c.state {
            State::Hit => Verdict::Hit { toi: c.toi },
            State::Undecided => Verdict::Undecided { toi: c.toi },
        };
    }
    Ok(verdicts)
}

fn query_of(mesh: &Mesh, c: &Contact) -> usize {
    mesh.vertices_of(c.kind, Pair { a: c.a, b: c.b })[0] as usize / 4
}

/// Compares a verdict with the answer known by construction.
fn judge(batch: &Batch, query: &Query, verdict: Verdict<f64>) -> Result<(), String> {
    let certain = matches!(verdict, Verdict::Hit { .. });
    let [from, until] = batch.window;
    if let Some(t) = verdict.toi().filter(|t| !(from <= *t && *t <= until)) {
        return Err(format!("{t:?} is outside of the window {from:?} to {until:?}"));
    }
    match (query.known, verdict.toi()) {
        (Known::At { .. }, None) => Err("missed".into()),
        (Known::At { .. }, Some(t)) if !batch.in_time(t) => Err(format!("late: {t:?}")),
        (Known::At { first: true }, Some(t)) if certain && batch.is_early(t) => {
            Err(format!("certain, and early by more than the tolerance: {t:?}"))
        }
        (Known::Free, Some(_)) if certain => Err(format!("no contact, but {verdict:?}")),
        _ => Ok(()),
    }
}

/// Compares a verdict with exact arithmetic: completely for touching, at some times for a distance.
fn judge_exactly(batch: &Batch, query: &Query, verdict: Verdict<f64>) -> Result<(), String> {
    let certain = matches!(verdict, Verdict::Hit { .. });
    let toi = verdict.toi();
    let whole = batch.window == [0.0, 1.0] && !batch.leaves;
    let (d, scaled) = (distance(batch), ends::<f64>(batch, query));
    let [t0, t1] = &scaled;
    if whole && d == 0.0 {
        return match contact(query.kind.patch(), t0, t1) {
            exact::Contact::At([_, hi], _) if toi.is_none_or(|t| t > hi) => {
                Err(format!("contact at {hi:?}, but {verdict:?}"))
            }
            exact::Contact::At([lo, _], true) if certain && toi < Some(lo - TOI_TOLERANCE) => {
                Err(format!("first contact at {lo:?}, but {verdict:?}"))
            }
            exact::Contact::Free if certain => Err(format!("no contact, but {verdict:?}")),
            _ => Ok(()),
        };
    }
    if !whole {
        return Ok(());
    }
    let limit = rational(d) * rational(d);
    let at = |t: f64| square(query.kind.patch(), t0, t1, &rational(t));
    let until = toi.unwrap_or(1.0);
    for i in 0..8 {
        let t = until * i as f64 / 8.0;
        if (t < until || toi.is_none()) && at(t) <= limit {
            return Err(format!("as near at {t:?}, but {verdict:?}"));
        }
    }
    // A certain contact has a witness within the tolerance: the time that is known, or one of some.
    let is_known = matches!(query.known, Known::At { .. }) && !batch.is_early(until);
    let slack = &limit * rational(1.0 + 1e-3);
    let near = |part: f64| at((until + TOI_TOLERANCE * part).min(1.0)) <= slack;
    if certain && !is_known && ![0.0, 0.125, 0.25, 0.5, 0.8, 1.0].into_iter().any(near) {
        return Err(format!("never as near within the tolerance of {verdict:?}"));
    }
    Ok(())
}

/// Compares the decision by integers, of a query without a distance, with a verdict, with what is
/// known and with exact arithmetic.
fn judge_decision(
    batch: &Batch,
    query: &Query,
    verdict: Verdict<f64>,
    exactly: bool,
) -> Result<(), String> {
    if distance(batch) > 0.0 {
        return Ok(());
    }
    let [t0, t1] = if batch.wide {
        ends::<f64>(batch, query)
    } else {
        ends::<f32>(batch, query).map(|x| x.map(|p| p.map(f64::from)))
    };
    let found = match query.kind {
        Kind::VertexFace => vertex_face(&VertexFace { t0, t1 }, batch.window),
        _ => edge_edge(&EdgeEdge { t0, t1 }, batch.window),
    };
    // Integers hold most, but not all, and nothing is said of the rest.
    let Some(found) = found else { return Ok(()) };
    let differs = |what: &str| Err(format!("{found:?} is {what}, {verdict:?}"));
    let decided = match (found, verdict) {
        (Exact::Miss, Verdict::Hit { .. }) => return differs("no certain contact"),
        (Exact::Contact(_), Verdict::Miss) => return differs("no miss"),
        (Exact::Contact([_, hi]), verdict) if verdict.toi() > Some(hi) => {
            return differs("before a time");
        }
        (Exact::Contact([lo, _]), Verdict::Hit { toi }) if lo - toi > 1.001 * TOI_TOLERANCE => {
            return differs("long after a time");
        }
        (Exact::Contact([lo, hi]), _) if hi > lo.next_up().next_up() => return differs("wide"),
        (Exact::Contact([toi, _]), _) => Verdict::Hit { toi },
        (Exact::Miss, _) => Verdict::Miss,
    };
    judge(batch, query, decided)?;
    if !exactly || batch.window != [0.0, 1.0] {
        return Ok(());
    }
    match (contact(query.kind.patch(), &t0, &t1), found) {
        (exact::Contact::At(..), Exact::Miss) => Err("a contact, decided as none".into()),
        (exact::Contact::Free, Exact::Contact(_)) => Err(format!("no contact, but {found:?}")),
        (exact::Contact::At([from, until], first), Exact::Contact([lo, hi]))
            if lo > until || first && hi < from =>
        {
            Err(format!("{found:?}, but a contact at {from:?} to {until:?}"))
        }
        _ => Ok(()),
    }
}

/// The same contact with lesser motions, or nearer to the origin.
fn changes(form: &Form) -> Vec<Form> {
    let mut all = Vec::new();
    for i in 0..5 * 3 {
        for divisor in [i64::MAX, 2] {
            let mut next = *form;
            let component = match i / 3 {
                0 => &mut next.a[1],
                1 => &mut next.b[1],
                2 => &mut next.c[1],
                3 => &mut next.o[0],
                _ => &mut next.o[1],
            };
            let old = component[i % 3];
            component[i % 3] = old / divisor;
            if component[i % 3] != old {
                all.push(next);
            }
        }
    }
    all
}
