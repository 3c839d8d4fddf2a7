//! Files that are refused, each an edit of one that is read, and the words with which they are, as
//! a snapshot.

use crate::read;
use std::fmt::Write;

/// A file begins with `= NAME`, ends before the next one, and is read as it stands; each line
/// `- FROM => TO` behind it is a file in which that is edited once.
const FILES: &str = include_str!("refused.txt");

/// What stands for letters that no line of a text can have.
const ESCAPES: [(&str, &str); 7] = [
    ("\\n", "\n"),
    ("\\v", "\u{b}"),
    ("\\0", "\0"),
    ("\\e", "\u{1b}"),
    ("\\*", "\u{2605}\u{2605}\u{2605}\u{2605}"),
    ("\\x", "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"),
    ("\\\\", "\\"),
];

#[test]
fn files_are_refused_with_the_place_and_the_words() {
    let mut out = String::new();
    for file in FILES.split("\n= ").skip(1) {
        let (name, rest) = file.split_once('\n').unwrap();
        let (text, edits) = rest.split_once("\n- ").unwrap_or((rest, ""));
        // Without the folder of the file, which has a name of its own in every run.
        let says = |error: &str| error.split_once(&format!("{name}: ")).unwrap().1.to_owned();
        let found = read(name, text.as_bytes());
        let found = found.map(|frame| frame.positions.len()).map_err(|e| says(&e));
        writeln!(out, "\n{name}: {found:?}").unwrap();
        for edit in edits.split("\n- ").filter(|edit| !edit.is_empty()) {
            let (from, to) = edit.trim_end().split_once(" =>").unwrap();
            assert!(text.contains(from), "{name} has no {from:?}");
            let to = to.strip_prefix(' ').unwrap_or(to);
            let to = ESCAPES.iter().fold(to.to_owned(), |to, (name, is)| to.replace(name, is));
            let error = read(name, text.replacen(from, &to, 1).as_bytes()).expect_err(edit);
            assert!(error.len() < 420 && !error.contains('\n'), "{edit}: {error}");
            writeln!(out, "{edit}\n    {}", says(&error)).unwrap();
        }
    }
    insta::assert_snapshot!("refused", out);
}
