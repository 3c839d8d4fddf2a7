//! Compiled kernels on disk, so that the next process takes them from there: one file for a kind of
//! GPU, checked before it is used, replaced as a whole.
//!
//! A file is a header and what the driver gave: the magic word, a digest of everything that the
//! content depends on and we know (this format, the kernels' manifest, adapter, driver), the length
//! of the rest, a digest of the rest. A file in which anything of it differs is no file: it is
//! compiled anew and replaced. wgpu and the driver have headers of their own inside and check them.
//! Whatever fails here costs a compilation and is never an error.

use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};

/// What a file begins with; the last character is the version of the format.
const MAGIC: &[u8; 8] = b"ccdkern1";
/// Magic, digest of the setting, length, digest of the content.
const HEADER: usize = 32;
/// Bytes beyond which a file is not read: all kernels together are some megabytes.
const MOST: u64 = 1 << 28;
/// What the kernels were compiled from.
const MANIFEST: &str = include_str!("../shaders/manifest.json");

/// Where the kernels of one kind of GPU are kept.
pub struct KernelFile {
    path: PathBuf,
    setting: u64,
}

impl KernelFile {
    /// The file in `folder` for an adapter; `None` where its driver has nothing to keep.
    pub fn of(folder: &Path, adapter: &wgpu::AdapterInfo) -> Option<Self> {
        let name = wgpu::util::pipeline_cache_key(adapter)?;
        let a = adapter;
        let setting = digest(&(MANIFEST, &a.name, a.vendor, a.device, &a.driver, &a.driver_info));
        Some(Self { path: folder.join(name), setting })
    }

    /// What was kept; `None` if there is nothing, or nothing that fits.
    pub fn read(&self) -> Option<Vec<u8>> {
        if std::fs::metadata(&self.path).ok()?.len() > MOST {
            return None;
        }
        let mut bytes = std::fs::read(&self.path).ok()?;
        let (header, data) = bytes.split_at_checked(HEADER)?;
        if header != self.header(data) {
            return None;
        }
        bytes.drain(..HEADER);
        Some(bytes)
    }

    /// Replaces the file; a reader sees the old one or the new one, never a part. Whether it could.
    pub fn write(&self, data: &[u8]) -> bool {
        let temporary = self.path.with_extension(format!("{}.part", std::process::id()));
        let bytes = [&self.header(data)[..], data].concat();
        let written = self.path.parent().is_some_and(|to| std::fs::create_dir_all(to).is_ok())
            && std::fs::write(&temporary, bytes).is_ok()
            && std::fs::rename(&temporary, &self.path).is_ok();
        if !written {
            let _ = std::fs::remove_file(&temporary);
        }
        written
    }

    fn header(&self, data: &[u8]) -> [u8; HEADER] {
        let mut header = [0; HEADER];
        header[..8].copy_from_slice(MAGIC);
        header[8..16].copy_from_slice(&self.setting.to_le_bytes());
        header[16..24].copy_from_slice(&(data.len() as u64).to_le_bytes());
        header[24..].copy_from_slice(&digest(data).to_le_bytes());
        header
    }
}

/// Another version of the standard library may compute another one: then kernels are compiled once
/// more.
fn digest(of: &(impl Hash + ?Sized)) -> u64 {
    let mut hasher = std::hash::DefaultHasher::new();
    of.hash(&mut hasher);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_whole_or_it_is_none() {
        let folder = std::env::temp_dir().join(format!("ccd-kernel-file-{}", std::process::id()));
        let file = KernelFile { path: folder.join("a/b"), setting: 7 };
        assert_eq!(file.read(), None);
        assert!(file.write(b"first") && file.write(b"second"));
        assert_eq!(file.read().as_deref(), Some(&b"second"[..]));
        assert_eq!(KernelFile { path: file.path.clone(), setting: 8 }.read(), None);
        let good = std::fs::read(&file.path).unwrap();
        let mut flipped = good.clone();
        flipped[HEADER + 1] ^= 1;
        let longer = [&good[..], b"x"].concat();
        for bad in [&flipped[..], &longer, &good[..good.len() - 1], &good[..9], b""] {
            std::fs::write(&file.path, bad).unwrap();
            assert_eq!(file.read(), None);
        }
        std::fs::write(&file.path, good).unwrap();
        assert!(file.read().is_some());
        // A folder that cannot be: below a file.
        assert!(!KernelFile { path: file.path.join("c/d"), setting: 7 }.write(b"third"));
        std::fs::remove_dir_all(folder).unwrap();
    }
}
