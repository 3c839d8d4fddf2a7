// All that is computed, in a worker, so that the page stays responsive: the cloth, and two meshes.

import { init, Mesh, Session, version } from "../pkg/index.js";
import { Cloth } from "./cloth.js";
import { contactsCsv } from "./csv.js";
import { readMesh } from "./read.js";

let cloth = null;
/** Last report of two meshes, for the download. */
let checked = null;

const answers = {
  /** Loads the module. */
  async load() {
    const begun = performance.now();
    await init();
    return { version: version(), ms: performance.now() - begun };
  },

  /** A new cloth; its mesh and positions. */
  cloth(parameters) {
    cloth?.free();
    cloth = new Cloth(parameters);
    return { faces: cloth.faces, x: Float32Array.from(cloth.x), nFirst: cloth.nCloth };
  },

  /** A step of the cloth: where it is now, what touched, what it took. */
  step() {
    const { report, free, detection, total } = cloth.step();
    const { counts, ms, undecided, contacts } = report;
    return {
      x: Float32Array.from(cloth.x),
      points: Float32Array.from(contacts.point),
      toi: contacts.toi,
      counts, ms, undecided, free, detection, total,
      seconds: cloth.seconds,
    };
  },

  /** Contacts of a step from one file to another. */
  async check({ files, minDistance, mode, device }) {
    const begun = performance.now();
    const [before, after] = files.map(({ bytes, name }) => readMesh(new Uint8Array(bytes), name));
    const loading = performance.now() - begun;
    const same = before.x.length === after.x.length
      && before.faces.length === after.faces.length
      && before.faces.every((v, i) => v === after.faces[i]);
    if (!same) {
      const [p, q] = [before, after].map(({ x, faces }) => (
        `${x.length / 3} vertices and ${faces.length / 3} triangles`
      ));
      throw new Error(`${files[0].name} has ${p}, ${files[1].name} has ${q}: both must be frames `
        + "of one mesh, with the same vertices and faces in the same order");
    }
    const mesh = new Mesh(before.x.length / 3, null, before.faces);
    const session = await Session.open(mesh, { minDistance, mode, device });
    try {
      const { contacts, counts, ms, undecided, toi, backend }
        = await session.stepAsync(before.x, after.x, { geometry: true });
      checked = { contacts, polygons: before.polygons };
      return {
        faces: before.faces,
        x0: before.x, x1: after.x,
        points: Float32Array.from(contacts.point),
        times: contacts.toi,
        nEdges: mesh.edges.length / 2,
        counts, ms, undecided, toi, loading, backend,
      };
    } finally {
      session.free();
      mesh.free();
    }
  },

  /** The contacts of the last check as CSV. */
  csv() {
    return contactsCsv(checked.contacts, checked.polygons);
  },
};

onmessage = async ({ data: { id, call, given } }) => {
  try {
    postMessage({ id, answer: await answers[call](given) });
  } catch (why) {
    postMessage({ id, error: why instanceof Error ? why.message : String(why) });
  }
};
