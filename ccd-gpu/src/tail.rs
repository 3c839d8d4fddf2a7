//! The end of a step on the CPU: what `f32` left open is decided in `f64`, and contacts get their canonical order.

use ccd_core::Real;
use ccd_core::Verdict;
use ccd_core::kernel::narrow;
use ccd_core::layout::Pair;
use ccd_core::report::{Contact, Kind, State};
use ccd_core::topology::Mesh;

/// Pairs that a thread takes at least; starting one costs as much as some tens of pairs.
const MIN_SHARE: usize = 256;

/// Decides pairs in `f64` on all cores and appends those that touch or stay undecided.
pub fn decide<T: Real>(mesh: &Mesh, kind: Kind, pairs: &[Pair], x0: &[[T; 3]], x1: &[[T; 3]], min_distance: f64, out: &mut Vec<Contact>) {
    let cores = std::thread::available_parallelism().map_or(1, |n| n.get());
    let share = pairs.len().div_ceil(cores).max(MIN_SHARE);
    let wide = |p: &[T; 3]| [p[0].to_f64(), p[1].to_f64(), p[2].to_f64()];
    // Only what the pairs touch is widened, so slices of `f64` are made once for all of them.
    if pairs.is_empty() {
        return;
    }
    let (x0, x1): (Vec<_>, Vec<_>) = (x0.iter().map(wide).collect(), x1.iter().map(wide).collect());
    let work = |pairs: &[Pair]| -> Vec<Contact> { pairs.iter().filter_map(|&pair| one(mesh, kind, pair, &x0, &x1, min_distance)).collect() };
    if pairs.len() <= MIN_SHARE {
        out.extend(work(pairs));
        return;
    }
    std::thread::scope(|scope| {
        let threads: Vec<_> = pairs.chunks(share).map(|part| scope.spawn(|| work(part))).collect();
        for thread in threads {
            match thread.join() {
                Ok(found) => out.extend(found),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
    });
}

fn one(mesh: &Mesh, kind: Kind, pair: Pair, x0: &[[f64; 3]], x1: &[[f64; 3]], min_distance: f64) -> Option<Contact> {
    let verdict: Verdict<f64> = match kind {
        Kind::VertexFace => narrow::vertex_face(narrow::vertex_face_ids(pair, mesh.faces()), x0, x1, min_distance, 0.0),
        Kind::EdgeEdge => narrow::edge_edge(narrow::edge_edge_ids(pair, mesh.edges()), x0, x1, min_distance, 0.0),
    };
    let (state, toi) = match verdict {
        Verdict::Miss => return None,
        Verdict::Hit { toi } => (State::Hit, toi),
        Verdict::Undecided { toi } => (State::Undecided, toi),
    };
    Some(Contact { kind, state, a: pair.a, b: pair.b, toi })
}

/// Sorts by kind, `a`, `b`: counted by kind and `a`, then each run by `b`. Runs are short, so this is linear.
pub fn sort(contacts: &mut Vec<Contact>, mesh: &Mesh) {
    let n_vertices = mesh.n_vertices();
    let key = |c: &Contact| match c.kind {
        Kind::VertexFace => c.a as usize,
        Kind::EdgeEdge => n_vertices + c.a as usize,
    };
    let n_keys = n_vertices + mesh.edges().len();
    if contacts.len() < n_keys / 16 {
        contacts.sort_unstable_by_key(|c| (c.kind, c.a, c.b));
        return;
    }
    let mut starts = vec![0u32; n_keys + 1];
    contacts.iter().for_each(|c| starts[key(c) + 1] += 1);
    for i in 0..n_keys {
        starts[i + 1] += starts[i];
    }
    let mut next = starts.clone();
    let mut sorted = contacts.clone();
    for c in contacts.iter() {
        let to = &mut next[key(c)];
        sorted[*to as usize] = *c;
        *to += 1;
    }
    for i in 0..n_keys {
        let run = &mut sorted[starts[i] as usize..starts[i + 1] as usize];
        if run.len() > 1 {
            run.sort_unstable_by_key(|c| c.b);
        }
    }
    *contacts = sorted;
}
