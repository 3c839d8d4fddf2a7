//! Reports as Markdown: paragraphs wrapped at the width that `tidy` allows.

use crate::tidy::MAX_COLUMNS_MARKDOWN;

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
}
