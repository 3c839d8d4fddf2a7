// Steps on a device beside those on the CPU, for Node and for a page in a browser: each answer that
// differs is a line of text. The same contacts, in the same order and of the same states; times and
// what follows from them within bounds.

import { scene } from "../page/example.js";
import { readMesh } from "../page/read.js";

/** A session of which both have the same mode: by default times on the CPU are exact. */
const GPU = { device: "gpu", mode: "conservative" };
/** How far times of both may be apart: the tolerance of options, by which each may be early. */
const TIME = 1e-6;
/** How far points, normals and weights may be: what moves within that time, in these scenes. */
const GEOMETRY = 1e-4;

/** Differences of two columns, as text. */
function unlike(name, got, want, bound) {
  if (got.length !== want.length) return [`${name}: ${got.length} entries, not ${want.length}`];
  const at = got.findIndex((value, i) => !(Math.abs(value - want[i]) <= bound));
  return at < 0 ? [] : [`${name}[${at}]: ${got[at]}, not ${want[at]}`];
}

const BOUNDS = { toi: TIME, point: GEOMETRY, normal: GEOMETRY, weights: GEOMETRY };
function unlikeReports(got, want) {
  const { length, ...columns } = want.contacts;
  const perKind = JSON.stringify(got.counts.contacts) === JSON.stringify(want.counts.contacts);
  return [
    ...Object.keys(columns).flatMap((name) => (
      unlike(name, got.contacts[name] ?? [], columns[name], BOUNDS[name] ?? 0)
    )),
    ...unlike("toi", [got.toi ?? 2], [want.toi ?? 2], TIME),
    ...unlike("undecided", [got.undecided], [want.undecided], 0),
    ...(perKind ? [] : [`counts: ${JSON.stringify(got.counts.contacts)}`]),
    ...(got.backend === "gpu" ? [] : [`the step ran on the ${got.backend}`]),
  ];
}

function unlikeTimes(got, want) {
  if (got === null || want === null) return got === want ? [] : [`earliest: ${got}, not ${want}`];
  return unlike("earliest", [got], [want], TIME);
}

/** Calls on one step. */
const CALLS = {
  wide: {},
  geometry: { call: { geometry: true } },
  window: { call: { window: [0.25, 0.75], geometry: true } },
  narrow: { Type: Float32Array },
  distance: { options: { minDistance: 0.01 } },
  exact: { options: { mode: "exact" } },
  bodies: { options: { bodies: { excluded: [0, 1] } } },
  // Backwards: the sheet leaves the pyramid, and `x0` and `x1` are not those of the step before.
  backwards: { turn: true },
};

/**
 * The example of the page by every call; all differences, and how many contacts were compared.
 * `lower`: how far the device is given the sheet lower at the end than the CPU, to see that
 * differences are seen.
 */
export async function compareExample({ Mesh, Session }, { lower = 0 } = {}) {
  const { x0, x1, faces, nSheet } = scene();
  const n = x0.length / 3;
  const mesh = new Mesh(n, null, faces);
  const ofVertex = Uint32Array.from({ length: n }, (_, v) => Number(v >= nSheet));
  const differences = [];
  let contacts = 0;
  for (const [name, given] of Object.entries(CALLS)) {
    const { Type = Float64Array, options = {}, call = {}, turn } = given;
    const bodies = options.bodies && { ofVertex, ...options.bodies };
    const session = await Session.open(mesh, { ...GPU, ...options, bodies });
    const frames = [x0, x1].map((x) => Type.from(x));
    const [p, q] = turn ? frames.toReversed() : frames;
    const want = session.step(p, q, call);
    for (let i = 1; i < 3 * nSheet; i += 3) frames[1][i] -= lower;
    // Twice: the second goes on from what the first has learnt.
    for (const again of ["", " again"]) {
      const got = await session.stepAsync(p, q, call);
      differences.push(...unlikeReports(got, want).map((line) => `${name}${again}: ${line}`));
    }
    const toi = await session.earliestToiAsync(p, q);
    const all = unlikeTimes(toi, session.earliestToi(p, q));
    differences.push(...all.map((line) => `${name}: ${line}`));
    contacts += want.contacts.length;
    session.free();
  }
  mesh.free();
  return { differences, contacts };
}

/** Two sessions in flight at once, changes between steps, and calls that are refused. */
export async function compareSessions({ Mesh, Session }) {
  const { x0, x1, faces } = scene();
  const mesh = new Mesh(x0.length / 3, null, faces);
  const frames = [x0, x1].map((x) => Float64Array.from(x));
  const sessions = await Promise.all([0, 0.01].map((minDistance) => (
    Session.open(mesh, { ...GPU, minDistance })
  )));
  const differences = [];
  const compare = async (name) => {
    const got = await Promise.all(sessions.map((session) => session.stepAsync(...frames)));
    sessions.forEach((session, i) => {
      const all = unlikeReports(got[i], session.step(...frames));
      differences.push(...all.map((line) => `${name} ${i}: ${line}`));
    });
    return got.map(({ contacts }) => contacts.length);
  };
  const before = await compare("both");
  const refused = async (name, call) => {
    const why = await call().then(() => "nothing", (error) => error.message);
    return `${name}: ${why}`;
  };
  const [session] = sessions;
  const flight = session.stepAsync(...frames);
  const errors = [await refused("busy", () => session.stepAsync(...frames))];
  try {
    session.setMinDistance(0.02);
  } catch (error) {
    errors.push(`change: ${error.message}`);
  }
  await flight;
  errors.push(await refused("short", () => session.stepAsync(frames[0].subarray(3), frames[1])));
  const endless = frames[1].map((value, i) => (i === 7 ? NaN : value));
  errors.push(await refused("not finite", () => session.stepAsync(frames[0], endless)));
  session.setMinDistance(0.02);
  const after = await compare("after errors and a change");
  sessions.forEach((one) => one.free());
  mesh.free();
  return { differences, before, after, errors };
}

/** The same of files at these addresses. */
export async function compareServed(meshccd, addresses) {
  const fetched = addresses.map(async (from) => (
    new Uint8Array(await (await fetch(from)).arrayBuffer())
  ));
  return compareFrames(meshccd, await Promise.all(fetched));
}

/** Two frames of a file each, by a session kept for three steps. */
export async function compareFrames({ Mesh, Session }, files) {
  const [p, q] = files.map((bytes) => readMesh(bytes, "frame.ply"));
  const mesh = new Mesh(p.x.length / 3, null, p.faces);
  const gpu = await Session.open(mesh, GPU);
  const timed = async (call) => {
    const begun = performance.now();
    return [await call(), performance.now() - begun];
  };
  const [want, cpu] = await timed(() => gpu.step(p.x, q.x));
  const [differences, times] = [[], []];
  for (let i = 0; i < 3; i++) {
    const [got, ms] = await timed(() => gpu.stepAsync(p.x, q.x));
    differences.push(...unlikeReports(got, want));
    times.push(ms);
  }
  const [toi, ms] = await timed(() => gpu.earliestToiAsync(p.x, q.x));
  differences.push(...unlikeTimes(toi, gpu.earliestToi(p.x, q.x)));
  const { counts: { contacts } } = want;
  gpu.free();
  mesh.free();
  return { differences, contacts, ms: { cpu, steps: times, earliest: ms } };
}
