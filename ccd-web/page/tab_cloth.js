// The tab with the falling cloth, which the worker moves.

import { $, ask, count, ms, NAMES, onEnded, stages, table } from "./page.js";

const SLIDERS = ["n", "thickness", "stiffness"];

/** `view`: the picture, or null; `isShown`: whether this tab is. */
export function clothTab(view, isShown) {
  let running = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  let cloth = null;
  /** Questions in flight. */
  let pending = 0;
  let ready = "";
  onEnded(() => { cloth = null; });

  const parameters = () => ({
    n: Number($("n").value),
    thickness: Number($("thickness").value) / 1000,
    stiffness: Number($("stiffness").value),
  });

  /** What the worker answers; the next one is asked after this one. */
  async function alone(call, given) {
    pending += 1;
    try {
      return await ask(call, given);
    } finally {
      pending -= 1;
    }
  }

  async function restart() {
    const given = parameters();
    // Where it fails, the next step begins with another one.
    cloth = null;
    const made = await alone("cloth", given);
    cloth = { ...made, points: new Float32Array(), toi: new Float64Array() };
    $("backend").textContent = ready;
    const most = `${(1000 * cloth.thickness).toFixed(1)}, the most for so many vertices`;
    const asked = (1000 * given.thickness).toFixed(0);
    $("thickness-out").textContent = cloth.thickness < given.thickness ? most : asked;
    draw();
  }

  function draw() {
    if (!isShown() || !cloth || !view) return;
    view.setMesh(cloth.faces, cloth.x.length / 3, cloth.nFirst);
    view.box = { middle: [0, 0.1, 0], size: 1.5 };
    view.now = 1;
    drawStep();
  }

  function drawStep() {
    if (!view) return;
    view.setPositions(cloth.x);
    view.setPoints(cloth.points, cloth.toi);
    view.draw();
  }

  async function step() {
    if (pending) return;
    if (!cloth) {
      await restart();
      return;
    }
    const mine = cloth;
    const frame = await alone("step");
    // Another one is on its way.
    if (mine !== cloth) return;
    Object.assign(cloth, frame);
    if (isShown()) tell(frame);
    if (frame.isGone) await restart();
  }

  function tell(frame) {
    drawStep();
    const { counts: { contacts, candidates } } = frame;
    const part = `${(100 * frame.free).toFixed(1)} % of the step`;
    table("cloth-numbers", [
      ["time", `${frame.seconds.toFixed(2)} s`],
      ["vertex-face contacts", count(contacts.vf)],
      ["edge-edge contacts", count(contacts.ee)],
      ["candidates of both", count(candidates.vf + candidates.ee)],
      ["free", frame.free < 1 ? part : "all of the step"],
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
    if (running && isShown()) step().catch(failed);
    requestAnimationFrame(everyFrame);
  }

  function failed(why) {
    $("backend").textContent = `Error: ${why.message}`;
    setRunning(false);
  }

  $("run").onclick = () => setRunning(!running);
  $("step").onclick = () => { setRunning(false); step().catch(failed); };
  $("restart").onclick = () => restart().catch(failed);
  for (const id of SLIDERS) {
    const tellValue = () => { $(`${id}-out`).textContent = $(id).value; };
    tellValue();
    $(id).oninput = tellValue;
    $(id).onchange = () => { tellValue(); restart().catch(failed); };
  }

  return {
    draw,
    failed,
    /** Begins, once the module is loaded; `text`: what the head of the page says then. */
    async begin(text) {
      ready = text;
      setRunning(running);
      const made = restart();
      everyFrame();
      await made;
    },
  };
}
