// Readers of meshes: OBJ (obj.js) and PLY (ply.js); polygons become fans. Two meshes are compared.

import { readObj } from "./obj.js";
import { readPly } from "./ply.js";

/** Names of files that are read. */
export const EXTENSIONS = [".obj", ".ply"];

/** A mesh while it is read; ids may be those of vertices that come later in the file. */
class Lists {
  x = [];
  edges = [];
  faces = [];
  polygons = [];
  nPolygons = 0;

  /** Appends a polygon as a fan of triangles. */
  pushPolygon(corners) {
    for (let i = 1; i + 1 < corners.length; i++) {
      this.faces.push(corners[0], corners[i], corners[i + 1]);
      this.polygons.push(this.nPolygons);
    }
    this.nPolygons += 1;
  }

  check() {
    const n = this.x.length / 3;
    if (n === 0) throw new Error("there are no vertices");
    const endless = this.x.findIndex((value) => !Number.isFinite(value));
    if (endless >= 0) throw new Error(`vertex ${Math.floor(endless / 3)} is not finite`);
    const outside = (v) => v < 0 || v >= n;
    const face = this.faces.findIndex(outside);
    if (face >= 0) {
      throw new Error(`face ${this.polygons[Math.floor(face / 3)]} (counted from 0) refers to `
        + `vertex ${this.faces[face]} (counted from 0); there are ${n} vertices`);
    }
    const edge = this.edges.findIndex(outside);
    if (edge >= 0) {
      throw new Error(`edge ${Math.floor(edge / 2)} (counted from 0) refers to vertex `
        + `${this.edges[edge]} (counted from 0); there are ${n} vertices`);
    }
  }
}

/**
 * Positions, edges of no face, faces, and the file's polygon of each face; an Error says what is
 * wrong.
 */
export function readMesh(bytes, name) {
  const mesh = new Lists();
  const ending = EXTENSIONS.find((end) => name.toLowerCase().endsWith(end));
  const isPly = new TextDecoder("latin1").decode(bytes.subarray(0, 3)) === "ply";
  try {
    if (!isPly && !ending) throw new Error(`this page reads ${EXTENSIONS.join(" and ")} files`);
    if (bytes.length === 0) throw new Error("the file is empty");
    if (isPly) readPly(bytes, mesh);
    else if (ending === ".obj") readObj(bytes, mesh);
    else throw new Error("this is not a PLY file: it does not begin with `ply`");
    mesh.check();
  } catch (why) {
    throw new Error(`${name}: ${why.message}`);
  }
  return {
    x: Float64Array.from(mesh.x),
    edges: Uint32Array.from(mesh.edges),
    faces: Uint32Array.from(mesh.faces),
    polygons: Uint32Array.from(mesh.polygons),
  };
}

/** Throws if two meshes are no frames of one; the message has the names of their files. */
export function compareFrames(meshes, names) {
  const must = "both must be frames of one mesh, with the same vertices, edges and faces in the "
    + "same order";
  const counts = meshes.map(({ x, faces, edges }) => {
    const rods = edges.length ? ` and ${edges.length / 2} edges of no face` : "";
    return `${x.length / 3} vertices and ${faces.length / 3} triangles${rods}`;
  });
  if (counts[0] !== counts[1]) {
    throw new Error(`${names[0]} has ${counts[0]}, ${names[1]} has ${counts[1]}: ${must}`);
  }
  for (const [list, what, width] of [["faces", "triangle", 3], ["edges", "edge", 2]]) {
    const [p, q] = meshes.map((mesh) => mesh[list]);
    const at = p.findIndex((v, i) => v !== q[i]);
    if (at < 0) continue;
    const first = Math.floor(at / width);
    const row = (ids) => ids.subarray(width * first, width * first + width).join(" ");
    throw new Error(`${what} ${first} (counted from 0, as are vertices) is ${row(p)} in `
      + `${names[0]}, ${row(q)} in ${names[1]}: ${must}`);
  }
}
