//! `ccd merge`: the outputs of the parts of a sequence, joined; contacts in `join`.

use super::files::has_extension;
use super::lines::{LastLine, Share, Step, summarise};
use super::output::{self, MeshSize};
use super::part::Part;
use super::start::Intersections;
use super::{Failure, Outcome, in_file, join};
use clap::Args;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};

#[derive(Args)]
pub struct Merge {
    /// What `ccd sequence --part i/n` printed with --json-lines, or wrote with --contacts (.csv),
    /// in any order; not both at once
    #[arg(required = true, value_name = "PART")]
    parts: Vec<PathBuf>,
}

/// The output of a part.
struct Output<'a> {
    path: &'a Path,
    /// Lines of steps, as they are.
    lines: Vec<String>,
    steps: Vec<Step>,
    share: Share,
    mesh: MeshSize,
    intersections: Option<Intersections>,
}

impl Merge {
    pub fn run(&self) -> Outcome {
        let is_rows = |path: &&PathBuf| has_extension(path, &["csv"]);
        if let Some(rows) = self.parts.iter().find(is_rows) {
            if let Some(lines) = self.parts.iter().find(|path| !is_rows(path)) {
                let what =
                    format!("is no CSV, but {} is: merge either kind by itself", rows.display());
                return Err(in_file(lines, what));
            }
            join::join(&self.parts)?;
            return Ok(false);
        }
        let mut parts: Vec<Output> =
            self.parts.iter().map(|path| read(path)).collect::<Result<_, _>>()?;
        parts.sort_by_key(|part| part.share.part.index);
        check(&parts)?;
        for line in parts.iter().flat_map(|part| &part.lines) {
            output::print(format_args!("{line}"));
        }
        let steps: Vec<Step> = parts.iter_mut().flat_map(|part| part.steps.drain(..)).collect();
        let summary = summarise(&steps);
        let Output { mesh, intersections, .. } = parts.remove(0);
        let any = summary.contacts > 0 || intersections.as_ref().is_some_and(|of| of.pairs > 0);
        output::json(&LastLine { summary, mesh, part: None, intersections })?;
        output::flush();
        Ok(any)
    }
}

/// Reads an output and checks that it is whole: all steps of its part, in order, and the summary.
fn read(path: &Path) -> Result<Output<'_>, Failure> {
    let file = std::fs::File::open(path).map_err(|e| in_file(path, e))?;
    let mut lines: Vec<String> = Vec::new();
    for line in BufReader::new(file).lines() {
        lines.push(line.map_err(|e| in_file(path, e))?);
    }
    let last: Option<LastLine> = lines.last().and_then(|line| serde_json::from_str(line).ok());
    let Some(last) = last else {
        let what = match is_one_object(&lines) {
            true => "was printed by --json; what --json-lines prints can be joined",
            false => "does not end with a summary: not the output of --json-lines, or cut off",
        };
        return Err(in_file(path, what));
    };
    let Some(share) = last.part else {
        return Err(in_file(path, "is no part: it was made without --part"));
    };
    let Part { index, of } = share.part;
    if index == 0 || index > of {
        return Err(in_file(path, format_args!("is part {index} of {of}; the first is 1")));
    }
    lines.pop();
    let mut steps: Vec<Step> = Vec::new();
    let expected = share.part.steps(share.all_steps);
    for (at, line) in lines.iter().enumerate() {
        let bad = |what: String| in_file(path, format_args!("line {}: {what}", at + 1));
        let step: Step = serde_json::from_str(line).map_err(|e| bad(e.to_string()))?;
        if Some(step.frame) != expected.clone().nth(at) {
            return Err(bad(format!("step {} is not expected here", step.frame)));
        }
        steps.push(step);
    }
    if steps.len() != expected.len() {
        let what = format!("holds {} steps; its part has {}", steps.len(), expected.len());
        return Err(in_file(path, what));
    }
    let LastLine { mesh, intersections, .. } = last;
    Ok(Output { path, lines, steps, share, mesh, intersections })
}

/// Whether lines are the output of `sequence --json`.
fn is_one_object(lines: &[String]) -> bool {
    let [line] = lines else { return false };
    serde_json::from_str::<serde_json::Value>(line).is_ok_and(|value| value["summary"].is_object())
}

/// Checks that sorted parts are those of one sequence, none missing and none twice.
fn check(parts: &[Output]) -> Result<(), Failure> {
    let Some(first) = parts.first() else { return Err(Failure("there are no parts".into())) };
    let (of, all) = (first.share.part.of, first.share.all_steps);
    for other in parts {
        let (path, whose) = (other.path, first.path.display());
        let Share { part, all_steps, asked, .. } = other.share;
        if (part.of, all_steps) != (of, all) {
            let what = format!(
                "is one of {} parts of {all_steps} steps, {whose} one of {of} of {all}",
                part.of
            );
            return Err(in_file(path, what));
        }
        if other.mesh != first.mesh {
            return Err(in_file(path, format_args!("has {}, {whose} {}", other.mesh, first.mesh)));
        }
        if asked != first.share.asked {
            let what = "was made with other options, bodies or precision than";
            return Err(in_file(path, format_args!("{what} {whose}")));
        }
    }
    if let Some(pair) = parts.windows(2).find(|w| w[0].share.part == w[1].share.part) {
        let (index, other) = (pair[0].share.part.index, pair[1].path.display());
        return Err(in_file(pair[0].path, format_args!("is part {index} of {of}, as is {other}")));
    }
    let is_there = |index: &usize| parts.iter().any(|part| part.share.part.index == *index);
    let missing: Vec<usize> = (1..=of).filter(|index| !is_there(index)).take(11).collect();
    if missing.is_empty() {
        let meet = |pair: &&[Output]| pair[0].share.frames[1] != pair[1].share.frames[0];
        return parts.windows(2).find(meet).map_or(Ok(()), |pair| {
            let what = "begins with other positions than those that part";
            let (index, whose) = (pair[0].share.part.index, pair[0].path.display());
            Err(in_file(pair[1].path, format_args!("{what} {index}, {whose}, ends with")))
        });
    }
    let more = if missing.len() > 10 { " and more" } else { "" };
    let names: Vec<String> = missing.iter().take(10).map(usize::to_string).collect();
    Err(Failure(format!("of {of} parts these are missing: {}{more}", names.join(", "))))
}
