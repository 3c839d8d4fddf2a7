// Reads WGSL files with Tint, the compiler of Chromium's WebGPU, through Dawn's bindings for Node, on no device at all. Fails if it refuses one.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [dawn, ...files] = process.argv.slice(2);
const { create } = await import(pathToFileURL(`${dawn}/index.js`));
// Kept: what it gives does not outlive it.
const gpu = create(["backend=null"]);
const adapter = await gpu.requestAdapter();
const device = await adapter.requestDevice();
let refused = 0;
for (const file of files) {
  device.pushErrorScope("validation");
  const module = device.createShaderModule({ code: readFileSync(file, "utf8") });
  const { messages } = await module.getCompilationInfo();
  await device.popErrorScope();
  if (messages.some((m) => m.type === "error")) {
    refused += 1;
    messages.forEach((m) => console.error(`${file}:${m.lineNum}: ${m.type}: ${m.message}`));
  }
}
device.destroy();
process.exitCode = refused === 0 ? 0 : 1;
