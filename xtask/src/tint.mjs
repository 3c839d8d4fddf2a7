// Reads the WGSL files of a folder that its manifest says are for browsers, with Tint, the compiler
// of Chromium's WebGPU, through Dawn's bindings for Node, on no device at all. Status 1 if it
// refuses one, 3 if the bindings do not load.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [dawn, folder] = process.argv.slice(2);
const { kernels } = JSON.parse(readFileSync(`${folder}/manifest.json`, "utf8"));
const portable = kernels.filter((kernel) => !kernel.wide && !kernel.native);
// Kept: what it gives does not outlive it.
const gpu = await load();
const adapter = await gpu.requestAdapter();
const device = await adapter.requestDevice();
let refused = 0;
for (const { name } of portable) {
  const file = `${folder}/${name}.wgsl`;
  device.pushErrorScope("validation");
  const module = device.createShaderModule({ code: readFileSync(file, "utf8") });
  const { messages } = await module.getCompilationInfo();
  const error = await device.popErrorScope();
  const errors = messages.filter((m) => m.type === "error");
  if (errors.length > 0 || error) {
    refused += 1;
    errors.forEach((m) => console.error(`${file}:${m.lineNum}: ${m.type}: ${m.message}`));
    if (errors.length === 0) console.error(`${file}: ${error.message}`);
  }
}
device.destroy();
const counts = `${portable.length} of ${kernels.length} kernels`;
console.log(`${counts}, all portable ones that do without f64`);
process.exitCode = refused === 0 && portable.length > 0 ? 0 : 1;

async function load() {
  try {
    const { create } = await import(pathToFileURL(`${dawn}/index.js`));
    return create(["backend=null"]);
  } catch (why) {
    console.error(String(why.message ?? why));
    process.exit(3);
  }
}
