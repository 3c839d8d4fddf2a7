//! Stages of a GPU by the parts of a step that [da Silva 2013] tells apart.
//!
//! A stage belongs to a word that it is, or that it begins with. Every stage has a part: one
//! without is an error of a report, and of a test, which reads the names in `ccd-gpu/src`.

/// Parts of a step. Boxes, and trees refitted or built; fronts tested and kept; pairs of nodes
/// expanded; what schedulers do themselves, and waiting (on a GPU what workers have left dealt out
/// again, and expanded); what takes pairs of leaves: triangles expanded to features, features
/// filtered and decided.
pub const PARTS: [&str; 5] = ["refit", "front", "traversal", "balancing", "intersection"];

/// Words of stages, by [`PARTS`].
const WORDS: [&[&str]; PARTS.len()] = [
    &["boxes", "shorten", "keys", "codes", "sort", "branches", "build", "nodes", "oriented"],
    &["front"],
    &["block pairs", "pairs", "work"],
    &["balancing"],
    &["list", "expand", "neighbours", "filter", "decide", "order contacts"],
];

/// Whether a stage belongs to a word.
fn has(stage: &str, word: &str) -> bool {
    stage.strip_prefix(word).is_some_and(|rest| rest.is_empty() || rest.starts_with(' '))
}

/// The part of a stage, a number of [`PARTS`].
pub fn part(stage: &str) -> Result<usize, String> {
    let found = WORDS.iter().position(|words| words.iter().any(|word| has(stage, word)));
    found.ok_or_else(|| format!("stage `{stage}` of a GPU belongs to no part: xtask/src/stages.rs"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programs::files_below;
    use std::path::Path;

    /// Strings in Rust between quotes; no stage has a quote in its name.
    fn quoted(text: &str) -> impl Iterator<Item = &str> {
        text.split('"').skip(1).step_by(2)
    }

    /// Names of stages in a text: what is passed on as one, and lists of names by kind.
    fn stages(text: &str) -> Vec<&str> {
        let lines = text.lines().map(str::trim).filter(|line| !line.starts_with("//"));
        lines
            .filter(|line| {
                [".stage(", ".detail("].iter().any(|call| line.contains(call))
                    || line.contains("const ") && line.contains(": [&str; 2]")
            })
            .flat_map(quoted)
            .filter(|name| !name.contains('_'))
            .collect()
    }

    #[test]
    fn every_stage_has_a_part_and_every_word_a_stage() {
        let mut all = Vec::new();
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../ccd-gpu/src");
        for path in files_below(&folder).unwrap() {
            if path.extension().is_some_and(|ending| ending == "rs") {
                let text = std::fs::read_to_string(&path).unwrap();
                all.extend(stages(&text).into_iter().map(String::from));
            }
        }
        assert!(all.len() > 20, "{all:?}");
        for stage in &all {
            part(stage).unwrap();
        }
        for word in WORDS.into_iter().flatten() {
            assert!(all.iter().any(|stage| has(stage, word)), "`{word}` is no stage of {all:?}");
        }
        for stage in &all {
            let n = WORDS.into_iter().flatten().filter(|word| has(stage, word)).count();
            assert_eq!(n, 1, "words of `{stage}`");
        }
    }

    #[test]
    fn a_stage_is_named_by_whole_words() {
        assert_eq!(part("front edge-edge"), Ok(1));
        assert!(part("frontier").is_err() && part("a front").is_err());
        assert_eq!(stages("recorder.stage(\"a b\");\n// .stage(\"c\")\nf(\"d\");"), ["a b"]);
    }
}
