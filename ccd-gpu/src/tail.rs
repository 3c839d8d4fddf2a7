//! The end of a step on the CPU: what `f32` left open is decided in `f64`, and contacts get their canonical order.

use ccd_core::Real;
use ccd_core::kernel::narrow;
use ccd_core::layout::{Pair, Touch, join};
use ccd_core::report::{Contact, Kind, State};
use ccd_core::topology::Mesh;

/// Pairs that a thread takes at least; starting one costs as much as some tens of pairs.
const MIN_SHARE: usize = 256;

/// Decides pairs in `f64` on all cores and appends those that touch or stay undecided.
pub fn decide<T: Real + Sync>(
    mesh: &Mesh,
    kind: Kind,
    pairs: &[Pair],
    x0: &[[T; 3]],
    x1: &[[T; 3]],
    min_distance: f64,
    out: &mut Vec<Contact>,
) {
    let one = |&pair: &Pair| {
        let verdict = match kind {
            Kind::VertexFace => narrow::vertex_face(narrow::vertex_face_ids(pair, mesh.faces()), x0, x1, min_distance, 0.0),
            Kind::EdgeEdge => narrow::edge_edge(narrow::edge_edge_ids(pair, mesh.edges()), x0, x1, min_distance, 0.0),
        };
        Contact::of(kind, pair, verdict)
    };
    if pairs.len() <= MIN_SHARE {
        out.extend(pairs.iter().filter_map(one));
        return;
    }
    let cores = std::thread::available_parallelism().map_or(1, |n| n.get());
    let share = pairs.len().div_ceil(cores).max(MIN_SHARE);
    std::thread::scope(|scope| {
        let threads: Vec<_> =
            pairs.chunks(share).map(|part| scope.spawn(move || part.iter().filter_map(one).collect::<Vec<_>>())).collect();
        for thread in threads {
            match thread.join() {
                Ok(found) => out.extend(found),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
    });
}

/// Puts contacts in order; buffers are kept.
#[derive(Debug, Default)]
pub struct Order {
    starts: Vec<u32>,
}

impl Order {
    /// Fills `out` with the contacts by kind, `a`, `b`: counted by kind and `a`, then each run by `b`. Runs are short, so this is linear.
    pub fn sort(&mut self, touches: &[Touch], mesh: &Mesh, out: &mut Vec<Contact>) {
        out.clear();
        let n_vertices = mesh.n_vertices();
        let key = |t: &Touch| if t.kind == 0 { t.a as usize } else { n_vertices + t.a as usize };
        let n_keys = n_vertices + mesh.edges().len();
        if touches.len() < n_keys / 16 {
            out.extend(touches.iter().map(contact));
            out.sort_unstable_by_key(|c| (c.kind, c.a, c.b));
            return;
        }
        self.starts.clear();
        self.starts.resize(n_keys + 1, 0);
        touches.iter().for_each(|t| self.starts[key(t) + 1] += 1);
        for i in 0..n_keys {
            self.starts[i + 1] += self.starts[i];
        }
        let none = Contact { kind: Kind::VertexFace, state: State::Hit, a: 0, b: 0, toi: 0.0 };
        out.resize(touches.len(), none);
        for t in touches {
            let to = &mut self.starts[key(t)];
            out[*to as usize] = contact(t);
            *to += 1;
        }
        // Every start has moved to the end of its run.
        let mut from = 0;
        for &end in &self.starts[..n_keys] {
            let end = end as usize;
            if end > from + 1 {
                out[from..end].sort_unstable_by_key(|c| c.b);
            }
            from = end;
        }
    }
}

fn contact(touch: &Touch) -> Contact {
    Contact {
        kind: if touch.kind == 0 { Kind::VertexFace } else { Kind::EdgeEdge },
        state: if touch.state == 0 { State::Hit } else { State::Undecided },
        a: touch.a,
        b: touch.b,
        toi: join(touch.toi),
    }
}
