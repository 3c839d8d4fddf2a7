//! Contacts of the parts of a sequence, joined: one head, and rows sorted by their steps.

use super::output::ended;
use super::{Failure, in_file};
use std::fs::File;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};

/// The contacts of a part.
struct Rows<'a> {
    path: &'a Path,
    head: String,
    /// Its first and its last step that has contacts; `None` without a contact.
    steps: Option<[u64; 2]>,
}

/// Prints the rows of all files. Each is read twice: nothing is printed before all are known to be
/// whole, and none is kept in memory.
pub fn join(paths: &[PathBuf]) -> Result<(), Failure> {
    let mut parts: Vec<Rows> = paths.iter().map(|path| read(path)).collect::<Result<_, _>>()?;
    let Some(head) = parts.first().map(|part| part.head.clone()) else { return Ok(()) };
    if let Some(other) = parts.iter().find(|part| part.head != head) {
        let what = format!("line 1: the columns are not those of {}", paths[0].display());
        return Err(in_file(other.path, what));
    }
    parts.retain(|part| part.steps.is_some());
    parts.sort_by_key(|part| part.steps);
    for pair in parts.windows(2) {
        if let ([Some([_, last]), Some([first, _])], other) =
            ([pair[0].steps, pair[1].steps], pair[0].path.display())
            && first <= last
        {
            let what = format!("begins with step {first}; {other} goes on to step {last}");
            return Err(in_file(pair[1].path, what));
        }
    }
    let mut out = std::io::stdout().lock();
    write!(out, "{head}").unwrap_or_else(|e| ended(&e));
    for part in parts {
        let mut rows = open(part.path)?;
        let mut line = Vec::new();
        rows.read_until(b'\n', &mut line).map_err(|e| in_file(part.path, e))?;
        loop {
            let some = rows.fill_buf().map_err(|e| in_file(part.path, e))?;
            if some.is_empty() {
                break;
            }
            out.write_all(some).unwrap_or_else(|e| ended(&e));
            let n = some.len();
            rows.consume(n);
        }
    }
    out.flush().unwrap_or_else(|e| ended(&e));
    Ok(())
}

fn open(path: &Path) -> Result<BufReader<File>, Failure> {
    let file = File::open(path).map_err(|e| in_file(path, e))?;
    Ok(BufReader::with_capacity(1 << 16, file))
}

/// Reads the contacts of a part and checks that they are whole and sorted by their steps.
fn read(path: &Path) -> Result<Rows<'_>, Failure> {
    let mut rows = open(path)?;
    let mut head = String::new();
    let bad = |at: usize, what: &str| in_file(path, format_args!("line {at}: {what}"));
    let n_read = rows.read_line(&mut head).map_err(|e| in_file(path, e))?;
    if n_read == 0 || !head.starts_with("frame,") || !head.ends_with('\n') {
        let what = "the columns are not those of `sequence --contacts`: `frame` is the first";
        return Err(bad(1, what));
    }
    let columns = |line: &str| line.matches(',').count();
    let n_columns = columns(&head);
    let mut steps: Option<[u64; 2]> = None;
    let mut line = String::new();
    for at in 2.. {
        line.clear();
        if rows.read_line(&mut line).map_err(|e| in_file(path, e))? == 0 {
            break;
        }
        if !line.ends_with('\n') || columns(&line) != n_columns {
            return Err(bad(at, "is cut short, or no row of these columns"));
        }
        let step = line.split(',').next().and_then(|text| text.parse().ok());
        let step: u64 = step.ok_or_else(|| bad(at, "does not begin with the number of a step"))?;
        if steps.is_some_and(|[_, last]| step < last) {
            return Err(bad(at, "is of an earlier step than the line before"));
        }
        steps = Some([steps.map_or(step, |[first, _]| first), step]);
    }
    Ok(Rows { path, head, steps })
}
