// SPDX-License-Identifier: MIT
// A recorded match, read by @mcap/core, against what `--decisions` says of the same match; and what that library still
// reads of the file when it is cut anywhere:
//   node official_recording.mjs REGISTA
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";

const millimetre = 0.001 + 1e-9;
const program = process.argv[2];
const configs = join(dirname(fileURLToPath(import.meta.url)), "../../configs/teams");
const folder = mkdtempSync(join(tmpdir(), "regista-recording-"));
process.on("exit", () => rmSync(folder, { recursive: true, force: true }));

const [file, log] = [join(folder, "match.mcap"), join(folder, "decisions.jsonl")];
const teams = ["paper", "fixed_rate"].map((name) => join(configs, `${name}.yaml`));
execFileSync(program, ["match", ...teams, "--limit", "120", "--quiet", "--record", file, "--decisions", log], {
  stdio: ["ignore", "ignore", "inherit"],
});
const bytes = readFileSync(file);
const lines = readFileSync(log, "utf8").trimEnd().split("\n").map((line) => JSON.parse(line));
const decompressHandlers = await loadDecompressHandlers();
const text = new TextDecoder();

const reader = await McapIndexedReader.Initialize({
  readable: {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + length))),
  },
  decompressHandlers,
});
const messages = new Map(); // by topic
for await (const message of reader.readMessages({ validateCrcs: true })) {
  const { topic } = reader.channelsById.get(message.channelId);
  if (!messages.has(topic)) messages.set(topic, []);
  messages.get(topic).push(JSON.parse(text.decode(message.data)));
}
const about = new Map();
for await (const { name, metadata } of reader.readMetadata()) if (name === "match") metadata.forEach((v, k) => about.set(k, v));
const names = ["home", "away"].map((side) => JSON.parse(about.get(side)).roles.map((role) => role.name));
const nameOf = (side, row) => (row === -1 ? null : row === -2 ? "unknown" : names[side][row]);

// Where everything was, once a second. Within two minutes home attacks towards +x: both are the world's frame.
const truth = lines.filter((line) => line.kind === "truth");
const games = new Map(messages.get("/game").map((game) => [game.time, game]));
assert.equal(truth.length, 120);
let farthest = 0;
for (const line of truth) {
  const game = games.get(line.time);
  const pairs = [[game.ball, line.ball], ...["home", "away"].flatMap((side) => game[side].map((p, i) => [p, line[side][i]]))];
  for (const [[x, y], [tx, ty]] of pairs) farthest = Math.max(farthest, Math.abs(x - tx), Math.abs(y - ty));
}
assert(farthest <= millimetre, `${farthest} m apart`);

// Every change of a decision, and the role that each robot held at every sample.
let decisions = 0;
for (const [side, name] of ["home", "away"].entries()) {
  for (let robot = 1; robot <= 7; ++robot) {
    const recorded = messages.get(`/decision/${name}/${robot}`);
    const logged = lines.filter((line) => line.kind === "decision" && line.side === name && line.robot === robot);
    let before = "";
    const changes = logged.filter((line) => {
      const state = JSON.stringify([line.context, line.role, line.kept, line.assignment]);
      const changed = state !== before;
      before = state;
      return changed;
    });
    // Without those that only tell the matrix again.
    const told = recorded.map((d) => JSON.stringify([d.context, d.role, d.columns, d.assigned]));
    const changed = recorded.filter((_, i) => told[i] !== told[i - 1]);
    assert.deepEqual(
      changed.map((d) => [d.time, nameOf(side, d.role), d.assigned.map((r) => nameOf(side, r)), d.columns.map((r) => nameOf(side, r))]),
      changes.map((line) => [line.time, line.role, line.assignment, line.kept]),
    );
    decisions += recorded.length;
    let next = 0, role = null;
    for (const game of messages.get("/game")) {
      while (next < logged.length && logged[next].time < game.time - 1e-6) role = logged[next++].role;
      assert.equal(nameOf(side, game.roles[side][robot - 1]), role, `${name} ${robot} at ${game.time}`);
    }
  }
}
console.log(`${truth.length} states of the game within ${(1000 * farthest).toFixed(2)} mm, ${decisions} decisions equal`);

// Cut anywhere: all messages of the chunks that are whole, none else.
const ends = []; // of chunks
for (let at = 8; at + 9 <= bytes.length - 8; at += 9 + Number(bytes.readBigUInt64LE(at + 1))) {
  if (bytes[at] === 0x06) ends.push(at + 9 + Number(bytes.readBigUInt64LE(at + 1)));
}
function streamed(part) {
  const stream = new McapStreamReader({ includeChunks: true, decompressHandlers, validateCrcs: true });
  stream.append(new Uint8Array(part));
  const counts = [0]; // messages after each chunk
  for (let record; (record = stream.nextRecord()) !== undefined; ) {
    if (record.type === "Chunk") counts.push(counts.at(-1));
    if (record.type === "Message") ++counts[counts.length - 1];
    if (record.type === "DataEnd") break;
  }
  return counts;
}
const whole = streamed(bytes);
assert.equal(whole.length, ends.length + 1);
assert.equal(whole.at(-1), [...messages.values()].reduce((sum, list) => sum + list.length, 0));
let state = 12345;
for (let trial = 0; trial < 100; ++trial) {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  const size = 8 + (state % (bytes.length - 8));
  const complete = ends.filter((end) => end <= size).length;
  const counts = streamed(bytes.subarray(0, size));
  assert.deepEqual(counts, whole.slice(0, complete + 1), `cut at ${size}`);
}
console.log(`100 cuts: every complete chunk of ${ends.length} was read`);
