//! How far a method of the broad phase is from the default tree: what tests that cannot afford
//! every combination of a tree's choices go by.

use ccd::method::{BroadPhaseMethod, TreeOptions};

/// Whether a tree has another builder, another traversal, other volumes than by default; `None`: it
/// is no tree.
pub fn differences(method: BroadPhaseMethod) -> Option<[bool; 3]> {
    let BroadPhaseMethod::Tree(tree) = method else { return None };
    let default = TreeOptions::default();
    Some([
        tree.builder != default.builder,
        tree.traversal != default.traversal,
        tree.volume != default.volume,
    ])
}

/// Whether a method is no tree, or the default one but for one choice.
pub fn is_near_default(method: BroadPhaseMethod) -> bool {
    differences(method).is_none_or(|all| all.iter().filter(|&&differs| differs).count() < 2)
}
