//! What must hold of the command's own readers: `merge` and files of bodies.

use crate::bodies::BodyOptions;
use crate::library::BUFFERS;
use crate::memory::bounded;
use crate::merge::Merge;
use clap::Args;
use std::path::Path;

fn options<T: Args>(args: Vec<&Path>) -> T {
    let command = T::augment_args(clap::Command::new("fuzz").no_binary_name(true));
    T::from_arg_matches(&command.get_matches_from(args)).expect("arguments")
}

/// Files of bodies that are accepted are so many whole numbers.
pub fn bodies(path: &Path, data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    let words = || text.split(|c: char| c.is_whitespace() || c == ',').filter(|w| !w.is_empty());
    let n = words().count();
    let options: BodyOptions = options(vec!["--bodies".as_ref(), path]);
    let (mesh, other) = (ccd::Mesh::new(n, &[]), ccd::Mesh::new(n + 1, &[]));
    let (mesh, other) = (mesh.expect("no faces"), other.expect("no faces"));
    // Whether each body is fixed is a list up to the last one, of 2^24 at most.
    let bodies = bounded(data.len(), 64, BUFFERS + (1 << 24), || options.of(&mesh, None, None));
    assert!(options.of(&other, None, None).is_err(), "a body too few");
    if let Ok(bodies) = bodies {
        let bodies = bodies.expect("there is a file");
        assert!(words().map(str::parse).eq(bodies.body_of_vertex().iter().map(|&b| Ok(b))));
    }
}

/// Parts between zero bytes are joined or refused, twice in the same way.
pub fn merge(folder: &Path, data: &[u8]) {
    let extension = if data.starts_with(b"frame,") { "csv" } else { "jsonl" };
    let parts = data.splitn(3, |&byte| byte == 0).enumerate();
    let paths: Vec<_> =
        parts.map(|(at, part)| crate::write(folder, &format!("{at}.{extension}"), part)).collect();
    let merge: Merge = options(paths.iter().map(|path| path.as_path()).collect());
    // The shortest object of JSON, `{}`, is some hundred bytes of the tree that is made of a line.
    let run = || bounded(data.len(), 128, BUFFERS, || merge.run().map_err(|e| e.to_string()));
    assert_eq!(run(), run());
}
