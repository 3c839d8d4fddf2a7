//! Variables that the command sets in its environment at its start.

/// Keeps Mesa's layer that orders GPUs for a desktop from looking for one that is not there:
/// libwayland then complains on standard error (`XDG_RUNTIME_DIR is invalid or not set`), once for
/// every look. The order of GPUs is not used here. Whoever chooses by that layer keeps it.
///
/// To be called while there is one thread.
pub fn prepare() {
    let unset = |name: &str| std::env::var_os(name).is_none();
    let is_idle = ["MESA_VK_DEVICE_SELECT", "DRI_PRIME", "NODEVICE_SELECT"].into_iter().all(unset);
    if cfg!(target_os = "linux") && unset("XDG_RUNTIME_DIR") && is_idle {
        // SAFETY: `main` calls this first, when no other thread can read the environment.
        #[allow(unsafe_code, reason = "a driver's layer is told by a variable only")]
        unsafe {
            std::env::set_var("NODEVICE_SELECT", "1");
        }
    }
}
