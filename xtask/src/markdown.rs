//! Reports as Markdown: tables, and paragraphs wrapped at the width that `tidy` allows.

use crate::tidy::MAX_COLUMNS_MARKDOWN;
#[cfg(feature = "report")]
use std::path::Path;

/// Wraps every line that is neither a row of a table nor a heading; no word is divided.
pub fn wrap(text: &str) -> String {
    let mut out = String::new();
    for line in text.lines() {
        if line.starts_with(['|', '#']) {
            out.push_str(line);
        } else {
            wrap_line(line, &mut out);
        }
        out.push('\n');
    }
    out
}

fn wrap_line(line: &str, out: &mut String) {
    let (spaces, body) = line.split_at(line.len() - line.trim_start().len());
    // What goes on in a further line stands below the text of the first.
    let indent = if body.starts_with("- ") { format!("{spaces}  ") } else { spaces.to_owned() };
    out.push_str(spaces);
    let mut columns = spaces.len();
    for (i, word) in body.split(' ').enumerate() {
        let n = word.chars().count();
        if i > 0 && columns + 1 + n > MAX_COLUMNS_MARKDOWN {
            out.push('\n');
            out.push_str(&indent);
            columns = indent.len();
        } else if i > 0 {
            out.push(' ');
            columns += 1;
        }
        out.push_str(word);
        columns += n;
    }
}

/// A table: the names of its columns, then rows.
pub struct Table(String);

impl Table {
    pub fn new<S: AsRef<str>>(columns: impl IntoIterator<Item = S>) -> Self {
        let mut table = Self(String::new());
        table.row(columns);
        let n = table.0.matches('|').count() - 1;
        table.0 += &format!("|{}\n", "---|".repeat(n));
        table
    }

    /// Appends a row.
    pub fn row<S: AsRef<str>>(&mut self, cells: impl IntoIterator<Item = S>) {
        self.0.push('|');
        cells.into_iter().for_each(|cell| self.0 += &format!(" {} |", cell.as_ref()));
        self.0.push('\n');
    }
}

impl std::fmt::Display for Table {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

/// The text with another table between the comments `<!-- name -->` and `<!-- end -->`.
pub fn replaced(text: &str, name: &str, table: &str) -> Result<String, String> {
    let begin = format!("<!-- {name} -->\n");
    let (head, rest) = text.split_once(&begin).ok_or(format!("no place for `{name}`"))?;
    let (_, tail) = rest.split_once("<!-- end -->").ok_or(format!("`{name}` has no end"))?;
    Ok(format!("{head}{begin}\n{}\n<!-- end -->{tail}", table.trim()))
}

/// The text with all its tables made anew; an error if one of them is not given, which would be of
/// another run.
pub fn all_replaced(text: &str, tables: &[(&str, String)]) -> Result<String, String> {
    let names = text.lines().filter_map(|line| line.strip_prefix("<!-- ")?.strip_suffix(" -->"));
    let given = |name: &&str| *name == "end" || tables.iter().any(|table| table.0 == *name);
    if let Some(name) = names.into_iter().find(|name| !given(name)) {
        return Err(format!("table `{name}` is not made anew"));
    }
    tables.iter().try_fold(text.to_owned(), |text, (name, table)| replaced(&text, name, table))
}

/// Writes a file of docs whose tables are made anew and whose text stays as it is: all or none.
#[cfg(feature = "report")]
pub fn rewrite(path: &Path, tables: &[(&str, String)]) -> Result<(), String> {
    let failed = |e: std::io::Error| format!("{}: {e}", path.display());
    let text = std::fs::read_to_string(path).map_err(failed)?;
    let text = all_replaced(&text, tables)?;
    std::fs::write(path, text).map_err(failed)?;
    println!("written {}", path.display());
    Ok(())
}

/// Writes one table of such a file that stands for itself: no other is compared with it.
#[cfg(feature = "report")]
pub fn rewrite_alone(path: &Path, name: &str, table: &str) -> Result<(), String> {
    let failed = |e: std::io::Error| format!("{}: {e}", path.display());
    let text = std::fs::read_to_string(path).map_err(failed)?;
    std::fs::write(path, replaced(&text, name, table)?).map_err(failed)?;
    println!("written {}", path.display());
    Ok(())
}

/// Three significant digits.
pub fn digits(x: f64) -> String {
    let places = (2 - x.abs().max(1e-9).log10().floor() as i32).clamp(0, 4) as usize;
    format!("{x:.places$}")
}

/// A number with commas between thousands.
pub fn thousands(n: u64) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paragraphs_are_wrapped_and_tables_are_not() {
        let words = "word ".repeat(41);
        let text =
            format!("# {words}\n\n{}\n- {}\n| {words}|\n", words.trim_end(), words.trim_end());
        let wrapped = wrap(&text);
        let lines: Vec<&str> = wrapped.lines().collect();
        assert_eq!(lines[0].len(), 207);
        assert_eq!((lines[2].len(), lines[3].len(), lines[4].len()), (99, 99, 4));
        assert!(lines[5].starts_with("- word") && lines[6].starts_with("  word"));
        assert!(lines.iter().all(|l| l.starts_with(['#', '|']) || l.len() <= MAX_COLUMNS_MARKDOWN));
        assert_eq!(wrap("   a  b"), "   a  b\n");
        let squeezed = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(squeezed(&wrapped), squeezed(&text));
    }

    #[test]
    fn tables_stand_between_their_comments() {
        let mut table = Table::new(["a", "b"]);
        table.row([digits(12.345), digits(0.0)]);
        assert_eq!(table.to_string(), "| a | b |\n|---|---|\n| 12.3 | 0.0000 |\n");
        let all = [0, 999, 1000, 113_854, 6_852_873].map(thousands);
        assert_eq!(all, ["0", "999", "1,000", "113,854", "6,852,873"]);
        let text = "x\n<!-- t -->\nold\n<!-- end -->\ny\n";
        let new = replaced(text, "t", "new\n").unwrap();
        assert_eq!(new, "x\n<!-- t -->\n\nnew\n<!-- end -->\ny\n");
        let all = |names: &[&'static str]| {
            let tables: Vec<_> = names.iter().map(|name| (*name, "new\n".to_owned())).collect();
            all_replaced(&format!("{text}<!-- u -->\nold\n<!-- end -->\n"), &tables)
        };
        assert!(all(&["t", "u"]).is_ok_and(|text| !text.contains("old")));
        assert_eq!(all(&["t"]), Err("table `u` is not made anew".into()));
        assert!(replaced(text, "u", "").is_err() && replaced("<!-- t -->\n", "t", "").is_err());
    }
}
