//! The kernel table: every entry point of ccd-shaders, one row each.

use super::{Access, Kernel};

/// The kernel table: calls a macro with all rows, in three groups: what the default methods run,
/// what the other methods run, and what tests run. A row says, in this order: id, name of the entry
/// point, threads of a workgroup, barriers that its source has, the numbers that it needs, its
/// record in [`Params`](crate::layout::Params) if it takes parameters, and its buffers in the order
/// of their bindings.
#[macro_export]
macro_rules! kernels {
    ($callback:ident) => { $callback! {
        product {
            /// Vertices in `f64`: their paths, keys of their exact boxes, their boxes.
            PlaceVertices = place_vertices(256 threads, 0 barriers, f64, Params<Plain>)
                { positions: Read, paths: Write, keys: Write, boxes: Write }
            /// Boxes of vertices.
            SweepVertices = sweep_vertices(256 threads, 0 barriers, f32, Params<Plain>)
                { paths: Read, boxes: Write }
            /// Boxes of edges and faces.
            SweepElements = sweep_elements(256 threads, 0 barriers, f32, Params<Plain>)
                { elements: Read, boxes: Write }
            /// Paths up to the earliest time of impact so far.
            Shorten = shorten(256 threads, 0 barriers, f32, Params<Plain>)
                { paths: Read, earliest: Read, shortened: Write }
            /// Bounds of all boxes, in six words.
            SceneBounds = scene_bounds(256 threads, 1 barriers, f32, Params<Plain>)
                { boxes: Read, bounds: Write }
            /// Sort keys of boxes, and their numbers.
            CurveKeys = curve_keys(256 threads, 0 barriers, f32, Params<Plain>)
                { boxes: Read, bounds: Read, keys: Write, order: Write }
            /// Digits of all keys, of each pass.
            SortCount = sort_count(256 threads, 2 barriers, f32, Params<SortPass>)
                { keys: Read, table: Write }
            /// One pass of the sort.
            SortScatter = sort_scatter(256 threads, 47 barriers, f32, Params<SortPass>)
                { keys: Read, values: Read, table: Write, keys_out: Write, values_out: Write }
            /// The same by subgroups of 32 threads.
            SortScatterBySubgroups =
                sort_scatter_by_subgroups(512 threads, 33 barriers, f32, Params<SortPass>)
                { keys: Read, values: Read, table: Write, keys_out: Write, values_out: Write }
            /// Sums of the rows of a table.
            ScanRows = scan_rows(256 threads, 3 barriers, f32, Params<SortPass>)
                { table: Write }
            /// Boxes that follow each other in order by halves.
            HalveRuns = halve_runs(256 threads, 16 barriers, f32, Params<Blocks>)
                { boxes: Read, order: Write }
            /// Leaves in order.
            PlaceLeaves = place_leaves(256 threads, 0 barriers, f32, Params<Blocks>)
                { order: Read, elements: Read, leaves: Write }
            /// Boxes of leaves, also at both ends of the step, and of the nodes above.
            FitLeaves = fit_leaves(256 threads, 1 barriers, f32, Params<Blocks>)
                { boxes: Read, leaves: Read, paths: Read, bodies: Read,
                  nodes: Write, ends: Write }
            /// Boxes of leaves that are boxes alone, and of the nodes above.
            FitBoxes = fit_boxes(256 threads, 1 barriers, f32, Params<Blocks>)
                { boxes: Read, order: Read, nodes: Write }
            /// Nodes of the next level.
            FitLevel = fit_level(256 threads, 1 barriers, f32, Params<Blocks>)
                { nodes: Write }
            /// Internal nodes of a binary tree.
            Branches = branches(256 threads, 0 barriers, f32, Params<Blocks>)
                { keys: Read, branches: Write }
            /// The same with the boxes of their children, if these are near; a list of the others:
            /// for queries.
            NearNodes = near_nodes(256 threads, 7 barriers, f32, Params<Blocks>)
                { branches: Read, block_nodes: Read, nodes: Write, far: Write }
            /// Those of the list.
            FarNodes = far_nodes(128 threads, 0 barriers, f32, Params<Blocks>)
                { branches: Read, block_nodes: Read, far: Read, nodes: Write }
            /// Leaves of a binary tree that overlap each other.
            TraverseHalf = traverse_half(128 threads, 0 barriers, f32, Params<Blocks>)
                { leaves: Read, order: Read, nodes: Read, pairs: Write }
            /// Boxes that overlap leaves of a binary tree.
            TraverseFull = traverse_full(128 threads, 0 barriers, f32, Params<Queries>)
                { boxes: Read, order: Read, nodes: Read, pairs: Write }
            /// Pairs of nodes to pairs of their children.
            NodePairs = node_pairs(128 threads, 9 barriers, f32, Params<Blocks>)
                { nodes: Read, input: Read, output: Write }
            /// Bounds of each of many worlds, in six words each.
            WorldBounds = world_bounds(256 threads, 0 barriers, f32, Params<Worlds>)
                { boxes: Read, worlds: Read, bounds: Write }
            /// Sort keys of boxes of many worlds, and their numbers.
            WorldKeys = world_keys(256 threads, 0 barriers, f32, Params<Worlds>)
                { boxes: Read, worlds: Read, bounds: Read, keys: Write, order: Write }
            /// Pairs of nodes to pairs of their children that have a world in common.
            NodePairsOfWorlds = node_pairs_of_worlds(128 threads, 9 barriers, f32, Params<Blocks>)
                { nodes: Read, worlds: Read, input: Read, output: Write }
            /// Pairs of blocks to pairs of boxes that overlap.
            ListOverlaps = list_overlaps(128 threads, 5 barriers, f32, Params<Blocks>)
                { nodes: Read, order: Read, input: Read, output: Write }
            /// The same by subgroups of 32 threads.
            ListOverlapsBySubgroups =
                list_overlaps_by_subgroups(128 threads, 2 barriers, f32, Params<Blocks>)
                { nodes: Read, order: Read, input: Read, output: Write }
            /// Pairs of blocks to candidates.
            ListCandidates = list_candidates(128 threads, 9 barriers, f32, Params<Blocks>)
                { nodes: Read, leaves: Read, ends: Read, input: Read, output: Write }
            /// The same where bodies select pairs or boxes were rounded.
            ListWanted = list_wanted(128 threads, 9 barriers, f32, Params<Blocks>)
                { nodes: Read, leaves: Read, ends: Read, bodies: Read, keys: Read, input: Read,
                  output: Write }
            /// Candidates to those that may touch.
            FilterPairs = filter_pairs(128 threads, 5 barriers, f32, Params<Filtering>)
                { elements: Read, paths: Read, vf: Read, ee: Read, output: Write }
            /// Boxes of triangles.
            SweepTriangles = sweep_triangles(256 threads, 0 barriers, f32, Params<Plain>)
                { triangles: Read, boxes: Read, swept: Write }
            /// Pairs of triangles to pairs of the features that they represent.
            ExpandTriangles = expand_triangles(128 threads, 5 barriers, f32, Params<Expansion>)
                { triangles: Read, regions: Read, boxes: Read, input: Read,
                  vf: Write, ee: Write, counts: Write }
            /// Pairs of features whose representatives share a vertex.
            NearTests = near_tests(128 threads, 5 barriers, f32, Params<Expansion>)
                { tests: Read, regions: Read, swept: Read, boxes: Read,
                  vf: Write, ee: Write, counts: Write }
            /// Listed pairs of a kind to candidates.
            ListListed = list_listed(128 threads, 3 barriers, f32, Params<Listing>)
                { boxes: Read, elements: Read, bodies: Read, keys: Read, input: Read,
                  output: Write }
            /// Verdicts of pairs by integers of 32 bits.
            DecideIntegers = decide_integers(64 threads, 7 barriers, f32, Params<IntegerDecision>)
                { paths: Read, positions: Read, elements: Read, input: Read,
                  contacts: Write, left: Write, earliest: Write }
            /// Verdicts of pairs in `f32`.
            Decide = decide(64 threads, 3 barriers, f32, Params<Plain>)
                { paths: Read, elements: Read, input: Read, contacts: Write, earliest: Write }
            /// Verdicts of pairs in `f64`.
            DecideWide = decide_wide(64 threads, 7 barriers, f64, Params<Decision>)
                { paths: Read, positions: Read, elements: Read, input: Read,
                  contacts: Write, left: Write, earliest: Write }
            /// Verdicts of those that this leaves open.
            AdvanceWide = advance_wide(64 threads, 3 barriers, f64, Params<Plain>)
                { paths: Read, positions: Read, elements: Read, input: Read,
                  contacts: Write, earliest: Write }
            /// Verdicts of pairs by a minimum distance, without `f64`.
            DecideNear = decide_near(64 threads, 3 barriers, f32, Params<Plain>)
                { paths: Read, elements: Read, input: Read, contacts: Write, earliest: Write }
            /// Verdicts of pairs by a minimum distance, in `f64`.
            DecideNearWide = decide_near_wide(64 threads, 3 barriers, f64, Params<Plain>)
                { paths: Read, positions: Read, elements: Read, input: Read,
                  contacts: Write, earliest: Write }
            /// Contacts of each kind and `a`, and the rank of each among them.
            CountContacts = count_contacts(256 threads, 0 barriers, f32, Params<Plain>)
                { contacts: Read, table: Write, ranks: Write }
            /// Contacts by kind and `a`, packed.
            PlaceContacts = place_contacts(256 threads, 3 barriers, f32, Params<Plain>)
                { contacts: Read, table: Read, ranks: Read, slots: Write }
            /// Contacts in order.
            OrderContacts = order_contacts(256 threads, 0 barriers, f32, Params<Plain>)
                { contacts: Read, slots: Read, ordered: Write, table: Write }
            /// Point, normal and weights of contacts, in `f32`.
            ContactGeometry = contact_geometry(64 threads, 0 barriers, f32, Params<Placing>)
                { paths: Read, elements: Read, contacts: Read, geometry: Write }
            /// Point, normal and weights of contacts, in `f64`.
            ContactGeometryWide = contact_geometry_wide(64 threads, 0 barriers, f64, Params<Plain>)
                { paths: Read, positions: Read, elements: Read, contacts: Read,
                  geometry: Write }
            /// For what a device flushes, and tests: scalar operations.
            ProbeScalars = probe_scalars(64 threads, 0 barriers, f32)
                { inputs: Read, results: Write }
            /// For what a device flushes, and tests: scalar operations in `f64`.
            ProbeWide = probe_wide(64 threads, 0 barriers, f64)
                { inputs: Read, results: Write }
        }
        catalogue {
            /// Where neighbours of sorted codes part, and at which levels any do.
            SplitLevels = split_levels(256 threads, 2 barriers, f32, Params<Building>)
                { keys: Read, levels: Write, present: Write }
            /// Entries of each tile on the list of each level.
            SplitCount = split_count(256 threads, 2 barriers, f32, Params<Building>)
                { levels: Read, present: Read, table: Write }
            /// The lists of all levels, one after the other.
            SplitEmit = split_emit(256 threads, 2 barriers, f32, Params<Building>)
                { levels: Read, present: Read, table: Read, entries: Write, list: Write }
            /// Internal nodes of a binary tree from those lists.
            SplitBranches = split_branches(256 threads, 1 barriers, f32, Params<Building>)
                { keys: Read, levels: Read, present: Read, table: Read, entries: Read, list: Read,
                  branches: Write }
            /// Boxes along the Morton curve as clusters.
            PlocLeaves = ploc_leaves(256 threads, 0 barriers, f32, Params<Building>)
                { boxes: Read, bounds: Read, order: Read,
                  clusters: Write, names: Write, counts: Write }
            /// The nearest neighbour of each cluster.
            PlocNearest = ploc_nearest(256 threads, 1 barriers, f32, Params<Building>)
                { clusters: Read, neighbours: Write, counts: Write }
            /// How many clusters of each tile are left.
            PlocCount = ploc_count(256 threads, 2 barriers, f32, Params<Building>)
                { neighbours: Read, counts: Write }
            /// Clusters joined and moved together.
            PlocJoin = ploc_join(256 threads, 2 barriers, f32, Params<Building>)
                { neighbours: Read, clusters: Read, names: Read,
                  clusters_out: Write, names_out: Write, counts: Write, joins: Write }
            /// The rounds of the last clusters.
            PlocFinish = ploc_finish(256 threads, 4 barriers, f32, Params<Building>)
                { counts: Read, even_clusters: Read, even_names: Read,
                  odd_clusters: Read, odd_names: Read, joins: Write }
            /// Boxes in the order of input as nodes to be paired.
            PairLeaves = pair_leaves(256 threads, 0 barriers, f32, Params<Building>)
                { boxes: Read, bounds: Read, clusters: Write, items: Write }
            /// The nearest of each 256 free nodes to the target.
            PairSearch = pair_search(256 threads, 3 barriers, f32, Params<Building>)
                { items: Read, found: Write }
            /// The nearest of those to the place after the target, and the next target.
            PairSwap = pair_swap(256 threads, 3 barriers, f32, Params<Building>)
                { items: Write, found: Write }
            /// Nodes of a level in pairs, each with its nearest free neighbour, by one workgroup.
            PairNearest = pair_nearest(256 threads, 4 barriers, f32, Params<Building>)
                { items: Write }
            /// The level above.
            PairJoin = pair_join(256 threads, 0 barriers, f32, Params<Building>)
                { clusters: Read, items: Read,
                  clusters_out: Write, items_out: Write, joins: Write }
            /// Numbers of nodes that were joined bottom up, and the order of their leaves.
            NumberLeaves = number_leaves(256 threads, 0 barriers, f32, Params<Building>)
                { joins: Read, order: Read, ordered: Write, branches: Write }
            /// The same with their boxes, and leaves: for pairs of nodes.
            BranchBoxes = branch_boxes(256 threads, 0 barriers, f32, Params<Blocks>)
                { branches: Read, block_nodes: Read, order: Read, nodes: Write }
            /// Oriented boxes of nodes whose leaves are near; a list of the others.
            OrientNear = orient_near(256 threads, 5 barriers, f32, Params<Blocks>)
                { branches: Read, block_nodes: Read, oriented: Write, stamps: Write, far: Write }
            /// Those of the list whose children were done in an earlier dispatch.
            OrientFar = orient_far(128 threads, 0 barriers, f32, Params<Blocks>)
                { branches: Read, block_nodes: Read, far: Read, oriented: Write, stamps: Write }
            /// Leaves of a tree of oriented boxes that overlap each other.
            TraverseHalfOriented
                = traverse_half_oriented(128 threads, 0 barriers, f32, Params<Blocks>)
                { leaves: Read, order: Read, nodes: Read, oriented: Read, pairs: Write }
            /// Boxes that overlap leaves of a tree of oriented boxes.
            TraverseFullOriented
                = traverse_full_oriented(128 threads, 0 barriers, f32, Params<Queries>)
                { boxes: Read, order: Read, nodes: Read, oriented: Read, pairs: Write }
            /// As `TraverseFull`, a call of a recursion a step.
            TraverseRecursive = traverse_recursive(128 threads, 0 barriers, f32, Params<Queries>)
                { boxes: Read, order: Read, nodes: Read, pairs: Write }
            /// The same of a tree of oriented boxes.
            TraverseRecursiveOriented
                = traverse_recursive_oriented(128 threads, 0 barriers, f32, Params<Queries>)
                { boxes: Read, order: Read, nodes: Read, oriented: Read, pairs: Write }
            /// Nodes of a cut through a binary tree.
            CutNodes = cut_nodes(256 threads, 4 barriers, f32, Params<NodeDescent>)
                { branches: Read, cuts: Write }
            /// Pairs of nodes of two cuts, or of one.
            CutPairs = cut_pairs(256 threads, 0 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read, cuts: Read,
                  control: Write, output: Write, front: Write }
            /// Pairs of nodes of binary trees to pairs of their children, and pairs of leaves.
            ExpandPairs = expand_pairs(128 threads, 3 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read, input: Read,
                  levels: Write, output: Write, pairs: Write }
            /// Pairs of nodes of two cuts, or of one, of trees of oriented boxes.
            CutPairsOriented = cut_pairs_oriented(256 threads, 0 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read, cuts: Read, oriented: Read,
                  control: Write, output: Write, front: Write }
            /// Pairs of nodes of trees of oriented boxes to pairs of their children, and of leaves.
            ExpandPairsOriented
                = expand_pairs_oriented(128 threads, 3 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read, oriented: Read, input: Read,
                  levels: Write, output: Write, pairs: Write }
            /// Pairs of nodes of two cuts, each by one thread with a stack, to pairs of leaves.
            DescendStacks = descend_stacks(128 threads, 0 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read, input: Read,
                  rounds: Write, output: Write, pairs: Write }
            /// The same of trees of oriented boxes.
            DescendStacksOriented
                = descend_stacks_oriented(128 threads, 0 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read, oriented: Read, input: Read,
                  rounds: Write, output: Write, pairs: Write }
            /// Pairs of a front to those that still end there, pairs of leaves, and tasks.
            ResumeFront = resume_front(128 threads, 3 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read,
                  control: Write, nodes: Write, pairs: Write, front: Write }
            /// Workers that descend pairs of nodes.
            PairWorkers = pair_workers(128 threads, 9 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read,
                  control: Write, nodes: Write, pairs: Write, front: Write }
            /// The same of trees of oriented boxes: a front.
            ResumeFrontOriented
                = resume_front_oriented(128 threads, 3 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read, oriented: Read,
                  control: Write, nodes: Write, pairs: Write, front: Write }
            /// The same of trees of oriented boxes: workers.
            PairWorkersOriented
                = pair_workers_oriented(128 threads, 9 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read, oriented: Read,
                  control: Write, nodes: Write, pairs: Write, front: Write }
            /// Workers that descend pairs of nodes and steal them from each other.
            StealPairs = steal_pairs(128 threads, 18 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read,
                  control: Write, nodes: Write, pairs: Write, front: Write }
            /// The same of trees of oriented boxes.
            StealPairsOriented
                = steal_pairs_oriented(128 threads, 18 barriers, f32, Params<NodeDescent>)
                { a_nodes: Read, b_nodes: Read, oriented: Read,
                  control: Write, nodes: Write, pairs: Write, front: Write }
            /// Prefix sums of the pairs that workers leave.
            BalanceCounts = balance_counts(256 threads, 2 barriers, f32, Params<NodeDescent>)
                { control: Write, nodes: Write }
            /// What workers leave, in even parts.
            BalancePairs = balance_pairs(128 threads, 0 barriers, f32, Params<NodeDescent>)
                { control: Read, nodes: Write }
            /// All pairs of blocks of the level where a descent begins: tasks, or the first front.
            FirstBlockPairs
                = first_block_pairs(128 threads, 3 barriers, f32, Params<BlockDescent>)
                { boxes: Read, first: Read,
                  control: Write, nodes: Write, pairs: Write, front: Write }
            /// Pairs of blocks of a front to those that still end there, pairs of blocks of boxes,
            /// and tasks.
            ResumeBlockFront
                = resume_block_front(128 threads, 3 barriers, f32, Params<BlockDescent>)
                { boxes: Read, control: Write, nodes: Write, pairs: Write, front: Write }
            /// Workers that descend pairs of blocks.
            BlockWorkers = block_workers(128 threads, 10 barriers, f32, Params<BlockDescent>)
                { boxes: Read, control: Write, nodes: Write, pairs: Write, front: Write }
            /// Workers that descend pairs of blocks and steal them from each other.
            StealBlockPairs = steal_block_pairs(128 threads, 19 barriers, f32, Params<BlockDescent>)
                { boxes: Read, control: Write, nodes: Write, pairs: Write, front: Write }
            /// The axis along which boxes vary most.
            SurveyAxis = survey_axis(256 threads, 1 barriers, f32, Params<Plain>)
                { boxes: Read, survey: Write }
            /// The largest sides of all boxes.
            SurveySides = survey_sides(256 threads, 2 barriers, f32, Params<Plain>)
                { boxes: Read, survey: Write }
            /// Keys of boxes for a sweep or a grid, and their numbers.
            IntervalKeys = interval_keys(256 threads, 0 barriers, f32, Params<Intervals>)
                { boxes: Read, survey: Read, keys: Write, order: Write }
            /// Boxes in order.
            OrderBoxes = order_boxes(256 threads, 0 barriers, f32, Params<Plain>)
                { boxes: Read, order: Read, sorted: Write }
            /// What groups of boxes are compared with, in pieces.
            IntervalWork = interval_work(128 threads, 3 barriers, f32, Params<Intervals>)
                { sorted: Read, keys: Read, survey: Read, work: Write }
            /// Pieces of work to overlapping boxes.
            IntervalPairs = interval_pairs(128 threads, 4 barriers, f32, Params<Intervals>)
                { sorted: Read, keys: Read, order: Read, survey: Read, work: Read,
                  pairs: Write }
            /// Where boxes begin and end on an axis: keys, and what begins or ends there.
            EndPointKeys = end_point_keys(256 threads, 0 barriers, f32, Params<Plain>)
                { boxes: Read, survey: Read, keys: Write, points: Write }
            /// From each start of a box to its end: overlapping boxes.
            SweepEndPoints = sweep_end_points(128 threads, 0 barriers, f32, Params<Plain>)
                { boxes: Read, points: Read, pairs: Write }
        }
        tests {
            /// Fields of records.
            ProbeLayout = probe_layout(64 threads, 0 barriers, f32, Params<Blocks>)
                { paths: Read, leaves: Read, touches: Read, pairs: Read, words: Write }
        }
    } };
}

macro_rules! wide {
    (f32) => {
        false
    };
    (f64) => {
        true
    };
}

macro_rules! table {
    ($($group:ident {$(
        $(#[$doc:meta])*
        $id:ident = $name:ident($threads:literal threads, $barriers:literal barriers, $float:ident
            $(, Params<$args:ident>)?) { $($field:ident: $access:ident),* }
    )*})*) => {
        /// A kernel of the table.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Id {
            $($($(#[$doc])* $id,)*)*
        }

        /// Every kernel with an entry point, in the order of [`Id`].
        pub const TABLE: &[Kernel] = &[$($(Kernel {
            name: stringify!($name),
            threads: $threads,
            barriers: $barriers,
            wide: wide!($float),
            native: Id::$id.native(),
            by_subgroups: Id::$id.by_subgroups(),
            params: [$(Some(stringify!($args)),)? None][0],
            buffers: &[$((stringify!($field), Access::$access)),*],
        },)*)*];
    };
}

kernels!(table);
