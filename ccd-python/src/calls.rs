//! Calls of a session, each over positions of either precision.

use crate::report::Columns;
use ccd::Coordinate;
use ccd::any;

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
}
