//! Particles and rods through a device: its broad phase, and what the host decides.

use ccd::gpu::{Device, Error, Session};
use ccd::scenes::particles_and_rods;
use ccd::{Contact, Kind, Options, State};
use ccd_testkit::brute;
use ccd_testkit::compare::agree;

/// Tests of sessions.
pub const TESTS: crate::Tests = &[("codimensional", check)];

/// All that every caller of the query learns.
fn key(c: &Contact) -> (Kind, u32, u32, State, f64) {
    (c.kind, c.a, c.b, c.state, c.toi)
}

fn check(device: &Device) {
    let step = particles_and_rods(60, 4);
    for distance in [0.0, 0.03] {
        let options = Options::default().with_min_distance(distance);
        let want = ccd::step(&step.mesh, &step.x0, &step.x1, &options).expect("a step");
        let ([_, vv], thin) = brute::codimensional(&step.mesh, &step.x0, &step.x1, distance);
        let n = want.contacts.len();
        assert!(thin.len() > 50 && n > thin.len(), "{} of {n}", thin.len());
        let mut session = Session::new(device, step.mesh.clone(), options).expect("a session");
        for round in 0..2 {
            let report = session.step(&step.x0, &step.x1).expect("a step").clone();
            let what = format!("{distance}, step {round}");
            agree(&want.contacts, &report.contacts).unwrap_or_else(|e| panic!("{what}: {e}"));
            let last = &report.contacts[report.contacts.len() - thin.len()..];
            assert!(last.iter().map(key).eq(thin.iter().map(key)), "{what}");
            assert_eq!(report.candidates, want.candidates, "{what}");
            assert_eq!(report.undecided, want.undecided, "{what}");
            let earliest = session.earliest_toi(&step.x0, &step.x1).expect("a step");
            let (toi, earliest) = (want.toi.expect("a contact"), earliest.expect("a contact"));
            assert!(earliest <= toi && earliest > toi - 2e-6, "{what}: {earliest} {toi}");
            let listed = session.candidates(&step.x0, &step.x1).expect("a step");
            assert!(vv.iter().all(|pair| listed.vv.contains(pair)), "{what}");
        }
        // On the device alone they would be missed.
        let mut encoder = device.wgpu().create_command_encoder(&Default::default());
        assert!(matches!(session.record(&mut encoder), Err(Error::Codimensional)));
    }
}
