//! Worlds: many copies of a scene in one place have the contacts of one, each.

use ccd::method::{BroadPhaseMethod, Pipeline};
use ccd::scenes::{copies, crumpled_sheet};
use ccd::{Contact, Kind, Mesh, Options, Session};

/// Contacts of world `w`, by those of one.
fn shifted(c: &Contact, one: &Mesh, w: u32) -> Contact {
    let of = |n: usize| w * n as u32;
    let (n_v, n_e, n_f) = (of(one.n_vertices()), of(one.edges().len()), of(one.faces().len()));
    let [a, b] = match c.kind {
        Kind::VertexFace => [c.a + n_v, c.b + n_f],
        _ => [c.a + n_e, c.b + n_e],
    };
    Contact::new(c.kind, c.state, a, b, c.toi).with_approach(c.approach)
}

fn check_copies(n: usize, side: usize, options: &Options) {
    let one = crumpled_sheet(side, 5);
    let single = ccd::step(&one.mesh, &one.x0, &one.x1, &Options::default()).unwrap();
    let (all, bodies) = copies(&one, n);
    let mut session = Session::new(all.mesh.clone(), options.clone().with_bodies(bodies)).unwrap();
    let report = session.step(&all.x0, &all.x1).unwrap();
    assert_eq!(report.candidates.total(), n as u64 * single.candidates.total());
    let worlds = 0..n as u32;
    let mut want: Vec<Contact> = worlds
        .flat_map(|w| single.contacts.iter().map(move |c| (c, w)))
        .map(|(c, w)| shifted(c, &one.mesh, w))
        .collect();
    want.sort_by_key(|c| (c.kind, c.a, c.b));
    assert!(want.len() > 20 * n);
    assert!(report.contacts == want, "{} contacts of {}", report.contacts.len(), want.len());
    // The next step keeps the order.
    assert!(session.step(&all.x0, &all.x1).unwrap().contacts == want);
    let toi = session.earliest_toi(&all.x0, &all.x1).unwrap();
    assert!(toi <= single.toi && toi.is_some());
}

#[test]
fn copies_in_one_place_have_the_contacts_of_one() {
    check_copies(512, 12, &Options::default());
    check_copies(3, 40, &Options::default().with_threads(1));
    for method in [BroadPhaseMethod::TREE, BroadPhaseMethod::SweepAndPrune] {
        check_copies(12, 12, &Options::default().with_broad_phase(method));
    }
    check_copies(20, 12, &Options::default().with_pipeline(Pipeline::TRIANGLES));
}

#[test]
fn without_worlds_copies_touch_each_other() {
    let one = crumpled_sheet(12, 5);
    let (all, _) = copies(&one, 4);
    let together = ccd::step(&all.mesh, &all.x0, &all.x1, &Options::default()).unwrap();
    let single = ccd::step(&one.mesh, &one.x0, &one.x1, &Options::default()).unwrap();
    assert!(together.contacts.len() > 8 * single.contacts.len());
}
