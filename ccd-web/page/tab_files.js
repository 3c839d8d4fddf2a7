// The tab with two frames of a mesh: files are chosen or dropped, and the worker checks them.

import { obj, scene } from "./example.js";
import { inOrder } from "./order.js";
import { $, ask, count, ms, NAMES, stages, table } from "./page.js";

/** `view`: the picture, or null; `isShown`: whether this tab is. */
export function filesTab(view, isShown) {
  let files = [];
  let result = null;
  /** Numbers of the last files and of the last check: what answers an earlier one is not shown. */
  let [taken, checked] = [0, 0];

  async function take(list) {
    const mine = ++taken;
    $("error").textContent = "";
    try {
      const all = [...list];
      $("pick").value = "";
      if (all.length !== 2) {
        throw new Error(`Two files are needed, both at once; ${all.length} came.`);
      }
      const frames = await Promise.all(inOrder(all).map(read));
      if (mine !== taken) return;
      files = frames;
    } catch (why) {
      if (mine === taken) fail(why);
      return;
    }
    await check();
  }

  async function read(file) {
    try {
      return { name: file.name, bytes: await file.arrayBuffer() };
    } catch (why) {
      throw new Error(`${file.name} cannot be read; is it a folder? ${why.message}`);
    }
  }

  async function check() {
    if (files.length !== 2) return;
    const [mine, asked] = [++checked, files.slice()];
    const exact = $("exact").checked;
    $("distance").disabled = exact;
    $("error").textContent = "";
    $("result").setAttribute("aria-busy", "true");
    try {
      const minDistance = exact ? 0 : Number($("distance").value);
      const mode = exact ? "exact" : "auto";
      const device = $("gpu").checked ? "gpu" : "cpu";
      const given = { check: mine, files: asked, minDistance, mode, device };
      const found = await ask("check", given);
      if (mine !== checked) return;
      result = { ...found, check: mine, names: asked.map(({ name }) => name) };
    } catch (why) {
      if (mine === checked) fail(why);
      return;
    }
    $("result").removeAttribute("aria-busy");
    $("result").hidden = false;
    tell();
    draw();
  }

  /** Says what went wrong, instead of a result; answers of earlier checks are not shown. */
  function fail(why) {
    checked += 1;
    result = null;
    $("result").removeAttribute("aria-busy");
    $("result").hidden = true;
    $("first").textContent = "";
    $("error").textContent = why.message;
    draw();
  }

  function tell() {
    const { counts: { contacts, candidates }, toi, undecided, ms: t, loading, faces, x0 } = result;
    const [from, to] = result.names;
    $("which").textContent = `Start: ${from}, end: ${to}`;
    $("first").textContent = toi === null
      ? `No contact from ${from} to ${to}.`
      : `From ${from} to ${to}: first contact after ${(100 * toi).toPrecision(3)} % of the step.`;
    $("jump").disabled = toi === null;
    $("time").value = toi ?? 1;
    const rows = [["particle-rod contacts", contacts.ve], ["particle contacts", contacts.vv]];
    // Stages of a GPU are not timed apart.
    const parts = result.backend === "gpu" ? [] : stages(t);
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
      ...parts.map(([name, value]) => [`of it ${name}`, value]),
      ["backend", NAMES[result.backend]],
    ]);
    scrub();
  }

  function draw() {
    if (!isShown() || !view) return;
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
    if (!result || !view || !isShown()) return;
    const { x0, x1 } = result;
    view.setPositions(Float32Array.from(x0, (value, i) => value + t * (x1[i] - value)));
    view.now = t;
    view.draw();
  }

  async function download() {
    const { check: number } = result;
    try {
      const text = await ask("csv", { check: number });
      const link = document.createElement("a");
      link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
      link.download = "contacts.csv";
      link.click();
      URL.revokeObjectURL(link.href);
    } catch (why) {
      if (number === checked) fail(why);
    }
  }

  $("time").oninput = scrub;
  $("jump").onclick = () => { $("time").value = result.toi; scrub(); };
  $("swap").onclick = () => { files.reverse(); check(); };
  $("distance").onchange = check;
  $("exact").onchange = check;
  $("gpu").onchange = check;
  $("pick").onchange = () => take($("pick").files);
  $("download").onclick = download;
  $("example").onclick = () => {
    const { x0, x1, faces } = scene();
    take([x0, x1].map((x, i) => new File([obj(x, faces)], `example_${i}.obj`)));
  };
  return { draw, take };
}
