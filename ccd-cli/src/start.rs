//! Whether the first frame already passes through itself, exactly: steps from there on cannot tell,
//! for what is through stays through without a contact.

use super::{output, toi};
use ccd::any::Session;
use ccd::{Report, State};
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// Edges and faces of the first frame that have a point in common but no vertex.
#[derive(Serialize, Deserialize)]
pub struct Intersections {
    pub pairs: usize,
    /// Pairs with coordinates so large or small that only their boxes were compared.
    undecided: usize,
    /// The first pair.
    example: Option<Example>,
    /// Whether options leave pairs out.
    #[serde(skip)]
    of_some: bool,
    /// Time of the check.
    #[serde(skip)]
    pub ms: f64,
}

/// The vertices of an edge and of a face.
#[derive(Serialize, Deserialize)]
struct Example {
    edge: [u32; 2],
    face: [u32; 3],
}

impl Intersections {
    /// Intersections of a session's mesh, among the pairs that its bodies want, which are not all
    /// if they are `of_some`; on the CPU.
    pub fn of(session: &mut Session, x: &[[f64; 3]], of_some: bool) -> Result<Self, ccd::Error> {
        let start = Instant::now();
        let found = session.intersections(x)?;
        let mesh = session.mesh();
        let example = |i: &ccd::Intersection| Example {
            edge: mesh.edges()[i.edge as usize],
            face: mesh.faces()[i.face as usize],
        };
        Ok(Self {
            pairs: found.len(),
            undecided: found.iter().filter(|i| i.state == State::Undecided).count(),
            example: found.first().map(example),
            of_some,
            ms: start.elapsed().as_secs_f64() * 1e3,
        })
    }

    /// A verb phrase for the first frame, if it intersects itself.
    pub fn verb(&self) -> Option<&'static str> {
        match self.pairs {
            0 => None,
            n if n == self.undecided => Some("may touch or pass through itself"),
            _ => Some("touches or passes through itself"),
        }
    }

    /// Prints it as lines of text. `stays`: it is the start of a whole step without a contact.
    pub fn print(&self, stays: bool) {
        let ms = output::milliseconds(self.ms);
        let (Some(verb), Some(Example { edge, face })) = (self.verb(), &self.example) else {
            let text = match self.of_some {
                false => "the first frame does not intersect itself",
                true => "no intersections among the pairs that are tested",
            };
            return output::line("start", format_args!("{text} (exact, {ms})"));
        };
        let text =
            format!("the first frame {verb}: {}", output::counted(self.pairs as u64, "pair"));
        output::line("start", text);
        let ([a, b], [c, d, e]) = (edge, face);
        output::line("", format!("such as edge {a} {b} and face {c} {d} {e} (exact, {ms})"));
        if stays {
            output::line("", "without a contact they still pass through each other at the end");
        }
    }
}

/// Whether a window is the whole step.
pub fn is_whole([from, until]: [f64; 2]) -> bool {
    from <= 0.0 && until >= 1.0
}

/// A window in words behind others, none for the whole step.
pub fn within(window: [f64; 2]) -> String {
    let [from, until] = window;
    if is_whole(window) { String::new() } else { format!(" from {from} to {until} of the step") }
}

/// Result of a window of a step in one sentence for people.
pub fn sentence(report: &Report, start: &Intersections, window: [f64; 2]) -> String {
    let ([from, _], within) = (window, within(window));
    match (report.toi, start.verb()) {
        (None, None) if is_whole(window) => "No contact: the whole step is free.".into(),
        (None, None) => format!("No contact{within}."),
        (None, Some(verb)) => format!("No contact{within}, but the first frame {verb}."),
        (Some(time), _) if from > 0.0 => {
            format!("First contact from {from} of the step on: {}.", toi::when(time))
        }
        (Some(0.0), _) => "There are contacts from the start of the step on.".into(),
        (Some(time), _) => format!("First contact {} of the step.", toi::when(time)),
    }
}
