//! What can go wrong with a device, with the sizes and names that a reader needs.

use thiserror::Error;

/// Why the GPU did not do what was asked. A session stays usable after every error but
/// [`Error::Lost`], and can be given another device after that.
///
/// ```no_run
/// use ccd::{Mesh, Options};
/// use ccd::gpu::{Device, DeviceOptions, Error, Session};
///
/// fn contacts(session: &mut Session, x: &[[f32; 3]]) -> Result<usize, Error> {
///     if let Err(Error::Lost { why }) = session.step(x, x) {
///         eprintln!("{why}; once more on another device");
///         session.move_to(&Device::open(&DeviceOptions::default())?)?;
///     }
///     Ok(session.step(x, x)?.contacts.len())
/// }
/// # let device = Device::open(&DeviceOptions::default())?;
/// # contacts(&mut Session::new(&device, Mesh::new(0, &[])?, Options::default())?, &[])?;
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug, Error)]
#[non_exhaustive]
pub enum Error {
    /// The input was refused, and nothing was computed from it; or a limit of the caller's ended
    /// the call.
    #[error(transparent)]
    Input(#[from] ccd_core::Error),
    /// There is no adapter that fits.
    #[error("no GPU: {why}")]
    Unavailable {
        /// What was looked for and what was found.
        why: String,
    },
    /// A scheduler that steals was asked for where kernels are WGSL.
    #[error(
        "{adapter} is used through WGSL, which has no acquire and release between workgroups, so \
         that they cannot steal from each other: choose another scheduler, or `passthrough`"
    )]
    NoStealing {
        /// Name of the adapter.
        adapter: String,
    },
    /// Free regions were asked for where an application writes paths on the device itself.
    #[error(
        "free regions are certified from positions on the host, which does not see the paths that \
         an application writes on the device: turn them off"
    )]
    PathsUnseen,
    /// A mesh has particles whose contacts a device alone does not find.
    #[error(
        "contacts of particles and rods are decided on the host, which does not see the paths that \
         an application writes on the device: call `step` with positions"
    )]
    Codimensional,
    /// A mesh has particles that could touch each other or rods, in a browser.
    #[error(
        "contacts of particles with each other and with rods need a call that waits, which a \
         browser does not allow: use the CPU"
    )]
    Particles,
    /// A step on the device alone was asked for in [`Mode::Exact`](ccd_core::model::options::Mode).
    #[error("exact decisions are made on the host: choose the conservative mode")]
    ExactOnDevice,
    /// Geometry of contacts was asked for where the last call left no list of them on the device.
    #[error("there are no contacts on the device: call `step`, or `record`, before")]
    NoContacts,
    /// The last pairs of boxes were asked for once more where no boxes are on the device.
    #[error("there are no boxes on the device: call `send_boxes`, or a search, before")]
    NoBoxes,
    /// A search was repeated until nobody could expect an end of it.
    #[error(
        "after {runs} runs of one search lists were still too short: choose another scheduler, or \
         report this as a defect"
    )]
    Incomplete {
        /// How often it ran.
        runs: u32,
    },
    /// A call that blocks was made in a browser, where a thread cannot wait for a device.
    #[error(
        "a browser does not let a thread wait for a GPU: call the function of the same name that \
         ends in `_async`, or `submit` and `poll`"
    )]
    CannotBlock,
    /// A step was asked for whose end nobody waits for.
    #[error("there is no step in flight: call `submit` before `poll`")]
    NotSubmitted,
    /// A buffer would be larger than the device allows.
    #[error("{what} need {bytes} bytes, but this device binds at most {limit} bytes at once")]
    TooLarge {
        /// What the buffer holds.
        what: &'static str,
        /// Bytes needed.
        bytes: u64,
        /// The limit of the device.
        limit: u64,
    },
    /// The device has too little memory.
    #[error("the device has no memory for {bytes} bytes of {what}")]
    OutOfMemory {
        /// What the buffer holds.
        what: &'static str,
        /// Bytes asked for.
        bytes: u64,
    },
    /// The device was lost: unplugged, reset by its driver, or destroyed.
    #[error("the device was lost: {why}")]
    Lost {
        /// What the driver says.
        why: String,
    },
    /// The device refused a command: a defect of this library or of the driver.
    #[error("the device refused a command, a defect of the library or the driver: {why}")]
    Refused {
        /// What the device says.
        why: String,
    },
}

impl Error {
    /// Whether less would have been possible: a buffer was too large, for the device or for the
    /// memory of the device or of the session.
    pub(crate) fn is_of_memory(&self) -> bool {
        use ccd_core::Error::Memory;
        let Self::Input(Memory { .. }) = self else {
            return matches!(self, Self::TooLarge { .. } | Self::OutOfMemory { .. });
        };
        true
    }
}

/// What tests let go wrong on a device from now on, in all its sessions.
#[derive(Clone, Debug, Default)]
pub struct Faults {
    /// Calls of the driver that succeed before: buffers, kernels, frames, results.
    pub skip: u32,
    /// Calls after them that fail.
    pub n: u32,
    /// How they fail; `None`: they do not.
    pub error: Option<Error>,
    /// Whether they fail as in a browser: the calls seem to succeed, and whoever waits for results
    /// gets the error.
    pub late: bool,
    /// Of sessions that are made from now on, a search begins with two workers that take one turn
    /// in one round, so that pairs are left.
    pub short_rounds: bool,
    /// How many candidates a part of a step has at most; 0: as many as a list may have.
    pub most_candidates: u32,
}

impl Faults {
    /// The fault of the next call, if it has one.
    pub(crate) fn next(&mut self) -> Option<Error> {
        let error = self.error.clone()?;
        if self.skip > 0 {
            self.skip -= 1;
            return None;
        }
        let fails = self.n > 0;
        self.n -= fails as u32;
        fails.then_some(error)
    }
}
