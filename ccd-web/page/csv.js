// Contacts as CSV, in the columns that `ccd check --contacts OUT.csv` has.

import { KINDS, STATES } from "../pkg/index.js";

const COLUMNS = "kind,a,b,toi,state,v0,v1,v2,v3,polygon,px,py,pz,nx,ny,nz,w0,w1,w2,w3";

/** Vertices of a pair, by the number of its kind. */
const N_VERTICES = [4, 4, 3, 2];

/** The text of a file; `polygons`: the file's face that each triangle is cut from. */
export function contactsCsv(contacts, polygons) {
  const rows = [COLUMNS];
  for (let i = 0; i < contacts.length; i++) {
    const kind = contacts.kind[i];
    const [a, b] = contacts.ids.subarray(2 * i, 2 * i + 2);
    const part = (column, n) => Array.from(column.subarray(n * i, n * i + n));
    const only = (cells) => cells.map((value, k) => (k < N_VERTICES[kind] ? value : ""));
    rows.push([
      KINDS[kind], a, b, contacts.toi[i], STATES[contacts.state[i]],
      ...only(part(contacts.vertices, 4)),
      kind === 0 ? polygons[b] : "",
      ...part(contacts.point, 3), ...part(contacts.normal, 3), ...only(part(contacts.weights, 4)),
    ].map(cell).join(","));
  }
  return `${rows.join("\n")}\n`;
}

/** A number as text that is read as the same number: that of -0 would be `0`. */
function cell(value) {
  return Object.is(value, -0) ? "-0" : String(value);
}
