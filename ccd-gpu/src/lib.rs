//! The host side of the kernels of `ccd-core` on a GPU.
//!
//! There is no GPU backend yet. This crate holds its place in the workspace and the one answer that it can give: [`open`] says so.

/// The error of every request for a GPU in this version.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unavailable;

impl core::fmt::Display for Unavailable {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("this version has no GPU backend")
    }
}

impl core::error::Error for Unavailable {}

/// Opens a device: always [`Unavailable`] in this version.
pub fn open() -> Result<core::convert::Infallible, Unavailable> {
    Err(Unavailable)
}
