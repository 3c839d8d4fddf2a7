//! A hierarchy of regions that fulfil the conditions of
//! [`region_certificate`](super::region_certificate) as to how their triangles are connected: found
//! once per mesh, looked at in every step.
//!
//! Faces are joined two and two along their longest common boundary, again and again, up to
//! [`MAX_TRIANGLES`]. A union whose boundary is not a single loop (an annulus, two faces that turn
//! their fronts different ways, three at an edge) is kept as a way to larger ones, but is never
//! certified itself.
//!
//! Cost: a sort of the common edges a level, and one of the edges of every region: half a second
//! for 100,000 faces.

use super::representatives::Triangles;
use crate::model::mesh::Mesh;
use alloc::vec::Vec;
use core::ops::Range;

/// Triangles of the largest regions: larger ones are rarely flat, and hide little more.
pub const MAX_TRIANGLES: usize = 1024;
/// Triangles of the smallest regions: below that nearly all neighbours share a vertex.
const MIN_TRIANGLES: usize = 8;

/// Regions in regions.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Patches {
    /// Faces, so that each region is a range of them.
    order: Vec<u32>,
    /// A region before those in it.
    regions: Vec<Patch>,
    rims: Vec<u32>,
    /// The regions in a largest one.
    roots: Vec<Range<usize>>,
}

/// One region.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Patch {
    /// Where its faces are in the order.
    pub faces: Range<usize>,
    rim: Range<usize>,
    /// How many regions that follow are in it.
    pub n_inside: usize,
}

impl Patches {
    /// Regions of a mesh.
    pub fn new(mesh: &Mesh, triangles: &Triangles) -> Self {
        let mut forest = Forest::new(mesh, triangles);
        while forest.join() {}
        let mut patches = Self::default();
        let mut edges = Vec::new();
        for &root in &forest.roots {
            let first = patches.regions.len();
            patches.add(mesh, &forest, root, &mut edges);
            if patches.regions.len() > first {
                patches.roots.push(first..patches.regions.len());
            }
        }
        patches
    }

    /// The regions in each of the largest, that one first.
    pub fn roots(&self) -> &[Range<usize>] {
        &self.roots
    }

    /// A region.
    pub fn patch(&self, region: usize) -> &Patch {
        &self.regions[region]
    }

    /// Its faces.
    pub fn faces(&self, region: usize) -> &[u32] {
        &self.order[self.regions[region].faces.clone()]
    }

    /// The vertices of its rim in order; none if its boundary is not a single loop.
    pub fn rim(&self, region: usize) -> &[u32] {
        &self.rims[self.regions[region].rim.clone()]
    }

    /// Adds a node and what is in it.
    fn add(&mut self, mesh: &Mesh, forest: &Forest, node: usize, edges: &mut Vec<[u32; 2]>) {
        // Depths are logarithmic, but no two faces need have an edge in common: an explicit stack.
        let mut stack = alloc::vec![(node, None)];
        while let Some((node, done)) = stack.pop() {
            if let Some(region) = done {
                self.close(mesh, region, edges);
                continue;
            }
            let Node { size, children } = forest.nodes[node];
            if size >= MIN_TRIANGLES {
                let (at, rim) = (self.order.len(), self.rims.len());
                let patch = Patch { faces: at..at + size, rim: rim..rim, n_inside: 0 };
                self.regions.push(patch);
                stack.push((node, Some(self.regions.len() - 1)));
            }
            match children {
                None => self.order.push(node as u32),
                Some([a, b]) => stack.extend([(b, None), (a, None)]),
            }
        }
    }

    /// All that is in a region is there.
    fn close(&mut self, mesh: &Mesh, region: usize, edges: &mut Vec<[u32; 2]>) {
        let start = self.rims.len();
        let faces = &self.order[self.regions[region].faces.clone()];
        rim_of(mesh, faces, edges, &mut self.rims);
        self.regions[region].rim = start..self.rims.len();
        self.regions[region].n_inside = self.regions.len() - 1 - region;
    }
}

/// Appends the only loop of the boundary of some faces; nothing if they break one of the first two
/// conditions.
pub fn rim_of(mesh: &Mesh, faces: &[u32], edges: &mut Vec<[u32; 2]>, rim: &mut Vec<u32>) {
    edges.clear();
    for &f in faces {
        let [a, b, c] = mesh.faces()[f as usize];
        edges.extend([[a, b], [b, c], [c, a]]);
    }
    edges.sort_unstable();
    // A side twice in one direction: three faces at an edge, or two that turn different ways.
    if edges.windows(2).any(|pair| pair[0] == pair[1]) || edges.iter().any(|[a, b]| a == b) {
        return;
    }
    let all = &edges[..];
    let is_open = |&[a, b]: &[u32; 2]| all.binary_search(&[b, a]).is_err();
    let Some(&[first, mut at]) = all.iter().find(|e| is_open(e)) else { return };
    let n_open = all.iter().filter(|e| is_open(e)).count();
    let start = rim.len();
    rim.push(first);
    // One open edge leaves each vertex of the rim; two would be a vertex twice.
    while at != first && rim.len() - start < n_open {
        rim.push(at);
        let from = all.partition_point(|e| *e < [at, 0]);
        let mut leaving = all[from..].iter().take_while(|e| e[0] == at).filter(|e| is_open(e));
        match (leaving.next(), leaving.next()) {
            (Some(e), None) => at = e[1],
            _ => break,
        }
    }
    if at != first || rim.len() - start != n_open {
        rim.truncate(start);
    }
}

/// Faces and unions of two.
#[derive(Clone, Copy, Debug)]
struct Node {
    size: usize,
    children: Option<[usize; 2]>,
}

/// Unions in the making.
struct Forest {
    nodes: Vec<Node>,
    roots: Vec<usize>,
    /// Common edges of two roots, and how many; each pair of roots once.
    common: Vec<(usize, usize, u32)>,
}

impl Forest {
    fn new(mesh: &Mesh, triangles: &Triangles) -> Self {
        let n = mesh.faces().len();
        let mut common = Vec::new();
        for e in 0..mesh.edges().len() as u32 {
            if let &[s, t] = triangles.of_edge(e) {
                common.push((s as usize, t as usize, 1));
            }
        }
        let nodes = alloc::vec![Node { size: 1, children: None }; n];
        Self { nodes, roots: (0..n).collect(), common: merged(common) }
    }

    /// Joins roots two and two; whether there were any to join.
    fn join(&mut self) -> bool {
        let roots = &self.roots;
        let largest = roots.iter().map(|&r| self.nodes[r].size).fold(0, usize::max);
        // Small ones first, then those that have most in common.
        let size = |&(a, b, _): &(usize, usize, u32)| self.nodes[a].size + self.nodes[b].size;
        self.common.retain(|pair| size(pair) <= MAX_TRIANGLES);
        let compact = |pair: &(usize, usize, u32)| {
            (2 * size(pair) > 3 * largest, core::cmp::Reverse(pair.2), pair.0, pair.1)
        };
        let mut wanted = core::mem::take(&mut self.common);
        wanted.sort_unstable_by_key(compact);
        let none = usize::MAX;
        let mut into = alloc::vec![none; self.nodes.len()];
        for &(a, b, _) in &wanted {
            if into[a] == none && into[b] == none {
                let size = self.nodes[a].size + self.nodes[b].size;
                (into[a], into[b]) = (self.nodes.len(), self.nodes.len());
                self.nodes.push(Node { size, children: Some([a, b]) });
            }
        }
        let after = |root: usize| if into[root] == none { root } else { into[root] };
        let any = !wanted.is_empty();
        let moved = wanted.iter().map(|&(a, b, n)| {
            let (a, b) = (after(a), after(b));
            (a.min(b), a.max(b), n)
        });
        self.common = merged(moved.filter(|&(a, b, _)| a != b).collect());
        self.roots.iter_mut().for_each(|root| *root = after(*root));
        self.roots.sort_unstable();
        self.roots.dedup();
        any
    }
}

/// Equal pairs as one.
fn merged(mut pairs: Vec<(usize, usize, u32)>) -> Vec<(usize, usize, u32)> {
    pairs.sort_unstable();
    pairs.dedup_by(|next, kept| {
        let same = (next.0, next.1) == (kept.0, kept.1);
        if same {
            kept.2 += next.2;
        }
        same
    });
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rim(faces: &[[u32; 3]]) -> Vec<u32> {
        let mesh = Mesh::new(10, faces).unwrap();
        let all: Vec<u32> = (0..faces.len() as u32).collect();
        let mut rim = Vec::new();
        rim_of(&mesh, &all, &mut Vec::new(), &mut rim);
        rim
    }

    #[test]
    fn boundaries_are_one_loop_or_nothing() {
        assert_eq!(rim(&[[0, 1, 2]]), [0, 1, 2]);
        assert_eq!(rim(&[[0, 1, 2], [2, 1, 3]]), [0, 1, 3, 2]);
        let none: [&[[u32; 3]]; 8] = [
            &[],
            &[[0, 1, 2], [1, 2, 3]],
            &[[0, 1, 2], [0, 1, 2]],
            &[[0, 1, 2], [2, 1, 0]],
            &[[0, 1, 2], [2, 1, 3], [1, 2, 4]],
            &[[0, 1, 1]],
            // Two at a vertex, two apart.
            &[[0, 1, 2], [0, 3, 4]],
            &[[0, 1, 2], [3, 4, 5]],
        ];
        for faces in none {
            assert_eq!(rim(faces), [0u32; 0], "{faces:?}");
        }
        // A ring of triangles around a hole has two loops.
        let ring = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]];
        assert_eq!(rim(&ring), [0u32; 0]);
        let with_floor: Vec<[u32; 3]> = ring.iter().copied().chain([[3, 4, 5]]).collect();
        assert_eq!(rim(&with_floor).len(), 3);
    }

    #[test]
    fn regions_nest_and_hold_every_face_once() {
        let n = 24u32;
        let mut faces = Vec::new();
        for k in 0..(n - 1) * (n - 1) {
            let at = k / (n - 1) * n + k % (n - 1);
            faces.extend([[at, at + 1, at + n], [at + 1, at + n + 1, at + n]]);
        }
        let mesh = Mesh::new((n * n) as usize, &faces).unwrap();
        let patches = Patches::new(&mesh, &Triangles::new(&mesh));
        let mut seen = alloc::vec![0; faces.len()];
        let mut with_rim = 0;
        for root in patches.roots() {
            patches.faces(root.start).iter().for_each(|&f| seen[f as usize] += 1);
            assert!(patches.faces(root.start).len() <= MAX_TRIANGLES);
            for region in root.clone() {
                let patch = patches.patch(region);
                for inside in region + 1..=region + patch.n_inside {
                    let part = &patches.patch(inside).faces;
                    assert!(part.start >= patch.faces.start && part.end <= patch.faces.end);
                }
                with_rim += !patches.rim(region).is_empty() as usize;
            }
            assert_eq!(patches.patch(root.start).n_inside + 1, root.len());
        }
        assert!(seen.iter().all(|&k| k == 1), "{seen:?}");
        assert!(with_rim * 10 > patches.regions.len() * 9, "{with_rim}");
        assert!(patches.regions.len() > faces.len() / 8);
    }
}
