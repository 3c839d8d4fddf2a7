//! The kernels that set headers of lists to zero, and that gather them.

use crate::support::{bytes, read, run};
use ccd::gpu::Device;
use ccd::gpu::bind::{Bind, ClearHeaders, GatherHeaders};
use ccd_core::layout::{Dispatch, Frame, LIST_HEADER, Params, Plain};

pub const TESTS: crate::Tests =
    &[("headers_are_cleared", check_clear), ("headers_are_gathered", check_gather)];

/// List `i`: a header, and ten entries behind it.
fn list(i: u32) -> Vec<u8> {
    bytes(&(0..LIST_HEADER as u32 + 20).map(|word| 1000 * (i + 1) + word).collect::<Vec<_>>())
}

fn check_clear(device: &Device) {
    let [list_0, list_1, list_2, list_3] = [0, 1, 2, 3].map(list);
    let [list_4, list_5, list_6, list_7] = [4, 5, 6, 7].map(list);
    let kernel = ClearHeaders { list_0, list_1, list_2, list_3, list_4, list_5, list_6, list_7 };
    let done = run(device, kernel, &Params::default(), 1);
    for (i, cleared) in done.buffers().into_iter().enumerate() {
        let (words, before): (Vec<u32>, Vec<u32>) = (read(cleared), read(&list(i as u32)));
        assert_eq!(words[..LIST_HEADER], [0; LIST_HEADER], "list {i}");
        assert_eq!(words[LIST_HEADER..], before[LIST_HEADER..], "list {i}: entries");
    }
}

fn check_gather(device: &Device) {
    let [list_0, list_1, list_2, list_3, list_4, list_5] = [0, 1, 2, 3, 4, 5].map(list);
    let untouched = u32::MAX;
    let headers = bytes(&[untouched; 8 * LIST_HEADER]);
    let kernel = GatherHeaders { list_0, list_1, list_2, list_3, list_4, list_5, headers };
    let dispatch = Dispatch { first: LIST_HEADER as u32, ..Dispatch::default() };
    let params = Params { frame: Frame::default(), dispatch, own: Plain::default() };
    let words: Vec<u32> = read(&run(device, kernel, &params, 1).headers);
    for (i, header) in words.chunks_exact(LIST_HEADER).enumerate() {
        let want: Vec<u32> = match i {
            1..7 => read(&list(i as u32 - 1))[..LIST_HEADER].to_vec(),
            _ => vec![untouched; LIST_HEADER],
        };
        assert_eq!(header, want, "header {i}");
    }
}
