//! Ties of a step: pairs that arithmetic in `f64` leaves open, and integers decide. What it would
//! take to leave them open, and what it takes to decide them.

use crate::measure::median_of;
use ccd::{Kind, Mesh, Options, Pair, Session};
use ccd_core::model::decision::Decider;
use ccd_core::narrow_phase::pair_verdict;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// All times of a step.
const WHOLE: [f64; 2] = [0.0, 1.0];

/// Figures of the ties of a step.
#[derive(Deserialize, Serialize)]
pub struct Ties {
    pub n: u64,
    /// Those of them that are contacts.
    pub contacts: u64,
    /// Milliseconds of one thread for all of them: in `f64`, which leaves them open.
    pub open_ms: f64,
    /// The same with integers, which decide them.
    pub decided_ms: f64,
}

/// Finds the ties among all candidates on so many threads, and times them on one.
pub fn measure(
    mesh: &Arc<Mesh>,
    x: [&[[f64; 3]]; 2],
    threads: usize,
    runs: usize,
) -> Result<Ties, String> {
    let options = Options::default();
    let mut session = Session::new(mesh.clone(), options.clone().with_threads(threads))
        .map_err(|e| e.to_string())?;
    let found = session.candidates(x[0], x[1]).map_err(|e| e.to_string())?;
    let of_kind = |kind: Kind| move |pair: Pair| (kind, pair);
    let vf = found.vf.iter().map(of_kind(Kind::VertexFace));
    let all: Vec<(Kind, Pair)> = vf.chain(found.ee.iter().map(of_kind(Kind::EdgeEdge))).collect();
    let search = options.search(WHOLE);
    let is_open = |&(kind, pair): &(Kind, Pair)| {
        pair_verdict::pair(kind, mesh.vertices_of(kind, pair), x, &search).is_open()
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|e| e.to_string())?;
    let ties: Vec<(Kind, Pair)> =
        pool.install(|| all.into_par_iter().filter(|pair| is_open(pair)).collect());
    let decider = Decider::new(&options, WHOLE);
    let contact = |&(kind, pair): &(Kind, Pair)| decider.contact(mesh, kind, pair, x);
    let open = || Ok::<_, String>(ties.iter().filter(|pair| is_open(pair)).count());
    let (open_ms, n_open) = median_of(runs, open)?;
    let decided = || Ok::<_, String>(ties.iter().filter_map(contact).count());
    let (decided_ms, n_contacts) = median_of(runs, decided)?;
    if n_open != ties.len() {
        return Err(format!("{n_open} of {} ties are open", ties.len()));
    }
    let still = ties.iter().filter_map(contact).filter(|c| c.state == ccd::State::Undecided);
    match still.count() {
        0 => Ok(Ties { n: n_open as u64, contacts: n_contacts as u64, open_ms, decided_ms }),
        n => Err(format!("{n} ties are not decided")),
    }
}
