//! Names of the rows of a catalogue as values of an option.

use ccd::method::{Catalogued, Row};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// The names of a table, each with its line.
pub fn named<T: Catalogued + Send + Sync>() -> impl TypedValueParser<Value = T> {
    let value = |row: &Row<T>| PossibleValue::new(row.name).help(row.about);
    PossibleValuesParser::new(T::ROWS.iter().map(value))
        .try_map(|name| T::named(&name).ok_or("not in the table"))
}
