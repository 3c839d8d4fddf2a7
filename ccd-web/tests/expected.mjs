// What steps on a device have to be, wherever they ran: under Node or in a browser.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

/** Contacts of all calls of `compareExample`. */
export function checkExample({ differences, contacts }) {
  assert.deepEqual(differences, []);
  assert.equal(contacts, 5 * 251 + 122 + 269);
}

/** A device that was given other positions than the CPU. */
export function checkLowered({ differences }) {
  for (const name of ["wide", "geometry again", "narrow", "exact"]) {
    assert.ok(differences.some((line) => line.startsWith(`${name}: `)), differences.join("\n"));
  }
}

export function checkSessions({ differences, before, after, errors }) {
  assert.deepEqual(differences, []);
  assert.deepEqual([before, after], [[251, 269], [310, 269]]);
  const flight = "a step of this session is in flight: await it first";
  assert.deepEqual(errors.slice(0, 2), [`busy: ${flight}`, `change: ${flight}`]);
  assert.match(errors[2], /^short: x0 has 600 numbers; the mesh has 201 vertices/);
  assert.match(errors[3], /^not finite: vertex 2 at t1 has y = NaN/);
}

/** Frames of cloth-ball as files, or why there are none. */
export function clothBall() {
  const beside = new URL("../../../shared/data", import.meta.url);
  const data = process.env.CCD_DATA ?? fileURLToPath(beside);
  const folder = `${data}/scenes/cloth-ball`;
  if (!existsSync(folder)) return { missing: `no data at ${folder}: set CCD_DATA` };
  return { files: [92, 93].map((i) => readFileSync(`${folder}/frames/cloth_ball${i}.ply`)) };
}

/** Those of the ground truth, which the CPU's tests compare with. */
export function checkClothBall({ differences, contacts }) {
  assert.deepEqual(differences, []);
  assert.deepEqual([contacts.vf, contacts.ee], [19_032, 94_822]);
}

/** Times, for documentation. */
export function told(t, where, { ms: { cpu, steps, earliest } }) {
  const seconds = (ms) => `${(ms / 1000).toFixed(2)} s`;
  t.diagnostic(`${where}: cloth-ball in ${steps.map(seconds).join(", ")} on the device, the `
    + `earliest time in ${seconds(earliest)}; all contacts on the CPU in ${seconds(cpu)}`);
}
