//! Comparisons with published answers: a contact that is missing, late, or too early without a flag
//! fails.

use crate::data::{Time, Truth};
use ccd::{Contact, Digest, Kind, Pair, Real, Report, State, TOI_TOLERANCE, Verdict};
use std::collections::HashMap;
use std::path::Path;

/// Asserts everything but the number of false alarms, which it returns.
pub fn contacts(report: &Report, vf: &[Truth], ee: &[Truth]) -> usize {
    let found: HashMap<(Kind, u32, u32), &Contact> =
        report.contacts.iter().map(|c| ((c.kind, c.a, c.b), c)).collect();
    assert_eq!(found.len(), report.contacts.len(), "a contact comes twice");
    let mut n_true = 0;
    for (kind, truth) in [(Kind::VertexFace, vf), (Kind::EdgeEdge, ee)] {
        for t in truth.iter().filter(|t| t.hit) {
            let contact =
                found.get(&(kind, t.a, t.b)).unwrap_or_else(|| panic!("missed {kind:?} {t:?}"));
            time(
                contact.state == State::Hit,
                contact.toi,
                t.toi.unwrap(),
                &format!("{kind:?} {t:?}"),
            );
            n_true += 1;
        }
        for t in truth.iter().filter(|t| !t.hit) {
            let state = found.get(&(kind, t.a, t.b)).map(|c| c.state);
            assert_ne!(state, Some(State::Hit), "a certain contact that is none: {kind:?} {t:?}");
        }
    }
    report.contacts.len() - n_true
}

/// Asserts that a time is not later than the exact one and, if it is certain, not too early.
pub fn time(certain: bool, toi: f64, exact: f64, what: &str) {
    assert!(toi <= exact, "{what}: {toi} is later than {exact}");
    assert!(
        !certain || toi >= exact - TOI_TOLERANCE,
        "{what}: {toi} is more than the tolerance before {exact}"
    );
}

/// Asserts that a verdict agrees with the exact answer; returns whether it is a hit, and whether a
/// certain one.
pub fn verdict<R: Real>(verdict: Verdict<R>, exact: &Time, what: &str) -> (bool, bool) {
    let certain = matches!(verdict, Verdict::Hit { .. });
    match verdict.toi() {
        None => assert!(!exact.hit, "{what}: missed, true time {:?}", exact.toi),
        Some(toi) => {
            assert!(exact.hit || !certain, "{what}: a certain contact that is none");
            if let Some(exact) = exact.toi {
                time(certain, toi.to_f64(), exact, what);
            }
        }
    }
    (verdict.toi().is_some(), certain)
}

/// The digest of a list of contacts, by kind and ids.
pub fn contact_digest(contacts: &[Contact]) -> Digest {
    let mut digest = Digest::default();
    contacts.iter().for_each(|c| digest.add(c.kind as u32, Pair { a: c.a, b: c.b }));
    digest
}

/// Digests of a step as text.
pub fn step_text(report: &Report) -> String {
    let c = &report.candidates;
    format!("candidates vf {} ee {}\ncontacts {}\n", c.vf, c.ee, contact_digest(&report.contacts))
}

/// The same text as `truth.rs` records it for a real scene, in the folder of snapshots.
pub fn recorded_step(scene: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/snapshots");
    let path = folder.join(format!("truth__step_{scene}.snap"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let content = text.splitn(3, "---\n").nth(2);
    content.unwrap_or_else(|| panic!("{}: no snapshot", path.display())).to_owned()
}

/// Whether two lists of contacts of one step can both be right: what is certain in one is in the
/// other, both are in their order, and two certain times differ by no more than their tolerances.
pub fn agree(want: &[Contact], found: &[Contact]) -> Result<(), String> {
    agree_within(want, found, TOI_TOLERANCE)
}

/// The same where another tolerance was asked for.
pub fn agree_within(want: &[Contact], found: &[Contact], tolerance: f64) -> Result<(), String> {
    let key = |c: &Contact| (c.kind, c.a, c.b);
    for (name, list) in [("right", want), ("found", found)] {
        if let Some(w) = list.windows(2).find(|w| key(&w[0]) >= key(&w[1])) {
            return Err(format!("not in order or twice in what is {name}: {w:?}"));
        }
    }
    for (name, these, those) in [("missing", want, found), ("too much", found, want)] {
        for c in these {
            match those.binary_search_by_key(&key(c), key) {
                Err(_) if c.state == State::Hit => return Err(format!("{name}: {c:?}")),
                Err(_) => {}
                Ok(i) => {
                    let other = &those[i];
                    let certain = c.state == State::Hit && other.state == State::Hit;
                    if certain && (c.toi - other.toi).abs() > 2.0 * tolerance {
                        return Err(format!("times differ: {c:?}, {other:?}"));
                    }
                }
            }
        }
    }
    Ok(())
}

/// Whether `check` panics; what it would print is kept back. For negative controls.
pub fn fails(check: impl FnOnce() + std::panic::UnwindSafe) -> bool {
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let failed = std::panic::catch_unwind(check).is_err();
    std::panic::set_hook(hook);
    failed
}
