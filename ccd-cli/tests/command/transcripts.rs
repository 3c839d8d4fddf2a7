//! Scripts of commands, each a test: what is printed, what is written, how commands end, as
//! snapshots. Times, numbers of threads and machines are left out of these.
//!
//! A script runs in a folder of its own; `COMMANDS` says what its lines may be.

use libtest_mimic::Trial;
use regex::Regex;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;

/// What the lines of a script do, besides a remark behind `#`.
const COMMANDS: &str = "
    $ [NAME=VALUE ..] ccd ARGS [< FILE] [> FILE]  run it; stderr follows behind `!`
    obj FILE H         the square and the triangle above it, lowered by H
    file FILE          an empty file, to which the lines behind `|` are added
    copy NEW OLD; gzip NEW OLD; edit NEW OLD FROM TO
    lines NEW OLD FIRST LAST; cut NEW OLD BYTES; pc2 NEW OBJ ..
    f32 FILE X ..; f64 FILE X ..; u8 FILE X ..   numbers, added to a file
    cat FILE; u32 FILE; ls FOLDER    what is in it
    same FILE OTHER    fails unless both hold the same, but for times
    width N            from here on no line of text may be longer";

/// A test of every script.
pub fn trials() -> Vec<Trial> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/command/scripts");
    let trial = |entry: std::io::Result<fs::DirEntry>| {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        Trial::test(format!("script_{name}"), move || {
            let mut settings = insta::Settings::clone_current();
            settings.set_prepend_module_to_snapshot(false);
            settings.set_omit_expression(true);
            let text = transcript(&fs::read_to_string(&path)?);
            settings.bind(|| insta::assert_snapshot!(name, text));
            Ok(())
        })
    };
    fs::read_dir(folder).unwrap().map(trial).collect()
}

fn transcript(script: &str) -> String {
    let dir = tempfile::tempdir().unwrap();
    let mut at = At { dir: dir.path().to_owned(), file: PathBuf::new(), width: usize::MAX };
    redacted(&script.lines().map(|line| format!("{line}\n{}", at.line(line))).collect::<String>())
}

/// What differs from run to run and from machine to machine.
fn redacted(text: &str) -> String {
    static WHAT: LazyLock<[(Regex, &str); 7]> = LazyLock::new(|| {
        [
            (r#"("times_ms":)\{[^}]*\}"#, "$1{..}"),
            (r#"("\w+_ms"|"ns_per_query"|"threads"|"rebuilt"|"asked"):[\w.+-]+"#, "$1:.."),
            (r#"("machine"):"[^"]*""#, "$1:.."),
            (r" on +\d+ threads?", " on .. threads"),
            (r" +[\d.]+ (?:ns|us|ms|s)\b", " .."),
            (r"(?m) +\d+(  (?:\S+\.csv|total))$", " ..$1"),
            (r"(?m)^machine .*| need \d+ bytes", " .."),
        ]
        .map(|(pattern, to)| (Regex::new(pattern).unwrap(), to))
    });
    WHAT.iter().fold(text.to_owned(), |text, (what, to)| what.replace_all(&text, *to).into_owned())
}

/// Where a script is.
struct At {
    dir: PathBuf,
    /// The file to which lines are added.
    file: PathBuf,
    width: usize,
}

impl At {
    /// Does what a line says; returns what is to be seen then.
    fn line(&mut self, line: &str) -> String {
        let quoted = line.split('\'').enumerate();
        let words: Vec<&str> = quoted
            .flat_map(
                |(i, part)| {
                    if i % 2 == 1 { vec![part] } else { part.split_whitespace().collect() }
                },
            )
            .collect();
        let path = |name: &str| self.dir.join(name);
        let append = |name: &str, bytes: &[u8]| {
            fs::create_dir_all(path(name).parent().unwrap()).unwrap();
            let file = File::options().create(true).append(true).open(path(name));
            file.unwrap().write_all(bytes).unwrap();
        };
        match words[..] {
            [] | ["#", ..] => {}
            ["|", ..] => {
                append(self.file.to_str().unwrap(), format!("{}\n", &line[2..]).as_bytes())
            }
            ["file", name] => {
                append(name, b"");
                fs::write(path(name), "").unwrap();
                self.file = path(name);
            }
            ["width", n] => self.width = n.parse().unwrap(),
            ["obj", name, drop] => {
                append(name, b"");
                crate::obj(&self.dir, name, drop.parse().unwrap());
            }
            ["copy", new, old] => append(new, &fs::read(path(old)).unwrap()),
            ["gzip", new, old] => {
                let mut packed = flate2::write::GzEncoder::new(Vec::new(), Default::default());
                packed.write_all(&fs::read(path(old)).unwrap()).unwrap();
                append(new, &packed.finish().unwrap());
            }
            ["edit", new, old, from, to] => {
                let text = fs::read_to_string(path(old)).unwrap();
                assert!(text.contains(from), "{old} has no {from:?}");
                append(new, text.replacen(from, to, 1).as_bytes());
            }
            ["lines", new, old, first, last] => {
                let [first, last] = [first, last].map(|n| n.parse::<usize>().unwrap());
                let text = fs::read_to_string(path(old)).unwrap();
                let lines = text.split_inclusive('\n').skip(first - 1).take(last + 1 - first);
                append(new, lines.collect::<String>().as_bytes());
            }
            ["cut", new, old, n] => {
                let bytes = fs::read(path(old)).unwrap();
                append(new, &bytes[..bytes.len() - n.parse::<usize>().unwrap()]);
            }
            ["pc2", new, ref frames @ ..] => {
                let frame = |name: &&str| ccd::io::read_frame(&path(name)).unwrap().positions_f32();
                let frames: Vec<Vec<[f32; 3]>> = frames.iter().map(frame).collect();
                let (n_vertices, n_frames) = (frames[0].len() as u32, frames.len() as u32);
                append(new, b"POINTCACHE2\0");
                let head = [1, n_vertices, 0, 0, n_frames].map(u32::to_le_bytes);
                append(new, head.as_flattened());
                let numbers = frames.iter().flatten().flatten();
                append(new, &numbers.flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>());
            }
            ["f32", name, ref all @ ..] => {
                all.iter().for_each(|x| append(name, &x.parse::<f32>().unwrap().to_le_bytes()));
            }
            ["f64", name, ref all @ ..] => {
                all.iter().for_each(|x| append(name, &x.parse::<f64>().unwrap().to_le_bytes()));
            }
            ["u8", name, ref all @ ..] => {
                all.iter().for_each(|x| append(name, &[x.parse().unwrap()]));
            }
            ["cat", name] => match String::from_utf8(fs::read(path(name)).unwrap()) {
                Ok(text) => return text,
                Err(e) if e.as_bytes().starts_with(b"\x89PNG") => return "(a picture)\n".into(),
                Err(e) => panic!("{name}: {e}"),
            },
            ["u32", name] => {
                let number = |b: &[u8]| u32::from_le_bytes(b.try_into().unwrap());
                let all = fs::read(path(name)).unwrap();
                return format!("{:?}\n", all.chunks(4).map(number).collect::<Vec<_>>());
            }
            ["ls", name] => {
                let names = fs::read_dir(path(name)).unwrap().map(|e| e.unwrap().file_name());
                let mut names: Vec<_> = names.map(|name| name.into_string().unwrap()).collect();
                names.sort();
                return names.join(" ") + "\n";
            }
            ["same", one, other] => {
                let [p, q] = [one, other].map(|name| fs::read_to_string(path(name)).unwrap());
                assert_eq!(redacted(&p), redacted(&q), "{one} and {other}");
            }
            ["$", ref words @ ..] => return self.run(words),
            _ => panic!("{line:?} is none of these:{COMMANDS}"),
        }
        String::new()
    }

    fn run(&self, words: &[&str]) -> String {
        let (words, to) = match words {
            [words @ .., ">", to] => (words, Some(to)),
            all => (all, None),
        };
        let (words, from) = match words {
            [words @ .., "<", from] => (words, Some(from)),
            all => (all, None),
        };
        let n = words.iter().position(|word| *word == "ccd").expect("the command");
        let mut command = Command::new(env!("CARGO_BIN_EXE_ccd"));
        command.current_dir(&self.dir).args(&words[n + 1..]).env("COLUMNS", "100");
        let of_slurm = std::env::vars_os().map(|(name, _)| name);
        for name in of_slurm.filter(|name| name.to_string_lossy().starts_with("SLURM_")) {
            command.env_remove(name);
        }
        command.envs(words[..n].iter().map(|word| word.split_once('=').expect("NAME=VALUE")));
        command.stdin(
            from.map_or(Stdio::null(), |from| File::open(self.dir.join(from)).unwrap().into()),
        );
        if let Some(to) = to {
            command.stdout(File::create(self.dir.join(to)).unwrap());
        }
        let output = command.output().unwrap();
        let (printed, said) = (crate::text(&output.stdout), crate::text(&output.stderr));
        for line in printed.lines().filter(|line| !line.starts_with('{')) {
            assert!(line.chars().count() <= self.width, "{words:?}: {line:?}");
        }
        let code = output.status.code().unwrap_or(-1);
        let ended = if code == 0 { String::new() } else { format!("[exit {code}]\n") };
        printed + &said.lines().map(|line| format!("! {line}\n")).collect::<String>() + &ended
    }
}
