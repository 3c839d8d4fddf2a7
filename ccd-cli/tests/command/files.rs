//! Files that are written: none lies over another or over what is read; what `-` means; contacts of
//! parts are joined.

use crate::{ccd, check_refused, obj, text};
use std::path::{Path, PathBuf};

pub fn outputs_never_lie_over_files() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let (a, b) = (obj(dir.path(), "a.obj", 0.0), obj(dir.path(), "b.obj", 1.0));
    let (a, b) = (a.to_str().unwrap(), b.to_str().unwrap());
    let out = at("out.csv");
    let both = ["check", a, b, "--contacts", &out, "--candidates"];
    check_refused(&[&both[..], &[&out]].concat(), "--contacts and --candidates both write it");
    // The same file by another name, which paths alone do not tell.
    std::fs::create_dir(dir.path().join("sub")).unwrap();
    let other = |name: &str| dir.path().join("sub").join("..").join(name);
    let again = other("out.csv");
    assert_ne!(again, Path::new(&out));
    check_refused(&[&both[..], &[again.to_str().unwrap()]].concat(), "both write it");
    check_refused(&["sequence", a, b, "--json-lines", "--contacts", "-"], "standard output");
    check_refused(&["check", a, b, "--picture", "-", "--contacts", "-"], "standard output");
    for (name, content, args) in [
        ("bodies.csv", "0,0,0,0,1,1,1", ["check", a, b, "--bodies", "FILE", "--contacts"].to_vec()),
        ("vf.csv", "1,1,1,1,1,1\n", ["queries", "FILE", "--out"].to_vec()),
        ("boxes.bin", "", ["boxes", "FILE", "--pairs"].to_vec()),
    ] {
        let file = at(name);
        std::fs::write(&file, content).unwrap();
        let args: Vec<&str> =
            args.into_iter().map(|arg| if arg == "FILE" { &file[..] } else { arg }).collect();
        let other = other(name);
        for output in [&file[..], other.to_str().unwrap()] {
            check_refused(&[&args[..], &[output]].concat(), "would write over it");
        }
        assert_eq!(std::fs::read_to_string(&file).unwrap(), content);
    }
}

pub fn everything_goes_to_standard_output() {
    let dir = tempfile::tempdir().unwrap();
    let (a, b) = (obj(dir.path(), "a.obj", 0.0), obj(dir.path(), "b.obj", 1.0));
    let (a, b) = (a.to_str().unwrap(), b.to_str().unwrap());
    let png = dir.path().join("a.png");
    assert!(ccd(&["check", a, b, "--picture", png.to_str().unwrap()]).status.success());
    let printed = ccd(&["check", a, b, "--picture", "-"]).stdout;
    assert!(printed.starts_with(b"\x89PNG") && printed == std::fs::read(&png).unwrap());
    let boxes = dir.path().join("a.bin");
    let numbers = [0.0f32, 0.0, 0.0, 1.0, 1.0, 1.0];
    let bytes: Vec<u8> = numbers.repeat(2).into_iter().flat_map(f32::to_le_bytes).collect();
    std::fs::write(&boxes, bytes).unwrap();
    let printed = ccd(&["boxes", boxes.to_str().unwrap(), "--pairs", "-"]).stdout;
    assert_eq!(printed, [0, 0, 0, 0, 1, 0, 0, 0]);
}

/// Contacts of parts, joined in any order, are those of one run, to the byte.
pub fn contacts_of_parts_are_joined() {
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("frames");
    std::fs::create_dir(&folder).unwrap();
    for i in 0..12 {
        // Up and down, so that there are contacts in several steps.
        obj(&folder, &format!("f{i}.obj"), if i % 2 == 0 { 0.0 } else { 0.9 });
    }
    let folder = folder.to_str().unwrap();
    let run = |name: &str, more: &[&str]| -> PathBuf {
        let path = dir.path().join(name);
        let args = ["sequence", folder, "--contacts", path.to_str().unwrap()];
        assert!(ccd(&[&args[..], more].concat()).status.success());
        path
    };
    let of = |path: &Path| std::fs::read_to_string(path).unwrap();
    let whole = of(&run("whole.csv", &[]));
    assert!(whole.lines().count() > 10, "{whole}");
    let merge = |parts: &[PathBuf]| {
        let parts = parts.iter().map(|part| part.to_str().unwrap());
        ccd(&["merge"].into_iter().chain(parts).collect::<Vec<_>>())
    };
    for n in [1, 3, 20] {
        let part = |i| run(&format!("{i}of{n}.csv"), &["--part", &format!("{i}/{n}")]);
        let parts: Vec<PathBuf> = (1..=n).rev().map(part).collect();
        let joined = merge(&parts);
        assert!(joined.status.success(), "{}", text(&joined.stderr));
        assert_eq!(text(&joined.stdout), whole, "{n} parts");
    }
    let [first, second] = ["1of3.csv", "2of3.csv"].map(|name| dir.path().join(name));
    let refused = |name: &str, content: &str, what: &str| {
        let path = dir.path().join(name);
        std::fs::write(&path, content).unwrap();
        let (first, path) = (first.to_str().unwrap(), path.to_str().unwrap());
        check_refused(&["merge", first, path], what);
    };
    let rows = of(&second);
    let (head, rest) = rows.split_once('\n').unwrap();
    refused("twice.csv", &of(&first), "begins with step 0");
    refused("head.csv", "frame,kind\n", "line 1: the columns are not those of");
    refused("check.csv", "kind,a,b\n", "`frame` is the first");
    refused("cut.csv", &rows[..rows.len() - 30], "is cut short");
    refused("order.csv", &format!("{head}\n{rest}{}\n", rest.lines().next().unwrap()), "earlier");
    refused("lines.jsonl", "{}\n", "they are joined apart");
    let object = ccd(&["sequence", folder, "--json", "--part", "1/3"]).stdout;
    let path = dir.path().join("object.jsonl");
    std::fs::write(&path, object).unwrap();
    check_refused(&["merge", path.to_str().unwrap()], "was printed by --json;");
}
