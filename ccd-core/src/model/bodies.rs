//! The bodies that vertices belong to, and which pairs of them are looked at.

use super::contact::Kind;
use super::exclusions::Exclusions;
use super::groups::Groups;
use super::mesh::Mesh;
use crate::model::error::Error;
use alloc::vec::Vec;

/// Which body each vertex belongs to, which bodies stand still, and which pairs are wanted.
///
/// A pair of features is left out if
/// - both are of one body, and that has no self-contact;
/// - both bodies stand still: each is fixed or sleeps;
/// - their bodies are two, and their [`Groups`] do not meet, or the pair of bodies is excluded;
/// - their bodies are in different worlds;
/// - the pair of features itself is excluded.
///
/// Setters add rules to a default. A rule only leaves pairs out: the others are found exactly as
/// without it.
///
/// ```
/// use ccd::{Bodies, Groups};
///
/// let floor = Groups { memberships: 1, filter: 2 };
/// let bodies = Bodies::new(&[0, 0, 1, 2])
///     .with_fixed(0, true)
///     .with_groups(0, floor)
///     .with_groups(1, Groups { memberships: 4, filter: !0 })
///     .with_excluded_bodies(&[[1, 2]]);
/// // The floor is looked at against group 2 alone, of which body 1 is none.
/// assert!(!bodies.wants(0, 2) && bodies.wants(0, 3) && !bodies.wants(2, 3));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bodies {
    body_of_vertex: Vec<u32>,
    /// Bodies by name, which may need all bits of a word; their places here are their numbers.
    names: Vec<u32>,
    number_of_vertex: Vec<u32>,
    rules: Vec<Body>,
    /// Numbers of bodies, the lesser first; in order.
    excluded_bodies: Vec<[u32; 2]>,
    /// Kind, ids; in order.
    excluded_features: Vec<(Kind, [u32; 2])>,
    fixed_may_move: bool,
    /// A body that a rule names and no vertex belongs to.
    unknown: Option<u32>,
}

/// The rules of one body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Body {
    pub self_contact: bool,
    pub fixed: bool,
    pub sleeping: bool,
    pub groups: Groups,
    pub world: u32,
}

impl Body {
    /// Whether it is not to move.
    pub fn is_still(&self) -> bool {
        self.fixed || self.sleeping
    }
}

impl Bodies {
    /// Worlds are numbered below this: their numbers stand in the upper bits of sort keys.
    pub const MAX_WORLDS: u32 = 1 << 16;

    /// The body of each vertex, by its name, which may be any number. Bodies move, and touch
    /// themselves and each other.
    pub fn new(body_of_vertex: &[u32]) -> Self {
        let mut names = body_of_vertex.to_vec();
        names.sort_unstable();
        names.dedup();
        let rules = Body {
            self_contact: true,
            fixed: false,
            sleeping: false,
            groups: Groups::ALL,
            world: 0,
        };
        let number = |name: &u32| names.partition_point(|n| n < name) as u32;
        Self {
            number_of_vertex: body_of_vertex.iter().map(number).collect(),
            rules: names.iter().map(|_| rules).collect(),
            body_of_vertex: body_of_vertex.to_vec(),
            names,
            excluded_bodies: Vec::new(),
            excluded_features: Vec::new(),
            fixed_may_move: false,
            unknown: None,
        }
    }

    /// With pairs of features within each body looked at or not.
    #[must_use]
    pub fn with_self_contacts(mut self, self_contact: bool) -> Self {
        self.rules.iter_mut().for_each(|rules| rules.self_contact = self_contact);
        self
    }

    /// With those bodies fixed whose entry is true, by their names (missing entries are false), and
    /// no other; see [`Bodies::with_fixed`].
    #[must_use]
    pub fn with_fixed_mask(mut self, fixed: &[bool]) -> Self {
        for (rules, &name) in self.rules.iter_mut().zip(&self.names) {
            rules.fixed = fixed.get(name as usize).copied().unwrap_or(false);
        }
        self
    }

    /// With pairs of features within one body looked at or not.
    #[must_use]
    pub fn with_self_contact(self, body: u32, self_contact: bool) -> Self {
        self.change(body, |rules| rules.self_contact = self_contact)
    }

    /// With a body fixed or not: two bodies that stand still are no pair, and one that moves in a
    /// step is an error, see [`Bodies::with_fixed_motion`].
    #[must_use]
    pub fn with_fixed(self, body: u32, fixed: bool) -> Self {
        self.change(body, |rules| rules.fixed = fixed)
    }

    /// The body of each vertex, by the numbers given.
    pub fn body_of_vertex(&self) -> &[u32] {
        &self.body_of_vertex
    }

    /// With a body asleep or not: while it sleeps it is as one that is fixed.
    #[must_use]
    pub fn with_sleeping(self, body: u32, sleeping: bool) -> Self {
        self.change(body, |rules| rules.sleeping = sleeping)
    }

    /// With the groups of a body, by which it is looked at against other bodies.
    #[must_use]
    pub fn with_groups(self, body: u32, groups: Groups) -> Self {
        self.change(body, |rules| rules.groups = groups)
    }

    /// Without these pairs of bodies, besides those before; a body with itself: without its
    /// self-contact.
    #[must_use]
    pub fn with_excluded_bodies(mut self, pairs: &[[u32; 2]]) -> Self {
        for &[a, b] in pairs {
            match [self.number(a), self.number(b)] {
                [Some(i), Some(j)] if i == j => self.rules[i].self_contact = false,
                [Some(i), Some(j)] => {
                    self.excluded_bodies.push([i.min(j) as u32, i.max(j) as u32]);
                }
                [None, _] => self.unknown = Some(a),
                [_, None] => self.unknown = Some(b),
            }
        }
        self.excluded_bodies.sort_unstable();
        self.excluded_bodies.dedup();
        self
    }

    /// Without these pairs of features, besides those before: a vertex and a face, or two edges in
    /// any order, by their ids in the mesh.
    #[must_use]
    pub fn with_excluded_features(mut self, kind: Kind, pairs: &[[u32; 2]]) -> Self {
        self.excluded_features.extend(pairs.iter().map(|&pair| (kind, ordered(kind, pair))));
        self.excluded_features.sort_unstable();
        self.excluded_features.dedup();
        self
    }

    /// Without the pairs of features of these lists, besides those before.
    ///
    /// ```
    /// use ccd::{Bodies, Exclusions, Mesh};
    ///
    /// // One body, whose neighbouring features are nearer than some minimum distance.
    /// let mesh = Mesh::new(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
    /// let near = Exclusions::of_neighbours(&mesh, 1);
    /// let bodies = Bodies::new(&[0; 5]).with_exclusions(&near);
    /// assert!(bodies.check(&mesh).is_ok());
    /// # Ok::<(), ccd::Error>(())
    /// ```
    #[must_use]
    pub fn with_exclusions(self, lists: &Exclusions) -> Self {
        self.with_excluded_features(Kind::VertexFace, &lists.vf)
            .with_excluded_features(Kind::EdgeEdge, &lists.ee)
    }

    /// With the world of each body, by its name (missing entries are 0), below
    /// [`Bodies::MAX_WORLDS`]: many independent scenes in one call. Bodies of two worlds are never
    /// looked at, wherever they are.
    ///
    /// The methods `blocks` of both backends leave such pairs out from the roots on; all others
    /// find them, and drop them one by one.
    #[must_use]
    pub fn with_worlds(mut self, worlds: &[u32]) -> Self {
        for (rules, &name) in self.rules.iter_mut().zip(&self.names) {
            rules.world = worlds.get(name as usize).copied().unwrap_or(0);
        }
        self
    }

    /// With the world of one body, see [`Bodies::with_worlds`].
    #[must_use]
    pub fn with_world(self, body: u32, world: u32) -> Self {
        self.change(body, |rules| rules.world = world)
    }

    /// With bodies that are fixed or asleep allowed to move, as a caller drives them: no step is
    /// refused for it. Two of them are no pair still.
    #[must_use]
    pub fn with_fixed_motion(mut self, may_move: bool) -> Self {
        self.fixed_may_move = may_move;
        self
    }

    /// Whether bodies that are fixed or asleep may move.
    pub fn fixed_may_move(&self) -> bool {
        self.fixed_may_move
    }

    /// Whether the body of vertex `v` stands still: is fixed or sleeps.
    #[inline]
    pub fn is_fixed(&self, v: u32) -> bool {
        self.of_vertex(v).is_still()
    }

    /// The world of vertex `v`.
    pub fn world(&self, v: u32) -> u32 {
        self.of_vertex(v).world
    }

    /// Whether features of the bodies of vertices `v` and `w` are to be tested against each other.
    pub fn wants(&self, v: u32, w: u32) -> bool {
        let (a, b) = (self.of_vertex(v), self.of_vertex(w));
        let [i, j] = [v, w].map(|v| self.number_of_vertex[v as usize]);
        if a.is_still() && b.is_still() {
            return false;
        }
        if i == j {
            return a.self_contact;
        }
        let excluded = self.excluded_bodies.binary_search(&[i.min(j), i.max(j)]).is_ok();
        a.world == b.world && a.groups.meet(b.groups) && !excluded
    }

    /// Whether a pair of features is excluded by itself.
    pub fn excludes(&self, kind: Kind, a: u32, b: u32) -> bool {
        self.excluded_features.binary_search(&(kind, ordered(kind, [a, b]))).is_ok()
    }

    /// Checks that there is a body for every vertex, that no element joins two, and that rules name
    /// what there is.
    ///
    /// # Errors
    /// [`Error::BodyCount`], [`Error::MixedBodies`], [`Error::NoBody`], [`Error::NoFeature`],
    /// [`Error::TooMany`] of worlds.
    pub fn check(&self, mesh: &Mesh) -> Result<(), Error> {
        if self.body_of_vertex.len() != mesh.n_vertices() {
            return Err(Error::BodyCount {
                expected: mesh.n_vertices(),
                found: self.body_of_vertex.len(),
            });
        }
        let mixed = |element, at, v: &[u32]| {
            let body = |v: u32| self.body_of_vertex[v as usize];
            let first = body(v[0]);
            match v.iter().map(|&v| body(v)).find(|&b| b != first) {
                Some(other) => Err(Error::MixedBodies { element, at, bodies: [first, other] }),
                None => Ok(()),
            }
        };
        mesh.faces().iter().enumerate().try_for_each(|(at, f)| mixed("face", at, f))?;
        mesh.edges().iter().enumerate().try_for_each(|(at, e)| mixed("edge", at, e))?;
        if let Some(body) = self.unknown {
            return Err(Error::NoBody { body });
        }
        if let Some(world) =
            self.rules.iter().map(|rules| rules.world).find(|&w| w >= Self::MAX_WORLDS)
        {
            let (count, limit) = (world as u64 + 1, Self::MAX_WORLDS as u64);
            return Err(Error::TooMany { element: "worlds", count, limit });
        }
        let vertices = ("vertex", mesh.n_vertices());
        let (edges, faces) = (("edge", mesh.edges().len()), ("face", mesh.faces().len()));
        for &(kind, ids) in &self.excluded_features {
            let features = match kind {
                Kind::VertexFace => [vertices, faces],
                Kind::EdgeEdge => [edges; 2],
                Kind::VertexEdge => [vertices, edges],
                Kind::VertexVertex => [vertices; 2],
            };
            for ((element, n), id) in features.into_iter().zip(ids) {
                if id as usize >= n {
                    return Err(Error::NoFeature { element, id, n });
                }
            }
        }
        Ok(())
    }

    /// Sets whether a body sleeps.
    ///
    /// # Errors
    /// [`Error::NoBody`] if no vertex belongs to it.
    pub fn set_sleeping(&mut self, body: u32, sleeping: bool) -> Result<(), Error> {
        self.body(body)?.sleeping = sleeping;
        Ok(())
    }

    /// Sets whether a body is fixed.
    ///
    /// # Errors
    /// [`Error::NoBody`] if no vertex belongs to it.
    pub fn set_fixed(&mut self, body: u32, fixed: bool) -> Result<(), Error> {
        self.body(body)?.fixed = fixed;
        Ok(())
    }

    /// The name of the body of vertex `v`.
    pub fn name(&self, v: u32) -> u32 {
        self.body_of_vertex[v as usize]
    }

    #[cfg(feature = "serde")]
    pub(super) fn names(&self) -> &[u32] {
        &self.names
    }

    /// A body that a rule names and no vertex belongs to.
    #[cfg(feature = "serde")]
    pub(super) fn unknown(&self) -> Option<u32> {
        self.unknown
    }

    pub(crate) fn numbers(&self) -> &[u32] {
        &self.number_of_vertex
    }

    pub(crate) fn all(&self) -> &[Body] {
        &self.rules
    }

    pub(crate) fn excluded_bodies(&self) -> &[[u32; 2]] {
        &self.excluded_bodies
    }

    pub(crate) fn excluded_features(&self) -> &[(Kind, [u32; 2])] {
        &self.excluded_features
    }

    fn of_vertex(&self, v: u32) -> &Body {
        &self.rules[self.number_of_vertex[v as usize] as usize]
    }

    pub(super) fn number(&self, name: u32) -> Option<usize> {
        self.names.binary_search(&name).ok()
    }

    fn body(&mut self, name: u32) -> Result<&mut Body, Error> {
        let number = self.number(name).ok_or(Error::NoBody { body: name })?;
        Ok(&mut self.rules[number])
    }

    fn change(mut self, name: u32, change: impl FnOnce(&mut Body)) -> Self {
        match self.number(name) {
            Some(number) => change(&mut self.rules[number]),
            None => self.unknown = Some(name),
        }
        self
    }
}

mod part;
mod ready;

/// A pair of features as lists have it: of one set, the lesser first.
fn ordered(kind: Kind, [a, b]: [u32; 2]) -> [u32; 2] {
    match kind {
        Kind::EdgeEdge | Kind::VertexVertex => [a.min(b), a.max(b)],
        _ => [a, b],
    }
}

#[cfg(test)]
mod tests;
