//! Bodies of vertices, and which of them do not move.

use super::{Failure, INPUT, QUESTION, in_file};
use ccd::{Bodies, Exclusions, Groups, Mesh};
use clap::Args;
use std::path::{Path, PathBuf};

/// Options that select pairs by the bodies of their features.
#[derive(Args)]
pub struct BodyOptions {
    /// The body of each vertex, as whole numbers from 0
    ///
    /// Separated by white space or commas. Without it the connected parts of the mesh are the
    /// bodies, numbered in the order of their first vertices. Of several objects: of all vertices,
    /// in order.
    #[arg(long, value_name = "FILE", help_heading = INPUT)]
    bodies: Option<PathBuf>,
    /// Leave out contacts within one body, or one connected part if no bodies are given
    #[arg(long, help_heading = QUESTION)]
    no_self_contact: bool,
    /// Bodies that do not move, such as 0,3
    ///
    /// Contacts between two of them are left out.
    #[arg(long, value_name = "BODY", value_delimiter = ',', allow_hyphen_values = true)]
    #[arg(help_heading = INPUT)]
    fixed: Vec<u32>,
    /// Layers that a body is in (M) and touches (F), as bits: 3=1/6,4=2/1
    ///
    /// Two bodies touch if each is in a layer that the other one touches; without this a body is
    /// in all layers and touches all.
    #[arg(long, value_name = "BODY=M/F", value_delimiter = ',', value_parser = layers)]
    #[arg(allow_hyphen_values = true, hide_short_help = true, help_heading = QUESTION)]
    layers: Vec<(u32, Groups)>,
    /// Leave out pairs of features at most N edges apart in the mesh
    ///
    /// With a --min-distance above the length of edges, neighbours would always be in contact.
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    #[arg(hide_short_help = true, help_heading = QUESTION)]
    exclude_neighbours: Option<u32>,
}

/// A body and its layers: `3=1/6`.
fn layers(text: &str) -> Result<(u32, Groups), String> {
    let read = || {
        let (body, rest) = text.split_once('=')?;
        let (memberships, filter) = rest.split_once('/')?;
        let groups =
            Groups { memberships: memberships.parse().ok()?, filter: filter.parse().ok()? };
        Some((body.parse().ok()?, groups))
    };
    read()
        .ok_or("a body, the layers that it is in, and those that it touches, such as 3=1/6".into())
}

impl BodyOptions {
    /// The file that is read, if any.
    pub fn file(&self) -> Option<&Path> {
        self.bodies.as_deref()
    }

    /// Whether an option leaves pairs out, which no test looks at then.
    pub fn leaves_pairs_out(&self) -> bool {
        let by_body = !self.fixed.is_empty() || !self.layers.is_empty() || self.no_self_contact;
        by_body || self.exclude_neighbours.is_some()
    }

    /// The bodies of a mesh, if any option speaks of them; of several objects, that of each vertex
    /// and which stand still, unless a file has others. `max_memory`: bytes that lists of
    /// neighbours may take.
    pub fn of(
        &self,
        mesh: &Mesh,
        objects: Option<(Vec<u32>, Vec<bool>)>,
        max_memory: Option<u64>,
    ) -> Result<Option<Bodies>, Failure> {
        let is_chosen = self.bodies.is_some() || self.leaves_pairs_out();
        if !is_chosen && objects.is_none() {
            return Ok(None);
        }
        let (of_vertex, mut fixed) = match (&self.bodies, objects) {
            (Some(path), _) => (read(path, mesh.n_vertices())?, Vec::new()),
            (None, Some(objects)) => objects,
            (None, None) => (Bodies::of_components(mesh).body_of_vertex().to_vec(), Vec::new()),
        };
        let most = of_vertex.iter().max().copied();
        fixed.resize(most.map_or(0, |most| most as usize + 1), false);
        let missing = |option: &str, body: u32| {
            let last =
                most.map_or("there is none".into(), |most| format!("the last one is {most}"));
            Failure(format!("{option}: there is no body {body}; {last}"))
        };
        for &body in &self.fixed {
            if !of_vertex.contains(&body) {
                return Err(missing("--fixed", body));
            }
            fixed[body as usize] = true;
        }
        for (at, (body, _)) in self.layers.iter().enumerate() {
            if !of_vertex.contains(body) {
                return Err(missing("--layers", *body));
            }
            if self.layers[..at].iter().any(|(before, _)| before == body) {
                return Err(Failure(format!("--layers: body {body} is given twice")));
            }
        }
        let mut bodies = Bodies::new(&of_vertex)
            .with_fixed_mask(&fixed)
            .with_self_contacts(!self.no_self_contact);
        for &(body, groups) in &self.layers {
            bodies = bodies.with_groups(body, groups);
        }
        if let Some(rings) = self.exclude_neighbours {
            let most = max_memory.unwrap_or(u64::MAX);
            let near = Exclusions::of_neighbours_within(mesh, rings, most)?;
            bodies = bodies.with_exclusions(&near);
        }
        Ok(Some(bodies))
    }
}

/// The most bodies of a file, so that a number that is none of a body is told from one.
const MOST_BODIES: u32 = 1 << 24;

fn read(path: &Path, n_vertices: usize) -> Result<Vec<u32>, Failure> {
    let text = std::fs::read_to_string(path).map_err(|e| in_file(path, e))?;
    let mut bodies = Vec::with_capacity(n_vertices);
    // Some editors begin a file with a mark.
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    for (line, words) in text.lines().enumerate() {
        let separator = |c: char| c.is_whitespace() || c == ',';
        for word in words.split(separator).filter(|word| !word.is_empty()) {
            let body = word.parse().ok().filter(|&body: &u32| body < MOST_BODIES);
            bodies.push(body.ok_or_else(|| {
                let (line, word) = (line + 1, word.chars().take(20).collect::<String>());
                let most = MOST_BODIES - 1;
                let what = format!("`{word}` is not a body, a whole number from 0 to {most}");
                in_file(path, format_args!("line {line}: {what}"))
            })?);
        }
    }
    if bodies.len() != n_vertices {
        let n = bodies.len();
        return Err(in_file(path, format_args!("{n} bodies for {n_vertices} vertices")));
    }
    Ok(bodies)
}
