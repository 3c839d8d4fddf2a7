// Answers: against the native library, brute force, and published data.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import test from "node:test";
import { init, Mesh, Session } from "../pkg/index.js";
import { contactsCsv } from "../page/csv.js";
import { readMesh } from "../page/read.js";
import { obj, scene } from "../page/example.js";

await init();
const { x0, x1, faces } = scene();
const [a, b] = [x0, x1].map((x) => Float64Array.from(x));
const mesh = new Mesh(a.length / 3, null, faces);

/** Rows of a CSV, numbers as numbers: both write them so that the same number is read. */
const rows = (text) => text.trim().split("\n").map((line) => line.split(",")
  .map((cell) => (cell === "" || Number.isNaN(Number(cell)) ? cell : Number(cell))));

test("contacts are those of the native library, bit for bit", () => {
  // Written by `ccd check before.obj after.obj --backend cpu --contacts contacts.csv`.
  const want = readFileSync(new URL("./data/contacts.csv", import.meta.url), "utf8");
  const frame = readMesh(new TextEncoder().encode(obj(x0, faces)), "before.obj");
  assert.deepEqual([...frame.x], x0);
  const { contacts } = new Session(mesh).step(a, b, { geometry: true });
  const [got, expected] = [rows(contactsCsv(contacts, frame.polygons)), rows(want)];
  assert.equal(got.length, expected.length);
  assert.ok(got.length > 200);
  got.forEach((row, i) => assert.deepEqual(row, expected[i], `row ${i}`));
});

test("candidates are those of brute force", () => {
  const box = (vertices) => {
    const all = vertices.flatMap((v) => [a, b].map((x) => x.subarray(3 * v, 3 * v + 3)));
    return [0, 1, 2].map((k) => all.map((p) => p[k])).map((c) => [Math.min(...c), Math.max(...c)]);
  };
  const overlap = (p, q) => p.every(([lo, hi], k) => lo <= q[k][1] && q[k][0] <= hi);
  const features = (list, n) => Array.from({ length: list.length / n }, (_, i) => {
    const vertices = [...list.subarray(n * i, n * i + n)];
    return { vertices, box: box(vertices) };
  });
  const points = features(Uint32Array.from({ length: mesh.nVertices }, (_, v) => v), 1);
  const [edges, triangles] = [features(mesh.edges, 2), features(mesh.faces, 3)];
  const pairs = (one, other, ordered) => one.flatMap((p, i) => other.flatMap((q, j) => {
    const apart = !p.vertices.some((v) => q.vertices.includes(v));
    return (!ordered || i < j) && apart && overlap(p.box, q.box) ? [`${i} ${j}`] : [];
  }));
  const found = new Session(mesh).candidates(a, b);
  const strings = (list) => Array.from({ length: list.length / 2 }, (_, i) => (
    `${list[2 * i]} ${list[2 * i + 1]}`
  )).sort();
  assert.deepEqual(strings(found.vf), pairs(points, triangles, false).sort());
  assert.deepEqual(strings(found.ee), pairs(edges, edges, true).sort());
  assert.ok(found.vf.length > 1000 && found.ee.length > 1000);
});

test("the earliest time is never later than a contact, nor a contact than in exact mode", () => {
  const session = new Session(mesh, { mode: "conservative" });
  const { contacts, undecided } = session.step(a, b);
  assert.ok(session.earliestToi(a, b) <= Math.min(...contacts.toi));
  const exact = new Session(mesh, { mode: "exact" }).step(a, b);
  assert.deepEqual([undecided, exact.undecided], [0, 0]);
  assert.ok(exact.contacts.length > 100);
  assert.deepEqual([contacts.kind, contacts.ids], [exact.contacts.kind, exact.contacts.ids]);
  const early = exact.contacts.toi.map((toi, i) => toi - contacts.toi[i]);
  assert.ok(early.every((by) => by >= 0 && by <= 1e-6) && early.some((by) => by > 0));
  assert.deepEqual(new Session(mesh).step(a, b).contacts, exact.contacts);
});

test("a step in f32 is that of the numbers rounded to f32", () => {
  const [p, q] = [a, b].map((x) => Float32Array.from(x));
  const narrow = new Session(mesh).step(p, q).contacts;
  const wide = new Session(mesh).step(Float64Array.from(p), Float64Array.from(q)).contacts;
  assert.deepEqual(narrow, wide);
});

test("cloth-ball has the contacts of its ground truth", (t) => {
  const data = process.env.CCD_DATA ?? new URL("../../../shared/data", import.meta.url).pathname;
  const folder = `${data}/scenes/cloth-ball`;
  if (!existsSync(folder)) {
    t.skip(`no data at ${folder}: set CCD_DATA`);
    return;
  }
  const [before, after] = [92, 93].map((i) => (
    readMesh(readFileSync(`${folder}/frames/cloth_ball${i}.ply`), "frame.ply")
  ));
  const truth = ["92vf", "92ee"].map((name) => (
    readFileSync(`${folder}/mma_bool/${name}_mma_bool.json`, "latin1").match(/true|1/g).length
  ));
  const session = new Session(new Mesh(before.x.length / 3, null, before.faces));
  const { counts } = session.step(before.x, after.x);
  assert.deepEqual([counts.contacts.vf, counts.contacts.ee], truth);
});
