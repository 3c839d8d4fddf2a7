//! The example in a Bevy app: built by its own Rust, run without a screen, compared with the CPU.

use crate::programs::{channel, command, command_with, output, skipped};
use std::path::Path;
use std::process::Command;

/// Frames that are run: the cloth touches the sphere from the eighteenth on.
const FRAMES: &str = "60";

/// Builds, lints and runs `examples/bevy`; installs nothing.
pub fn run(root: &Path) -> Result<(), String> {
    let folder = root.join("examples/bevy");
    let channel = channel(&folder)?;
    let with_rust = ["rustup", "run", &channel];
    let rustc = [&with_rust[1..], &["rustc", "--version"]].concat();
    if output(Command::new(with_rust[0]).args(rustc)).is_err() {
        let install = format!("rustup toolchain install {channel} --profile minimal -c clippy");
        skipped(&format!("examples/bevy was not run, its Rust is missing ({install} -c rustfmt)"));
        return Ok(());
    }
    if let Err(why) = output(Command::new("xvfb-run").arg("--help")) {
        skipped(&format!("examples/bevy was not run, there is no display server: {why}"));
        return Ok(());
    }
    let cargo = [&with_rust[..], &["cargo"]].concat();
    command(&folder, &[&cargo[..], &["fmt", "--check"]].concat())?;
    command(&folder, &[&cargo[..], &["clippy", "--locked", "--", "-D", "warnings"]].concat())?;
    command(&folder, &[&cargo[..], &["build", "--locked"]].concat())?;
    let run = ["run", "--locked", "--", "--frames", FRAMES, "--check"];
    // Seconds: a run that waits for a frame for ever fails.
    let run = [&["timeout", "1800", "xvfb-run", "-a"], &cargo[..], &run].concat();
    // Xvfb has no GPU: of Vulkan's drivers the software one alone presents there.
    command_with(&folder, &run, &[("WGPU_ADAPTER_NAME", "llvmpipe")])
}
