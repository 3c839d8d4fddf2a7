// The page in Chromium and in Firefox: the cloth, two files, the download, the keyboard, contrast,
// two widths. Screenshots go to the folder SCREENSHOTS, if it is set.

import assert from "node:assert/strict";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test, { after, before } from "node:test";
import puppeteer from "puppeteer-core";
import { obj, scene } from "../page/example.js";
import { serve } from "./serve.mjs";

const BROWSERS = {
  chrome: {
    paths: [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/google-chrome"],
    args: ["--headless=new", "--no-sandbox", "--enable-unsafe-webgpu",
      "--use-webgpu-adapter=swiftshader", "--enable-unsafe-swiftshader"],
  },
  firefox: { paths: [process.env.FIREFOX, "/usr/bin/firefox-esr", "/usr/bin/firefox"], args: [] },
};

let server;
const folder = mkdtempSync(join(tmpdir(), "meshccd-"));
const files = ["frame_1.obj", "frame_2.obj"].map((name) => join(folder, name));
before(async () => {
  server = await serve();
  const { x0, x1, faces } = scene();
  [x0, x1].forEach((x, i) => writeFileSync(files[i], obj(x, faces)));
});
after(() => {
  server.close();
  rmSync(folder, { recursive: true });
});

for (const [browser, { paths, args }] of Object.entries(BROWSERS)) {
  test(`the page in ${browser}`, { timeout: 180_000 }, async (t) => {
    const executablePath = paths.find((path) => path && existsSync(path));
    if (!executablePath) {
      t.skip(`there is no ${browser}: none of ${paths.filter(Boolean).join(", ")}`);
      return;
    }
    const options = { browser, executablePath, args, headless: true, protocolTimeout: 120_000 };
    const window = await puppeteer.launch(options);
    try {
      await visit(await window.newPage(), browser);
    } finally {
      await window.close();
    }
  });
}

async function visit(page, browser) {
  const wrong = [];
  page.on("pageerror", (why) => wrong.push(String(why)));
  page.on("console", (message) => {
    if (message.type() === "error") wrong.push(message.text());
  });
  await page.setViewport({ width: 1280, height: 900 });
  await page.goto(server.url);
  const text = (id) => page.$eval(`#${id}`, (element) => element.textContent);
  const shot = async (name) => {
    if (!process.env.SCREENSHOTS) return;
    mkdirSync(process.env.SCREENSHOTS, { recursive: true });
    const path = join(process.env.SCREENSHOTS, `${browser}-${name}.png`);
    await page.screenshot({ path, fullPage: true });
  };
  const fits = () => page.evaluate(() => document.documentElement.scrollWidth <= innerWidth);

  // The cloth: smaller, for machines without a GPU; contacts within some frames.
  await page.waitForFunction(() => /runs on the CPU/.test(document.body.textContent));
  await set(page, "n", 20);
  await page.waitForFunction(() => (
    /vertex-face contacts[1-9]/.test(document.querySelector("#cloth-numbers").textContent)
  ), { timeout: 60_000 });
  assert.match(await text("cloth-numbers"), /decisions[\d.]+ ms/);
  await shot("cloth-1280");
  await page.click("#run");
  assert.equal(await text("run"), "Run");
  const seconds = async () => Number(/time([\d.]+) s/.exec(await text("cloth-numbers"))[1]);
  await new Promise((resolve) => setTimeout(resolve, 300));
  const then = await seconds();
  await page.click("#step");
  await page.waitForFunction((t) => (
    Number(/time([\d.]+) s/.exec(document.querySelector("#cloth-numbers").textContent)[1]) > t
  ), {}, then);

  // By the keyboard: from tab to tab, with a focus that is seen.
  await page.focus("#tab-cloth");
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.evaluate(() => document.activeElement.id), "tab-files");
  const { outlineStyle, outlineWidth } = await page.evaluate(() => {
    const { outlineStyle, outlineWidth } = getComputedStyle(document.activeElement);
    return { outlineStyle, outlineWidth };
  });
  assert.ok(outlineStyle !== "none" && parseFloat(outlineWidth) > 0, `outline: ${outlineWidth}`);

  // A file alone, then two.
  await (await page.$("#pick")).uploadFile(files[0]);
  await page.waitForFunction(() => /Two files/.test(document.querySelector("#error").textContent));
  await drop(page, files);
  await page.waitForFunction(() => document.querySelector("#first").textContent);
  assert.equal(await text("error"), "");
  assert.match(await text("first"), /first contact after 29.2 % of the step/);
  assert.match(await text("files-numbers"), /vertex-face contacts112edge-edge contacts139/);
  assert.match(await text("files-numbers"), /earliest time0.2923914/);
  assert.match(await text("time-out"), /^0.292391$/);
  await shot("files-1280");
  await page.focus("#time");
  await page.keyboard.press("End");
  assert.equal(await text("time-out"), "1.00000");
  await page.click("#jump");
  assert.match(await text("time-out"), /^0.292391$/);

  // The rows of the download are those of the native command.
  const csv = await downloaded(page);
  const want = readFileSync(new URL("./data/contacts.csv", import.meta.url), "utf8");
  const head = (rows) => rows.trim().split("\n").map((row) => row.split(",").slice(0, 10).join());
  assert.deepEqual(head(csv), head(want));

  // Exact: none is undecided.
  await page.click("#exact");
  await page.waitForFunction(() => (
    /of these undecided0/.test(document.querySelector("#files-numbers").textContent)
  ));

  assert.deepEqual(await poorContrast(page), []);
  await page.setViewport({ width: 390, height: 844 });
  assert.ok(await fits(), "the page is wider than a phone");
  await shot("files-390");
  await page.click("#tab-cloth");
  await page.click("#step");
  assert.ok(await fits(), "the page is wider than a phone");
  assert.deepEqual(await poorContrast(page), []);
  await shot("cloth-390");
  assert.deepEqual(wrong, []);
}

/** Moves a slider. */
function set(page, id, value) {
  return page.$eval(`#${id}`, (input, to) => {
    input.value = to;
    input.dispatchEvent(new Event("input"));
    input.dispatchEvent(new Event("change"));
  }, value);
}

/** Drops files onto the page. */
function drop(page, paths) {
  const all = paths.map((path) => (
    { name: path.split("/").at(-1), text: readFileSync(path, "utf8") }
  ));
  return page.evaluate((given) => {
    const dataTransfer = new DataTransfer();
    given.forEach(({ name, text }) => dataTransfer.items.add(new File([text], name)));
    const target = document.querySelector("#drop");
    target.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  }, all);
}

/** Text of the file that the button downloads, taken from the link instead of from the disk. */
function downloaded(page) {
  return page.evaluate(() => new Promise((resolve) => {
    const click = HTMLAnchorElement.prototype.click;
    HTMLAnchorElement.prototype.click = function () {
      HTMLAnchorElement.prototype.click = click;
      if (this.download !== "contacts.csv") throw new Error(this.download);
      fetch(this.href).then((response) => response.text()).then(resolve);
    };
    document.querySelector("#download").click();
  }));
}

/** Texts whose contrast is below 4.5 (WCAG 2 AA), buttons that are off apart. */
function poorContrast(page) {
  return page.evaluate(() => {
    const rgb = (colour) => colour.match(/[\d.]+/g).map(Number);
    const luminance = (colour) => rgb(colour).slice(0, 3).map((c) => c / 255)
      .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
      .reduce((sum, c, k) => sum + c * [0.2126, 0.7152, 0.0722][k], 0);
    const behind = (element) => {
      for (let at = element; at; at = at.parentElement) {
        const colour = getComputedStyle(at).backgroundColor;
        if ((rgb(colour)[3] ?? 1) > 0) return colour;
      }
      return "rgb(255, 255, 255)";
    };
    const own = (element) => [...element.childNodes].some((n) => n.nodeType === 3 && n.data.trim());
    return [...document.querySelectorAll("body *")]
      .filter((element) => own(element) && element.checkVisibility() && !element.disabled)
      .filter((element) => {
        const both = [getComputedStyle(element).color, behind(element)].map(luminance).sort();
        return (both[1] + 0.05) / (both[0] + 0.05) < 4.5;
      })
      .map((element) => element.textContent.trim());
  });
}
