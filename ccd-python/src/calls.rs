//! Calls of a session, each over positions of either precision.

use crate::candidate_set::flat;
use crate::report::Columns;
use ccd::any;
use ccd::{Coordinate, Kind};

/// A call of a session, whatever the precision of positions.
pub trait Call: Send + Copy {
    /// What is found.
    type Found: Send;

    /// Makes it, for the positions at both ends of a step.
    fn call<T: Coordinate>(
        self,
        session: &mut any::Session,
        x: [&[[T; 3]]; 2],
    ) -> Result<Self::Found, any::Error>;

    /// The candidates that a filter is asked of before the call: those that the call may take.
    fn candidates<T: Coordinate>(
        self,
        session: &mut any::Session,
        x: [&[[T; 3]]; 2],
    ) -> Result<[Vec<u32>; 4], any::Error> {
        ListCandidates.call(session, x)
    }
}

/// Candidates for steps up to this far from the one that they are found for.
#[derive(Clone, Copy)]
pub struct MakeSet(pub f64);

impl Call for MakeSet {
    type Found = ccd::CandidateSet;

    fn call<T: Coordinate>(
        self,
        session: &mut any::Session,
        [x0, x1]: [&[[T; 3]]; 2],
    ) -> Result<ccd::CandidateSet, any::Error> {
        Ok(session.candidate_set(x0, x1, self.0)?)
    }

    fn candidates<T: Coordinate>(
        self,
        session: &mut any::Session,
        x: [&[[T; 3]]; 2],
    ) -> Result<[Vec<u32>; 4], any::Error> {
        let set = self.call(session, x)?;
        Ok(Kind::ALL.map(|kind| flat(&set, kind)))
    }
}

macro_rules! calls {
    ($($name:ident $(($of:ty))?, |$this:pat_param, $session:ident, $x0:ident, $x1:ident|
        -> $found:ty { $($body:tt)* })*) => {$(
        #[derive(Clone, Copy)]
        pub struct $name $((pub $of))?;

        impl Call for $name {
            type Found = $found;

            fn call<T: Coordinate>(
                self,
                $session: &mut any::Session,
                [$x0, $x1]: [&[[T; 3]]; 2],
            ) -> Result<$found, any::Error> {
                let $this = self;
                $($body)*
            }
        }
    )*};
}

calls! {
    Step([f64; 2]), |Self(window), session, x0, x1| -> Columns {
        session.step_window(x0, x1, window)?;
        Ok(Columns::new(session.report(), session.options()))
    }
    EarliestToi, |_, session, x0, x1| -> Option<f64> { session.earliest_toi(x0, x1) }
    FirstContact, |_, session, x0, x1| -> Option<ccd::Hit> { session.first_contact(x0, x1) }
    SetPositions, |_, session, x0, _x1| -> () { Ok(session.set_positions(x0)?) }
    ListCandidates, |_, session, x0, x1| -> [Vec<u32>; 4] {
        let all = session.candidates(x0, x1)?;
        let kinds = [all.vf, all.ee, all.ve, all.vv];
        Ok(kinds.map(|pairs| pairs.iter().flat_map(|p| [p.a, p.b]).collect()))
    }
    Intersect, |_, session, x0, _x1| -> Vec<u32> {
        let all = session.intersections(x0)?;
        Ok(all.iter().flat_map(|found| [found.edge, found.face]).collect())
    }
    Intersects, |_, session, x0, _x1| -> bool { Ok(session.has_intersections(x0)?) }
}
