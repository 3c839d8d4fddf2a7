// What callers give, as the bindings take it: ids, numbers and options, each checked, because
// WebAssembly makes some number of any value.

/** Ids as the bindings take them; `width`: how many a row has, if rows have one length. */
export function ids(list, what, width) {
  if (list == null) return new Uint32Array();
  if (list instanceof Uint32Array) return list;
  const rows = Array.from(list);
  const nested = rows.some(Array.isArray);
  // Flat, rows of another length would be cut anew.
  const odd = nested && width ? rows.findIndex((row) => row?.length !== width) : -1;
  if (odd >= 0) {
    const [row, isList] = [rows[odd], Array.isArray(rows[odd])];
    throw new Error(`${what}: row ${odd} is ${isList ? `a list of ${row.length}` : row}; rows have `
      + `${width} ids each`);
  }
  const all = nested ? rows.flat() : rows;
  const wrong = all.findIndex((id) => !isId(id));
  if (wrong >= 0) {
    throw new Error(`${what}: entry ${wrong} is ${all[wrong]}; ids are whole numbers from 0 on`);
  }
  return Uint32Array.from(all);
}

function isId(value) {
  return Number.isInteger(value) && value >= 0 && value <= 0xffffffff;
}

/** One id. */
export function id(value, what) {
  if (!isId(value)) throw new Error(`${what} is ${String(value)}; ids are whole numbers from 0 on`);
  return value;
}

export function number(value, what) {
  if (typeof value !== "number") {
    throw new Error(`${what} is ${String(value)}; it must be a number`);
  }
  return value;
}

/** A number of bytes: `Infinity` is no limit. */
function bytes(value, what) {
  if (!(number(value, what) >= 0)) throw new Error(`${what} is ${value}; it must be 0 or more`);
  return value;
}

/** Start and end of a part of the step. */
export function ends(window) {
  if (window?.length !== 2) {
    throw new Error(`window is ${String(window)}; it must be a list of two times`);
  }
  return [number(window[0], "window[0]"), number(window[1], "window[1]")];
}

/** Options, each with how it is set. */
const SETTERS = {
  minDistance: (raw, value) => raw.set_min_distance(number(value, "minDistance")),
  tolerance: (raw, value) => raw.set_tolerance(number(value, "tolerance")),
  leaveContact: (raw, value) => raw.set_leave_contact(Boolean(value)),
  maxMemory: (raw, value) => raw.set_max_memory(bytes(value, "maxMemory")),
  mode: (raw, value) => raw.set_mode(String(value)),
  bodies: (raw, { ofVertex, fixed, noSelfContact, excluded, ...others }) => {
    for (const name in others) throw new Error(`there is no rule bodies.${name}`);
    raw.set_bodies(
      ids(ofVertex, "bodies.ofVertex"), ids(fixed, "bodies.fixed"),
      ids(noSelfContact, "bodies.noSelfContact"), ids(excluded, "bodies.excluded", 2),
    );
  },
};

/** Options for a module, as its class `Type` of them. */
export function rawOptions(options, Type) {
  const raw = new Type();
  for (const [name, value] of Object.entries(options ?? {})) {
    if (value == null) continue;
    if (!Object.hasOwn(SETTERS, name)) {
      const names = Object.keys(SETTERS).join(", ");
      throw new Error(`there is no option ${name}; options are ${names}`);
    }
    SETTERS[name](raw, value);
  }
  return raw;
}
