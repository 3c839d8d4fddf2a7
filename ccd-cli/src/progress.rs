//! Progress on standard error: a bar over many steps, a line that says what a single long one is
//! at. Both are hidden where standard error is no terminal, and with `--quiet`.

use super::output::is_quiet;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::sync::mpsc;
use std::thread::JoinHandle;
use std::time::Duration;

/// A bar over `n` things.
pub fn bar(n: usize, what: &'static str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(n as u64), target());
    bar.with_style(style("{msg} {wide_bar} {pos}/{len}, {eta} left")).with_message(what)
}

fn target() -> ProgressDrawTarget {
    if is_quiet() { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() }
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

/// The time after which work is long enough to be told of.
const LONG: Duration = Duration::from_secs(1);

/// A line that says what is done and for how long, once that takes long; cleared at its end.
pub struct Work {
    line: ProgressBar,
    /// Once this is dropped the thread ends.
    ends: Option<mpsc::Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Work {
    /// Begins with `what`.
    pub fn new(what: &'static str) -> Self {
        Self::on(what, target)
    }

    fn on(what: &'static str, target: impl Fn() -> ProgressDrawTarget + Send + 'static) -> Self {
        let line = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        let line = line.with_style(style("{spinner} {msg} .. {elapsed}")).with_message(what);
        let (ends, end) = mpsc::channel();
        let shown = line.clone();
        let thread = std::thread::spawn(move || {
            if end.recv_timeout(LONG) == Err(mpsc::RecvTimeoutError::Timeout) {
                shown.set_draw_target(target());
                shown.enable_steady_tick(Duration::from_millis(100));
            }
        });
        Self { line, ends: Some(ends), thread: Some(thread) }
    }

    /// Goes on with `what`.
    pub fn goes_on(&self, what: &'static str) {
        self.line.set_message(what);
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        self.ends = None;
        if let Some(thread) = self.thread.take() {
            // It has nothing to say.
            let _ = thread.join();
        }
        self.line.finish_and_clear();
    }
}
