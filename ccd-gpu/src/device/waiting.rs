//! Waiting for a device: what it reports of commands, at once or later, and when its work is done.
//!
//! A native device reports an error as soon as a command was given. A browser reports it some time
//! later. There a command counts as good until the results are waited for, which waits for reports
//! as well; after a bad one whoever holds buffers makes them anew ([`Device::mend`]).

use super::Device;
use crate::error::Error;
use std::future::Future;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::pin::{Pin, pin};
use std::sync::{Mutex, MutexGuard};
use std::task::{Context, Poll, Waker};

/// Reports that are still to come, of the commands of one session.
#[derive(Default)]
pub(super) struct Unchecked(Mutex<State>);

#[derive(Default)]
struct State {
    /// In the order of the commands.
    checks: Vec<Check>,
    failed: bool,
}

impl Unchecked {
    fn lock(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(|e| e.into_inner())
    }
}

/// What a device reports of some commands.
enum Check {
    /// By the kind of the error: no memory, validation, internal.
    Scopes { what: &'static str, bytes: u64, scopes: [Scope; 3] },
    /// A test lets the commands fail.
    Fault(Error),
}

/// Errors of one kind.
enum Scope {
    Open(Pin<Box<dyn Future<Output = Option<wgpu::Error>> + Send>>),
    Closed(Option<wgpu::Error>),
}

impl Scope {
    fn new(
        mut pop: impl Future<Output = Option<wgpu::Error>> + Send + Unpin + 'static,
        context: &mut Context,
    ) -> Self {
        match Pin::new(&mut pop).poll(context) {
            Poll::Ready(error) => Self::Closed(error),
            Poll::Pending => Self::Open(Box::pin(pop)),
        }
    }

    /// Whether the device has reported.
    fn poll(&mut self, context: &mut Context) -> bool {
        if let Self::Open(pop) = self
            && let Poll::Ready(error) = pop.as_mut().poll(context)
        {
            *self = Self::Closed(error);
        }
        matches!(self, Self::Closed(_))
    }
}

impl Check {
    fn poll(&mut self, context: &mut Context) -> bool {
        match self {
            Self::Scopes { scopes, .. } => scopes.iter_mut().all(|scope| scope.poll(context)),
            Self::Fault(_) => true,
        }
    }

    /// What the device has reported.
    fn result(self) -> Result<(), Error> {
        let (what, bytes, scopes) = match self {
            Self::Scopes { what, bytes, scopes } => (what, bytes, scopes),
            Self::Fault(error) => return Err(error),
        };
        let [memory, validation, internal] = scopes.map(|scope| match scope {
            Scope::Open(_) => None,
            Scope::Closed(error) => error,
        });
        if memory.is_some() {
            return Err(Error::OutOfMemory { what, bytes });
        }
        match validation.or(internal) {
            Some(e) => Err(Error::Refused { why: e.to_string() }),
            None => Ok(()),
        }
    }
}

impl Device {
    /// Runs `work` and turns what the device reports meanwhile into an error: here, or where it
    /// reports later, when results are waited for. `what`, `bytes`: for lack of memory.
    pub(crate) fn guarded<T>(
        &self,
        what: &'static str,
        bytes: u64,
        work: impl FnOnce() -> T,
    ) -> Result<T, Error> {
        let scopes = self.begin_guard()?;
        let out = work();
        self.end_guard(what, bytes, scopes)?;
        Ok(out)
    }

    /// Scopes for what the device reports, the outermost first. Apart from [`Self::guarded`], as
    /// [`Self::end_guard`] is, so that it is compiled once.
    fn begin_guard(&self) -> Result<[wgpu::ErrorScopeGuard; 3], Error> {
        self.check_lost()?;
        let (fault, late) = {
            let mut faults = self.faults();
            (faults.next(), faults.late)
        };
        match fault {
            Some(fault) if late => self.unchecked.lock().checks.push(Check::Fault(fault)),
            Some(fault) => return Err(fault),
            None => {}
        }
        let filters = [
            wgpu::ErrorFilter::Internal,
            wgpu::ErrorFilter::Validation,
            wgpu::ErrorFilter::OutOfMemory,
        ];
        Ok(filters.map(|filter| self.wgpu().push_error_scope(filter)))
    }

    fn end_guard(
        &self,
        what: &'static str,
        bytes: u64,
        [internal, validation, memory]: [wgpu::ErrorScopeGuard; 3],
    ) -> Result<(), Error> {
        let context = &mut Context::from_waker(Waker::noop());
        let scopes = [memory.pop(), validation.pop(), internal.pop()];
        let scopes = scopes.map(|pop| Scope::new(pop, context));
        self.check_lost()?;
        let mut check = Check::Scopes { what, bytes, scopes };
        if check.poll(context) {
            return check.result();
        }
        self.unchecked.lock().checks.push(check);
        Ok(())
    }

    /// Runs what may fail without harm.
    pub(crate) fn quietly(&self, work: impl FnOnce()) {
        let scope = self.wgpu().push_error_scope(wgpu::ErrorFilter::Validation);
        work();
        drop(scope.pop());
    }

    /// Whether the device has reported of all commands so far, or the first error.
    pub(crate) fn poll_reports(&self, context: &mut Context) -> Poll<Result<(), Error>> {
        let mut unchecked = self.unchecked.lock();
        // All of them are asked, so that each wakes the caller.
        let polled = unchecked.checks.iter_mut().map(|check| check.poll(context));
        if polled.filter(|here| !here).count() > 0 {
            return Poll::Pending;
        }
        let results = unchecked.checks.drain(..).map(Check::result);
        let result = results.fold(Ok(()), Result::and);
        unchecked.failed |= result.is_err();
        Poll::Ready(result)
    }

    /// If a command failed after it had counted as good, so that buffers may be none, has them made
    /// anew; again, if that fails, the next time.
    pub(crate) fn mend(&self, anew: impl FnOnce() -> Result<(), Error>) -> Result<(), Error> {
        if !std::mem::take(&mut self.unchecked.lock().failed) {
            return Ok(());
        }
        anew().inspect_err(|_| self.unchecked.lock().failed = true)
    }

    /// Waits for all that was submitted.
    pub(crate) fn wait(&self) -> Result<(), Error> {
        let waited = polled(|| self.wgpu().poll(wgpu::PollType::wait_indefinitely()));
        self.check_lost()?;
        waited
    }

    /// Lets callbacks run of what is done.
    pub(crate) fn run_callbacks(&self) {
        // An error is that of a lost device, which is asked for elsewhere.
        let _ = polled(|| self.wgpu().poll(wgpu::PollType::Poll));
    }

    /// Blocks until `work`, which waits for this device alone, is done.
    pub(crate) fn block_on<T>(
        &self,
        work: impl Future<Output = Result<T, Error>>,
    ) -> Result<T, Error> {
        if BLOCKS {
            let mut work = pin!(work);
            let context = &mut Context::from_waker(Waker::noop());
            loop {
                if let Poll::Ready(done) = work.as_mut().poll(context) {
                    return done;
                }
                self.wait()?;
            }
        }
        Err(Error::CannotBlock)
    }
}

/// Polls a device. wgpu panics where a driver says meanwhile that the device is lost.
fn polled(poll: impl FnOnce() -> Result<wgpu::PollStatus, wgpu::PollError>) -> Result<(), Error> {
    match catch_unwind(AssertUnwindSafe(poll)) {
        Ok(polled) => polled.map(|_| ()).map_err(|e| Error::Lost { why: e.to_string() }),
        Err(payload) => {
            let text = payload.downcast_ref::<String>().map(String::as_str);
            match text.or_else(|| payload.downcast_ref::<&str>().copied()) {
                Some(why) if why.starts_with("Error in Device::poll") => {
                    Err(Error::Lost { why: why.to_owned() })
                }
                _ => resume_unwind(payload),
            }
        }
    }
}

/// Whether a thread may wait for a device; in a browser it may not.
pub(crate) const BLOCKS: bool = !cfg!(target_arch = "wasm32");

/// What wgpu does at once wherever a thread may wait.
pub(super) fn at_once<T>(work: impl Future<Output = T>) -> Option<T> {
    let mut work = pin!(work);
    let context = &mut Context::from_waker(Waker::noop());
    while BLOCKS {
        if let Poll::Ready(done) = work.as_mut().poll(context) {
            return Some(done);
        }
        std::thread::yield_now();
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_of_a_lost_device_is_an_error() {
        let lost = polled(|| panic!("Error in Device::poll: Validation Error: {}", "it is lost"));
        assert!(matches!(lost, Err(Error::Lost { why }) if why.ends_with("it is lost")));
        assert!(polled(|| Ok(wgpu::PollStatus::QueueEmpty)).is_ok());
        let other = catch_unwind(|| polled(|| panic!("a callback's {}", "own")));
        assert!(other.is_err());
    }
}
