//! Positions over time: NPY, NPZ, PC2, MDD.

use ccd::io::PointCache;
use std::io::{Cursor, Write};
use std::path::Path;

/// Three frames of two points; exact in `f32`.
fn frames() -> Vec<[[f64; 3]; 2]> {
    (0..3).map(|i| [[i as f64, 0.5, -1.0], [2.0, i as f64 / 4.0, 8.0]]).collect()
}

fn npy(kind: &str, header_version: u8, shape: &str, order: &str) -> Vec<u8> {
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}");
    header += &" ".repeat(63 - (header.len() + 10) % 64);
    header += "\n";
    let mut bytes = b"\x93NUMPY".to_vec();
    bytes.extend([header_version, 0]);
    match header_version {
        1 => bytes.extend((header.len() as u16).to_le_bytes()),
        _ => bytes.extend((header.len() as u32).to_le_bytes()),
    }
    bytes.extend(header.bytes());
    for c in frames().iter().flatten().flatten() {
        match kind {
            "<f4" => bytes.extend((*c as f32).to_le_bytes()),
            ">f4" => bytes.extend((*c as f32).to_be_bytes()),
            ">f8" => bytes.extend(c.to_be_bytes()),
            _ => bytes.extend(c.to_le_bytes()),
        }
    }
    bytes
}

fn npz(entries: &[(&str, Vec<u8>)], method: zip::CompressionMethod) -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = zip::write::SimpleFileOptions::default().compression_method(method);
    for (name, bytes) in entries {
        archive.start_file(*name, options).unwrap();
        archive.write_all(bytes).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

fn pc2() -> Vec<u8> {
    let mut bytes = b"POINTCACHE2\0".to_vec();
    bytes.extend([1u32, 2].iter().flat_map(|n| n.to_le_bytes()));
    bytes.extend([0.0f32, 1.0].iter().flat_map(|n| n.to_le_bytes()));
    bytes.extend(3u32.to_le_bytes());
    bytes.extend(frames().iter().flatten().flatten().flat_map(|c| (*c as f32).to_le_bytes()));
    bytes
}

fn mdd() -> Vec<u8> {
    let mut bytes: Vec<u8> = [3u32, 2].iter().flat_map(|n| n.to_be_bytes()).collect();
    bytes.extend([0.0f32, 0.04, 0.08].iter().flat_map(|n| n.to_be_bytes()));
    bytes.extend(frames().iter().flatten().flatten().flat_map(|c| (*c as f32).to_be_bytes()));
    bytes
}

fn open(dir: &Path, name: &str, bytes: &[u8]) -> Result<PointCache, String> {
    let path = dir.join(name);
    std::fs::write(&path, bytes).unwrap();
    PointCache::open(&path).map_err(|e| e.to_string())
}

#[test]
fn frames_are_read_in_any_order() {
    let dir = tempfile::tempdir().unwrap();
    let plain = npy("<f4", 1, "(3, 2, 3)", "False");
    let entries = [("times.npy", plain[..plain.len() - 8].to_vec()), ("x.npy", plain.clone())];
    let times = npy("<f4", 1, "(18,)", "False");
    let mut files = vec![("a.pc2", pc2()), ("a.mdd", mdd())];
    for kind in ["<f4", "<f8", ">f4", ">f8"] {
        for version in [1, 2, 3] {
            files.push(("a.npy", npy(kind, version, "(3, 2, 3)", "False")));
        }
    }
    for method in [zip::CompressionMethod::Stored, zip::CompressionMethod::Deflated] {
        files.push((
            "a.npz",
            npz(&[("times.npy", times.clone()), ("x.npy", plain.clone())], method),
        ));
    }
    for (name, bytes) in files {
        let mut cache = open(dir.path(), name, &bytes).unwrap();
        assert_eq!((cache.n_frames(), cache.n_vertices()), (3, 2), "{name}");
        for at in [2, 0, 1, 1] {
            assert_eq!(cache.frame(at).unwrap(), frames()[at], "{name}, frame {at}");
        }
    }
    let several = npz(&entries, zip::CompressionMethod::Stored);
    let error = open(dir.path(), "two.npz", &several).err().unwrap();
    assert!(error.contains("several arrays") && error.contains("times.npy"), "{error}");
}

#[test]
fn what_does_not_fit_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let refused = |name: &str, bytes: &[u8], says: &str| {
        let error = open(dir.path(), name, bytes).err().expect(says);
        assert!(error.contains(name) && error.contains(says), "{error:?} does not say {says:?}");
    };
    let good = npy("<f4", 1, "(3, 2, 3)", "False");
    refused("a.npy", &good[..good.len() - 1], "3 frames of 2 vertices take");
    refused("a.npy", &[&good[..], b"x"].concat(), "3 frames of 2 vertices take");
    refused("a.npy", &good[..40], "ends in its header");
    refused("a.npy", b"", "no array of NumPy");
    refused("a.npy", &pc2(), "no array of NumPy");
    refused("a.npy", &npy("<i4", 1, "(3, 2, 3)", "False"), "`<i4`; float32 or float64");
    refused("a.npy", &npy("<f4", 1, "(3, 2, 3)", "True"), "Fortran");
    refused("a.npy", &npy("<f4", 1, "(6, 3)", "False"), "the shape is (6, 3)");
    refused("a.npy", &npy("<f4", 1, "(3, 3, 2)", "False"), "the shape is (3, 3, 2)");
    let most = "(18446744073709551615, 2, 3)";
    refused("a.npy", &npy("<f4", 1, most, "False"), "too many bytes");
    let none = npz(&[("a.npy", npy("<f4", 1, "(18,)", "False"))], zip::CompressionMethod::Stored);
    refused("a.npz", &none, "no array (frames, n, 3): a.npy");
    // Which of them are the positions?
    let x = ("x.npy", npy("<f4", 1, "(3, 2, 3)", "True"));
    let two = npz(&[("v.npy", good.clone()), x], zip::CompressionMethod::Stored);
    refused("a.npz", &two, "v.npy and another array may be the positions; x.npy: ");
    // As other writers than NumPy write a shape.
    let x = ("x.npy", npy("<i4", 1, "(3,2,3)", "False"));
    let two = npz(&[("v.npy", good.clone()), x], zip::CompressionMethod::Stored);
    refused("a.npz", &two, "may be the positions; x.npy: ");
    // The first of two, damaged or compressed in another way, may be them as well.
    let two = [("x.npy", good.clone()), ("v.npy", good.clone())];
    let two = npz(&two, zip::CompressionMethod::Stored);
    let find = |bytes: &[u8]| two.windows(bytes.len()).position(|found| found == bytes).unwrap();
    // The method stands in the entry, and in the list of entries.
    for (places, says) in [
        (vec![find(b"\x93NUMPY")], "x.npy: Invalid checksum"),
        (vec![8, find(b"PK\x01\x02") + 10], "x.npy: compression method not supported"),
    ] {
        let mut damaged = two.clone();
        places.into_iter().for_each(|at| damaged[at] ^= 12);
        refused("a.npz", &damaged, says);
    }
    refused("a.npz", &none[..none.len() - 30], "a.npz");
    refused("a.pc2", &pc2()[..31], "no point cache");
    refused("a.pc2", &pc2()[..60], "the file has 60");
    refused("a.pc2", &mdd(), "POINTCACHE2");
    refused("a.mdd", &mdd()[..60], "the file has 60");
    refused("a.mdd", b"1234", "no MDD");
    refused("a.abc", &pc2(), ".npy, .npz, .pc2 or .mdd");
    let mut nan = pc2();
    let at = nan.len() - 4;
    nan[at..].copy_from_slice(&f32::NAN.to_le_bytes());
    let error = open(dir.path(), "nan.pc2", &nan).unwrap().frame(2).unwrap_err().to_string();
    let says = "frame 2 (counted from 0): vertex 1 (counted from 0): z = NaN";
    assert!(error.contains(says), "{error}");
}

#[test]
fn archives_unpack_to_what_they_promise() {
    let dir = tempfile::tempdir().unwrap();
    let refused = |array: Vec<u8>, says: &str| {
        let file = npz(&[("x.npy", array)], zip::CompressionMethod::Deflated);
        let error = super::small(&file, || open(dir.path(), "a.npz", &file)).err().expect(says);
        assert!(error.contains(says), "{error:?} does not say {says:?}");
    };
    let mut long = npy("<f4", 1, "(3, 2, 3)", "False");
    long.resize(1 << 24, 0);
    refused(long, "3 frames of 2 vertices take 72 bytes; the file has 73");
    let mut head = b"\x93NUMPY\x02\0".to_vec();
    head.extend((1u32 << 24).to_le_bytes());
    head.resize(1 << 24, b' ');
    refused(head, "takes 16777216 bytes, more than 65536");
}
