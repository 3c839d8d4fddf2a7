//! `ccd completions` and `ccd man`: what shells and `man` read.

use super::files::Output;
use super::{Cli, Failure, Outcome, in_file, output};
use clap::{Args, CommandFactory};
use std::io::Write;
use std::path::PathBuf;

#[derive(Args)]
pub struct Completions {
    /// The shell that reads them
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
        let mut all = Cli::command().disable_help_subcommand(true);
        all.build();
        for command in all.get_subcommands().chain([&all]) {
            self.write(command.clone())?;
        }
        Ok(false)
    }

    /// Writes a page. Its last section has columns, which `man` must not fill up.
    fn write(&self, command: clap::Command) -> Result<(), Failure> {
        // Of an option that `-h` leaves out a page has the long text alone.
        let command = command.mut_args(|arg| match arg.get_help().cloned() {
            Some(help) if arg.get_long_help().is_none() => arg.long_help(help),
            _ => arg,
        });
        let page = clap_mangen::Man::new(command);
        let path = self.folder.join(page.get_filename());
        let mut text = Vec::new();
        page.render(&mut text).map_err(|e| in_file(&path, e))?;
        let text = String::from_utf8_lossy(&text).replace(".SH EXTRA\n", ".SH EXTRA\n.nf\n");
        let write = || {
            let mut out = Output::beside(&path)?;
            out.write_all(text.as_bytes())?;
            out.done()
        };
        write().map_err(|e| in_file(&path, e))
    }
}
