// Whole steps by WebGPU in browsers: in Firefox, whose WebGPU is wgpu, on the system's adapter; in
// Chromium, whose WebGPU is Dawn, on lavapipe in place of SwiftShader, which compiles filters for
// hours. And the page with a GPU in use. Screenshots go to the folder SCREENSHOTS, if it is set.

import assert from "node:assert/strict";
import { existsSync, mkdirSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import puppeteer from "puppeteer-core";
import {
  checkClothBall, checkExample, checkLowered, checkSessions, clothBall, told,
} from "./expected.mjs";
import { chromiumOnLavapipe, environment } from "./lavapipe.mjs";
import { serve } from "./serve.mjs";

const NOTHING = () => {};
/** Browsers: where they may be, and how they are launched with WebGPU. */
const BROWSERS = {
  firefox: {
    paths: [process.env.FIREFOX, "/usr/bin/firefox-esr", "/usr/bin/firefox"],
    launch: (executablePath) => ({
      browser: "firefox",
      executablePath,
      extraPrefsFirefox: { "dom.webgpu.enabled": true, "gfx.webgpu.ignore-blocklist": true },
      remove: NOTHING,
    }),
  },
  chromium: {
    paths: [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/google-chrome"],
    launch: (program) => ({
      args: ["--headless=new", "--no-sandbox", "--disable-gpu-watchdog", "--enable-unsafe-webgpu",
        "--use-webgpu-adapter=swiftshader", "--enable-unsafe-swiftshader"],
      ...chromiumOnLavapipe(program),
    }),
  },
};

for (const [name, { paths, launch }] of Object.entries(BROWSERS)) {
  test(`whole steps on a device in ${name}`, { timeout: 900_000 }, async (t) => {
    const skip = (why) => {
      console.log(`SKIPPED: whole steps in ${name}: ${why}`);
      t.skip(why);
    };
    const program = paths.find((path) => path && existsSync(path));
    if (!program) return skip(`none of ${paths.filter(Boolean).join(", ")} is there`);
    let how;
    try {
      how = launch(program);
    } catch (why) {
      return skip(why.message);
    }
    const { remove, env, ...options } = how;
    const server = await serve();
    const all = { ...process.env, ...env };
    const browser = await puppeteer.launch(
      { ...options, env: all, headless: true, protocolTimeout: 600_000 },
    );
    try {
      await t.test("steps", (part) => steps(part, browser, server, name));
      await t.test("the page", () => page(browser, server, name));
    } finally {
      await browser.close();
      server.close();
      remove();
    }
  });
}

async function steps(t, browser, server, name) {
  const window = await browser.newPage();
  await window.goto(server.url.replace("/page/", "/pkg/package.json"));
  /** Calls a function of steps.mjs there. */
  const run = (call, ...given) => window.evaluate(async (called, ...rest) => {
    const meshccd = await import("/pkg/index.js");
    await meshccd.init();
    return (await import("/tests/steps.mjs"))[called](meshccd, ...rest);
  }, call, ...given);
  const begun = performance.now();
  checkExample(await run("compareExample"));
  t.diagnostic(`${name}: the example in ${((performance.now() - begun) / 1000).toFixed(1)} s, `
    + "with the compilation of kernels");
  checkLowered(await run("compareExample", { lower: 0.01 }));
  checkSessions(await run("compareSessions"));
  const { files, missing } = clothBall();
  if (missing) {
    t.diagnostic(`without cloth-ball: ${missing}`);
    return;
  }
  files.forEach((bytes, i) => server.files.set(`/frame_${i}.ply`, bytes));
  const found = await run("compareServed", ["/frame_0.ply", "/frame_1.ply"]);
  checkClothBall(found);
  told(t, name, found);
  await window.close();
}

/** The example on the page, with the box for the GPU set. */
async function page(browser, server, name) {
  const window = await browser.newPage();
  const wrong = [];
  window.on("pageerror", (why) => wrong.push(String(why)));
  await window.setViewport({ width: 1280, height: 900 });
  await window.goto(server.url);
  await window.waitForFunction(() => /runs on the CPU/.test(document.body.textContent));
  await window.click("#tab-files");
  const numbers = () => window.$eval("#files-numbers", (element) => element.textContent);
  const backend = async (text) => {
    await window.waitForFunction((want) => (
      document.querySelector("#error").textContent
        || document.querySelector("#files-numbers").textContent.endsWith(want)
    ), { timeout: 120_000 }, text);
    assert.equal(await window.$eval("#error", (element) => element.textContent), "");
    return (await numbers()).replace(/loading.*/, "");
  };
  await window.click("#example");
  const cpu = await backend("backendCPU (WebAssembly)");
  await window.click("#gpu");
  const gpu = await backend("backendGPU (WebGPU)");
  const untimed = (text) => text.replace(/earliest time([\d.]+)/, "");
  assert.equal(untimed(gpu), untimed(cpu));
  assert.match(gpu, /vertex-face contacts112edge-edge contacts139of these undecided0/);
  if (process.env.SCREENSHOTS) {
    mkdirSync(process.env.SCREENSHOTS, { recursive: true });
    const path = join(process.env.SCREENSHOTS, `${name}-gpu.png`);
    await window.screenshot({ path, fullPage: true });
  }
  assert.deepEqual(wrong, []);
}
