//! Compiled kernels on disk, for the next process: one file for a kind of GPU, checked before it is
//! used, replaced at once.
//!
//! A file is a header and what the driver gave: the magic word, a digest of what the content
//! depends on (this format, the kernels' manifest, adapter, driver), the length of the rest, a
//! digest of the rest. A file whose header differs is ignored: kernels are compiled anew and it is
//! replaced. wgpu and the driver have headers of their own inside and check them. Whatever fails
//! here costs a compilation and is never an error.
//!
//! A digest finds damage, not malice: who may write the file hands the driver what they like. So on
//! Unix nothing is read or written but in a folder that is the user's own, or from a file that is
//! not, or where others may write, or through a link. Elsewhere the folder must be one that others
//! cannot write.
//!
//! Some drivers give nothing to keep. That of lavapipe (Mesa 22.3) gives a header of 32 bytes and
//! no kernel, so that a file has 128 with wgpu's header of 64 and ours, and every process compiles
//! anew. What Mesa keeps of compiled kernels by itself is in its own folder
//! (`MESA_SHADER_CACHE_DIR`), whatever is done here.

use crate::pipeline;
use std::fs::File;
use std::hash::{Hash, Hasher};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

/// What a file begins with; the last character is the version of the format.
const MAGIC: &[u8; 8] = b"ccdkern1";
/// Magic, digest of the setting, length, digest of the content.
const HEADER: usize = 32;
/// Bytes beyond which a file is not read: all kernels together are some megabytes.
const MOST: u64 = 1 << 28;
/// What the kernels were compiled from.
const MANIFEST: &str = include_str!("../shaders/manifest.json");

/// Compiled kernels that are kept on disk.
pub struct Cache {
    file: KernelFile,
    pub kernels: wgpu::PipelineCache,
    /// What was read of them.
    stored: Option<Vec<u8>>,
}

impl Cache {
    /// What is kept in `folder` for a device; `None` where its driver has nothing to keep.
    pub fn open(device: &wgpu::Device, folder: &Path, adapter: &wgpu::AdapterInfo) -> Option<Self> {
        let file = KernelFile::of(folder, adapter)?;
        let stored = file.read();
        Some(Self { kernels: pipeline::cache(device, stored.as_deref()), stored, file })
    }

    /// Whether there was a file.
    pub fn was_kept(&self) -> bool {
        self.stored.is_some()
    }

    /// Writes what is there now, if it is something else. Without it the next process compiles.
    pub fn keep(&self) {
        let data = self.kernels.get_data().filter(|data| Some(data) != self.stored.as_ref());
        data.map(|data| self.file.write(&data));
    }
}

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

    /// What was kept; `None` if there is nothing, or nothing that fits or that is safe to take.
    pub fn read(&self) -> Option<Vec<u8>> {
        let file = own::open(&self.path)?;
        let mut bytes = Vec::new();
        if file.take(MOST + 1).read_to_end(&mut bytes).ok()? as u64 > MOST {
            return None;
        }
        let (header, data) = bytes.split_at_checked(HEADER)?;
        if header != self.header(data) {
            return None;
        }
        bytes.drain(..HEADER);
        Some(bytes)
    }

    /// Replaces the file; a reader sees the old one or the new one, never a part. Whether it could.
    pub fn write(&self, data: &[u8]) -> bool {
        let Some(folder) = self.path.parent().filter(|folder| own::make_folder(folder)) else {
            return false;
        };
        let bytes = [&self.header(data)[..], data].concat();
        let Some((temporary, mut file)) = own::new_file(folder) else { return false };
        let written =
            file.write_all(&bytes).is_ok() && std::fs::rename(&temporary, &self.path).is_ok();
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
fn digest(content: &(impl Hash + ?Sized)) -> u64 {
    let mut hasher = std::hash::DefaultHasher::new();
    content.hash(&mut hasher);
    hasher.finish()
}

/// Files and folders of the user that this process runs as.
mod own {
    use super::*;

    /// Opens a file that is the user's own and that nobody else may write, in such a folder.
    pub fn open(path: &Path) -> Option<File> {
        let user = user_of(path.parent()?)?;
        let file = File::open(path).ok()?;
        is_own(path, &file, user).then_some(file)
    }

    /// Makes a folder of the user's own, if it is not there; whether it is one.
    pub fn make_folder(folder: &Path) -> bool {
        let mut builder = std::fs::DirBuilder::new();
        #[cfg(unix)]
        std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
        builder.recursive(true).create(folder).is_ok() && user_of(folder).is_some()
    }

    /// A file that was not there, and its name.
    pub fn new_file(folder: &Path) -> Option<(PathBuf, File)> {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let path = folder.join(format!("{}.{number}.part", std::process::id()));
        let mut options = std::fs::OpenOptions::new();
        #[cfg(unix)]
        std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
        let file = options.write(true).create_new(true).open(&path).ok()?;
        Some((path, file))
    }

    /// The user, if a folder is theirs: who owns what this process makes there.
    #[cfg(unix)]
    fn user_of(folder: &Path) -> Option<u32> {
        use std::os::unix::fs::MetadataExt;
        let of_folder = std::fs::symlink_metadata(folder).ok()?;
        // Before anything is made there.
        if !of_folder.is_dir() || of_folder.mode() & OTHERS_WRITE != 0 {
            return None;
        }
        let (path, file) = new_file(folder)?;
        let user = file.metadata();
        std::fs::remove_file(path).ok()?;
        user.ok().map(|made| made.uid()).filter(|&user| user == of_folder.uid())
    }

    /// Whether a file is a user's, and is what its name says: no link.
    #[cfg(unix)]
    fn is_own(path: &Path, file: &File, user: u32) -> bool {
        use std::os::unix::fs::MetadataExt;
        let (Ok(named), Ok(opened)) = (std::fs::symlink_metadata(path), file.metadata()) else {
            return false;
        };
        named.is_file()
            && (named.dev(), named.ino()) == (opened.dev(), opened.ino())
            && opened.uid() == user
            && opened.mode() & OTHERS_WRITE == 0
    }

    /// Bits of a mode with which group or others may write.
    #[cfg(unix)]
    const OTHERS_WRITE: u32 = 0o022;

    #[cfg(not(unix))]
    fn user_of(folder: &Path) -> Option<u32> {
        folder.is_dir().then_some(0)
    }

    #[cfg(not(unix))]
    fn is_own(_: &Path, _: &File, _: u32) -> bool {
        true
    }
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

    #[cfg(unix)]
    #[test]
    fn what_others_may_write_is_not_read() {
        use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
        let folder = std::env::temp_dir().join(format!("ccd-kernels-own-{}", std::process::id()));
        let file = KernelFile { path: folder.join("a"), setting: 7 };
        assert!(file.write(b"kernels") && file.read().is_some());
        let mode = |path: &Path, mode: u32| {
            std::fs::set_permissions(path, std::fs::Permissions::from_mode(mode)).unwrap();
        };
        let is_mode = |path: &Path| std::fs::metadata(path).unwrap().mode() & 0o777;
        assert_eq!([is_mode(&folder), is_mode(&file.path)], [0o700, 0o600]);
        for bad in [0o620, 0o602, 0o666] {
            mode(&file.path, bad);
            assert_eq!(file.read(), None, "{bad:o}");
        }
        mode(&file.path, 0o644);
        assert!(file.read().is_some());
        for bad in [0o720, 0o702, 0o1777] {
            mode(&folder, bad);
            assert!(file.read().is_none() && !file.write(b"others"), "{bad:o}");
        }
        mode(&folder, 0o755);
        // A link, to a file that may be read and to a folder that may be written.
        let link = KernelFile { path: folder.join("b"), setting: 7 };
        symlink(&file.path, &link.path).unwrap();
        assert_eq!(link.read(), None);
        assert!(link.write(b"a link is replaced") && file.read().unwrap() == b"kernels");
        let to_folder = folder.join("c");
        symlink(&folder, &to_folder).unwrap();
        let below = KernelFile { path: to_folder.join("a"), setting: 7 };
        assert!(below.read().is_none() && !below.write(b"below"));
        // Nothing is left behind.
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 3);
        std::fs::remove_dir_all(folder).unwrap();
    }
}
