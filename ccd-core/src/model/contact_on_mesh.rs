//! A contact on its mesh: its vertices, and how they meet at the time of impact.

use crate::layout::Pair;
use crate::model::bodies::Bodies;
use crate::model::contact::{Contact, Kind, State};
use crate::model::mesh::Mesh;
use crate::model::positions::{AsPositions, Ends, PositionView, ends};
use crate::model::precision::{Coordinate, Precision};
use crate::narrow_phase::contact_geometry::{ContactGeometry, contact_geometry};
use crate::narrow_phase::exact::{Meeting, meeting};

impl Contact {
    /// Its vertices: `v f0 f1 f2`, the vertex and those of the face as the mesh has them, or
    /// `ea0 ea1 eb0 eb1`, those of both edges; `v e0 e1 e1` and `v w w w` of particles and rods,
    /// with their last one repeated.
    ///
    /// # Panics
    /// If the contact is none of this mesh and names features that it does not have.
    pub fn vertices(&self, mesh: &Mesh) -> [u32; 4] {
        mesh.vertices_of(self.kind, Pair { a: self.a, b: self.b })
    }

    /// The bodies of its features, by their names: of `a`, then of `b`.
    ///
    /// # Panics
    /// If the contact is none of this mesh, or the bodies are those of another one.
    pub fn bodies(&self, mesh: &Mesh, bodies: &Bodies) -> [u32; 2] {
        let vertices = self.vertices(mesh);
        [vertices[0], vertices[3]].map(|v| bodies.name(v))
    }

    /// Point, normal and weights at the time of impact, from the positions that were given to the
    /// step: see [`ContactGeometry`], and for the rules of the sign and of what is degenerate
    /// [`contact_geometry`].
    ///
    /// ```
    /// use ccd::{Contact, Kind, Mesh, State};
    ///
    /// // A vertex falls through a triangle.
    /// let mesh = Mesh::new(4, &[[0, 1, 2]])?;
    /// let x0 = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, -4.0], [1.0, 1.0, -1.0f64]];
    /// let mut x1 = x0;
    /// x1[3][1] = -1.0;
    /// let contact = Contact::new(Kind::VertexFace, State::Hit, 3, 0, 0.5);
    /// let vertices = contact.vertices(&mesh);
    /// assert_eq!(vertices, [3, 0, 1, 2]);
    ///
    /// let at = contact.geometry(&mesh, &x0, &x1);
    /// assert_eq!((at.point, at.normal), ([1.0, 0.0, -1.0], [0.0, 1.0, 0.0]));
    /// assert_eq!(at.weights, [1.0, 0.5, 0.25, 0.25]);
    ///
    /// // How fast they meet: the velocity of `a` less that of `b`, along the normal.
    /// let along = |i: usize| {
    ///     let v = vertices[i] as usize;
    ///     let part = if i < contact.kind.n_first() { at.weights[i] } else { -at.weights[i] };
    ///     (0..3).map(|k| part * at.normal[k] * (x1[v][k] - x0[v][k])).sum::<f64>()
    /// };
    /// assert_eq!((0..4).map(along).sum::<f64>(), -2.0);
    /// # Ok::<(), ccd::Error>(())
    /// ```
    ///
    /// Positions are whatever [`Session::step`](super::session::Session::step) takes; what is
    /// computed is `f64`. Of an undecided contact it is the geometry at the
    /// time until which the step is certainly free. One contact takes about a third of a
    /// microsecond.
    ///
    /// # Of exact times
    /// Of a hit that begins between its `toi` and the next `f64`, as all do in
    /// [`Mode::Exact`](super::options::Mode), geometry is that of the true time, by integers:
    ///
    /// - each weight is off by at most 0.51 units in the last place, and 0 or 1 if it is that;
    /// - `on_a` and `on_b` are the positions at `toi`, weighted: off by at most `16 u` of the
    ///   greatest coordinate, `u = 2^-53`; `distance` is 0;
    /// - the normal is perpendicular to the face, or to both edges, to `8 u`, on corners and sides
    ///   too, and points to the side of `b` on which `a` is just before: the relative velocity is
    ///   never along it. If features touch at the start of the step, that is the side from which
    ///   the same motion would have come. Needles and nearly parallel edges are no exception.
    ///
    /// This takes some three microseconds, and tens of them where a weight is 0 or 1 or features
    /// only touch. Where features are in one plane all the time the normal is
    /// by the rules of [`contact_geometry`]; where the face has no area then, edges are parallel,
    /// or features are an edge or a vertex, so are weights and points, because they are not unique
    /// or not quotients of the same forms.
    ///
    /// A normal away from one of both features is this one for `a`, and its opposite for `b`; of a
    /// body, [`Hit::normal_towards`](super::session::Hit::normal_towards).
    ///
    /// # Panics
    /// If the contact is none of this mesh, or there is no position for one of its vertices.
    pub fn geometry<A, B>(&self, mesh: &Mesh, x0: &A, x1: &B) -> ContactGeometry
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        geometry(self, mesh, ends(x0, x1))
    }
}

/// The same with weights and normal of a decided contact, from positions at its time and at both
/// ends of the step.
fn met(
    mut found: ContactGeometry,
    exact: &Meeting,
    n_first: usize,
    [x, t0, t1]: [&[[f64; 3]; 4]; 3],
) -> ContactGeometry {
    let w = exact.weights;
    let sum = |of: core::ops::Range<usize>, k: usize| of.map(|i| w[i] * x[i][k]).sum();
    found.weights = w;
    found.normal = exact.normal.unwrap_or_else(|| {
        // It is against the velocity of other points of an overlap.
        let of = |i: usize, k: usize| w[i] * (t1[i][k] - t0[i][k]);
        let along = |i: usize| (0..3).map(|k| of(i, k) * found.normal[k]).sum::<f64>();
        let speed: f64 = (0..4).map(|i| if i < n_first { along(i) } else { -along(i) }).sum();
        if speed > 0.0 { found.normal.map(|c| -c) } else { found.normal }
    });
    found.on_a = [0, 1, 2].map(|k| sum(0..n_first, k));
    found.on_b = [0, 1, 2].map(|k| sum(n_first..4, k));
    found.point = [0, 1, 2].map(|k| 0.5 * found.on_a[k] + 0.5 * found.on_b[k]);
    found.distance = 0.0;
    found
}

/// [`Contact::geometry`], without the types of positions.
#[inline(never)]
pub(super) fn geometry(contact: &Contact, mesh: &Mesh, x: Ends) -> ContactGeometry {
    let ids = contact.vertices(mesh);
    let [t0, t1] = match x {
        Precision::F32(x) => x.map(|x| gather(ids, x)),
        Precision::F64(x) => x.map(|x| gather(ids, x)),
    };
    let mut found = contact_geometry(contact.kind.patch(), &t0, &t1, contact.toi, 0.0);
    if contact.state == State::Hit
        && let Some(exact) = meeting(contact.kind.patch(), [&t0, &t1], contact.toi)
    {
        let t = contact.toi;
        let at = |i: usize| [0, 1, 2].map(|k| (1.0 - t) * t0[i][k] + t * t1[i][k]);
        found = met(found, &exact, contact.kind.n_first(), [&[0, 1, 2, 3].map(at), &t0, &t1]);
    }
    // A last vertex that is repeated has all of its weight in its first place.
    let weights = &mut found.weights;
    match contact.kind {
        Kind::VertexFace | Kind::EdgeEdge => {}
        Kind::VertexEdge => (weights[2], weights[3]) = (weights[2] + weights[3], 0.0),
        Kind::VertexVertex => *weights = [1.0, 1.0, 0.0, 0.0],
    }
    found
}

/// Positions of four vertices.
fn gather<T: Coordinate>(ids: [u32; 4], x: PositionView<T>) -> [[f64; 3]; 4] {
    ids.map(|v| x.at(v as usize).map(T::to_f64))
}
