//! The kernels that sort, each by itself and together: keys with values, contacts by their ids.

use crate::support::{bytes, read, run, zeros};
use ccd::gpu::bind::{
    CountContacts, OrderContacts, PlaceContacts, ScanRows, SortCount, SortScatter,
    SortScatterBySubgroups,
};
use ccd::gpu::{Device, Sorter};
use ccd_core::backend::kernel::contact_order::{LONGEST, ROWS, row, unordered};
use ccd_core::backend::kernel::sort;
use ccd_core::backend::layout::{Dispatch, Frame, PackedTouch, Params, Plain, SortPass, Touch};
use ccd_testkit::generate::Random;

pub const TESTS: crate::Tests = &[
    ("sort", check_sort),
    ("sort_passes", check_sort_passes),
    ("rows", check_rows),
    ("order_of_contacts", check_order),
    ("largest_grid", check_largest_grid),
];

/// The greatest key is also what stands behind the last one.
const FEW: [u32; 3] = [0, 0x0100_0001, u32::MAX];

fn check_sort(device: &Device) {
    let mut random = Random::new(3);
    let tiles = [sort::TILE, sort::SUBGROUP_TILE];
    for n in tiles.into_iter().flat_map(|n| [n - 1, n, n + 1]).chain([1, 31, 100_003]) {
        for few in [false, true] {
            let keys: Vec<u32> = (0..n)
                .map(|_| if few { FEW[random.below(3) as usize] } else { random.bits() })
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
    // Lists that are sorted already: a digit fills whole tiles.
    let keys: Vec<u32> = (0..20_000).map(|i| i / 5000).collect();
    let sorted = Sorter::new(device, 20_000).unwrap().sort(&keys, &keys).unwrap();
    assert!(sorted == (keys.clone(), keys));
}

/// The kernels by themselves, also where the first tiles never publish what they have, so that the
/// others count it.
fn check_sort_passes(device: &Device) {
    let mut random = Random::new(4);
    let n = 25_000u32;
    let keys: Vec<u32> = (0..n).map(|_| random.bits()).collect();
    let totals = check_count(device, &keys, (0, 3));
    for silent in [0, 1, 5] {
        for shift in [8, 16] {
            check_pass(device, (&keys, &totals), (shift, sort::TILE), silent);
            if device.info().subgroups {
                check_pass(device, (&keys, &totals), (shift, sort::SUBGROUP_TILE), silent);
            }
        }
    }
}

/// Counts the digits, by so many workgroups, of which the first takes round `first`.
fn check_count(device: &Device, keys: &[u32], (first, groups): (u32, u32)) -> Vec<u32> {
    let mut p = sort_pass(keys.len() as u32, SortPass::default());
    p.dispatch.first = first;
    let table = zeros::<u32>(sort::first_row(1, 0) as usize);
    let SortCount { table, .. } = run(device, SortCount { keys: bytes(keys), table }, &p, groups);
    let mut want = vec![0u32; 4 * 256];
    keys.iter().for_each(|k| {
        (0..4).for_each(|pass| want[pass * 256 + (k >> (8 * pass) & 255) as usize] += 1);
    });
    assert_eq!(read::<u32>(&table), want);
    want
}

/// Rows of counts of fewer and more words than a workgroup takes in a round.
fn check_rows(device: &Device) {
    let mut random = Random::new(6);
    for n in [1, 5, 1024, 2500] {
        let mut want: Vec<u32> = (0..256 * n).map(|_| random.below(1000)).collect();
        // Totals are behind the rows.
        want.resize(256 * (n + 1), 0);
        let kernel = ScanRows { table: bytes(&want) };
        let p = sort_pass(0, SortPass { shift: 0, n_tiles: n as u32 });
        let table: Vec<u32> = read(&run(device, kernel, &p, 256).table);
        for d in 0..256 {
            let row = &mut want[d * n..(d + 1) * n];
            let total = row.iter_mut().fold(0, |sum, count| std::mem::replace(count, sum) + sum);
            want[256 * n + d] = total;
        }
        assert!(table == want, "rows of {n}");
    }
}

/// Runs one pass, by the kernel for tiles of so many keys, without workgroups for the first tiles.
fn check_pass(
    device: &Device,
    (keys, totals): (&[u32], &[u32]),
    (shift, tile): (u32, u32),
    silent: u32,
) {
    let n = keys.len() as u32;
    let n_tiles = n.div_ceil(tile);
    let mut p = sort_pass(n, SortPass { shift, n_tiles });
    p.dispatch.first = silent;
    let odd = shift / 8 % 2;
    let rows = |odd| [odd, odd + 1].map(|odd| sort::first_row(odd, n_tiles) as usize);
    let ([first, end], [first_other, end_other]) = (rows(odd), rows(1 - odd));
    let mut table = totals.to_vec();
    // What an earlier pass left.
    table.resize(sort::first_row(2, n_tiles) as usize, sort::SUMMED | 7);
    table[first..end].fill(0);
    let (table, values) = (bytes(&table), bytes(&(0..n).collect::<Vec<u32>>()));
    let (keys_out, values_out) = (zeros::<u32>(n as usize), zeros::<u32>(n as usize));
    let kernel = SortScatter { keys: bytes(keys), values, table, keys_out, values_out };
    let SortScatter { table, keys_out, values_out, .. } = if tile == sort::TILE {
        run(device, kernel, &p, n_tiles - silent)
    } else {
        let SortScatter { keys, values, table, keys_out, values_out } = kernel;
        let kernel = SortScatterBySubgroups { keys, values, table, keys_out, values_out };
        let SortScatterBySubgroups { keys, values, table, keys_out, values_out } =
            run(device, kernel, &p, n_tiles - silent);
        SortScatter { keys, values, table, keys_out, values_out }
    };
    let what = format!("tiles of {tile} from {silent} on, bit {shift}");
    let digit = |key: u32| key >> shift & 255;
    let mut want: Vec<(u32, u32)> = keys.iter().copied().zip(0..).collect();
    want.sort_by_key(|(key, _)| digit(*key));
    want.iter_mut().filter(|(_, at)| *at < silent * tile).for_each(|pair| *pair = (0, 0));
    let got = read::<u32>(&keys_out).into_iter().zip(read::<u32>(&values_out));
    assert!(want.into_iter().eq(got), "{what}");
    let table = read::<u32>(&table);
    let silent_words = silent as usize * 256;
    let mut next = table[first_other..end_other].iter().skip(silent_words);
    assert!(next.all(|&word| word == 0), "{what}: rows for the next pass");
    assert!(table[first..][..silent_words].iter().all(|&word| word == 0), "{what}");
    let mut sums = [sort::SUMMED; 256];
    for (i, (keys, row)) in
        keys.chunks(tile as usize).zip(table[first..end].chunks(256)).enumerate()
    {
        keys.iter().for_each(|key| sums[digit(*key) as usize] += 1);
        // The last row counts what is behind the last key, as keys that are greater.
        sums[255] += tile - keys.len() as u32;
        assert!(i < silent as usize || *row == sums, "{what}: row {i}");
    }
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
        let ScanRows { table } = run(device, ScanRows { table: counted.table }, &of_scan, ROWS);
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
/// all keys are those of three workgroups in the second row.
fn check_largest_grid(device: &Device) {
    let keys: Vec<u32> = (0..5000).collect();
    check_count(device, &keys, (0u32.wrapping_sub(65_600), 65_900));
}
