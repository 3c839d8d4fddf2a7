//! A share of the steps of a sequence, so that several machines do it: `--part 2/8`.

use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::str::FromStr;

/// One of several shares, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Part {
    pub index: usize,
    pub of: usize,
}

impl Part {
    /// The steps of this share, of so many in all: neighbours, and as many as in the others, or one
    /// more or less.
    pub fn steps(self, n: usize) -> Range<usize> {
        let begin = |index: usize| (index as u128 * n as u128 / self.of as u128) as usize;
        begin(self.index - 1)..begin(self.index)
    }

    /// The share of this task of an array of Slurm's.
    fn of_slurm(variable: impl Fn(&str) -> Option<String>) -> Result<Self, String> {
        let number = |name: &str, default: Option<usize>| match variable(name) {
            Some(text) => text.parse().map_err(|_| format!("{name} is `{text}`, no number")),
            None => default.ok_or_else(|| format!("{name} is not set: no array of Slurm's")),
        };
        let id = number("SLURM_ARRAY_TASK_ID", None)?;
        let of = number("SLURM_ARRAY_TASK_COUNT", None)?;
        let least = number("SLURM_ARRAY_TASK_MIN", Some(0))?;
        let step = number("SLURM_ARRAY_TASK_STEP", Some(1))?;
        let from = id.checked_sub(least).filter(|_| step > 0);
        match from.filter(|from| from % step == 0).map(|from| from / step) {
            Some(index) if index < of => Ok(Self { index: index + 1, of }),
            _ => Err(format!(
                "task {id} is none of {of} from {least} in steps of {step}; an array with gaps \
                 needs --part i/n"
            )),
        }
    }
}

impl FromStr for Part {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "slurm" {
            return Self::of_slurm(|name| std::env::var(name).ok());
        }
        let numbers = text.split_once('/').map(|(index, of)| (index.parse(), of.parse()));
        match numbers {
            Some((Ok(index), Ok(of))) if index >= 1 && index <= of => Ok(Self { index, of }),
            _ => Err("expected i/n with i from 1 to n, or slurm".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_all_of_it_and_nothing_twice() {
        for n in [0, 1, 7, 8, 1000] {
            for of in 1..20 {
                let steps = (1..=of).flat_map(|index| Part { index, of }.steps(n));
                assert!(steps.eq(0..n), "{n} steps in {of} parts");
            }
        }
        assert_eq!("2/3".parse(), Ok(Part { index: 2, of: 3 }));
        for bad in ["0/3", "4/3", "1", "1/", "/1", "a/b", "1/0", "-1/2"] {
            assert!(bad.parse::<Part>().is_err(), "{bad}");
        }
    }

    #[test]
    fn tasks_of_slurm_are_parts() {
        let part = |set: &[(&str, &str)]| {
            Part::of_slurm(|name| {
                let name = name.strip_prefix("SLURM_ARRAY_TASK_")?;
                set.iter().find(|(n, _)| *n == name).map(|(_, value)| value.to_string())
            })
        };
        assert_eq!(part(&[("ID", "0"), ("COUNT", "4")]), Ok(Part { index: 1, of: 4 }));
        let array = |id| part(&[("ID", id), ("COUNT", "3"), ("MIN", "10"), ("STEP", "5")]);
        assert_eq!(array("20"), Ok(Part { index: 3, of: 3 }));
        for bad in ["25", "11", "5", "x"] {
            assert!(array(bad).is_err(), "{bad}");
        }
        assert!(part(&[("ID", "0")]).unwrap_err().contains("COUNT"));
    }
}
