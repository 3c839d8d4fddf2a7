//! The kernels that sort, each by itself and together: keys with values, contacts by their ids.

use crate::support::{bytes, read, run, zeros};
use ccd::gpu::bind::{ContactKeys, OrderContacts, SortCount, SortScan, SortScatter};
use ccd::gpu::{Device, Sorter};
use ccd_core::backend::kernel::sort;
use ccd_core::backend::layout::{ContactSort, Dispatch, Frame, Params, Plain, SortPass, Touch};
use ccd_testkit::generate::Random;

pub const TESTS: crate::Tests = &[
    ("sort", check_sort),
    ("order_of_contacts", check_order),
    ("largest_grid", check_largest_grid),
];

fn check_sort(device: &Device) {
    let mut random = Random::new(3);
    for n in [1u32, 31, 2047, 2048, 2049, 100_003] {
        for few in [false, true] {
            let keys: Vec<u32> = (0..n)
                .map(|_| if few { random.below(3) * 0x0100_0001 } else { random.bits() })
                .collect();
            let values: Vec<u32> = (0..n).collect();
            let (got_keys, got_values) =
                Sorter::new(device, n).unwrap().sort(&keys, &values).unwrap();
            let mut want: Vec<(u32, u32)> = keys.iter().copied().zip(values).collect();
            want.sort();
            assert!(
                want.into_iter().eq(got_keys.into_iter().zip(got_values)),
                "{n} keys, few different: {few}"
            );
        }
    }
    // The three kernels by themselves.
    let n = 10_000u32;
    let keys: Vec<u32> = (0..n).map(|_| random.bits()).collect();
    let n_tiles = n.div_ceil(sort::TILE);
    let p = sort_pass(n, SortPass { shift: 8, n_tiles });
    let kernel =
        SortCount { keys: bytes(&keys), table: zeros::<u32>((n_tiles as usize + 1) * 256) };
    let SortCount { table, .. } = run(device, kernel, &p, n_tiles);
    let mut want = vec![0u32; 256 * (n_tiles as usize + 1)];
    keys.iter().enumerate().for_each(|(i, k)| {
        want[(k >> 8 & 255) as usize * n_tiles as usize + i / sort::TILE as usize] += 1
    });
    assert_eq!(read::<u32>(&table), want);
    let done = run(device, SortScan { table }, &p, 256);
    for d in 0..256 {
        let row = &mut want[d * n_tiles as usize..(d + 1) * n_tiles as usize];
        let total = row.iter_mut().fold(0, |sum, count| std::mem::replace(count, sum) + sum);
        want[256 * n_tiles as usize + d] = total;
    }
    assert_eq!(read::<u32>(&done.table), want);
    let (table, values) = (done.table, (0..n).collect::<Vec<u32>>());
    let (keys_out, values_out) = (zeros::<u32>(n as usize), zeros::<u32>(n as usize));
    let kernel =
        SortScatter { table, keys: bytes(&keys), values: bytes(&values), keys_out, values_out };
    let done = run(device, kernel, &p, n_tiles);
    let mut want: Vec<(u32, u32)> = keys.into_iter().zip(values).collect();
    want.sort_by_key(|(key, _)| key >> 8 & 255);
    assert!(
        want.into_iter().eq(read(&done.keys_out).into_iter().zip(read(&done.values_out))),
        "one pass"
    );
}

fn sort_pass(n: u32, args: SortPass) -> Params<SortPass> {
    Params { frame: Frame::default(), dispatch: Dispatch { n, ..Dispatch::default() }, args }
}

/// Contacts of a list are sorted by kind, `a`, `b`; what is not a contact stays behind them.
fn check_order(device: &Device) {
    let mut random = Random::new(5);
    let count = [300, 500, 200];
    for (n, capacity) in [(0, 40), (1, 40), (5000, 6000), (6000, 6000)] {
        let touches: Vec<Touch> = (0..n)
            .map(|i| {
                let kind = random.below(2);
                let (a, b) =
                    (random.below(count[kind as usize]), random.below([200, 500][kind as usize]));
                Touch { kind, state: i % 2, a, b, toi: [i, !i], approach: i % 3 }
            })
            .collect();
        let mut list = bytes(&[n, 0, 0, 0]);
        list.extend(bytes(&touches));
        // What stands behind the last contact is left from another frame.
        list.resize(16 + capacity as usize * size_of::<Touch>(), 0x11);
        let mut want = touches.clone();
        want.sort_by_key(|t| (t.kind, t.a, t.b));
        let frame = Frame { count, ..Frame::default() };
        let dispatch = Dispatch { n: capacity, capacity_in: capacity, ..Dispatch::default() };
        let groups = capacity.div_ceil(256);
        let mut order: Vec<u32> = vec![0; capacity as usize];
        for pass in [0, 1] {
            let p = Params { frame, dispatch, args: ContactSort { pass } };
            let (contacts, keys) = (list.clone(), zeros::<u32>(capacity as usize));
            let kernel = ContactKeys { contacts, keys, order: bytes(&order) };
            let done = run(device, kernel, &p, groups);
            let mut sorter = Sorter::new(device, capacity).unwrap();
            (_, order) = sorter.sort(&read(&done.keys), &read(&done.order)).unwrap();
        }
        let p = Params { frame, dispatch, args: Plain::default() };
        let kernel = OrderContacts {
            contacts: list,
            order: bytes(&order),
            ordered: zeros::<Touch>(capacity as usize),
        };
        let ordered: Vec<Touch> = read(&run(device, kernel, &p, groups).ordered);
        assert!(ordered[..n as usize] == want, "{n} contacts");
        let behind = &ordered[n as usize..];
        assert!(behind.iter().all(|t| *t == Touch::default()), "written behind the last contact");
    }
}

/// More workgroups than one row of a grid may have, so that it is folded without being asked to:
/// each writes where no other does.
fn check_largest_grid(device: &Device) {
    let n_tiles = 65_536 + 300;
    let keys: Vec<u32> = (0..5000).collect();
    let p = sort_pass(keys.len() as u32, SortPass { shift: 0, n_tiles });
    let kernel = SortCount { keys: bytes(&keys), table: vec![0xee; (n_tiles as usize + 1) * 1024] };
    let table: Vec<u32> = read(&run(device, kernel, &p, n_tiles).table);
    for digit in 0..256 {
        let row = &table[digit * n_tiles as usize..(digit + 1) * n_tiles as usize];
        let want = keys.iter().filter(|&&k| k as usize % 256 == digit).count() as u32;
        assert_eq!(row[..3].iter().sum::<u32>(), want, "digit {digit}");
        // Workgroups beyond the first row write their zeros, and nowhere else.
        assert!(row[3..].iter().all(|&count| count == 0), "digit {digit}");
    }
}
