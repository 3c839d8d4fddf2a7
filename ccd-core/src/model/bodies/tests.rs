//! Rules of bodies: which pairs they select, and what they name in vain.

use super::*;

#[test]
fn bodies_select_pairs() {
    let bodies =
        Bodies::new(&[0, 0, 1, 2]).with_fixed_mask(&[false, true, true]).with_self_contacts(false);
    assert!(bodies.wants(0, 2) && bodies.wants(3, 1));
    assert!(!bodies.wants(0, 1) && !bodies.wants(2, 3));
    let mesh = Mesh::new(4, &[[0, 1, 2]]).unwrap();
    assert_eq!(
        bodies.check(&mesh),
        Err(Error::MixedBodies { element: "face", at: 0, bodies: [0, 1] })
    );
}

#[test]
fn rules_that_name_nothing_are_errors() {
    let mesh = Mesh::new(3, &[[0, 1, 2]]).unwrap();
    let of = || Bodies::new(&[7, 7, 7]);
    assert_eq!(of().check(&mesh), Ok(()));
    assert_eq!(of().with_fixed(0, true).check(&mesh), Err(Error::NoBody { body: 0 }));
    assert_eq!(of().with_excluded_bodies(&[[7, 8]]).check(&mesh), Err(Error::NoBody { body: 8 }));
    assert_eq!(
        of().with_excluded_features(Kind::VertexFace, &[[2, 1]]).check(&mesh),
        Err(Error::NoFeature { element: "face", id: 1, n: 1 })
    );
    let far = of().with_worlds(&[0, 0, 0, 0, 0, 0, 0, 1 << 16]).check(&mesh);
    assert!(matches!(far, Err(Error::TooMany { element: "worlds", .. })), "{far:?}");
    assert_eq!(of().set_sleeping(3, true), Err(Error::NoBody { body: 3 }));
}

/// Components against a flood of labels until nothing changes.
#[test]
fn components_are_what_paths_join() {
    let mut random = crate::random::Random::new(11);
    let mut most = 0;
    for n_edges in 0..60 {
        let n = 40;
        let mut vertex = || (random.unit() * n as f64) as u32;
        let edges: Vec<[u32; 2]> = (0..n_edges).map(|_| [vertex(), vertex()]).collect();
        let mesh = Mesh::with_edges(n, &[[0, 5, 9]], &edges).unwrap();
        let mut first: Vec<u32> = (0..n as u32).collect();
        for _ in 0..n {
            for &[a, b] in mesh.edges() {
                let least = first[a as usize].min(first[b as usize]);
                (first[a as usize], first[b as usize]) = (least, least);
            }
        }
        let firsts: Vec<u32> = (0..n as u32).filter(|&v| first[v as usize] == v).collect();
        let want: Vec<u32> =
            first.iter().map(|v| firsts.iter().position(|f| f == v).unwrap() as u32).collect();
        assert_eq!(Bodies::of_components(&mesh).body_of_vertex(), want);
        most = most.max(firsts.len());
    }
    assert!(most > 30, "{most}");
}
