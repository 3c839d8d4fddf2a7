//! A member of a group: an engine, the positions of its part, what it finds in ids of the mesh.

use super::merge::NO_CONTACT;
use super::parts::Part;
use super::threads::{at_once, contacts_a_thread};
use crate::positions::Precision;
use crate::{Contact, Error, Kind, Pair};
use ccd_core::model::precision::Given;
use ccd_core::model::session::{self, Ask, Candidates};

/// An engine that can be a member.
pub trait Member: session::Engine<On: Clone + Sync, Error: Send> + Send {
    /// Candidates in lists.
    ///
    /// # Errors
    /// Those of [`session::Engine::candidates`].
    fn list(&mut self, given: Given) -> Result<Candidates<Vec<Pair>>, Self::Error>;
}

#[cfg(feature = "gpu")]
impl Member for ccd_gpu::Engine {
    fn list(&mut self, given: Given) -> Result<Candidates<Vec<Pair>>, ccd_gpu::Error> {
        session::Engine::candidates(self, given)
    }
}

impl Member for ccd_cpu::Engine {
    fn list(&mut self, given: Given) -> Result<Candidates<Vec<Pair>>, Error> {
        let found = session::Engine::candidates(self, given)?;
        let lists = [found.vf.to_vec(), found.ee.to_vec()];
        Ok(Candidates::new(lists, [found.ve.to_vec(), found.vv.to_vec()]))
    }
}

/// A member, and what it copies and finds.
pub struct InGroup<E> {
    /// With the mesh of its part.
    pub engine: E,
    in_f32: [Vec<[f32; 3]>; 2],
    in_f64: [Vec<[f64; 3]>; 2],
    /// What it found last, in ids of the whole mesh.
    pub contacts: Vec<Contact>,
    /// The same of candidates, by kind.
    pub lists: [Vec<Pair>; 4],
}

impl<E: Member> InGroup<E> {
    /// Before the first step.
    pub fn new(engine: E) -> Self {
        let (in_f32, in_f64) = Default::default();
        Self { engine, in_f32, in_f64, contacts: Vec::new(), lists: Default::default() }
    }

    /// Copies the positions of its part; whether they are all where they may be.
    pub fn gather(&mut self, part: &Part, given: Given, n_threads: usize) -> bool {
        match given {
            Precision::F32(x) => part.gather(x, &mut self.in_f32, n_threads),
            Precision::F64(x) => part.gather(x, &mut self.in_f64, n_threads),
        }
    }

    /// Finds what is asked for, in ids of the whole mesh.
    pub fn find(&mut self, part: &Part, is_f32: bool, ask: Asked) -> Result<(), E::Error> {
        let [a, b] = &self.in_f32;
        let [c, d] = &self.in_f64;
        let given = if is_f32 { Given::F32([a, b]) } else { Given::F64([c, d]) };
        match ask {
            Asked::Step(ask) => {
                self.engine.find(given, None, ask)?;
                let found = &self.engine.state().report.contacts[..];
                let in_mesh = |c: &Contact| {
                    let [a, b] = part.ids(c.kind, [c.a, c.b]);
                    Contact::new(c.kind, c.state, a, b, c.toi).with_approach(c.approach)
                };
                // What stands there from the last step is overwritten.
                self.contacts.resize(found.len(), NO_CONTACT);
                let share = contacts_a_thread(found.len());
                let parts = self.contacts.chunks_mut(share).zip(found.chunks(share));
                at_once(parts, |(to, found)| {
                    to.iter_mut().zip(found).for_each(|(to, c)| *to = in_mesh(c));
                });
            }
            Asked::Candidates => {
                let found = self.engine.list(given)?;
                self.lists = [found.vf, found.ee, found.ve, found.vv];
                for (list, kind) in self.lists.iter_mut().zip(Kind::ALL) {
                    list.iter_mut().for_each(|pair| {
                        [pair.a, pair.b] = part.ids(kind, [pair.a, pair.b]);
                    });
                }
            }
        }
        Ok(())
    }
}

/// What is asked of a member.
#[derive(Clone, Copy)]
pub enum Asked {
    /// Something of a step.
    Step(Ask),
    /// Its candidates.
    Candidates,
}
