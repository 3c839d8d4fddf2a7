//! Why a command ends with status 2, as a person is told it.

/// Why a command ends with status 2.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct Failure(pub String);

impl Failure {
    /// Prints why the command ends.
    pub fn print(&self) {
        use std::io::Write;
        let style = anstyle::Style::new().bold().fg_color(Some(anstyle::AnsiColor::Red.into()));
        // If nobody can be told, the exit status says it.
        let _ = writeln!(anstream::stderr(), "{style}error:{style:#} {self}");
    }
}

impl From<ccd::io::ReadError> for Failure {
    fn from(e: ccd::io::ReadError) -> Self {
        Failure(e.to_string())
    }
}

impl From<ccd::Error> for Failure {
    fn from(e: ccd::Error) -> Self {
        match e {
            ccd::Error::MinDistance { value } => {
                let most = ccd::Error::MAX_COORDINATE;
                let what = "it must be from 0 to";
                Failure(format!("the minimum distance is {value:?}; {what} {most:e}"))
            }
            ccd::Error::ExactDistance { .. } => {
                Failure("--mode exact decides what touches: it takes no --min-distance".into())
            }
            ccd::Error::Tolerance { value } => {
                let what = format!("it must be from {:e} to 1", ccd::Options::LEAST_TOLERANCE);
                Failure(format!("--tolerance is {value:?}; {what}"))
            }
            ccd::Error::Window { from, until } => {
                Failure(format!("--window {from},{until}: it must be within 0,1, and in order"))
            }
            _ => Failure(e.to_string()),
        }
    }
}

impl From<ccd::gpu::Error> for Failure {
    fn from(e: ccd::gpu::Error) -> Self {
        match e {
            ccd::gpu::Error::Input(e) => e.into(),
            _ => Failure(e.to_string()),
        }
    }
}

/// A failure that names the file.
pub fn in_file(path: &std::path::Path, e: impl std::fmt::Display) -> Failure {
    Failure(format!("{}: {e}", path.display()))
}
