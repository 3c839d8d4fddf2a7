//! Status codes, the message of the last error of a thread, and the guard around every call:
//! a panic becomes a status.

use ccd::any;
use std::any::Any;
use std::cell::RefCell;
use std::ffi::{CString, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Major version of this header.
pub const CCD_VERSION_MAJOR: u32 = 0;
/// Minor version of this header.
pub const CCD_VERSION_MINOR: u32 = 1;
/// Patch version of this header.
pub const CCD_VERSION_PATCH: u32 = 0;

/// Outcome of a call. ccd_last_error() has the message of all but CCD_STATUS_OK.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CcdStatus {
    /// The call did what was asked.
    Ok = 0,
    /// Misuse: a pointer is NULL, a value is none of its enumeration, a size is none of a struct.
    InvalidArgument = 1,
    /// Input is refused, and nothing was computed from it: an index out of range, a wrong number
    /// of vertices, a coordinate that is NaN, infinite or above 1e100, options out of their range.
    InvalidInput = 2,
    /// There is no GPU that fits, or of the given name, or the library was built without GPU.
    NoGpu = 3,
    /// The GPU failed: it was lost, or refused a command.
    DeviceFailed = 4,
    /// More memory would be needed than max_memory, or the GPU, allows. The object stays usable.
    OutOfMemory = 5,
    /// ccd_session_cancel ended the call.
    Cancelled = 6,
    /// Another call uses this object at the moment.
    Busy = 7,
    /// A defect of the library. The object refuses all further calls: destroy it.
    Panicked = 8,
}

/// Why a call failed.
#[derive(Debug)]
pub struct Failure {
    status: CcdStatus,
    message: String,
}

impl Failure {
    /// A failure with its message.
    pub fn new(status: CcdStatus, message: impl Into<String>) -> Self {
        Self { status, message: message.into() }
    }

    /// Misuse by the caller.
    pub fn argument(message: impl Into<String>) -> Self {
        Self::new(CcdStatus::InvalidArgument, message)
    }
}

impl From<ccd::Error> for Failure {
    fn from(why: ccd::Error) -> Self {
        let status = match why {
            ccd::Error::Memory { .. } => CcdStatus::OutOfMemory,
            ccd::Error::Cancelled => CcdStatus::Cancelled,
            _ => CcdStatus::InvalidInput,
        };
        Self::new(status, why.to_string())
    }
}

impl From<any::Error> for Failure {
    fn from(why: any::Error) -> Self {
        let status = match why {
            any::Error::Input(why) => return why.into(),
            any::Error::Unavailable { .. } => CcdStatus::NoGpu,
            #[cfg(feature = "gpu")]
            any::Error::TooLarge { .. } | any::Error::OutOfMemory { .. } => CcdStatus::OutOfMemory,
            _ => CcdStatus::DeviceFailed,
        };
        Self::new(status, why.to_string())
    }
}

thread_local! {
    static LAST: RefCell<CString> = RefCell::default();
}

/// Makes a call: its status, with the message kept for this thread. A panic ends here.
pub fn guard(call: impl FnOnce() -> Result<(), Failure>) -> CcdStatus {
    let failure = match catch_unwind(AssertUnwindSafe(call)) {
        Ok(Ok(())) => return CcdStatus::Ok,
        Ok(Err(failure)) => failure,
        Err(panic) => {
            let what = text(&*panic);
            // Whatever a destructor of the payload does, it does not do it here.
            std::mem::forget(panic);
            Failure::new(CcdStatus::Panicked, format!("a defect of the library: {what}"))
        }
    };
    let message = CString::new(failure.message.replace('\0', " ")).unwrap_or_default();
    // A thread that ends may have destroyed its message already; then there is none.
    let _ = LAST.try_with(|last| last.replace(message));
    failure.status
}

/// Does what cannot fail; `nothing` after a panic.
pub fn guard_value<T>(nothing: T, call: impl FnOnce() -> T) -> T {
    let mut value = nothing;
    guard(|| {
        value = call();
        Ok(())
    });
    value
}

/// Message of a panic.
fn text(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default()
}

/// Version of the library: `major << 16 | minor << 8 | patch`, which may differ from that of the
/// header that a program was compiled with. Versions of one major number, of 0 those of one minor
/// number, can be exchanged.
#[unsafe(no_mangle)]
pub extern "C" fn ccd_version() -> u32 {
    CCD_VERSION_MAJOR << 16 | CCD_VERSION_MINOR << 8 | CCD_VERSION_PATCH
}

/// Message of the last call on this thread that failed, in English and UTF-8, with element, place
/// and value; "" if none failed. Valid until another call fails on this thread, or the thread ends.
#[unsafe(no_mangle)]
pub extern "C" fn ccd_last_error() -> *const c_char {
    LAST.try_with(|last| last.borrow().as_ptr()).unwrap_or(c"".as_ptr())
}

/// Name of a status, such as "invalid input"; "unknown status" of any other number. Static.
#[unsafe(no_mangle)]
pub extern "C" fn ccd_status_name(status: i32) -> *const c_char {
    let names = [
        c"ok",
        c"invalid argument",
        c"invalid input",
        c"no GPU",
        c"device failed",
        c"out of memory",
        c"cancelled",
        c"busy",
        c"panicked",
    ];
    let name = usize::try_from(status).ok().and_then(|status| names.get(status));
    name.unwrap_or(&c"unknown status").as_ptr()
}

/// The numbers above are those of the package.
const _: () = {
    const fn is(number: u32, text: &str) -> bool {
        matches!(u32::from_str_radix(text, 10), Ok(n) if n == number)
    }
    assert!(is(CCD_VERSION_MAJOR, env!("CARGO_PKG_VERSION_MAJOR")));
    assert!(is(CCD_VERSION_MINOR, env!("CARGO_PKG_VERSION_MINOR")));
    assert!(is(CCD_VERSION_PATCH, env!("CARGO_PKG_VERSION_PATCH")));
};
