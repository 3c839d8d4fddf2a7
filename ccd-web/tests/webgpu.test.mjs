// WebGPU in Chromium, played by SwiftShader: what a browser without a GPU compiles within minutes.
// Kernels of filters and decisions are not among that: whole steps are in steps.test.mjs.

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import test from "node:test";
import puppeteer from "puppeteer-core";
import { serve } from "./serve.mjs";

const PATHS = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/google-chrome"];
const WITH = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader",
  "--enable-unsafe-swiftshader"];

/** Calls a function in a page that has the package, in a browser with these arguments. */
async function inBrowser(t, args, call) {
  const executablePath = PATHS.find((path) => path && existsSync(path));
  if (!executablePath) {
    t.skip(`there is no Chromium: none of ${PATHS.filter(Boolean).join(", ")}`);
    return;
  }
  const server = await serve();
  const all = ["--headless=new", "--no-sandbox", "--disable-gpu-watchdog", ...args];
  const options = { executablePath, args: all, headless: true, protocolTimeout: 500_000 };
  const browser = await puppeteer.launch(options);
  try {
    const page = await browser.newPage();
    await page.goto(server.url.replace("/page/", "/pkg/package.json"));
    await call(page);
  } finally {
    await browser.close();
    server.close();
  }
}

test("sessions are opened on a GPU where there is one", { timeout: 120_000 }, (t) => (
  inBrowser(t, WITH, async (page) => {
    const found = await page.evaluate(async () => {
      const { init, Mesh, Session } = await import("/pkg/index.js");
      await init();
      const small = new Mesh(4, null, [0, 1, 2]);
      const strips = Array.from({ length: 10_001 }, (_, v) => [v, v + 1, v + 2]);
      const large = new Mesh(10_003, null, strips);
      const open = async (mesh, device) => {
        const { backend, whyCpu } = await Session.open(mesh, { device });
        return [backend, whyCpu];
      };
      const gpu = await Session.open(small, { device: "gpu" });
      const [x0, x1] = [1, -1].map((y) => (
        new Float32Array([0, 0, 0, 1, 0, 0, 0, 0, 1, 0.2, y, 0.2])
      ));
      const toi = gpu.earliestToi(x0, x1);
      gpu.setMinDistance(0.1);
      gpu.free();
      return [gpu.backend, toi, await open(small, "auto"), await open(large, "auto")];
    });
    const [backend, toi, small, large] = found;
    assert.equal(backend, "gpu");
    assert.ok(Math.abs(toi - 0.5) < 1e-5, "calls that return at once run on the CPU");
    assert.deepEqual(small, ["cpu", "the mesh has fewer than 20000 edges"]);
    assert.deepEqual(large, ["cpu", "the browser's GPU is played by the CPU"]);
  })
));

test("pairs of boxes on the device are those of brute force", { timeout: 500_000 }, (t) => (
  inBrowser(t, WITH, async (page) => {
    const found = await page.evaluate(async () => {
      const { default: load, RawDevice } = await import("/pkg/meshccd_gpu.js");
      await load({ module_or_path: "/pkg/meshccd_gpu_bg.wasm" });
      const device = await RawDevice.open();
      let state = 1;
      const random = () => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return state / 2 ** 32;
      };
      /** Boxes of a size, and how many pairs overlap. */
      const boxes = (n, size) => {
        const all = Array.from({ length: n }, () => [random(), random(), random()].map(Math.fround));
        const bounds = all.flatMap((min) => [...min, ...min.map((c) => Math.fround(c + size))]);
        const meets = (i, j) => [0, 1, 2].every((k) => (
          bounds[6 * i + k] <= bounds[6 * j + 3 + k] && bounds[6 * j + k] <= bounds[6 * i + 3 + k]
        ));
        const pairs = [];
        for (let i = 0; i < n; i++) {
          for (let j = i + 1; j < n; j++) if (meets(i, j)) pairs.push(`${i} ${j}`);
        }
        return { bounds: Float32Array.from(bounds), pairs: pairs.sort() };
      };
      const strings = (ids) => Array.from({ length: ids.length / 2 }, (_, i) => (
        [ids[2 * i], ids[2 * i + 1]].sort((p, q) => p - q).join(" ")
      )).sort();
      // The second has more pairs than there is room at first, and runs again.
      const scenes = [boxes(1000, 0.1), boxes(500, 1)];
      const wrong = [];
      const compare = async ({ bounds, pairs }) => {
        const got = strings(await device.box_pairs(bounds));
        if (got.join() !== pairs.join()) wrong.push(`${got.length} of ${pairs.length}`);
        return pairs.length;
      };
      const one = await compare(scenes[0]);
      // Two in flight at once.
      const both = await Promise.all(scenes.map(compare));
      return { wrong, counts: [one, ...both] };
    });
    assert.deepEqual(found.wrong, []);
    assert.ok(found.counts[0] > 1000 && found.counts[2] > 65_536, String(found.counts));
  })
));

test("without WebGPU the CPU answers, and says why", { timeout: 120_000 }, (t) => (
  inBrowser(t, ["--disable-features=WebGPU", "--disable-gpu"], async (page) => {
    const [auto, gpu] = await page.evaluate(async () => {
      const { init, Mesh, Session } = await import("/pkg/index.js");
      await init();
      const strips = Array.from({ length: 10_001 }, (_, v) => [v, v + 1, v + 2]);
      const mesh = new Mesh(10_003, null, strips);
      const { backend, whyCpu } = await Session.open(mesh);
      const refused = await Session.open(mesh, { device: "gpu" }).catch((why) => why.message);
      return [`${backend}: ${whyCpu}`, refused];
    });
    assert.match(auto, /^cpu: .*(no WebGPU|no GPU)/);
    assert.match(gpu, /no WebGPU|no GPU/);
  })
));
