// What the bindings find, as callers get it: columns of contacts, and reports.

/** Names of the kinds of contacts, by their numbers. */
export const KINDS = Object.freeze(["vf", "ee", "ve", "vv"]);

/** Names of the states of contacts, by their numbers. */
export const STATES = Object.freeze(["hit", "undecided"]);

/** Types of the columns of contacts, in the order in which the bindings have them. */
const COLUMNS = {
  kind: Uint8Array,
  state: Uint8Array,
  ids: Uint32Array,
  toi: Float64Array,
  vertices: Uint32Array,
  point: Float64Array,
  normal: Float64Array,
  weights: Float64Array,
};
const GEOMETRY = ["vertices", "point", "normal", "weights"];

/** Views of lists in a module's memory, from their addresses and lengths. */
export function views(places, types, memory) {
  const all = places.all();
  places.free();
  return types.map((Type, i) => new Type(memory.buffer, all[2 * i], all[2 * i + 1]));
}

/** Columns of contacts; `borrow`: as views. */
export function columns(places, { geometry, borrow, memory }) {
  const contacts = {};
  const lists = views(places, Object.values(COLUMNS), memory);
  Object.keys(COLUMNS).forEach((name, i) => {
    if (geometry || !GEOMETRY.includes(name)) {
      contacts[name] = borrow ? lists[i] : lists[i].slice();
    }
  });
  contacts.length = contacts.kind.length;
  return contacts;
}

/** A report of a step: columns, and numbers in the order in which the bindings have them. */
export function report(contacts, numbers, copy, backend) {
  const [toi, undecided, rebuilt] = numbers;
  const perKind = (from) => Object.fromEntries(KINDS.map((kind, i) => [kind, numbers[from + i]]));
  const [boxes, build, traverse, narrow, total] = numbers.subarray(15);
  return {
    contacts,
    toi: Number.isNaN(toi) ? null : toi,
    undecided,
    rebuilt: rebuilt === 1,
    counts: { contacts: perKind(3), candidates: perKind(7), filtered: perKind(11) },
    ms: { boxes, build, traverse, narrow, copy, total: total + copy },
    backend,
  };
}
