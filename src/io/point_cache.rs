//! Positions over time without a mesh: NPY, NPZ, PC2 and MDD. Frames are read one at a time.
//!
//! - `.npy`: an array of NumPy, `(frames, n, 3)`; `.npz`: an archive with one such array.
//! - `.pc2`: the point cache of 3ds Max and Blender, little-endian `f32`; `.mdd`: that of
//!   LightWave, big-endian `f32`. Their times of frames are not used.

use super::{Frame, ReadError, ReadErrorKind, extension, npy, quote};
use std::fs::File;
use std::io::{BufReader, Cursor, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

/// Positions of one mesh over many frames, in a file.
///
/// ```no_run
/// let mut cache = ccd::io::PointCache::open("cloth.pc2".as_ref())?;
/// for at in 0..cache.n_frames() {
///     println!("{:?}", cache.frame(at)?.first());
/// }
/// # Ok::<(), ccd::io::ReadError>(())
/// ```
pub struct PointCache {
    path: PathBuf,
    from: Box<dyn Source>,
    start: u64,
    n_frames: usize,
    n_vertices: usize,
    wide: bool,
    big_endian: bool,
}

trait Source: Read + Seek + Send {}
impl<T: Read + Seek + Send> Source for T {}

impl PointCache {
    /// Ends of the names of files that are read.
    pub const EXTENSIONS: [&str; 4] = ["npy", "npz", "pc2", "mdd"];

    /// Opens a file and checks that it is as long as its header says. The array of an `.npz`
    /// archive is unpacked in memory.
    ///
    /// # Errors
    /// A header that is not understood, an archive with no array `(frames, n, 3)` or with several,
    /// or with anything that is damaged, a file that is too short or too long.
    pub fn open(path: &Path) -> Result<Self, ReadError> {
        open(path).map_err(|kind| ReadError { path: path.to_owned(), kind })
    }

    /// How many frames there are.
    pub fn n_frames(&self) -> usize {
        self.n_frames
    }

    /// How many vertices each frame has.
    pub fn n_vertices(&self) -> usize {
        self.n_vertices
    }

    /// The positions of frame `at`, counted from 0.
    ///
    /// # Errors
    /// What cannot be read, and coordinates that [`super::read_frame`] would refuse.
    ///
    /// # Panics
    /// If there is no such frame.
    pub fn frame(&mut self, at: usize) -> Result<Vec<[f64; 3]>, ReadError> {
        assert!(at < self.n_frames, "frame {at} of {}", self.n_frames);
        self.read(at).map_err(|kind| ReadError { path: self.path.clone(), kind })
    }

    fn read(&mut self, at: usize) -> Result<Vec<[f64; 3]>, ReadErrorKind> {
        let number = if self.wide { 8 } else { 4 };
        let mut bytes = vec![0; self.n_vertices * 3 * number];
        self.from.seek(SeekFrom::Start(self.start + at as u64 * bytes.len() as u64))?;
        self.from.read_exact(&mut bytes)?;
        if self.big_endian {
            bytes.chunks_exact_mut(number).for_each(<[u8]>::reverse);
        }
        let value = |b: &[u8]| match *b {
            [b0, b1, b2, b3] => f32::from_le_bytes([b0, b1, b2, b3]) as f64,
            [b0, b1, b2, b3, b4, b5, b6, b7] => {
                f64::from_le_bytes([b0, b1, b2, b3, b4, b5, b6, b7])
            }
            _ => unreachable!("numbers have four bytes or eight"),
        };
        let point = |b: &[u8]| [0, 1, 2].map(|axis| value(&b[axis * number..][..number]));
        let positions = bytes.chunks_exact(3 * number).map(point).collect();
        let frame = Frame { positions, ..Frame::default() };
        frame.check().map_err(|e| {
            let what = e.to_string();
            ReadErrorKind::Element { element: "frame", at, what }
        })?;
        Ok(frame.positions)
    }
}

fn open(path: &Path) -> Result<PointCache, ReadErrorKind> {
    let mut file = BufReader::new(File::open(path)?);
    let length = file.get_ref().metadata()?.len();
    match extension(path).as_deref() {
        Some("npy") => {
            let header = npy::header(&mut file)?;
            of_array(path, Box::new(file), length, header)
        }
        Some("npz") => of_archive(path, file),
        Some("pc2") => {
            let mut b = [0; 32];
            file.read_exact(&mut b).map_err(|_| head("the file is no point cache"))?;
            if &b[..12] != b"POINTCACHE2\0" {
                return Err(head("the file does not begin with POINTCACHE2"));
            }
            let word = |at: usize| u32::from_le_bytes([b[at], b[at + 1], b[at + 2], b[at + 3]]);
            // Between them: version, number of points, first frame, rate, number of samples.
            let (n_vertices, n_frames) = (word(16).into(), word(28).into());
            let header =
                npy::Header { start: 32, n_frames, n_vertices, wide: false, big_endian: false };
            of_array(path, Box::new(file), length, header)
        }
        Some("mdd") => {
            let mut b = [0; 8];
            file.read_exact(&mut b).map_err(|_| head("the file is no MDD file"))?;
            let word = |at: usize| u32::from_be_bytes([b[at], b[at + 1], b[at + 2], b[at + 3]]);
            let (n_frames, n_vertices) = (u64::from(word(0)), word(4).into());
            // A time for each frame comes first.
            let start = 8 + 4 * n_frames;
            let header = npy::Header { start, n_frames, n_vertices, wide: false, big_endian: true };
            of_array(path, Box::new(file), length, header)
        }
        _ => Err(ReadErrorKind::Extension { expected: &PointCache::EXTENSIONS }),
    }
}

fn head(what: &str) -> ReadErrorKind {
    ReadErrorKind::Header(what.into())
}

/// The one array `(frames, n, 3)` of an archive.
fn of_archive(path: &Path, file: BufReader<File>) -> Result<PointCache, ReadErrorKind> {
    let bad = |e: zip::result::ZipError| ReadErrorKind::Format(quote(&e.to_string()));
    let mut archive = zip::ZipArchive::new(file).map_err(bad)?;
    let mut found: Vec<(usize, String)> = Vec::new();
    let (mut others, mut like) = (Vec::new(), Vec::new());
    for at in 0..archive.len() {
        let mut entry = archive.by_index(at).map_err(bad)?;
        let name = String::from_utf8_lossy(entry.name_raw()).into_owned();
        match npy::look(&mut entry) {
            Ok(_) => found.push((at, name)),
            Err((why, is_like)) => {
                // What is damaged may have been the positions: it must be whole to be passed over.
                let bad = |e: std::io::Error| ReadErrorKind::Format(quote(&format!("{name}: {e}")));
                if let ReadErrorKind::Io(e) = why {
                    return Err(bad(e));
                }
                std::io::copy(&mut entry, &mut std::io::sink()).map_err(bad)?;
                let text = format!("{name}: {why}");
                if is_like {
                    like.push(text.clone());
                }
                others.push(text);
            }
        }
    }
    if let ([(_, name)], [other, ..]) = (&found[..], &like[..]) {
        let what = format!("{name} and another array may be the positions; {other}");
        return Err(ReadErrorKind::Format(quote(&what)));
    }
    let at = match found.as_slice() {
        [(at, _)] => *at,
        [] => {
            let what = format!("there is no array (frames, n, 3): {}", others.join("; "));
            return Err(ReadErrorKind::Format(quote(&what)));
        }
        _ => {
            let names: Vec<&str> = found.iter().map(|(_, name)| name.as_str()).collect();
            let what = format!("several arrays are (frames, n, 3): {}", names.join(", "));
            return Err(ReadErrorKind::Format(quote(&what)));
        }
    };
    let mut entry = archive.by_index(at).map_err(bad)?;
    let header = npy::header(&mut entry)?;
    // As much as is promised and one byte, which would be too many: little may unpack to a lot.
    let most = header.n_bytes().unwrap_or(0).saturating_add(1);
    let mut bytes = Vec::new();
    entry.take(most).read_to_end(&mut bytes)?;
    let length = bytes.len() as u64;
    of_array(path, Box::new(Cursor::new(bytes)), length, npy::Header { start: 0, ..header })
}

fn of_array(
    path: &Path,
    from: Box<dyn Source>,
    length: u64,
    header: npy::Header,
) -> Result<PointCache, ReadErrorKind> {
    let needed = header.n_bytes().and_then(|n| n.checked_add(header.start));
    let npy::Header { start, n_frames, n_vertices, wide, big_endian } = header;
    let limit = crate::Error::MAX_ELEMENTS;
    if n_vertices > limit {
        return Err(crate::Error::TooMany { element: "vertices", count: n_vertices, limit }.into());
    }
    if n_vertices == 0 {
        return Err(head("the frames have no vertices"));
    }
    if needed != Some(length) {
        let what = format!(
            "{n_frames} frames of {n_vertices} vertices take {} bytes; the file has {length}",
            needed.map_or("too many".into(), |n| n.to_string())
        );
        return Err(ReadErrorKind::Header(what));
    }
    let (path, n_vertices) = (path.to_owned(), n_vertices as usize);
    let n_frames = n_frames as usize;
    Ok(PointCache { path, from, start, n_frames, n_vertices, wide, big_endian })
}
