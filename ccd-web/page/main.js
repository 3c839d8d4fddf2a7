// The page: its tabs, the picture, and what it says of this browser. What is computed runs in
// worker.js.

import { picture } from "./draw.js";
import { $, ask, ms } from "./page.js";
import { clothTab } from "./tab_cloth.js";
import { filesTab } from "./tab_files.js";

const view = picture($("canvas"), {
  lost() {
    $("lost").hidden = false;
  },
  restored() {
    $("lost").hidden = true;
    show(shown);
  },
});
$("no-webgl").hidden = view !== null;
$("canvas").hidden = view === null;
$("legend").hidden = view === null;
$("webgpu").textContent = navigator.gpu
  ? "This browser has WebGPU: two meshes can be checked there."
  : "This browser has no WebGPU here, so two meshes are checked on the CPU as well.";
$("gpu").disabled = !navigator.gpu;

let shown = "cloth";
const tabs = {
  cloth: clothTab(view, () => shown === "cloth"),
  files: filesTab(view, () => shown === "files"),
};
const names = Object.keys(tabs);
function show(tab) {
  shown = tab;
  for (const name of names) {
    $(name).hidden = name !== tab;
    $(`tab-${name}`).setAttribute("aria-selected", name === tab);
    $(`tab-${name}`).tabIndex = name === tab ? 0 : -1;
  }
  tabs[tab].draw();
}
names.forEach((name, i) => {
  $(`tab-${name}`).onclick = () => show(name);
  // By arrow keys as well.
  $(`tab-${name}`).onkeydown = ({ key }) => {
    if (key !== "ArrowLeft" && key !== "ArrowRight") return;
    show(names[1 - i]);
    $(`tab-${names[1 - i]}`).focus();
  };
});
// Files dropped beside the field must not replace the page.
for (const type of ["dragover", "dragleave", "drop"]) {
  addEventListener(type, (event) => {
    event.preventDefault();
    $("drop").classList.toggle("over", type === "dragover");
    if (type !== "drop" || !event.dataTransfer.files.length) return;
    show("files");
    tabs.files.take(event.dataTransfer.files);
  });
}

// Begin.
try {
  const { version, ms: loading } = await ask("load");
  for (const id of ["run", "step", "restart", "example"]) $(id).disabled = false;
  await tabs.cloth.begin(`Version ${version}, loaded in ${ms(loading)}. The cloth runs on the CPU `
    + "(wasm).");
} catch (why) {
  tabs.cloth.failed(why);
}
