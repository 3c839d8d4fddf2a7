// The page: buttons, sliders and numbers. What is computed runs in worker.js.

import { picture } from "./draw.js";
import { obj, scene } from "./example.js";

const $ = (id) => document.getElementById(id);
const view = picture($("canvas"));
$("no-webgl").hidden = view !== null;
$("canvas").hidden = view === null;
$("legend").hidden = view === null;
$("webgpu").textContent = navigator.gpu
  ? "This browser has WebGPU: two meshes can be checked there."
  : "This browser has no WebGPU here, so two meshes are checked on the CPU as well.";
$("gpu").disabled = !navigator.gpu;
const NAMES = { cpu: "CPU (WebAssembly)", gpu: "GPU (WebGPU)" };

/** Asks the worker; one answer for each question. */
const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
const waiting = new Map();
let asked = 0;
function ask(call, given) {
  return new Promise((resolve, reject) => {
    waiting.set(++asked, { resolve, reject });
    worker.postMessage({ id: asked, call, given });
  });
}
worker.onmessage = ({ data: { id, answer, error } }) => {
  const { resolve, reject } = waiting.get(id);
  waiting.delete(id);
  if (error === undefined) resolve(answer);
  else reject(new Error(error));
};
worker.onerror = (event) => {
  $("backend").textContent = `The worker could not start: ${event.message ?? "no reason given"}`;
};

const ms = (t) => `${t.toFixed(t < 9.95 ? 1 : 0)} ms`;
const count = (n) => n.toLocaleString("en");
/** Rows of a table of names and values. */
function table(id, rows) {
  $(id).replaceChildren(...rows.flatMap(([name, value]) => {
    const cells = [document.createElement("dt"), document.createElement("dd")];
    [name, value].forEach((text, i) => { cells[i].textContent = text; });
    return cells;
  }));
}
const stages = (t) => [
  ["boxes", ms(t.boxes)], ["trees", ms(t.build)], ["candidates", ms(t.traverse)],
  ["decisions", ms(t.narrow)], ["copies", ms(t.copy)],
];

// Tabs, by arrow keys as well.
const tabs = ["cloth", "files"];
let shown = "cloth";
function show(tab) {
  shown = tab;
  for (const name of tabs) {
    $(name).hidden = name !== tab;
    $(`tab-${name}`).setAttribute("aria-selected", name === tab);
    $(`tab-${name}`).tabIndex = name === tab ? 0 : -1;
  }
  if (tab === "cloth") showCloth();
  else showFrames();
}
tabs.forEach((name, i) => {
  $(`tab-${name}`).onclick = () => show(name);
  $(`tab-${name}`).onkeydown = ({ key }) => {
    if (key !== "ArrowLeft" && key !== "ArrowRight") return;
    show(tabs[1 - i]);
    $(`tab-${tabs[1 - i]}`).focus();
  };
});

// The cloth.
const sliders = ["n", "thickness", "stiffness"];
let running = !matchMedia("(prefers-reduced-motion: reduce)").matches;
let cloth = null;
let busy = false;
const parameters = () => ({
  n: Number($("n").value),
  thickness: Number($("thickness").value) / 1000,
  stiffness: Number($("stiffness").value),
});

async function restart() {
  busy = true;
  const made = await ask("cloth", parameters());
  cloth = { ...made, nPoints: 0, points: new Float32Array(), toi: new Float64Array() };
  busy = false;
  showCloth();
}

function showCloth() {
  if (shown !== "cloth" || !cloth || !view) return;
  view.setMesh(cloth.faces, cloth.x.length / 3, cloth.nFirst);
  view.box = { middle: [0, 0.1, 0], size: 1.5 };
  view.now = 1;
  drawCloth();
}

function drawCloth() {
  if (!view) return;
  view.setPositions(cloth.x);
  view.setPoints(cloth.points, cloth.toi);
  view.draw();
}

async function step() {
  if (busy || !cloth) return;
  busy = true;
  const frame = await ask("step");
  busy = false;
  Object.assign(cloth, frame);
  if (shown !== "cloth") return;
  drawCloth();
  const { counts: { contacts, candidates } } = frame;
  const free = frame.free < 1 ? `${(100 * frame.free).toFixed(1)} % of the step` : "all of the step";
  table("cloth-numbers", [
    ["time", `${frame.seconds.toFixed(2)} s`],
    ["vertex-face contacts", count(contacts.vf)],
    ["edge-edge contacts", count(contacts.ee)],
    ["candidates of both", count(candidates.vf + candidates.ee)],
    ["free", free],
    ["one frame", ms(frame.total)],
    ["of it detection, 3 calls", ms(frame.detection)],
    ["backend", NAMES.cpu],
    ...stages(frame.ms).map(([name, value]) => [`last call: ${name}`, value]),
  ]);
}

function setRunning(on) {
  running = on;
  $("run").textContent = on ? "Pause" : "Run";
}

function everyFrame() {
  if (running && shown === "cloth") step().catch(failed);
  requestAnimationFrame(everyFrame);
}

const failed = (why) => { $("backend").textContent = `Error: ${why.message}`; setRunning(false); };
$("run").onclick = () => setRunning(!running);
$("step").onclick = () => { setRunning(false); step().catch(failed); };
$("restart").onclick = () => restart().catch(failed);
for (const id of sliders) {
  const tell = () => { $(`${id}-out`).textContent = $(id).value; };
  tell();
  $(id).oninput = tell;
  $(id).onchange = () => restart().catch(failed);
}

// Two meshes.
let files = [];
let result = null;

async function take(list) {
  $("error").textContent = "";
  const all = [...list];
  $("pick").value = "";
  if (all.length !== 2) {
    $("error").textContent = `Two files are needed, both at once; ${all.length} came.`;
    return;
  }
  // Frames in the order of their numbers.
  all.sort((p, q) => p.name.localeCompare(q.name, "en", { numeric: true }));
  const read = async (file) => ({ name: file.name, bytes: await file.arrayBuffer() });
  files = await Promise.all(all.map(read));
  await check();
}

async function check() {
  if (files.length !== 2) return;
  const exact = $("exact").checked;
  $("distance").disabled = exact;
  $("error").textContent = "";
  $("result").setAttribute("aria-busy", "true");
  try {
    const minDistance = exact ? 0 : Number($("distance").value);
    const mode = exact ? "exact" : "conservative";
    const device = $("gpu").checked ? "gpu" : "cpu";
    result = await ask("check", { files, minDistance, mode, device });
    $("result").hidden = false;
    tellResult();
    showFrames();
  } catch (why) {
    result = null;
    $("result").hidden = true;
    $("error").textContent = why.message;
  }
  $("result").removeAttribute("aria-busy");
}

function tellResult() {
  const { counts: { contacts, candidates }, toi, undecided, ms: t, loading, faces, x0 } = result;
  const [from, to] = files.map(({ name }) => name);
  $("first").textContent = toi === null
    ? `No contact from ${from} to ${to}.`
    : `From ${from} to ${to}: first contact after ${(100 * toi).toPrecision(3)} % of the step.`;
  $("jump").disabled = toi === null;
  $("time").value = toi ?? 1;
  const rows = [["particle-rod contacts", contacts.ve], ["particle contacts", contacts.vv]];
  table("files-numbers", [
    ["vertices", count(x0.length / 3)],
    ["faces", count(faces.length / 3)],
    ["vertex-face contacts", count(contacts.vf)],
    ["edge-edge contacts", count(contacts.ee)],
    ...rows.filter(([, n]) => n > 0).map(([name, n]) => [name, count(n)]),
    ["of these undecided", count(undecided)],
    ["candidates of both", count(candidates.vf + candidates.ee)],
    ["earliest time", toi === null ? "none" : String(toi)],
    ["loading", ms(loading)],
    ["detection", ms(t.total)],
    // Stages of a GPU are not timed apart.
    ...(result.backend === "gpu" ? [] : stages(t).map(([name, value]) => [`of it ${name}`, value])),
    ["backend", NAMES[result.backend]],
  ]);
  scrub();
}

function showFrames() {
  if (shown !== "files" || !view) return;
  if (!result) {
    view.nFaces = 0;
    view.nPoints = 0;
    view.draw();
    return;
  }
  view.setMesh(result.faces, result.x0.length / 3, result.x0.length);
  view.lookAt(result.x0);
  view.setPoints(result.points, result.times);
  scrub();
}

/** Positions at the time of the slider. */
function scrub() {
  const t = Number($("time").value);
  $("time-out").textContent = t.toPrecision(6);
  if (!result || !view || shown !== "files") return;
  const { x0, x1 } = result;
  view.setPositions(Float32Array.from(x0, (value, i) => value + t * (x1[i] - value)));
  view.now = t;
  view.draw();
}

$("time").oninput = scrub;
$("jump").onclick = () => { $("time").value = result.toi; scrub(); };
$("swap").onclick = () => { files.reverse(); check(); };
$("distance").onchange = check;
$("exact").onchange = check;
$("gpu").onchange = check;
$("pick").onchange = () => take($("pick").files);
$("example").onclick = () => {
  const { x0, x1, faces } = scene();
  take([x0, x1].map((x, i) => new File([obj(x, faces)], `example_${i}.obj`)));
};
$("download").onclick = async () => {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([await ask("csv")], { type: "text/csv" }));
  link.download = "contacts.csv";
  link.click();
  URL.revokeObjectURL(link.href);
};
// Files dropped beside the field must not replace the page.
for (const type of ["dragover", "dragleave", "drop"]) {
  addEventListener(type, (event) => {
    event.preventDefault();
    $("drop").classList.toggle("over", type === "dragover");
    if (type !== "drop" || !event.dataTransfer.files.length) return;
    show("files");
    take(event.dataTransfer.files);
  });
}

// Begin.
try {
  const { version, ms: loading } = await ask("load");
  $("backend").textContent = `Version ${version}, loaded in ${ms(loading)}. The cloth runs on the `
    + "CPU (wasm).";
  for (const id of ["run", "step", "restart", "example"]) $(id).disabled = false;
  setRunning(running);
  await restart();
  everyFrame();
} catch (why) {
  failed(why);
}
