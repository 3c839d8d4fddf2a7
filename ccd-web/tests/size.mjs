// Sizes of the package, compressed: an error above the bar.

import { readFileSync } from "node:fs";
import { brotliCompressSync, gzipSync } from "node:zlib";

/** Bytes that module and bindings may have together, by gzip, which every server has. */
const BAR = 400_000;

const compressed = (names) => {
  const files = names.map((name) => readFileSync(new URL(`../pkg/${name}`, import.meta.url)));
  const sum = (of) => files.reduce((all, bytes) => all + of(bytes).length, 0);
  const gzip = sum((bytes) => gzipSync(bytes, { level: 9 }));
  const [raw, brotli] = [sum((bytes) => bytes), sum((bytes) => brotliCompressSync(bytes))];
  return { gzip, text: `${raw} bytes, ${gzip} by gzip, ${brotli} by brotli` };
};
const names = ["meshccd_bg.wasm", "meshccd.js", "index.js", "input.js", "output.js"];
const { gzip, text } = compressed(names);
console.log(`npm package: ${text}; bar ${BAR} by gzip`);
const kernels = compressed(["meshccd_gpu_bg.wasm", "meshccd_gpu.js", "gpu.js"]);
console.log(`.. fetched for a GPU alone: ${kernels.text}`);
if (gzip > BAR) process.exitCode = 1;
