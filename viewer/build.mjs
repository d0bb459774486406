// SPDX-License-Identifier: MIT
// Builds the page: scripts, styles and decompressor in one HTML file that needs nothing else.
//   node build.mjs --out FILE [--recording FILE.mcap]
// Without a recording the page keeps the places that `regista view` fills: @REGISTA_RECORDING@ (the file as base64)
// and @REGISTA_RECORDING_NAME@ (its name, escaped for HTML), each once.
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { build } from "esbuild";

import { lz4Frame } from "./lz4_frame.mjs";

const root = dirname(fileURLToPath(import.meta.url));
const require = createRequire(import.meta.url);
const places = { recording: "@REGISTA_RECORDING@", name: "@REGISTA_RECORDING_NAME@" };

function usage(problem) {
  console.error(`build.mjs: ${problem}\nusage: node build.mjs --out FILE [--recording FILE.mcap]`);
  process.exit(2);
}

function options(words) {
  const found = {};
  for (let i = 0; i < words.length; i += 2) {
    const name = words[i].replace(/^--/, "");
    if (!["out", "recording"].includes(name) || words[i + 1] === undefined) usage(`cannot read "${words[i]}"`);
    found[name] = words[i + 1];
  }
  if (found.out === undefined) usage("--out is missing");
  return found;
}

// The script holds the decompressor's WebAssembly, packed: a page from disk cannot fetch. LZ4 is unpacked by
// src/recording/lz4.ts, and nobody compresses recordings with bzip2, so these two decompressors stay out.
const decompressors = {
  name: "decompressors",
  setup(plugins) {
    const lz4 = join(root, "src/recording/lz4.ts");
    const wasm = readFileSync(join(dirname(require.resolve("@foxglove/wasm-zstd")), "wasm-zstd.wasm"));
    plugins.onLoad({ filter: /wasm-zstd[\\/]dist[\\/]index\.js$/ }, ({ path }) => {
      const original = readFileSync(path, "utf8");
      const contents = original.replace(
        "ModuleFactory()",
        `ModuleFactory({
          wasmBinary: require(${JSON.stringify(lz4)}).unpackLz4(require("./wasm-zstd.wasm"), BigInt(${wasm.length})),
        })`,
      );
      if (contents === original) throw new Error(`${path} does not load its WebAssembly as expected`);
      return { contents, loader: "js" };
    });
    plugins.onLoad({ filter: /wasm-zstd\.wasm$/ }, () => ({ contents: lz4Frame(wasm), loader: "binary" }));
    plugins.onResolve({ filter: /^@foxglove\/wasm-(bz2|lz4)$/ }, ({ path }) => ({ path, namespace: "left-out" }));
    plugins.onLoad({ filter: /.*/, namespace: "left-out" }, ({ path }) => ({
      contents: `
        const refuse = () => { throw new Error("the page does not unpack ${path.split("-").pop()}"); };
        export default Object.assign(refuse, { init: async () => ({ decompress: refuse }), isLoaded: true });`,
      loader: "js",
    }));
    // Only its decompressors are needed of @mcap/support.
    plugins.onResolve({ filter: /^@mcap\/support$/ }, () => ({
      path: join(dirname(require.resolve("@mcap/support")), "../esm/decompressHandlers.js"),
      sideEffects: false,
    }));
  },
};

async function script(entry = join(root, "src/main.ts")) {
  const result = await build({
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    platform: "browser",
    loader: { ".wasm": "binary" },
    absWorkingDir: root,
    target: ["chrome102", "firefox102"],
    charset: "ascii",
    legalComments: "none",
    define: {
      "process.env.WASM_ZSTD_ENVIRONMENT": '"WEB"',
      process: "undefined",
      __filename: "undefined",
      __dirname: '""',
    },
    inject: [join(root, "src/recording/buffer.js")],
    external: ["fs", "path"],
    plugins: [decompressors],
    logLevel: "warning",
    metafile: true,
  });
  return { code: result.outputFiles[0].text, inputs: Object.keys(result.metafile.inputs) };
}

// The licences of the packages whose code stands in the page.
function licences(inputs) {
  const folders = new Set(
    inputs
      .map((file) => join(root, file))
      .map((file) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(file)?.[0])
      .filter(Boolean),
  );
  const texts = [...folders].sort().map((folder) => {
    const { name, version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
    const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
    const text = file === undefined ? "" : readFileSync(join(folder, file), "utf8").trim();
    return `${name} ${version} (${license})\n\n${text}\n`;
  });
  return texts.join("\n\n").replaceAll("<", "(").replaceAll(">", ")");
}

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

function fill(template, values) {
  return template.replace(/@(POLICY|STYLE|SCRIPT|LICENCES)@/g, (_, key) => values[key]);
}

const escaped = (text) => text.replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`);

async function page(recording) {
  const bundle = await script();
  const code = bundle.code.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
  const curves = readFileSync(join(dirname(require.resolve("uplot")), "uPlot.min.css"), "utf8");
  const ours = join(root, "src/style");
  const style = [
    curves,
    ...readdirSync(ours)
      .sort()
      .map((file) => readFileSync(join(ours, file), "utf8")),
  ].join("\n");
  const policy = [
    "default-src 'none'",
    `script-src ${hash(code)} 'wasm-unsafe-eval'`,
    `style-src ${hash(style)}`,
    "img-src data:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
  const template = readFileSync(join(root, "src/page.html"), "utf8");
  let html = fill(template, { POLICY: policy, STYLE: style, SCRIPT: code, LICENCES: licences(bundle.inputs) });
  for (const place of Object.values(places)) {
    if (html.split(place).length !== 2) throw new Error(`${place} does not stand just once in the page`);
  }
  if (recording !== undefined) {
    const bytes = readFileSync(recording).toString("base64");
    html = html.replace(places.name, () => escaped(basename(recording))).replace(places.recording, () => bytes);
  }
  return html;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { out, recording } = options(process.argv.slice(2));
  mkdirSync(dirname(out), { recursive: true });
  writeFileSync(out, await page(recording));
}
