// A cloth that falls on a sphere: position based dynamics, and steps that never pass through
// anything. As examples/cloth.rs does it: features are pushed apart from `thickness` on, and a step
// goes as far as is certified free at the lesser distance `LEAST`.

import { Mesh, Session } from "../pkg/index.js";

const SIDE = 1;
const RADIUS = 0.3;
/** Greatest thickness, as a part of the distance of vertices at rest: neighbours touch above. */
const THICKEST = 0.6;
/** Height in metres below which a cloth that slid off is of no interest any more. */
const BOTTOM = -3;
/** Metres that are kept whatever happens. */
const LEAST = 0.0005;
/** Seconds, metres per second squared. */
const DT = 1 / 80;
const GRAVITY = -9.81;
/** Part of the velocity that is left after a step, and part of a slide that a push takes away. */
const DAMPING = 0.995;
const FRICTION = 0.3;
const ROUNDS = 2;

export class Cloth {
  /**
   * `n`: vertices along a side; `thickness` in metres, less if vertices are closer than that;
   * `stiffness`: rounds of springs a step.
   */
  constructor({ n, thickness, stiffness }) {
    const sphere = sphereMesh(3, RADIUS);
    this.nCloth = n * n;
    this.thickness = Math.min(thickness, THICKEST * SIDE / (n - 1));
    this.stiffness = stiffness;
    const x = new Float64Array(3 * this.nCloth + sphere.x.length);
    for (let i = 0; i < this.nCloth; i++) {
      const at = (k) => SIDE * (k / (n - 1) - 0.5);
      x.set([at(i % n), RADIUS + 0.2, at(Math.floor(i / n))], 3 * i);
    }
    x.set(sphere.x, 3 * this.nCloth);
    const faces = gridFaces(n).concat(sphere.faces.map((v) => v + this.nCloth));
    this.faces = Uint32Array.from(faces);
    this.mesh = new Mesh(x.length / 3, null, this.faces);
    const ofVertex = new Uint32Array(x.length / 3).fill(1, this.nCloth);
    this.session = new Session(this.mesh, {
      minDistance: this.thickness, leaveContact: true, bodies: { ofVertex, fixed: [1] },
    });
    this.x = x;
    this.v = new Float64Array(3 * this.nCloth);
    this.springs = springs(n, x);
    this.seconds = 0;
  }

  /** One step; its report has the contacts of the last round. */
  step() {
    const { x, v, session } = this;
    const x1 = x.slice();
    for (let i = 0; i < v.length; i++) {
      v[i] = (v[i] + (i % 3 === 1 ? GRAVITY * DT : 0)) * DAMPING;
      x1[i] = x[i] + v[i] * DT;
    }
    const begun = performance.now();
    let detection = 0;
    session.setMinDistance(this.thickness);
    let report;
    for (let round = 0; round < ROUNDS; round++) {
      for (let k = 0; k < this.stiffness; k++) pull(this.springs, x1);
      report = session.step(x, x1, { geometry: true });
      detection += report.ms.total;
      this.pushApart(report.contacts, x1);
    }
    session.setMinDistance(LEAST);
    const asked = performance.now();
    const toi = session.earliestToi(x, x1);
    detection += performance.now() - asked;
    // Short of the time itself, so that some distance is left for the next step.
    const part = toi === null ? 1 : 0.9 * toi;
    for (let i = 0; i < v.length; i++) {
      v[i] = (x1[i] - x[i]) / DT;
      x[i] += part * (x1[i] - x[i]);
    }
    this.seconds += part * DT;
    return { report, free: toi ?? 1, detection, total: performance.now() - begun };
  }

  /**
   * Moves the vertices of each contact, each by its weight, so that at the end of the step the
   * points that meet are apart by `thickness` along the normal; the sphere stays.
   */
  pushApart(contacts, x1) {
    const { x, nCloth } = this;
    for (let c = 0; c < contacts.length; c++) {
      const [nx, ny, nz] = contacts.normal.subarray(3 * c, 3 * c + 3);
      // A point is a sum of its vertices; of the second feature it counts against the first.
      const nFirst = contacts.kind[c] === 1 ? 2 : 1;
      let [gap, freedom] = [0, 0];
      for (let k = 0; k < 4; k++) {
        const [id, w] = [contacts.vertices[4 * c + k], contacts.weights[4 * c + k]];
        const along = nx * x1[3 * id] + ny * x1[3 * id + 1] + nz * x1[3 * id + 2];
        gap += (k < nFirst ? w : -w) * along;
        if (id < nCloth) freedom += w * w;
      }
      const lacking = this.thickness - gap;
      if (lacking <= 0 || freedom === 0) continue;
      for (let k = 0; k < 4; k++) {
        const [id, w] = [contacts.vertices[4 * c + k], contacts.weights[4 * c + k]];
        if (id >= nCloth) continue;
        const push = (k < nFirst ? w : -w) * lacking / freedom;
        const at = 3 * id;
        const moved = [x1[at] - x[at], x1[at + 1] - x[at + 1], x1[at + 2] - x[at + 2]];
        const along = nx * moved[0] + ny * moved[1] + nz * moved[2];
        [nx, ny, nz].forEach((normal, axis) => {
          x1[at + axis] += normal * push - FRICTION * w * (moved[axis] - along * normal);
        });
      }
    }
  }

  /** Whether all of the cloth fell past the sphere. */
  isGone() {
    return this.x.subarray(0, 3 * this.nCloth).every((c, i) => i % 3 !== 1 || c < BOTTOM);
  }

  free() {
    this.session.free();
    this.mesh.free();
  }
}

function gridFaces(n) {
  const faces = [];
  for (let j = 0; j + 1 < n; j++) {
    for (let i = 0; i + 1 < n; i++) {
      const v = j * n + i;
      faces.push(v, v + n, v + 1, v + 1, v + n, v + n + 1);
    }
  }
  return faces;
}

/** Sides and diagonals of cells, and every second vertex against bending: ends and lengths. */
function springs(n, x) {
  const all = [];
  for (let i = 0; i < n * n; i++) {
    for (const [right, down] of [[1, 0], [0, 1], [1, 1], [2, 0], [0, 2]]) {
      if (i % n + right < n && Math.floor(i / n) + down < n) {
        const j = i + right + down * n;
        const d = [0, 1, 2].map((k) => x[3 * i + k] - x[3 * j + k]);
        all.push([3 * i, 3 * j, Math.hypot(...d)]);
      }
    }
  }
  return all;
}

/** Moves the ends of each spring towards its length, equally. */
function pull(all, x) {
  for (const [i, j, rest] of all) {
    const [dx, dy, dz] = [x[j] - x[i], x[j + 1] - x[i + 1], x[j + 2] - x[i + 2]];
    const length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    const part = 0.5 * (length - rest) / Math.max(length, 1e-9);
    x[i] += part * dx;
    x[i + 1] += part * dy;
    x[i + 2] += part * dz;
    x[j] -= part * dx;
    x[j + 1] -= part * dy;
    x[j + 2] -= part * dz;
  }
}

/** A sphere of triangles: an octahedron, refined. */
export function sphereMesh(levels, radius) {
  let points = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
  let faces = [
    [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5],
  ];
  for (let level = 0; level < levels; level++) {
    const middles = new Map();
    const middle = (a, b) => {
      const key = Math.min(a, b) * points.length + Math.max(a, b);
      if (!middles.has(key)) {
        const sum = points[a].map((value, k) => value + points[b][k]);
        const length = Math.hypot(...sum);
        middles.set(key, added.push(sum.map((value) => value / length)) - 1 + points.length);
      }
      return middles.get(key);
    };
    const added = [];
    faces = faces.flatMap(([a, b, c]) => {
      const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
      return [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
    });
    points = points.concat(added);
  }
  return { x: points.flat().map((value) => value * radius), faces: faces.flat() };
}
