//! The kernels that sort, each by itself and together: keys with values, contacts by their ids.

use crate::support::{bytes, read, run, zeros};
use ccd::gpu::bind::{
    CountContacts, OrderContacts, PlaceContacts, SortCount, SortScan, SortScatter,
};
use ccd::gpu::{Device, Sorter};
use ccd_core::backend::kernel::contact_order::{LONGEST, ROWS, row, unordered};
use ccd_core::backend::kernel::sort;
use ccd_core::backend::layout::{Dispatch, Frame, PackedTouch, Params, Plain, SortPass, Touch};
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

/// Contacts of a list are sorted by kind, `a`, `b`; what is not a contact stays behind them. A
/// bucket that is too long is said to be in no order, and loses nothing.
fn check_order(device: &Device) {
    let mut random = Random::new(5);
    let longest = LONGEST + 1;
    for (n, capacity, of_one) in [
        (0, 40, 0),
        (1, 40, 0),
        (5000, 6000, 0),
        (6000, 6000, 0),
        (6000, 9000, longest),
        (6000, 9000, longest + 1),
    ] {
        let count = [300, 500, 200];
        let mut touches: Vec<Touch> = (0..n)
            .map(|i| {
                let kind = if i < of_one { 0 } else { random.below(2) };
                let a = if i < of_one { 7 } else { random.below(count[kind as usize]) };
                // Each pair once, in no order.
                let b = i.wrapping_mul(2_654_435_761) >> 1;
                Touch { kind, state: i % 2, a, b, toi: [i, 0x3ff0_0000 - i], approach: i % 3 }
            })
            .filter(|t| of_one == 0 || t.toi[0] < of_one || (t.kind, t.a) != (0, 7))
            .collect();
        let n = touches.len() as u32;
        // Not all of a bucket one behind the other.
        touches.sort_by_key(|t| t.b.reverse_bits());
        let mut list = bytes(&[n, 0, 0, 0]);
        list.extend(bytes(&touches));
        // What stands behind the last contact is left from another frame.
        list.resize(16 + capacity as usize * size_of::<Touch>(), 0x11);
        let mut want = touches.clone();
        want.sort_by_key(|t| (t.kind, t.a, t.b));
        let frame = Frame { count, ..Frame::default() };
        let dispatch = Dispatch { n: capacity, capacity_in: capacity, ..Dispatch::default() };
        let groups = capacity.div_ceil(256);
        let p = Params { frame, dispatch, args: Plain::default() };
        let (contacts, ranks) = (list.clone(), zeros::<u32>(capacity as usize));
        let table = zeros::<u32>(unordered(&frame) as usize + 1);
        let counted = run(device, CountContacts { contacts, table, ranks }, &p, groups);
        let of_scan = Params { frame, dispatch, args: SortPass { shift: 0, n_tiles: row(&frame) } };
        let SortScan { table } = run(device, SortScan { table: counted.table }, &of_scan, ROWS);
        let (contacts, ranks) = (list.clone(), counted.ranks);
        let slots = zeros::<PackedTouch>(capacity as usize);
        let placed = PlaceContacts { contacts, table: table.clone(), ranks, slots };
        let PlaceContacts { slots, .. } = run(device, placed, &p, groups);
        let ordered = zeros::<PackedTouch>(capacity as usize);
        let done = run(device, OrderContacts { contacts: list, slots, ordered, table }, &p, groups);
        let table: Vec<u32> = read(&done.table);
        let packed: Vec<PackedTouch> = read(&done.ordered);
        let mut ordered: Vec<Touch> = packed.iter().map(PackedTouch::touch).collect();
        let is_long = of_one > longest;
        assert_eq!(table[unordered(&frame) as usize], is_long as u32, "{n}, {of_one} of one");
        let sorted = &mut ordered[..n as usize];
        if is_long {
            assert!(sorted != want);
            sorted.sort_by_key(|t| (t.kind, t.a, t.b));
        }
        assert!(sorted == want, "{n} contacts, {of_one} of one");
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
