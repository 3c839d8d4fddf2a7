//! The table against the rules as they are stated, and against the definition of groups.

use super::*;
use crate::model::groups::Groups;
use crate::random::Random;

#[test]
fn tables_say_what_bodies_say() {
    let mut random = Random::new(5);
    let mut below = |n: u32| random.below(n);
    for round in 0..40 {
        let n_bodies = 1 + below(80);
        let of_vertex: Vec<u32> = (0..200).map(|_| below(n_bodies) * 7).collect();
        let mut bodies = Bodies::new(&of_vertex).with_self_contacts(below(2) == 1);
        let mut pairs = Vec::new();
        for _ in 0..round {
            let mut body = || of_vertex[below(200) as usize];
            let (a, b, c, d) = (body(), body(), body(), body());
            pairs.push([a, b]);
            let groups = Groups { memberships: 1 + below(7), filter: below(8) };
            bodies = bodies.with_groups(c, groups).with_fixed(a, below(2) == 1);
            bodies = bodies.with_sleeping(b, below(3) == 1).with_self_contact(d, below(2) == 1);
        }
        bodies = bodies.with_excluded_bodies(&pairs);
        if u32::is_multiple_of(round, 3) {
            let worlds: Vec<u32> = (0..600).map(|_| below(5)).collect();
            bodies = bodies.with_worlds(&worlds);
        }
        let excluded: Vec<[u32; 2]> = (0..below(50)).map(|_| [below(20), below(20)]).collect();
        for kind in [Kind::VertexFace, Kind::EdgeEdge] {
            bodies = bodies.with_excluded_features(kind, &excluded);
        }
        let rules = Rules::new(&bodies).unwrap();
        let mut counts = [0; 2];
        for v in 0..200 {
            for w in 0..200 {
                assert_eq!(rules.wants(v, w), bodies.wants(v, w), "{round}: {v} {w}");
                counts[rules.wants(v, w) as usize] += 1;
            }
            assert_eq!((rules.world(v), rules.is_still(v)), (bodies.world(v), bodies.is_fixed(v)));
        }
        assert!(round < 10 || counts[0] > 100, "{round}: {counts:?} show nothing");
        for a in 0..20 {
            for b in 0..20 {
                let listed = excluded.contains(&[a, b]);
                assert_eq!(rules.excludes(Kind::VertexFace, a, b), listed, "{round}: {a} {b}");
                let listed = listed || excluded.contains(&[b, a]);
                assert_eq!(rules.excludes(Kind::EdgeEdge, a, b), listed, "{round}: {a} {b}");
            }
        }
    }
}

#[test]
fn many_bodies_of_few_sorts_are_few_classes() {
    let of_vertex: Vec<u32> = (0..20_000).collect();
    let mut bodies = Bodies::new(&of_vertex);
    for body in 0..20_000 {
        bodies = bodies.with_groups(body, Groups { memberships: 1 << (body % 3), filter: 5 });
    }
    let rules = Rules::new(&bodies).unwrap();
    assert_eq!(rules.table().len(), HEADER + 2 * 20_000 + 3);
    // Every body has partners of its own.
    let pairs: Vec<[u32; 2]> = (0..5000).map(|i| [2 * i, 2 * i + 1]).collect();
    let too_many = Rules::new(&bodies.with_excluded_bodies(&pairs)).unwrap_err();
    assert!(matches!(too_many, Error::TooMany { element: "classes of bodies", .. }));
    // What words say by themselves needs no table.
    let simple = Bodies::new(&of_vertex).with_fixed(0, true).with_self_contact(3, false);
    assert!(!Rules::new(&simple).unwrap().has_table());
}

#[test]
fn what_stands_still_and_moves_is_found() {
    let bodies = Bodies::new(&[0, 1, 1]).with_fixed(1, true);
    let x0 = [[0.0f32; 3], [1.0; 3], [2.0; 3]];
    let mut x1 = x0;
    x1[0][1] = 5.0;
    let rules = Rules::new(&bodies).unwrap();
    assert_eq!(rules.check_still(&x0, &x1, None), Ok(()));
    x1[2][2] = 2.5;
    assert_eq!(rules.check_still(&x0, &x1, None), Err(Error::FixedMoves { vertex: 2 }));
    let run = |first: u32| [0..0, first..first + 1];
    assert_eq!(rules.check_still(&x0, &x1, Some(&run(1))), Ok(()));
    assert!(rules.check_still(&x0, &x1, Some(&run(2))).is_err());
    let driven = Rules::new(&bodies.with_fixed_motion(true)).unwrap();
    assert_eq!(driven.check_still(&x0, &x1, None), Ok(()));
}
