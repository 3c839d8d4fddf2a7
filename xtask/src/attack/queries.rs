//! Queries of families that are nearly degenerate, against what is known of them by construction
//! and, of a part of them, against exact arithmetic: none is missed, none is late, and what is said
//! to be certain is.
//!
//! On a CPU each is asked by itself or all through a session; on a GPU through a session, in which
//! every query is a body in a world of its own.

use super::query_families::{Batch, Form, Known, Query};
use super::{Counts, Found, Place, caught, fewest};
use ccd::any::Session;
use ccd::geometry::{Motion, Patch};
use ccd::{Bodies, Contact, Kind, Mesh, Options, Pair, Real, State, TOI_TOLERANCE, Verdict};
use ccd_core::narrow_phase::query::search;
use ccd_core::narrow_phase::search::Search;
use ccd_testkit::grazing::exact::{self, contact};
use ccd_testkit::grazing::exact_distance::{exact as rational, square};
use ccd_testkit::grazing::random::Random;

/// Queries of a batch: what a device needs to be worth a submission, and few enough for all
/// families to come within seconds.
const ON_GPU: usize = 512;
const ON_CPU: usize = 256;
/// Of so many queries whose answer is known one is decided by exact arithmetic too.
const EXACT_EVERY: usize = 64;

/// How a batch is asked.
#[derive(Clone, Copy)]
enum Way<'a> {
    Alone,
    Session(&'a Place, usize),
}

pub fn case(
    place: &Place,
    number: u64,
    mut random: Random,
    counts: &mut Counts,
) -> Result<(), Found> {
    let on_gpu = place.backend() == "gpu";
    let batch = Batch::new(&mut random, if on_gpu { ON_GPU } else { ON_CPU });
    let way = if on_gpu || number % 4 == 3 {
        Way::Session(place, 1 + random.below(2))
    } else {
        Way::Alone
    };
    let failed = |batch: &Batch, what: String| shrink(way, batch, what);
    let verdicts = caught(|| ask(way, &batch)).map_err(|what| failed(&batch, what))?;
    counts.add(batch.name(), batch.queries.len() as u64);
    for (i, (query, verdict)) in batch.queries.iter().zip(&verdicts).enumerate() {
        let exactly = query.known == Known::Nothing && i % 4 == 0 || i % EXACT_EVERY == 0;
        let what = judge(&batch, query, *verdict)
            .and_then(|()| if exactly { judge_exactly(&batch, query, *verdict) } else { Ok(()) });
        if let Err(what) = what {
            return Err(failed(&Batch { queries: vec![*query], ..batch.clone() }, what));
        }
        counts.add("exact", exactly as u64);
        counts.add(["misses", "undecided", "hits"][word(verdict)], 1);
    }
    Ok(())
}

fn word(verdict: &Verdict<f64>) -> usize {
    match verdict {
        Verdict::Miss => 0,
        Verdict::Undecided { .. } => 1,
        Verdict::Hit { .. } => 2,
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

fn ask(way: Way, batch: &Batch) -> Result<Vec<Verdict<f64>>, String> {
    match (way, batch.wide) {
        (Way::Alone, true) => Ok(batch.queries.iter().map(|q| alone::<f64>(batch, q)).collect()),
        (Way::Alone, false) => Ok(batch.queries.iter().map(|q| alone::<f32>(batch, q)).collect()),
        (Way::Session(place, threads), true) => together::<f64>(place, threads, batch),
        (Way::Session(place, threads), false) => together::<f32>(place, threads, batch),
    }
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
        leaves: batch.leaves,
    };
    let motion = Motion::new(query.patch, &t0, &t1, R::splat(0.0));
    match search(&motion, query.patch, &wanted).verdict {
        Verdict::Miss => Verdict::Miss,
        Verdict::Hit { toi } => Verdict::Hit { toi: toi.to_f64() },
        Verdict::Undecided { toi } => Verdict::Undecided { toi: toi.to_f64() },
    }
}

/// A mesh of all queries, four vertices each, and its bodies.
fn mesh(batch: &Batch) -> Result<(Mesh, Bodies), String> {
    let (mut faces, mut edges) = (Vec::new(), Vec::new());
    for (query, v) in batch.queries.iter().zip((0u32..).step_by(4)) {
        match query.patch {
            Patch::Triangle => faces.push([v + 1, v + 2, v + 3]),
            Patch::Parallelogram => edges.extend([[v, v + 1], [v + 2, v + 3]]),
        }
    }
    let n = batch.queries.len() as u32;
    let mesh = Mesh::with_edges(4 * n as usize, &faces, &edges).map_err(|e| e.to_string())?;
    let of: Vec<u32> = (0..4 * n).map(|v| v / 4).collect();
    let worlds: Vec<u32> = (0..n).collect();
    Ok((mesh, Bodies::new(&of, &[], true).with_worlds(&worlds)))
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

/// What construction knows.
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

/// What exact arithmetic knows: of touching all, of a distance what it is at some times.
fn judge_exactly(batch: &Batch, query: &Query, verdict: Verdict<f64>) -> Result<(), String> {
    let certain = matches!(verdict, Verdict::Hit { .. });
    let toi = verdict.toi();
    let whole = batch.window == [0.0, 1.0] && !batch.leaves;
    let (d, scaled) = (distance(batch), ends::<f64>(batch, query));
    let [t0, t1] = &scaled;
    if whole && d == 0.0 {
        return match contact(query.patch, t0, t1) {
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
    let at = |t: f64| square(query.patch, t0, t1, &rational(t));
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

fn fails(way: Way, batch: &Batch) -> Option<String> {
    let verdicts = match caught(|| ask(way, batch)) {
        Ok(verdicts) => verdicts,
        Err(what) => return Some(what),
    };
    batch.queries.iter().zip(verdicts).find_map(|(query, verdict)| {
        judge(batch, query, verdict).and_then(|()| judge_exactly(batch, query, verdict)).err()
    })
}

/// One query if one is enough, of the least numbers with which it still fails.
fn shrink(way: Way, batch: &Batch, what: String) -> Found {
    let with = |queries: &[Query]| Batch { queries: queries.to_vec(), ..batch.clone() };
    let few = fewest(&batch.queries, |queries| fails(way, &with(queries)).is_some());
    let mut best = with(&few);
    let mut smaller = true;
    while smaller {
        smaller = false;
        for i in 0..best.queries.len() {
            let Query { patch, form: Some(form), .. } = best.queries[i] else { continue };
            for change in changes(&form) {
                let mut next = best.clone();
                next.queries[i] = next.assembled(patch, change);
                if fails(way, &next).is_some() {
                    (best, smaller) = (next, true);
                    break;
                }
            }
        }
        let unit = Batch { unit: best.unit / 2, ..best.clone() };
        if best.unit != 0 && fails(way, &unit).is_some() {
            (best, smaller) = (unit, true);
        }
    }
    let what = fails(way, &best).unwrap_or(what);
    let what = format!("{}: {what}, known is {:?}", best.name(), best.queries[0].known);
    Found { what, code: code(way, &best) }
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

fn code(way: Way, batch: &Batch) -> String {
    let time = format!("{}.0 / {}.0", batch.p, batch.q);
    let real = if batch.wide { "f64" } else { "f32" };
    let d = distance(batch);
    let [from, until] = batch.window;
    let check = |toi: &str, certain: &str| {
        let mut text = String::new();
        for (i, query) in batch.queries.iter().enumerate() {
            let [toi, certain] = [toi, certain].map(|text| text.replace('#', &i.to_string()));
            text += &match query.known {
                Known::At { first } => {
                    let early =
                        if first { format!(" && t > {time} - 1.001e-6") } else { "".into() };
                    format!("assert!({toi}.is_some_and(|t| t <= {time}{early}));\n")
                }
                Known::Free => format!("assert!(!{certain});\n"),
                Known::Nothing => {
                    let [t0, t1] = ends::<f64>(batch, query);
                    let patch = query.patch;
                    let right = contact(patch, &t0, &t1);
                    format!(
                        "// Exactly: {right:?}.\nprintln!(\"{{:?}} {{}}\", {toi}, {certain});\n"
                    )
                }
            };
        }
        text
    };
    let points = |end: usize| -> Vec<String> {
        let of = |q: &Query| match batch.wide {
            true => format!("{:?}", ends::<f64>(batch, q)[end]),
            false => format!("{:?}", ends::<f32>(batch, q)[end]),
        };
        batch.queries.iter().map(of).collect()
    };
    match way {
        Way::Alone => {
            let mut text = String::new();
            for (i, (t0, t1)) in points(0).iter().zip(points(1)).enumerate() {
                let patch = batch.queries[i].patch;
                text += &format!(
                    "let t0: [[{real}; 3]; 4] = {t0};\nlet t1: [[{real}; 3]; 4] = {t1};\n\
                     let wanted = ccd_core::narrow_phase::search::Search {{ min_distance: {d:?}, \
                     tolerance: 1e-6, from: {from:?}, until: {until:?}, leaves: {} }};\n\
                     let motion = Motion::new(Patch::{patch:?}, &t0, &t1, 0.0);\n\
                     let answer = ccd_core::narrow_phase::query::search(&motion, \
                     Patch::{patch:?}, &wanted);\nlet verdict = answer.verdict;\n",
                    batch.leaves
                );
            }
            let toi = "verdict.toi().map(f64::from)";
            "use ccd::geometry::{Motion, Patch};\n".to_owned()
                + &text
                + &check(toi, "matches!(verdict, ccd::Verdict::Hit { .. })")
        }
        Way::Session(place, threads) => {
            let Ok((mesh, _)) = mesh(batch) else { return String::new() };
            let n = batch.queries.len();
            let edges: Vec<_> = mesh
                .edges()
                .iter()
                .filter(|e| batch.queries[e[0] as usize / 4].patch == Kind::EdgeEdge.patch())
                .collect();
            let flat =
                |end: usize| points(end).iter().map(|p| format!("    {p},\n")).collect::<String>();
            place.code()
                + &format!(
                    "let mesh = ccd::Mesh::with_edges({}, &{:?}, &{edges:?}).unwrap();\n\
                     let of: Vec<u32> = (0..4 * {n}).map(|v| v / 4).collect();\n\
                     let worlds: Vec<u32> = (0..{n}).collect();\n\
                     let bodies = ccd::Bodies::new(&of, &[], true).with_worlds(&worlds);\n\
                     let options = ccd::Options::default().with_threads({threads})\
                     .with_bodies(bodies).with_min_distance({d:?}).with_leave_contact({});\n\
                     let mut session = ccd::any::Session::new(&choice, mesh, options).unwrap();\n\
                     let x0: Vec<[{real}; 3]> = [\n{}].concat();\n\
                     let x1: Vec<[{real}; 3]> = [\n{}].concat();\n\
                     let report = session.step_window(&x0, &x1, [{from:?}, {until:?}]).unwrap();\n\
                     let found = |query: u32| report.contacts.iter().find(|c| \
                     report.mesh().vertices_of(c.kind, ccd::Pair {{ a: c.a, b: c.b }})[0] / 4 == \
                     query);\n",
                    4 * n,
                    mesh.faces(),
                    batch.leaves,
                    flat(0),
                    flat(1)
                )
                + &check(
                    "found(#).map(|c| c.toi)",
                    "found(#).is_some_and(|c| c.state == ccd::State::Hit)",
                )
        }
    }
}
