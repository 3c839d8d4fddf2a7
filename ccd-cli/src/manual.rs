//! `ccd completions` and `ccd man`: what shells and `man` read.

use super::{Cli, Outcome, in_file, output};
use clap::{Args, CommandFactory};
use std::path::PathBuf;

#[derive(Args)]
pub struct Completions {
    #[arg(value_enum)]
    shell: clap_complete::Shell,
}

impl Completions {
    pub fn run(&self) -> Outcome {
        let mut text = Vec::new();
        clap_complete::generate(self.shell, &mut Cli::command(), "ccd", &mut text);
        output::print(format_args!("{}", String::from_utf8_lossy(&text).trim_end()));
        output::flush();
        Ok(false)
    }
}

#[derive(Args)]
pub struct Man {
    /// The folder that the pages are written to; it must be there
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
}

impl Man {
    pub fn run(&self) -> Outcome {
        clap_mangen::generate_to(Cli::command(), &self.folder)
            .map_err(|e| in_file(&self.folder, e))?;
        Ok(false)
    }
}
