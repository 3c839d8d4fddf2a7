//! Geometry of contacts that are listed: every workgroup takes its share of the list, entry `i`
//! goes to record `i`.

use crate::entry::kernel;
use crate::workgroup::part;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::put;
use ccd_core::backend::layout::{Path, TouchGeometry};
use ccd_core::narrow_phase::{decide, touch_geometry};

const THREADS: u32 = Id::ContactGeometry.threads();

kernel! {
    /// Thread `i` writes the geometry of contact `dispatch.first + i`, from paths.
    contact_geometry[64](t; params: Placing;; paths: [Path], elements: [u32],
        contacts: [u32], mut geometry: [TouchGeometry]) {
        let len = part(contacts, &params.dispatch);
        for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
            let i = (t.group + round * t.groups) * THREADS + t.lane;
            if i < len {
                let i = params.dispatch.first + i;
                let record = touch_geometry::narrow(i, params, paths, elements, contacts);
                put(geometry, i as usize, record);
            }
        }
    }
}

kernel! {
    /// Thread `i` writes the geometry of contact `dispatch.first + i`, from positions as they were
    /// given.
    contact_geometry_wide[64](t; params: Plain;; paths: [Path], positions: [[f64; 3]],
        elements: [u32], contacts: [u32], mut geometry: [TouchGeometry]) {
        let len = part(contacts, &params.dispatch);
        for round in 0..decide::rounds(len, t.group, t.groups, THREADS) {
            let i = (t.group + round * t.groups) * THREADS + t.lane;
            if i < len {
                let i = params.dispatch.first + i;
                let record =
                    touch_geometry::wide(i, params, paths, positions, elements, contacts);
                put(geometry, i as usize, record);
            }
        }
    }
}
