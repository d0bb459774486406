// SPDX-License-Identifier: MIT
// A recording as a page holds it: the match that is read is the one of the recording that it was made from.
// With REGISTA, which names the program, also of a match that was played.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";

import { countSwitches } from "../src/model/switches";
import { fromBase64 } from "../src/recording/embedded";
import { type Match, readMatch } from "../src/recording/match";
import { recording, seconds, withPlays } from "./synthetic";

const change = { ...withPlays, segments: true, plugins: true };
const written = (packed?: number) => recording({ ...change, anew: packed === undefined ? {} : { packed } });
const original = await readMatch(await written());

// All that a page can show of it.
async function shown(match: Match) {
  const logs = (all: Match["decisions"] | Match["beliefs"]) =>
    all.map((side) => side.map((log) => log.times.map((time, i) => [time, log.json(i)])));
  const { decisions, beliefs, drawings, ...rest } = match;
  const drawn = drawings.layers.map((_, i) =>
    drawings.drawers.map((drawer) => Array.from({ length: seconds }, (_, time) => drawings.at(i, drawer, time))),
  );
  const switches = await countSwitches(match, async () => {});
  return { ...rest, layers: drawings.layers, drawn, decisions: logs(decisions), beliefs: logs(beliefs), switches };
}

for (const packed of [1_000_000, 700, 37])
  test(`the same match, in records of up to ${packed} messages`, async () => {
    const read = await readMatch(await written(packed));
    assert.deepEqual(read.faults, []);
    assert.deepEqual(await shown(read), await shown(original));
  });

test("numbers of any form, and those that stand in words, come back as they were", async () => {
  const text = 'x1 1.50 "-0" 007 1e5 -3e-05 0a1bff 12345678901 é\\ 3.2.1 2147483648 0.000001 -5';
  const message = (topic: string, json: Record<string, unknown>) =>
    topic === "/packet" ? { ...json, reason: text, bytes: 6.856e-5 } : json;
  const [plain, packed] = await Promise.all(
    [{}, { packed: 500 }].map(async (anew) => readMatch(await recording({ message, anew }))),
  );
  assert.equal(plain!.packets.sent[0][1]![0]!.reason, text);
  assert.deepEqual(packed!.packets, plain!.packets);
});

test("a damaged record is left out and said, and the rest is read", async () => {
  const bytes = await written(300);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const records: number[] = [];
  for (let at = 8; bytes[at] !== 0x0f; at += 9 + Number(view.getBigUint64(at + 1, true)))
    if (bytes[at] === 0x80) records.push(at);
  assert.ok(records.length > 3);
  for (const place of [15, 18, 40, 200]) {
    const changed = bytes.slice();
    changed[records[2]! + place]! ^= 0xff;
    const read = await readMatch(changed);
    assert.equal(read.gaps.length, 1);
    assert.equal(read.game.end, original.game.end);
    assert.match(read.faults[0]!, /^This recording is damaged: .+ is missing, the rest is shown\. 1 part of it/);
  }
  const cut = await readMatch(bytes.slice(0, bytes.length - 100));
  assert.match(cut.faults[0]!, /^This recording is cut off\. What is complete is shown/);
});

const program = process.env.REGISTA ?? "";
const skip = program === "" && "REGISTA names no program";
test("what `regista view` packs is the match that was recorded", { skip }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "regista-packed-"));
  try {
    const [file, page] = [join(folder, "match.mcap"), join(folder, "match.html")];
    const teams = ["paper", "fixed_rate"].map((name) => `../configs/teams/${name}.yaml`);
    execFileSync(program, ["match", ...teams, "--limit", "180", "--quiet", "--record", file], { stdio: "ignore" });
    execFileSync(program, ["view", file, "-o", page], { stdio: "ignore" });
    const data = /id="recording"[^>]*>([^<]*)</.exec(readFileSync(page, "latin1"))![1]!;
    const [played, packed] = [await readMatch(readFileSync(file)), await readMatch(fromBase64(data))];
    assert.ok(played.game.count === 1800 && played.faults.length === 0);
    assert.deepEqual(await shown(packed), await shown(played));
    // And the page has room for a whole match of 1302 s in 12 MB, 0.9 MB of them for the viewer.
    assert.ok(data.length / 180 < 11.1e6 / 1302, `${data.length} letters`);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
