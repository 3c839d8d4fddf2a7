//! The `ccd` command: see `ccd --help`.

mod cli;

fn main() -> std::process::ExitCode {
    cli::main()
}
