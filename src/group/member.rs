//! A member of a group: an engine, and what it finds of its part of the mesh.

use super::parts::Part;
use crate::{Error, Kind, Pair};
use ccd_core::backend::quantization::Scan;
use ccd_core::model::positions::{Chosen, Gathered};
use ccd_core::model::precision::Given;
use ccd_core::model::session::{self, Ask, Candidates};

/// An engine that can be a member.
pub trait Member: session::Engine<On: Clone + Sync, Error: Send> + Send {
    /// What [`session::Engine::find`] finds of a mesh whose vertices are some of those that have
    /// these positions. While it works, or before, `holds` looks whether [`Chosen::scan`] covers
    /// the positions and the mesh has all that it must have; where not, nothing was found, and
    /// false is returned.
    ///
    /// # Errors
    /// Those of [`session::Engine::find`].
    fn find_chosen(
        &mut self,
        given: Given,
        chosen: Chosen,
        ask: Ask,
        holds: impl FnOnce() -> bool,
    ) -> Result<bool, Self::Error>;

    /// Candidates in lists.
    ///
    /// # Errors
    /// Those of [`session::Engine::candidates`].
    fn list(&mut self, given: Given) -> Result<Candidates<Vec<Pair>>, Self::Error>;
}

#[cfg(feature = "gpu")]
impl Member for ccd_gpu::Engine {
    fn find_chosen(
        &mut self,
        given: Given,
        chosen: Chosen,
        ask: Ask,
        holds: impl FnOnce() -> bool,
    ) -> Result<bool, ccd_gpu::Error> {
        self.find_chosen(given, chosen, ask, holds)
    }

    fn list(&mut self, given: Given) -> Result<Candidates<Vec<Pair>>, ccd_gpu::Error> {
        session::Engine::candidates(self, given)
    }
}

impl Member for ccd_cpu::Engine {
    fn find_chosen(
        &mut self,
        given: Given,
        chosen: Chosen,
        ask: Ask,
        holds: impl FnOnce() -> bool,
    ) -> Result<bool, Error> {
        if !holds() {
            return Ok(false);
        }
        let mut gathered = Gathered::default();
        session::Engine::find(self, gathered.choose(given, chosen.vertices), None, ask)?;
        Ok(true)
    }

    fn list(&mut self, given: Given) -> Result<Candidates<Vec<Pair>>, Error> {
        let found = session::Engine::candidates(self, given)?;
        let lists = [found.vf.to_vec(), found.ee.to_vec()];
        Ok(Candidates::new(lists, [found.ve.to_vec(), found.vv.to_vec()]))
    }
}

/// A member, and its candidates.
pub struct InGroup<E> {
    /// With the mesh of its part.
    pub engine: E,
    gathered: Gathered,
    /// By kind, the candidates that it found last, in ids of the whole mesh.
    pub lists: [Vec<Pair>; 4],
}

impl<E: Member> InGroup<E> {
    /// Before the first step.
    pub fn new(engine: E) -> Self {
        Self { engine, gathered: Gathered::default(), lists: Default::default() }
    }

    /// Finds what is asked for: of a step in the report of the engine, in ids of its part. Returns
    /// whether `holds` did, which is asked of steps alone.
    pub fn find(
        &mut self,
        given: Given,
        (part, scan): (&Part, &Scan),
        ask: Asked,
        holds: impl FnOnce() -> bool,
    ) -> Result<bool, E::Error> {
        let chosen = Chosen { vertices: part.vertices(), scan };
        match ask {
            Asked::Step(ask) => return self.engine.find_chosen(given, chosen, ask, holds),
            Asked::Candidates => {
                let found = self.engine.list(self.gathered.choose(given, chosen.vertices))?;
                self.lists = [found.vf, found.ee, found.ve, found.vv];
                for (list, kind) in self.lists.iter_mut().zip(Kind::ALL) {
                    list.iter_mut().for_each(|pair| {
                        [pair.a, pair.b] = part.ids(kind, [pair.a, pair.b]);
                    });
                }
            }
        }
        Ok(true)
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
