// Every call with its types, as a user writes it. Compiled, not run; errors that must be are marked.

import {
  gpuWasmUrl, init, initSync, KINDS, Mesh, Session, STATES, version, wasmUrl,
  type Contacts, type ContactsWithGeometry, type FirstContact, type Intersection, type Kind,
  type Options, type Report,
} from "../pkg/index.js";

await init();
await init(wasmUrl);
const kernels: URL = gpuWasmUrl;
initSync(new Uint8Array());
const text: string = version();
const kind: Kind | undefined = KINDS[0];
const state: "hit" | "undecided" = STATES[1];

const mesh = new Mesh(4, null, [[0, 1, 2]]);
const edges: Uint32Array = mesh.edges;
const options: Options = {
  minDistance: 0.1, mode: "conservative", tolerance: 1e-6, leaveContact: true, maxMemory: 1e9,
  bodies: { ofVertex: [0, 0, 0, 1], fixed: [0], noSelfContact: [1], excluded: [[0, 1]] },
};
const session = new Session(mesh, options);
const { x0, x1 }: { x0: Float32Array; x1: Float32Array } = session.positions(Float32Array);

const report: Report = session.step(x0, x1);
const plain: Contacts = session.step(x0, new Float64Array(12), { window: [0, 0.5] }).contacts;
const all: ContactsWithGeometry = session.step(x0, x1, { geometry: true, views: true }).contacts;
const counted: number = report.counts.candidates.vf + report.ms.total + all.normal[0]!;
const toi: number | null = session.earliestToi(x0, x1);
const size: number = session.collisionFreeStepsize(x0, x1);
const free: boolean = session.isStepCollisionFree(x0, x1);
const first: FirstContact | null = session.firstContact(x0, x1);
const pairs: Uint32Array = session.candidates(x0, x1).ee;
const through: Intersection[] = session.intersections(x0);
const any: boolean = session.hasIntersections(x0);
const opened: Session = await Session.open(mesh, { ...options, device: "auto" });
const where: "cpu" | "gpu" = (await opened.stepAsync(x0, x1, { window: [0, 1] })).backend;
const normals: Float64Array
  = (await opened.stepAsync(x0, x1, { geometry: true })).contacts.normal;
const soon: number | null = await opened.earliestToiAsync(x0, x1);
const why: string | null = opened.whyCpu ?? opened.adapter;
session.setMinDistance(0);
session.setFixed(0, true);
session.setSleeping(1, false);
session.free();
mesh.free();
{
  using held: Session = new Session(mesh);
  held[Symbol.dispose]();
}

// @ts-expect-error: points are there with `geometry: true` alone
report.contacts.point;
// @ts-expect-error: there is no such mode
new Session(mesh, { mode: "fast" });
// @ts-expect-error: positions are typed arrays
session.step([0, 0, 0], x1);
// @ts-expect-error: there is no such device
Session.open(mesh, { device: "tpu" });
// @ts-expect-error: what is awaited is copied
opened.stepAsync(x0, x1, { views: true });
// @ts-expect-error: faces may be none, but not left out
new Mesh(6, [0, 1, 2, 3, 4, 5]);
// @ts-expect-error: there is no such backend
report.backend === "webgpu";

export { text, kernels, kind, state, edges, plain, counted, toi, size, free, first, pairs, through, any, where, normals, soon, why };
