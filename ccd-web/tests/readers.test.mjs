// Readers of the page: what they take and refuse is what the command `ccd check` does.

import assert from "node:assert/strict";
import test from "node:test";
import { inOrder } from "../page/order.js";
import { compareFrames, readMesh } from "../page/read.js";

const read = (text, name) => readMesh(new TextEncoder().encode(text), name);
const V = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/** A PLY of three vertices, with more of a header and of data. */
const ply = (head, data, points = "0 0 0\n1 0 0\n0 1 0\n") => (
  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
  + `property float z\n${head}end_header\n${points}${data}`
);
const FACE = "element face 1\nproperty list uchar int vertex_indices\n";
const EDGE = "element edge 1\nproperty int vertex1\nproperty int vertex2\n";

test("files that the command reads, in its way", () => {
  const check = (text, name, { n = 3, edges = [], faces = [0, 1, 2] }) => {
    const mesh = read(text, name);
    assert.equal(mesh.x.length, 3 * n, text);
    assert.deepEqual([[...mesh.edges], [...mesh.faces]], [edges, faces], text);
  };
  const rod = { edges: [0, 1, 1, 2], faces: [] };
  check(`${V}f 1 2 3\n`.replaceAll("\n", "\r"), "a.obj", {});
  check(`${V}f 1 2 3\n`.replaceAll("\n", "\r\n"), "a.obj", {});
  check(`\ufeff${V}f 1 2 3`, "a.obj", {});
  check(`${V}f 1 2 3 # b\n`, "a.obj", {});
  check(`${V}f 1 2 \\\n3\n`, "a.obj", {});
  check(`# a path \\\n${V}f 1/1 2//2 3/3/3\n`, "a.obj", {});
  check("v 0 0 \\\n5 1\nv 1 0 0 .5 .5 .5\nv 0 1. 1e0 0 0 0 1\nf -3 -2 -1\n", "a.obj", {});
  check(`vn 0 0 1\no x\n${V}f 1 2 2\n`, "a.obj", { faces: [0, 1, 1] });
  check(`f 1 2 3\n${V}`, "a.obj", {});
  check(`${V}l 1 2 -1\n`, "a.obj", rod);
  // The time of a line is its own, however much there is of its statement already.
  assert.equal(read(`${V}f 1 2 ${"\\\n".repeat(1 << 20)}3\n`, "a.obj").faces.length, 3);
  check(ply(FACE, "3 0 1 2\n\n \n"), "a.ply", {});
  check(ply(FACE + FACE.replace("face", "other").replace("vertex_indices", "x"), "3 0 1 2\n1 0"),
    "a.ply", {});
  check(ply(EDGE, "0 2\n"), "a.ply", { edges: [0, 2], faces: [] });
  check(ply(`comment a\n${FACE}`, "3 0 1 2").replaceAll("\n", "\r\n"), "a.ply", {});
  // Coordinates are of the type that the header has.
  assert.equal(read(ply("", "", "0.1 0 0\n1 0 0\n0 1 0\n"), "a.ply").x[0], Math.fround(0.1));
});

test("files that the command refuses", () => {
  const refused = (text, why, name = "a.obj") => assert.throws(() => read(text, name), why, text);
  refused(`${V}f 1x 2.9 3zz\n`, /line 4: `1x` is not a vertex index/);
  refused(`${V}f 1/0 2 3\n`, /`1\/0` is not a vertex index/);
  refused(`${V}f 1 2 0\n`, /line 4: vertex index 0 names no vertex: OBJ counts from 1/);
  refused(`${V}f -4 2 3\n`, /vertex index -4 names no vertex \(3 so far\)/);
  refused(`${V}f 1 2\n`, /has 2 vertices, fewer than 3/);
  refused(`${V}l 1 4\n`, /edge 0 .* refers to vertex 3/);
  refused(`V 0 0 0\n${V}`, /line 1: `V` is no statement/);
  refused(`${V}F 1 2 3\n`, /line 4: `F` is no statement/);
  refused(`hello\n${V}`, /`hello` is no statement/);
  for (const word of ["curv", "curv2", "surf"]) refused(`${V}${word} 0 1 1 2\n`, /free-form/);
  refused("v 0x10 0 0\n", /`0x10` is not a number/);
  refused("v 1e999 0 0\n", /not a finite number/);
  refused("v 1e101 0 0\n", /beyond 1e100/);
  refused("v 0 0 0 2\n", /the weight of a vertex is 2/);
  refused("v 0 0 0 1 2\n", /3, 4, 6 or 7 numbers, not 5/);
  refused(`${V}f 1 2 3 \\`, /goes on/);
  refused("v\0 0 0 0\n", /is not text/);
  const strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  const refusedPly = (text, why) => refused(text, why, "a.ply");
  refusedPly(ply(strips, "3 0 1 2\n"), /element `tristrips` has lists of vertices/);
  refusedPly(ply(FACE, "3 0 1 2\n4 4 4 4\n"), /there is more than the header promises/);
  refusedPly(ply(FACE, "3.7 0 1 2\n"), /`3.7` is no whole number/);
  refusedPly(ply(FACE, "3 0 1 2 2\n"), /more numbers than the header says/);
  refusedPly(ply(FACE, "3 0 1\n"), /fewer numbers/);
  refusedPly(ply(FACE, "-1\n"), /`-1` does not fit/);
  refusedPly(ply(FACE, "3 0 1 3\n"), /face 0 .* refers to vertex 3/);
  refusedPly(ply(FACE, "3 0 1 -1\n"), /face 0 .* refers to vertex -1/);
  refusedPly(ply(FACE, ""), /ends early/);
  refusedPly(ply(FACE, "3 0 1 2\n", "0 0 0 7\n1 0 0\n0 1 0\n"), /more numbers/);
  refusedPly(ply("", "", "1,5 0 0\n1 0 0\n0 1 0\n"), /`1,5` is no number/);
  refusedPly(ply("", "", "0x1F 0 0\n1 0 0\n0 1 0\n"), /`0x1F` is no number/);
  refusedPly(ply("", "", "nan 0 0\n1 0 0\n0 1 0\n"), /vertex 0 is not finite/);
  refusedPly(ply("", "").replace("property float x", "property float a"), /x, y or z is missing/);
  for (const count of ["-3", "x3", "1e15"]) {
    refusedPly(ply("", "").replace("vertex 3", `vertex ${count}`), /header: line 3/);
  }
  refusedPly(ply("", "").replace("ascii", "binary_foo_endian"), /header: line 2/);
  refusedPly(ply("", "").replace("float x", "constructor x"), /header: line 4/);
  refusedPly(ply("property list float int a\n", ""), /header: line 7/);
  refusedPly(ply("", "").replaceAll("\n", "\r"), /no end_header/);
  refusedPly(ply("element vertex 1\n", ""), /header: line 7: `vertex` is the name of two elements/);
  refusedPly(ply("", "").replace("float y", "float x"), /5: `x` is the name of two properties/);
  refusedPly(ply(`comment ${" ".repeat(1 << 20)}\n`, ""), /header: it is longer than 1 MiB/);
  // These end, too.
  refusedPly(ply("element none 1000000000000000\n", ""), /at most 2147483647 are possible/);
  const none = "element none 2147483647\n";
  refusedPly(ply(none, ""), /none 0: the file ends early/);
  const binary = ply(none, "", "\0".repeat(36)).replace("ascii", "binary_big_endian");
  assert.equal(read(binary, "a.ply").x.length, 9);
  refusedPly(`${binary}\0`, /there is more than the header promises/);
  refusedPly("ply\nformat ascii 1.0\nelement none 3\nend_header\n", /no element named vertex/);
});

test("two meshes that are no frames of one: what differs first", () => {
  const compare = (p, q, why) => {
    const frames = [p, q].map((text) => read(V + text, "a.obj"));
    assert.throws(() => compareFrames(frames, ["p.obj", "q.obj"]), why);
  };
  const same = read(`${V}f 1 2 3\nl 1 2\n`, "a.obj");
  compareFrames([same, same], ["p.obj", "q.obj"]);
  compare("f 1 2 3\nf 1 2 3\n", "f 1 2 3\nf 1 3 2\n",
    /^Error: triangle 1 .* is 0 1 2 in p.obj, 0 2 1 in q.obj: both must be frames/);
  compare("l 1 2\n", "l 1 3\n", /edge 0 .* is 0 1 in p.obj, 0 2 in q.obj/);
  compare("l 1 2\n", "l 1 2 3\n", /p.obj has .* and 1 edges of no face, q.obj has .* 2 edges/);
  compare("f 1 2 3\n", "", /p.obj has 3 vertices and 1 triangles, q.obj has .* 0 triangles/);
});

test("which of two files is the start", () => {
  const check = (given, want) => {
    const files = given.map((name) => ({ name }));
    assert.deepEqual(inOrder(files).map(({ name }) => name), want, String(given));
  };
  check(["f10.obj", "f9.obj"], ["f9.obj", "f10.obj"]);
  check(["f9.obj", "f10.obj"], ["f9.obj", "f10.obj"]);
  check(["before.ply", "after.ply"], ["before.ply", "after.ply"]);
  check(["after.ply", "before.ply"], ["before.ply", "after.ply"]);
  check(["new_1.ply", "old_2.ply"], ["old_2.ply", "new_1.ply"]);
  check(["x_end.obj", "x_start.obj"], ["x_start.obj", "x_end.obj"]);
  check(["a.obj", "firsthand.obj"], ["a.obj", "firsthand.obj"]);
  check(["z.obj", "a.obj"], ["z.obj", "a.obj"]);
  // Numbers with a point have no order as whole ones.
  check(["t_0.05.obj", "t_0.1.obj"], ["t_0.05.obj", "t_0.1.obj"]);
});
