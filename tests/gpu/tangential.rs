//! Queries whose features nearly graze, decided on the device, against exact arithmetic: none is
//! missed, none is late.

use crate::queries::{Ends, decide};
use ccd::gpu::Device;
use ccd::{Real, Verdict};
use ccd_core::narrow_phase::relative_motion::Patch;
use ccd_testkit::grazing::exact::{Contact, contact};
use ccd_testkit::grazing::random::Random;
use ccd_testkit::grazing::{tangential, widen};

/// Tests of generated queries.
pub const TESTS: crate::Tests = &[("tangential", check_tangential)];

/// Verdicts on queries must not contradict the exact answers. Returns how many contacts there are.
fn check_verdicts(patch: Patch, queries: &[Ends], verdicts: &[Verdict<f64>]) -> usize {
    let mut n_contacts = 0;
    for ((t0, t1), verdict) in queries.iter().zip(verdicts) {
        match contact(patch, t0, t1) {
            Contact::At([lo, hi], _) => {
                let early = verdict.toi().is_some_and(|t| t <= hi);
                assert!(early, "contact in [{lo}, {hi}], but {verdict:?}: {patch:?} {t0:?} {t1:?}");
                n_contacts += 1;
            }
            Contact::Free => {
                let hit = matches!(verdict, Verdict::Hit { .. });
                assert!(!hit, "no contact, but {verdict:?}: {patch:?} {t0:?} {t1:?}");
            }
            _ => {}
        }
    }
    n_contacts
}

fn check_precision<R: Real>(device: &Device, seed: u64) {
    let mut random = Random::new(seed);
    let mut by_patch: [Vec<Ends>; 2] = Default::default();
    for _ in 0..4000 {
        let q = tangential::query::<R>(&mut random);
        by_patch[(q.patch == Patch::Parallelogram) as usize].push((widen(&q.t0), widen(&q.t1)));
    }
    for (patch, queries) in [Patch::Triangle, Patch::Parallelogram].into_iter().zip(by_patch) {
        let verdicts = decide(device, patch == Patch::Triangle, &queries, 0.0);
        let n_contacts = check_verdicts(patch, &queries, &verdicts);
        assert!(n_contacts > queries.len() / 4, "{n_contacts} of {} are contacts", queries.len());
        // A check that nothing fails shows nothing.
        let missed = vec![Verdict::Miss; queries.len()];
        assert!(ccd_testkit::compare::fails(|| {
            check_verdicts(patch, &queries, &missed);
        }));
    }
}

fn check_tangential(device: &Device) {
    check_precision::<f32>(device, 1);
    if device.info().wide {
        check_precision::<f64>(device, 2);
    }
}
