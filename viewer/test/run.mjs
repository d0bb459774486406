// SPDX-License-Identifier: MIT
// Runs the viewer's tests: node run.mjs [BEGINNING], a regular expression for the beginning of their files' names, such as
// model, page or page_boxes. They are written in TypeScript, which older versions of Node do not read, so each file is
// bundled first.
import { spawnSync } from "node:child_process";
import { mkdirSync, readdirSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const wanted = process.argv[2] ?? "";
const files = readdirSync(here).filter((name) => name.endsWith(".test.ts") && name.search(wanted) === 0);
if (files.length === 0) {
  console.error(`no test begins with ${wanted}; usage: node run.mjs [model|page]`);
  process.exit(2);
}

// In the viewer's folder.
function run(words) {
  const { status } = spawnSync(process.execPath, words, { cwd: join(here, ".."), stdio: "inherit" });
  if (status !== 0) process.exit(status ?? 1);
}

run(["node_modules/typescript/bin/tsc", "--noEmit"]);
// Inside node_modules, so that the bundles find the packages that stay outside of them.
const out = join(here, "../node_modules/.cache/regista-tests", String(process.pid));
mkdirSync(out, { recursive: true });
process.on("exit", () => rmSync(out, { recursive: true, force: true }));
await build({
  entryPoints: files.map((name) => join(here, name)),
  bundle: true,
  platform: "node",
  format: "esm",
  target: "node18",
  packages: "external",
  sourcemap: "inline",
  outdir: out,
  outExtension: { ".js": ".mjs" },
  logLevel: "warning",
});
run(["--enable-source-maps", "--test", ...files.map((name) => join(out, name.replace(/\.ts$/, ".mjs")))]);
