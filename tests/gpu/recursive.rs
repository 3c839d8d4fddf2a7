//! The kernels of recursion without calls, by themselves, beside those with a stack of nodes.

use crate::oriented::{Oriented, slanted};
use crate::scenes::check_pairs;
use crate::support::{bytes, run};
use crate::trees::{in_two_parts, wide_tree};
use crate::twin::Twin;
use ccd::gpu::Device;
use ccd::gpu::bind::{TraverseRecursive, TraverseRecursiveOriented};
use ccd::{Aabb, Pair};
use ccd_core::backend::layout::{Params, Queries};
use ccd_testkit::brute;
use ccd_testkit::generate::uniform_boxes;

pub const TESTS: crate::Tests = &[("recursion", check_recursion)];

const CAPACITY: u32 = 100_000;

/// What queries of the first set of a kind find, in either order.
fn found(
    device: &Device,
    twin: &Twin,
    kind: u32,
    nodes: &[u8],
    oriented: Option<&[u8]>,
) -> [Vec<Pair>; 2] {
    let n = twin.frame.count[kind as usize];
    [0, 1].map(|sorted| {
        in_two_parts(n, CAPACITY, |dispatch, pairs| {
            let p = Params { frame: twin.frame, dispatch, args: Queries { kind, sorted } };
            let (boxes, order) = (bytes(&twin.boxes), bytes(&twin.order));
            let (nodes, groups) = (nodes.to_vec(), dispatch.n.div_ceil(128));
            match oriented {
                None => {
                    let kernel = TraverseRecursive { boxes, order, nodes, pairs };
                    run(device, kernel, &p, groups).pairs
                }
                Some(oriented) => {
                    let oriented = oriented.to_vec();
                    let kernel = TraverseRecursiveOriented { boxes, order, nodes, oriented, pairs };
                    run(device, kernel, &p, groups).pairs
                }
            }
        })
    })
}

fn check_recursion(device: &Device) {
    let uniform: Vec<Aabb> = uniform_boxes(3000).iter().map(|b| b.inflated(0.02)).collect();
    let equal = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 70];
    let check = |boxes: &[Aabb]| {
        let loose = &uniform[..300];
        let twin = Twin::new([loose, &[], boxes], |_, i| [i; 3]);
        let nodes = wide_tree(device, &twin, 2, 2);
        for pairs in found(device, &twin, 0, &nodes, None) {
            check_pairs("between two sets", brute::pairs(loose, boxes), pairs);
        }
        let twin = Twin::new([&[], boxes, &[]], |_, i| [i; 3]);
        let nodes = wide_tree(device, &twin, 1, 2);
        for pairs in found(device, &twin, 1, &nodes, None) {
            check_pairs("within one set", brute::self_pairs(boxes), pairs);
        }
    };
    check(&uniform);
    check(&uniform[..2]);
    check(&uniform[..1]);
    check(&equal);
    let boxes = slanted(700, 0.0);
    let tree = Oriented::over(device, &boxes);
    let nodes = wide_tree(device, &tree.twin, 1, 2);
    for pairs in found(device, &tree.twin, 1, &nodes, Some(&tree.boxes)) {
        check_pairs("oriented", brute::self_pairs(&boxes), pairs);
    }
}
