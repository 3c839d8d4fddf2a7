// WebGPU under Node by Dawn's bindings: Chromium's WebGPU without Chromium, on any adapter that
// Dawn finds. `DAWN` is the folder of the npm package `webgpu`.

import assert from "node:assert/strict";
import { fork } from "node:child_process";
import { existsSync } from "node:fs";
import test, { after, before } from "node:test";
import { fileURLToPath } from "node:url";
import {
  checkClothBall, checkExample, checkLowered, checkSessions, clothBall, told,
} from "./expected.mjs";
import { environment, isFetched } from "./lavapipe.mjs";

const { DAWN } = process.env;
/** Longest time of a call: the first compiles all kernels, for 20 s on an idle machine. */
const ANSWER_MS = 240_000;
let child = null;
/** Why there is no adapter, if there is none. */
let missing = null;

/** Answer of a call of dawn.mjs, which is ended if it has none. */
function ask(call, given) {
  return new Promise((resolve, reject) => {
    const late = setTimeout(() => child.kill("SIGKILL"), ANSWER_MS);
    const ended = (code, signal) => reject(new Error(`dawn.mjs ended: ${signal ?? code}`));
    child.once("exit", ended);
    child.once("message", ({ found, error }) => {
      clearTimeout(late);
      child.off("exit", ended);
      if (error) reject(new Error(error));
      else resolve(found);
    });
    child.send({ call, given }, (why) => { if (why) reject(why); });
  });
}

before(async () => {
  if (!DAWN || !existsSync(DAWN)) {
    missing = "no Dawn: set DAWN to the folder of the npm package webgpu";
    return;
  }
  const program = fileURLToPath(new URL("./dawn.mjs", import.meta.url));
  child = fork(program, { env: { ...process.env, ...environment() }, execArgv: [] });
  missing = await ask("open", DAWN);
  // An adapter that was fetched for this has to be taken.
  if (/no adapter/.test(missing) && isFetched()) throw new Error(`${missing} in target/lavapipe`);
});
after(() => child?.kill("SIGKILL"));

/** A test that needs a device, and all that `why` says it lacks. */
const onDevice = (name, call, why = () => null) => test(name, { timeout: 300_000 }, (t) => {
  const lacks = missing ?? why();
  if (!lacks) return call(t);
  console.log(`SKIPPED: ${name}: ${lacks}`);
  return t.skip(lacks);
});

onDevice("steps on a device are those of the CPU, by every call", async () => {
  checkExample(await ask("compareExample"));
  checkLowered(await ask("compareExample", { lower: 0.01 }));
});

onDevice("two sessions in flight, changes, refused input", async () => {
  checkSessions(await ask("compareSessions"));
});

onDevice("a lost device is an error, and the next session has another", async () => {
  const { errors, onCpu, contacts, opened } = await ask("lose");
  for (const error of errors) assert.match(error, /the device was lost/);
  assert.deepEqual([onCpu, ...contacts], [251, 251, 251]);
  assert.equal(opened, 1);
});

onDevice("cloth-ball on a device", async (t) => {
  const found = await ask("compareFrames");
  checkClothBall(found);
  told(t, "Node, Dawn", found);
}, () => {
  const whole = process.env.CCD_WHOLE;
  return whole ? clothBall().missing : "half a minute on an adapter of software: set CCD_WHOLE=1";
});

onDevice("where a device is lost, the CPU takes over a session of `auto`", async () => {
  const found = await ask("loseFreely");
  const { refused, times, backends, contacts, backend, why } = found;
  // Input that the CPU refuses as well costs no session its GPU.
  assert.match(refused[0], /^vertex 2 at t1 has y = NaN/);
  assert.match(refused[1], /^x1 has 30000 numbers/);
  assert.deepEqual(backends, ["gpu", "cpu"]);
  assert.deepEqual(contacts, [1, 1]);
  assert.equal(backend, "cpu");
  assert.match(why, /the device was lost/);
  for (const [toi, want, after] of times) {
    assert.ok(want > 0.49 && Math.abs(toi - want) < 1e-6, `${toi}, not ${want}`);
    assert.equal(after, "cpu");
  }
});

// The last one: there are no more sessions on a device afterwards.
onDevice("an exception in the module is an error of its calls", async () => {
  const { errors, onCpu, uncaught } = await ask("end");
  for (const error of errors) assert.match(error, /^the GPU module ended: /);
  assert.equal(onCpu, 251);
  assert.ok(uncaught.length > 0);
});
