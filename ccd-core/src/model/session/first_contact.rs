//! The first contact of a step with all that a response needs: what engines ask of a cast.

use super::engine::{Ask, Engine};
use super::moving::{BodyMotion, Moved};
use super::{Session, given};
use crate::model::contact::{Contact, Kind, State};
use crate::model::contact_on_mesh::geometry;
use crate::model::positions::{AsPositions, ends};
use crate::model::precision::{Given, Precision};

/// A contact, and how its features meet: the answer of [`Session::first_contact`].
///
/// ```
/// use ccd::Hit;
///
/// /// The velocity of a body after it has bounced off what it hit.
/// fn bounced(hit: &Hit, body: u32, velocity: [f64; 3]) -> [f64; 3] {
///     let normal = hit.normal_towards(body);
///     let along: f64 = (0..3).map(|k| velocity[k] * normal[k]).sum();
///     [0, 1, 2].map(|k| velocity[k] - 2.0 * along.min(0.0) * normal[k])
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Hit {
    /// The time of impact in `[0, 1]`; before it nothing touches.
    pub toi: f64,
    /// Which features touch.
    pub kind: Kind,
    /// Whether it is certain that they do.
    pub state: State,
    /// Their ids in the mesh, as [`Contact::a`] and [`Contact::b`].
    pub features: [u32; 2],
    /// The bodies of the features, by their names; both 0 where the options have no bodies.
    pub bodies: [u32; 2],
    /// The vertices, in the order of [`Contact::vertices`].
    pub vertices: [u32; 4],
    /// Where they meet: halfway between the nearest points of the features.
    pub point: [f64; 3],
    /// Unit vector from the second feature towards the first.
    pub normal: [f64; 3],
    /// Of each of the vertices, in the point of its feature.
    pub weights: [f64; 4],
    /// How far the features are apart at that time.
    pub distance: f64,
}

impl Hit {
    /// The normal that points towards `body`, away from what it touches: pushed along it, the body
    /// parts. Of a body that touches itself, or none of [`Hit::bodies`], it is [`Hit::normal`].
    pub fn normal_towards(&self, body: u32) -> [f64; 3] {
        let [a, b] = self.bodies;
        if body == b && body != a { self.normal.map(|c| -c) } else { self.normal }
    }
}

impl<E: Engine, P> Session<E, P> {
    /// The first contact of a step, with its geometry; `None`: the whole step is free.
    ///
    /// Of contacts with the same time it is the first by kind and ids; a pair that is undecided in
    /// the whole step may be no contact in the shorter step that is searched. On a CPU it costs
    /// what [`Session::earliest_toi`] does, but where something touches at the start; [`Hit::toi`]
    /// is that time, and the report is that of such a search. A GPU finds the time, then the
    /// contacts up to it, whose report it leaves, and the two times may differ by up to the
    /// tolerance, by more where the pair is undecided; neither is later than the contact.
    ///
    /// ```
    /// use ccd::{Bodies, Mesh, Options, Session};
    ///
    /// // A floor of one face, and a particle that falls through it.
    /// let bodies = Bodies::new(&[0, 0, 0, 1]).with_fixed(0, true).with_self_contacts(false);
    /// let options = Options::default().with_bodies(bodies);
    /// let mut session = Session::new(Mesh::new(4, &[[0, 2, 1]])?, options)?;
    /// let mut x = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 1.0, 0.2]];
    /// let before = x;
    /// x[3][1] = -1.0;
    /// let hit = session.first_contact(&before, &x)?.expect("half way");
    /// assert_eq!((hit.bodies, hit.vertices), ([1, 0], [3, 0, 2, 1]));
    /// assert_eq!(hit.normal_towards(1), [0.0, 1.0, 0.0]);
    /// # Ok::<(), ccd::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn first_contact<A, B>(&mut self, x0: &A, x1: &B) -> Result<Option<Hit>, E::Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        let Self { engine, gathered, .. } = self;
        let given = given(&engine.state().mesh, gathered, ends(x0, x1));
        let done = given.map_err(E::Error::from).and_then(|given| first(engine, given, None));
        self.settled(done)
    }

    /// The first contact of a step in which these bodies move: what [`Session::first_contact`] is
    /// to [`Session::step`]. A GPU finds it among all contacts of the step, in one search, and
    /// leaves their report.
    ///
    /// # Errors
    /// Those of [`Session::step_bodies`].
    pub fn first_contact_of_bodies(
        &mut self,
        motions: &[BodyMotion],
    ) -> Result<Option<Hit>, E::Error> {
        self.with_bodies_moved(motions, first)
    }
}

/// The contact of the earliest time. If the engine says only the time: the first of the contacts up
/// to it, which are few.
fn first<E: Engine>(
    engine: &mut E,
    given: Given,
    moved: Option<Moved>,
) -> Result<Option<Hit>, E::Error> {
    // Where little of a mesh moves there are few contacts, and a second search costs more.
    let ask = if moved.is_some() { Ask::First } else { Ask::Earliest { whose: true } };
    engine.find(given, moved, ask)?;
    let report = &engine.state().report;
    let Some(toi) = report.toi else { return Ok(None) };
    if let Some(contact) = report.first().or(first_of(&report.contacts)) {
        return Ok(Some(hit(engine, contact, given)));
    }
    // A time is early by up to the tolerance, and of a GPU by the rounding to an `f32`: the contact
    // whose time it is begins in this window, if it is one. What was only undecided may turn out to
    // be none in so short a step; then all of it is looked at.
    let soon = toi + 2.0 * engine.state().options.tolerance + f64::from(f32::EPSILON);
    for until in [soon.min(1.0), 1.0] {
        engine.find(given, None, Ask::Contacts { window: [0.0, until] })?;
        if let Some(contact) = first_of(&engine.state().report.contacts) {
            return Ok(Some(hit(engine, contact, given)));
        }
    }
    Ok(None)
}

fn first_of(contacts: &[Contact]) -> Option<&Contact> {
    contacts.iter().min_by(|a, b| a.by_time(b))
}

fn hit<E: Engine>(engine: &E, contact: &Contact, given: Given) -> Hit {
    let super::State { mesh, options, .. } = engine.state();
    let at = match given {
        Precision::F32([x0, x1]) => geometry(contact, mesh, ends(x0, x1)),
        Precision::F64([x0, x1]) => geometry(contact, mesh, ends(x0, x1)),
    };
    Hit {
        toi: contact.toi,
        kind: contact.kind,
        state: contact.state,
        features: [contact.a, contact.b],
        bodies: options.bodies.as_ref().map_or([0; 2], |bodies| contact.bodies(mesh, bodies)),
        vertices: contact.vertices(mesh),
        point: at.point,
        normal: at.normal,
        weights: at.weights,
        distance: at.distance,
    }
}
