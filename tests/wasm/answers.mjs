// Prints the answers of every scene by every way of finding pairs, as `tests/answers.rs` does, from the
// module that is named; and checks what is different on WebAssembly: threads and times.
import { readFileSync } from "node:fs";

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), {});
const { n_scenes, n_ways, answer, n_contacts, milliseconds, threads } = instance.exports;
// What comes back as 64 bits is signed here.
const unsigned = (x) => BigInt.asUintN(64, x);

for (let scene = 0; scene < n_scenes(); scene++) {
  console.log(`scene ${scene}: ${unsigned(n_contacts(scene))} contacts`);
  for (let way = 0; way < n_ways(); way++) {
    const inF32 = (scene + way) % 2;
    const found = unsigned(answer(scene, way, inF32, 1));
    console.log(`${scene} ${way} ${inF32} ${found.toString(16).padStart(16, "0")}`);
  }
  // 0 threads: as many as there can be, which is the calling one.
  check(answer(scene, 0, 0, 0) === answer(scene, 0, 0, 1), "0 threads are 1 thread");
  check(milliseconds(scene) === 0, "there is no clock");
}
check(threads(0) === 1 && threads(1) === 1, "there is one thread");
check(threads(2) === 0, "two threads are refused");

function check(holds, what) {
  if (!holds) {
    console.error(`not so: ${what}`);
    process.exitCode = 1;
  }
}
