// All that is computed, in a worker, so that the page stays responsive: the cloth, and two meshes.

import { init, Mesh, Session, version } from "../pkg/index.js";
import { Cloth } from "./cloth.js";
import { contactsCsv } from "./csv.js";
import { compareFrames, readMesh } from "./read.js";

let cloth = null;
/** Last report of two meshes, for the download, and the number of its check. */
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
    cloth = null;
    cloth = new Cloth(parameters);
    const { faces, nCloth: nFirst, thickness } = cloth;
    return { faces, x: Float32Array.from(cloth.x), nFirst, thickness };
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
      isGone: cloth.isGone(),
    };
  },

  /** Contacts of a step from one file to another. */
  async check({ check, files, minDistance, mode, device }) {
    const begun = performance.now();
    const frames = files.map(({ bytes, name }) => readMesh(new Uint8Array(bytes), name));
    const loading = performance.now() - begun;
    compareFrames(frames, files.map(({ name }) => name));
    const [before, after] = frames;
    const mesh = new Mesh(before.x.length / 3, before.edges, before.faces);
    const session = await Session.open(mesh, { minDistance, mode, device });
    try {
      const { contacts, counts, ms, undecided, toi, backend }
        = await session.stepAsync(before.x, after.x, { geometry: true });
      // A GPU may answer after a later check.
      if (!(checked?.check > check)) checked = { check, contacts, polygons: before.polygons };
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

  /** The contacts of a check as CSV, if it was the last one. */
  csv({ check }) {
    if (checked?.check !== check) {
      throw new Error("these contacts are no longer kept: choose the files again");
    }
    return contactsCsv(checked.contacts, checked.polygons);
  },
};

onmessage = async ({ data: { id, call, given } }) => {
  try {
    await init();
    postMessage({ id, answer: await answers[call](given) });
  } catch (why) {
    // The module ended: another worker has to take over.
    const ended = why instanceof WebAssembly.RuntimeError;
    postMessage({ id, error: why instanceof Error ? why.message : String(why), ended });
  }
};
