// The software Vulkan adapter for WebGPU: the one that `.ci/lavapipe` fetches where the system's is
// too old for Dawn. And Chromium on it, which takes no CPU as a GPU but SwiftShader.

import { execFileSync } from "node:child_process";
import {
  copyFileSync, existsSync, linkSync, mkdtempSync, readdirSync, realpathSync, rmSync, symlinkSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const FOLDER = fileURLToPath(new URL("../../target/lavapipe/", import.meta.url));
const FETCHED = join(FOLDER, "icd.json");
const DRIVER = join(FOLDER, "libvulkan_lvp.so");

/** Whether it was fetched. */
export const isFetched = () => existsSync(FETCHED);

/**
 * Environment of a program that uses it: vectors of 128 bits, of which LLVM compiles kernels in
 * half of the time. Where it was not fetched, the program takes what the system has.
 */
export const environment = () => (
  isFetched() ? { VK_ICD_FILENAMES: FETCHED, LP_NATIVE_VECTOR_WIDTH: "128" } : {}
);

/**
 * A copy of Chromium's folder in which lavapipe stands for SwiftShader: the program's path, its
 * environment, and how to remove the copy; or an Error with what is missing. The program itself
 * has to lie in that folder, because it looks for SwiftShader beside itself.
 */
export function chromiumOnLavapipe(program) {
  if (!isFetched()) throw new Error("no adapter in target/lavapipe (.ci/lavapipe fetches it)");
  // Debian's `chromium` is a script.
  const folders = [dirname(realpathSync(program)), "/usr/lib/chromium"];
  const from = folders.find((folder) => existsSync(join(folder, "libvk_swiftshader.so")));
  if (!from) throw new Error(`no libvk_swiftshader.so in ${folders.join(" or ")}`);
  const to = mkdtempSync(join(tmpdir(), "meshccd-chromium-"));
  const remove = () => rmSync(to, { recursive: true });
  try {
    const names = ["chromium", "chrome"].filter((name) => existsSync(join(from, name)));
    for (const name of readdirSync(from)) {
      if (!names.includes(name)) symlinkSync(join(from, name), join(to, name));
    }
    const binary = join(to, names[0]);
    linkOrCopy(join(from, names[0]), binary);
    // The loader of drivers, which finds what `named` says.
    rmSync(join(to, "libvk_swiftshader.so"));
    copyFileSync(join(from, "libvulkan.so.1"), join(to, "libvk_swiftshader.so"));
    const library = join(to, "libnamed.so");
    const source = fileURLToPath(new URL("./named_swiftshader.c", import.meta.url));
    const define = `-DDRIVER="${DRIVER}"`;
    execFileSync("cc", ["-shared", "-fPIC", "-O1", define, "-o", library, source, "-ldl"]);
    const named = join(to, "named.json");
    const icd = { library_path: library, api_version: "1.3.0" };
    writeFileSync(named, JSON.stringify({ file_format_version: "1.0.0", ICD: icd }));
    rmSync(join(to, "vk_swiftshader_icd.json"));
    copyFileSync(named, join(to, "vk_swiftshader_icd.json"));
    return { executablePath: binary, env: { ...environment(), VK_ICD_FILENAMES: named }, remove };
  } catch (why) {
    remove();
    throw why;
  }
}

/** Another name of a file, or a copy where that is on another disk. */
function linkOrCopy(from, to) {
  try {
    linkSync(from, to);
  } catch {
    copyFileSync(from, to);
  }
}
