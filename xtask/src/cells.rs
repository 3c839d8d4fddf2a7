//! Cells of a report, each measured once and kept in a folder as a line of JSON: a report that ran
//! out of time goes on where it was, and a method that stands in several tables has one figure.

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::collections::HashMap;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Cells by name.
pub struct Cells {
    /// Where they are kept, if they outlast this run.
    path: Option<PathBuf>,
    kept: HashMap<String, Value>,
    /// Nothing is measured after this.
    until: Option<Instant>,
    n_left: usize,
}

impl Cells {
    /// Those of a report: kept in `folder`, or by this run alone. Nothing new is begun after so
    /// many minutes.
    pub fn open(folder: Option<&Path>, report: &str, minutes: Option<f64>) -> Result<Self, String> {
        let path = folder.map(|folder| folder.join(format!("{report}.jsonl")));
        let mut kept = HashMap::new();
        if let Some(path) = &path {
            let failed = |e: std::io::Error| format!("{}: {e}", path.display());
            path.parent().map_or(Ok(()), std::fs::create_dir_all).map_err(failed)?;
            let text =
                if path.exists() { std::fs::read_to_string(path) } else { Ok(String::new()) };
            let text = text.map_err(failed)?;
            // A run that was ended may have left a part of a line, after which none is appended.
            let mut whole = String::new();
            for line in text.lines() {
                let Ok(Value::Array(cell)) = serde_json::from_str(line) else { continue };
                let [Value::String(name), value] = &cell[..] else { continue };
                kept.insert(name.clone(), value.clone());
                whole += line;
                whole.push('\n');
            }
            std::fs::write(path, whole).map_err(failed)?;
        }
        let after = |minutes: f64| Instant::now() + Duration::from_secs_f64(60.0 * minutes);
        Ok(Self { path, kept, until: minutes.map(after), n_left: 0 })
    }

    /// A cell as it was kept, or as it is measured now; `None` if there is no more time.
    pub fn get<T: Serialize + DeserializeOwned>(
        &mut self,
        name: &str,
        measure: impl FnOnce() -> Result<T, String>,
    ) -> Result<Option<T>, String> {
        let of_value = |value: Value| {
            let cell = serde_json::from_value(value).map(Some);
            cell.map_err(|e| format!("{name}: not a cell of this report: {e}"))
        };
        if let Some(value) = self.kept.get(name) {
            return of_value(value.clone());
        }
        if self.until.is_some_and(|until| Instant::now() >= until) {
            self.n_left += 1;
            return Ok(None);
        }
        let value = serde_json::to_value(measure()?).map_err(|e| format!("{name}: {e}"))?;
        if let Some(path) = &self.path {
            let failed = |e: std::io::Error| format!("{}: {e}", path.display());
            let file = std::fs::OpenOptions::new().append(true).open(path);
            let line = format!("{}\n", json!([name, value]));
            file.and_then(|mut file| file.write_all(line.as_bytes())).map_err(failed)?;
        }
        self.kept.insert(name.into(), value.clone());
        of_value(value)
    }

    /// Whether all cells are there that were asked for; says how many are not.
    pub fn are_complete(&self) -> bool {
        if self.n_left > 0 {
            let (left, kept) = (self.n_left, self.kept.len());
            println!("{left} cells are left, {kept} are kept, no table is written: run it again");
        }
        self.n_left == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_measured_once_and_outlasts_a_run() {
        let folder = tempfile::tempdir().unwrap();
        let open = |minutes| Cells::open(Some(folder.path()), "a", minutes).unwrap();
        let mut cells = open(None);
        assert_eq!(cells.get("x", || Ok(json!([1.5, null]))), Ok(Some(json!([1.5, null]))));
        assert!(cells.get::<Value>("y", || Err("no".into())).is_err() && cells.are_complete());
        // A run that was ended in the middle of a line.
        let path = folder.path().join("a.jsonl");
        let text = std::fs::read_to_string(&path).unwrap();
        std::fs::write(&path, format!("{text}[\"y\",")).unwrap();
        let mut cells = open(Some(0.0));
        let again = |_: ()| -> Result<Value, String> { Err("measured twice".into()) };
        assert_eq!(cells.get("x", || again(())), Ok(Some(json!([1.5, null]))));
        assert_eq!(cells.get("y", || again(())), Ok(None));
        assert!(!cells.are_complete());
        let mut cells = open(None);
        assert_eq!(cells.get("y", || Ok(json!(2))), Ok(Some(json!(2))));
        assert_eq!(open(Some(0.0)).get("y", || again(())), Ok(Some(json!(2))));
        let mut others = Cells::open(None, "a", None).unwrap();
        assert_eq!(others.get("x", || Ok(json!(3))), Ok(Some(json!(3))));
    }
}
