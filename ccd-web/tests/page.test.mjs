// What the page computes, without a browser: the cloth, and the readers of files.

import assert from "node:assert/strict";
import test from "node:test";
import { init, Session } from "../pkg/index.js";
import { Cloth } from "../page/cloth.js";
import { readMesh } from "../page/read.js";
import { obj, scene } from "../page/example.js";

await init();

test("a cloth falls, touches, and never passes through anything", () => {
  const cloth = new Cloth({ n: 16, thickness: 0.01, stiffness: 2 });
  const exact = new Session(cloth.mesh);
  const heights = () => cloth.x.slice(0, 3 * cloth.nCloth).filter((_, i) => i % 3 === 1);
  let contacts = 0;
  for (let i = 0; i < 80; i++) {
    const { report } = cloth.step();
    contacts = Math.max(contacts, report.contacts.length);
    assert.ok(!exact.hasIntersections(cloth.x), `step ${i}`);
  }
  assert.ok(contacts > 20, `${contacts} contacts`);
  assert.ok(cloth.seconds > 0.5 && Math.min(...heights()) < 0.2, `${cloth.seconds} s`);
  // What a cloth that passes through looks like.
  cloth.x[1 + 3 * (8 * 16 + 8)] = 0;
  assert.ok(exact.hasIntersections(cloth.x));
});

test("a cloth is no thicker than the distance of its vertices, and gone once it fell off", () => {
  const cloth = new Cloth({ n: 60, thickness: 0.02, stiffness: 1 });
  assert.ok(cloth.thickness > 0.01 && cloth.thickness < 0.0102, String(cloth.thickness));
  // Neighbours do not touch.
  assert.equal(cloth.step().report.contacts.length, 0);
  assert.equal(cloth.isGone(), false);
  for (let i = 1; i < 3 * cloth.nCloth; i += 3) cloth.x[i] = -3.1;
  assert.equal(cloth.isGone(), true);
  assert.equal(new Cloth({ n: 10, thickness: 0.02, stiffness: 1 }).thickness, 0.02);
});

/** Bytes of a PLY with one quad and one triangle. */
function ply(format) {
  const head = `ply\nformat ${format} 1.0\nelement vertex 5\nproperty float x\nproperty float y\n`
    + "property double z\nproperty uchar red\nelement face 2\n"
    + "property list uchar int vertex_indices\nend_header\n";
  const points = [0, 1, 2, 3, 4].map((i) => [i, i / 2, -i]);
  const polygons = [[0, 1, 2, 3], [2, 3, 4]];
  if (format === "ascii") {
    const lines = points.map((p) => [...p, 7].join(" "));
    polygons.forEach((p) => lines.push([p.length, ...p].join(" ")));
    return new TextEncoder().encode(`${head}${lines.join("\n")}\n`);
  }
  const bytes = [...new TextEncoder().encode(head)];
  const put = (size, method, value) => {
    const view = new DataView(new ArrayBuffer(size));
    view[method](0, value, format === "binary_little_endian");
    bytes.push(...new Uint8Array(view.buffer));
  };
  for (const [x, y, z] of points) {
    put(4, "setFloat32", x);
    put(4, "setFloat32", y);
    put(8, "setFloat64", z);
    put(1, "setUint8", 7);
  }
  for (const corners of polygons) {
    put(1, "setUint8", corners.length);
    corners.forEach((v) => put(4, "setInt32", v));
  }
  return Uint8Array.from(bytes);
}

test("PLY in its three forms, polygons as fans", () => {
  for (const format of ["ascii", "binary_little_endian", "binary_big_endian"]) {
    const mesh = readMesh(ply(format), "a.ply");
    assert.deepEqual([...mesh.x.subarray(9, 12)], [3, 1.5, -3], format);
    assert.deepEqual([...mesh.faces], [0, 1, 2, 0, 2, 3, 2, 3, 4], format);
    assert.deepEqual([...mesh.polygons], [0, 0, 1], format);
  }
});

test("OBJ with normals, ids from the end, quads", () => {
  const text = "# a\nv 0 0 0\nv 1 0 0\r\nv 1 1 0\nv 0 1 0\nvn 0 0 1\n"
    + "f 1//1 2//1 3//1 4//1\nf -1 -2 -3\n";
  const mesh = readMesh(new TextEncoder().encode(text), "A.OBJ");
  assert.deepEqual([...mesh.faces], [0, 1, 2, 0, 2, 3, 3, 2, 1]);
  assert.deepEqual([...mesh.polygons], [0, 0, 1]);
  const { x0, faces } = scene();
  assert.deepEqual([...readMesh(new TextEncoder().encode(obj(x0, faces)), "b.obj").faces], faces);
});

test("what is wrong with a file is said with its name", () => {
  const read = (text, name) => () => readMesh(new TextEncoder().encode(text), name);
  assert.throws(read("", "a.stl"), /^Error: a.stl: this page reads .obj and .ply/);
  assert.throws(read("", "a.obj"), /^Error: a.obj: the file is empty/);
  assert.throws(read("# none\n", "a.obj"), /no vertices/);
  assert.throws(read("", "a.ply"), /^Error: a.ply: the file is empty/);
  assert.throws(read("solid a\n", "a.ply"), /^Error: a.ply: this is not a PLY file/);
  assert.throws(read("v 0 0\n", "a.obj"), /line 1/);
  assert.throws(read("v 0 0 0\nf 1 2 3\n", "a.obj"), /face 0 .* refers to vertex 1/);
  assert.throws(read("ply\n", "a.ply"), /end_header/);
  const early = ply("binary_little_endian");
  assert.throws(() => readMesh(early.subarray(0, early.length - 3), "a.ply"), /ends early/);
});
