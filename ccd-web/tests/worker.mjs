// A worker that answers with the earliest time of a step.

import { parentPort, workerData } from "node:worker_threads";
import { init, Mesh, Session } from "../pkg/index.js";

await init(workerData);
const session = new Session(new Mesh(4, null, [0, 1, 2]));
parentPort.on("message", ({ x0, x1 }) => parentPort.postMessage(session.earliestToi(x0, x1)));
