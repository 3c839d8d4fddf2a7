//! Bodies for three rules that many solvers have: static obstacles, patches of vertices, and
//! connected components.

use super::Bodies;
use crate::model::mesh::Mesh;
use alloc::vec;
use alloc::vec::Vec;

impl Bodies {
    /// Static obstacles: vertices whose entry is true are body 1, which is fixed, and all others
    /// body 0. Obstacles are tested against what moves alone, not against each other.
    ///
    /// Obstacles that the caller moves need [`Bodies::with_fixed_motion`]. An edge or a face that
    /// joins both is refused, as for all bodies.
    ///
    /// ```
    /// use ccd::Bodies;
    ///
    /// let bodies = Bodies::of_obstacles(&[false, false, true, true]);
    /// assert!(bodies.wants(0, 1) && bodies.wants(1, 2) && !bodies.wants(2, 3));
    /// ```
    pub fn of_obstacles(is_static: &[bool]) -> Self {
        let bodies: Vec<u32> = is_static.iter().map(|&fixed| fixed as u32).collect();
        Self::new(&bodies).with_fixed_mask(&[false, true])
    }

    /// Patches of vertices: each is a body, without self-contact. `patches`: that of each vertex,
    /// by any number. An edge or a face that joins two patches is refused.
    ///
    /// ```
    /// use ccd::Bodies;
    ///
    /// let bodies = Bodies::of_patches(&[7, 7, 3]);
    /// assert!(!bodies.wants(0, 1) && bodies.wants(1, 2));
    /// ```
    pub fn of_patches(patches: &[u32]) -> Self {
        Self::new(patches).with_self_contacts(false)
    }

    /// Connected components of a mesh: vertices that a path of edges joins are a body. Components
    /// are numbered from 0 in the order of their first vertices, and touch themselves and each
    /// other.
    ///
    /// ```
    /// use ccd::{Bodies, Mesh};
    ///
    /// // Two triangles, a rod and a particle.
    /// let mesh = Mesh::with_edges(9, &[[0, 1, 4], [2, 3, 5]], &[[6, 7]])?;
    /// let bodies = Bodies::of_components(&mesh).with_self_contacts(false);
    /// assert_eq!(bodies.body_of_vertex(), [0, 0, 1, 1, 0, 1, 2, 2, 3]);
    /// assert!(!bodies.wants(0, 4) && bodies.wants(0, 2));
    /// # Ok::<(), ccd::Error>(())
    /// ```
    pub fn of_components(mesh: &Mesh) -> Self {
        let n = mesh.n_vertices();
        // Each vertex names one that is not greater; the least of a component names itself.
        let mut lesser: Vec<u32> = (0..n as u32).collect();
        for &[a, b] in mesh.edges() {
            let [a, b] = [a, b].map(|v| least(&mut lesser, v));
            lesser[a.max(b) as usize] = a.min(b);
        }
        let (mut component, mut n_components) = (vec![0; n], 0);
        for v in 0..n {
            let first = least(&mut lesser, v as u32) as usize;
            component[v] = if first == v { n_components } else { component[first] };
            n_components += (first == v) as u32;
        }
        Self::new(&component)
    }
}

/// The vertex that is named last, on a path that is halved on the way.
fn least(lesser: &mut [u32], mut v: u32) -> u32 {
    while lesser[v as usize] != v {
        let next = lesser[lesser[v as usize] as usize];
        lesser[v as usize] = next;
        v = next;
    }
    v
}
