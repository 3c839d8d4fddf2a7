//! The ways to find overlapping boxes: an enum to select one, and a table that says what each is.

/// How a broad phase finds overlapping boxes; all methods give the same set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum BroadPhaseMethod {
    /// Blocks of neighbouring boxes in Morton order, descended together: the fastest where boxes
    /// overlap many others.
    #[default]
    Blocks,
    /// A binary radix tree [Karras 2012], one query per box with a stack: for boxes of which few
    /// overlap, on a GPU.
    Tree,
}

/// What there is to say about a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MethodRow {
    /// The method, with the settings that it has by default.
    pub method: BroadPhaseMethod,
    /// Its name on a command line.
    pub name: &'static str,
    /// One line about it.
    pub about: &'static str,
    /// Where it is from: a key of docs/REFERENCES.md; `None`: this project.
    pub source: Option<&'static str>,
    /// Where it runs: `"cpu"`, `"gpu"`.
    pub backends: &'static [&'static str],
}

/// Every method, in the order of the enum.
pub const METHODS: &[MethodRow] = &[
    MethodRow {
        method: BroadPhaseMethod::Blocks,
        name: "blocks",
        about: "Blocks of neighbouring boxes, of 8 on the CPU and 32 on a GPU",
        source: None,
        backends: &["cpu", "gpu"],
    },
    MethodRow {
        method: BroadPhaseMethod::Tree,
        name: "tree",
        about: "A binary radix tree; on a GPU faster where few boxes overlap",
        source: Some("Karras 2012"),
        backends: &["cpu", "gpu"],
    },
];

impl BroadPhaseMethod {
    /// What there is to say about it.
    pub const fn row(self) -> &'static MethodRow {
        match self {
            Self::Blocks => &METHODS[0],
            Self::Tree => &METHODS[1],
        }
    }

    /// The method of that name, with the settings that it has by default.
    pub fn named(name: &str) -> Option<Self> {
        METHODS.iter().find(|row| row.name == name).map(|row| row.method)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_method_has_its_row() {
        for row in METHODS {
            assert_eq!(row.method.row(), row);
            assert_eq!(BroadPhaseMethod::named(row.name), Some(row.method));
            assert!(
                !row.about.is_empty() && row.backends.iter().all(|b| ["cpu", "gpu"].contains(b))
            );
        }
        assert_eq!(BroadPhaseMethod::named("by hand"), None);
        assert_eq!(METHODS[0].method, BroadPhaseMethod::default());
    }
}
