//! Options in a struct whose first field is its size, so that it may grow: a program that was
//! compiled with an older header gives a shorter one, and the rest has its defaults.

use crate::memory::string;
use crate::status::{CcdStatus, Failure, guard};
use ccd::any::{self, Backend, Choice};
use ccd::{Mode, Options};
use std::ffi::c_char;
use std::mem::offset_of;

/// Where steps run.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CcdBackend {
    /// A GPU if there is one and the mesh has at least 20,000 edges, and for as long as it does not
    /// fail; else the CPU. With an `adapter` that one, however small the mesh is.
    Auto = 0,
    /// Threads of this machine.
    Cpu = 1,
    /// A GPU; an error if there is none, or if it fails.
    Gpu = 2,
}

/// How times of impact are found. Which pairs touch is decided exactly in all modes.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CcdMode {
    /// CCD_MODE_EXACT on the CPU, if there is no minimum distance; else, and in sessions on a GPU
    /// also for what they leave to the CPU, CCD_MODE_CONSERVATIVE.
    Auto = 0,
    /// Never late, and early by the tolerance at most.
    Conservative = 1,
    /// The true ones, rounded down. Takes no minimum distance.
    Exact = 2,
}

/// What a session looks for and how. Later versions may have more fields at the end:
/// ccd_options_default fills in all that there are.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CcdOptions {
    /// Bytes of this struct as the program knows it.
    pub size: usize,
    /// Contact means a distance of at most this, in the unit of coordinates; 0 means touching.
    pub min_distance: f64,
    /// How early a certain time of impact may be, from 1e-12 to 1; 1e-6 by default.
    pub tolerance: f64,
    /// Bytes that the session may hold; 0: no limit.
    pub max_memory: u64,
    /// A part of the name of a GPU, its PCI id or its number, for CCD_BACKEND_AUTO and
    /// CCD_BACKEND_GPU; NULL or empty: the one that the system prefers. UTF-8.
    pub adapter: *const c_char,
    /// A CcdBackend; CCD_BACKEND_AUTO by default.
    pub backend: u32,
    /// A CcdMode; CCD_MODE_AUTO by default.
    pub mode: u32,
    /// Threads of work on the CPU: 0 for all cores, shared by all sessions; 1 for the calling
    /// thread alone; more, up to 1024, for a pool of the session's own.
    pub threads: u32,
    /// Whether features that are in contact at the start of a step may leave it (1) or not (0).
    pub leave_contact: u32,
}

/// Bytes of the first version of the struct.
const FIRST_SIZE: usize = offset_of!(CcdOptions, leave_contact) + size_of::<u32>();

impl CcdOptions {
    fn new(size: usize) -> Self {
        let Options { min_distance, tolerance, .. } = Options::default();
        Self {
            size,
            min_distance,
            tolerance,
            max_memory: 0,
            adapter: std::ptr::null(),
            backend: CcdBackend::Auto as u32,
            mode: CcdMode::Auto as u32,
            threads: 0,
            leave_contact: 0,
        }
    }
}

/// Fills in the defaults. `size`: sizeof(CcdOptions).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ccd_options_default(options: *mut CcdOptions, size: usize) -> CcdStatus {
    guard(|| {
        check(options, size)?;
        let (all, known) = (CcdOptions::new(size), size.min(size_of::<CcdOptions>()));
        // SAFETY: not NULL and aligned; that `size` bytes are there is the caller's duty. What a
        // later header has behind those that are known is 0.
        unsafe {
            options.cast::<u8>().write_bytes(0, size);
            options.cast::<u8>().copy_from(std::ptr::from_ref(&all).cast(), known);
        }
        Ok(())
    })
}

/// Options of the library, and the choice of a backend for so many edges, from those of a caller.
///
/// # Safety
/// NULL, or as many bytes as `size` says, of which `adapter` points to a text.
pub(crate) unsafe fn read(
    options: *const CcdOptions,
    edge_count: usize,
) -> Result<(Options, Choice), Failure> {
    let mut given = CcdOptions::new(size_of::<CcdOptions>());
    if !options.is_null() {
        check_aligned(options)?;
        // SAFETY: the size is the first field of every version.
        let size = unsafe { options.cast::<usize>().read() };
        check(options, size)?;
        let known = size.min(size_of::<CcdOptions>());
        // SAFETY: the caller's duty; every pattern of bits is a value of each field.
        let rest = unsafe {
            std::ptr::from_mut(&mut given).cast::<u8>().copy_from(options.cast(), known);
            std::slice::from_raw_parts(options.cast::<u8>().add(known), size - known)
        };
        if rest.iter().any(|&byte| byte != 0) {
            let why = "options have fields of a later version that this library does not know";
            return Err(Failure::argument(why));
        }
    }
    let mode = match given.mode {
        mode if mode == CcdMode::Auto as u32 => Mode::Auto,
        mode if mode == CcdMode::Conservative as u32 => Mode::Conservative,
        mode if mode == CcdMode::Exact as u32 => Mode::Exact,
        mode => return Err(Failure::argument(format!("mode is {mode}; it must be a CcdMode"))),
    };
    let backend = match given.backend {
        backend if backend == CcdBackend::Auto as u32 => Backend::Auto,
        backend if backend == CcdBackend::Cpu as u32 => Backend::Cpu,
        backend if backend == CcdBackend::Gpu as u32 => Backend::Gpu,
        backend => {
            let why = format!("backend is {backend}; it must be a CcdBackend");
            return Err(Failure::argument(why));
        }
    };
    // SAFETY: the caller's duty.
    let adapter = unsafe { string(given.adapter, "adapter")? };
    let choice = choose(backend, edge_count, adapter)?;
    let options = Options::default()
        .with_min_distance(given.min_distance)
        .with_tolerance(given.tolerance)
        .with_max_memory((given.max_memory > 0).then_some(given.max_memory))
        .with_threads(given.threads as usize)
        .with_mode(mode)
        .with_leave_contact(given.leave_contact != 0);
    Ok((options, choice))
}

#[cfg(feature = "gpu")]
fn choose(backend: Backend, size: usize, adapter: Option<&str>) -> Result<Choice, any::Error> {
    let adapter = adapter.filter(|name| !name.is_empty()).map(str::to_owned);
    backend.choose_with(size, &ccd::gpu::DeviceOptions { adapter, ..Default::default() })
}

/// The error for a GPU says that there is none in this build.
#[cfg(not(feature = "gpu"))]
fn choose(backend: Backend, size: usize, _: Option<&str>) -> Result<Choice, any::Error> {
    backend.choose(size)
}

fn check(options: *const CcdOptions, size: usize) -> Result<(), Failure> {
    if options.is_null() {
        return Err(Failure::argument("options is NULL"));
    }
    check_aligned(options)?;
    // No version will be so long: this is something else.
    if size < FIRST_SIZE || size > 1 << 16 {
        let why = "use ccd_options_default, with sizeof(CcdOptions)";
        return Err(Failure::argument(format!("options have a size of {size} bytes: {why}")));
    }
    Ok(())
}

fn check_aligned(options: *const CcdOptions) -> Result<(), Failure> {
    if options.is_aligned() {
        Ok(())
    } else {
        Err(Failure::argument("options lie at an address that their type cannot have"))
    }
}
