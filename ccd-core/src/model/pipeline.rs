//! The ways from boxes to pairs of features, as choices: what each is is said in
//! [`catalogue`](super::catalogue).

/// What pairs a step looks for first. Contacts do not depend on it, nor do candidates, but for what
/// [`TriangleOptions::free_regions`] certifies.
///
/// ```
/// use ccd::{Options, method::Pipeline};
///
/// let options = Options::default().with_pipeline(Pipeline::TRIANGLES);
/// assert_ne!(options.pipeline, Pipeline::Features);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Pipeline {
    /// Pairs of features: vertices against faces, edges against edges.
    #[default]
    Features,
    /// Pairs of triangles, each then expanded into those of its features that no other pair tests
    /// [Curtis 2008].
    Triangles(TriangleOptions),
}

/// How pairs of triangles are found and expanded.
///
/// ```
/// use ccd::method::TriangleOptions;
///
/// let few = TriangleOptions::default().orphans(true).free_regions(true);
/// assert!(few.orphans && few.free_regions);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[non_exhaustive]
pub struct TriangleOptions {
    /// Skip triangles that share a vertex, and test what only they would test from a list made once
    /// per mesh [Tang 2008]. Where that list would be too long (see
    /// [`OrphanSets::new`](crate::backend::triangle_pairs::orphans::OrphanSets::new)) they are not
    /// skipped.
    pub orphans: bool,
    /// Skip pairs within regions of the mesh that certainly do not touch themselves during the step
    /// [Volino 1994], see
    /// [`region_certificate`](crate::backend::triangle_pairs::region_certificate). Their pairs of
    /// features are no candidates. Without effect where a minimum distance is asked for; refused
    /// where positions never were on the host, which certifies regions.
    ///
    /// A pair of features that would have been [undecided](super::contact::State::Undecided), and
    /// is certified to be free in this way, is no contact.
    pub free_regions: bool,
    /// Test a vertex or an edge once, by the triangle that represents it [Curtis 2008]. Off: every
    /// pair of triangles makes all of its 15 tests, the first form of the literature, and
    /// neighbours are not skipped either; on a CPU alone. Contacts and candidates are the same and
    /// counted once; [`Report::filtered`](super::report::Report::filtered) counts tests as often
    /// as they are made.
    pub representatives: bool,
}

impl TriangleOptions {
    /// The same with or without orphan sets.
    pub const fn orphans(self, orphans: bool) -> Self {
        Self { orphans, ..self }
    }

    /// The same with or without free regions.
    pub const fn free_regions(self, free_regions: bool) -> Self {
        Self { free_regions, ..self }
    }

    /// The same with or without representatives.
    pub const fn representatives(self, representatives: bool) -> Self {
        Self { representatives, ..self }
    }
}

impl Default for TriangleOptions {
    fn default() -> Self {
        Self { orphans: true, free_regions: false, representatives: true }
    }
}

impl Pipeline {
    /// [`Pipeline::Triangles`] as it is by default.
    pub const TRIANGLES: Self = Self::Triangles(TriangleOptions {
        orphans: true,
        free_regions: false,
        representatives: true,
    });

    /// Whether a pair of features may be tested more than once.
    pub fn repeats_tests(self) -> bool {
        matches!(self, Self::Triangles(TriangleOptions { representatives: false, .. }))
    }
}
