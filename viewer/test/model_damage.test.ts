// SPDX-License-Identifier: MIT
// Recordings that are cut off, damaged or strange, without a browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import { lookAt } from "../src/model/look";
import { timeText } from "../src/model/text";
import { type Match, readMatch } from "../src/recording/match";
import { metadata, recording, seconds } from "./synthetic";

const whole = await recording();
const match = await readMatch(whole);
const samples = Array.from({ length: 10 * seconds + 1 }, (_, i) => i / 10);

test("a file that was cut off yields its complete part, wherever it was cut", async () => {
  let least = Infinity;
  for (let i = 1; i < 60; ++i) {
    const length = Math.floor((i * whole.length) / 60);
    let cut: Match;
    try {
      cut = await readMatch(whole.slice(0, length));
    } catch (error) {
      assert.match((error as Error).message, /cut off/, `at ${length}`);
      continue;
    }
    least = Math.min(least, length);
    assert.match(cut.faults[0]!, /^This recording is cut off\. What is complete is shown, up to \d+:\d\d\.\d\.$/);
    assert.ok(cut.game.count > 0 && cut.game.count <= match.game.count);
    assert.equal(cut.game.times[cut.game.count - 1], samples[cut.game.count - 1]);
  }
  assert.ok(least < whole.length / 2);
});

// Where the chunks of a recording lie.
function chunksOf(bytes: Uint8Array): [number, number][] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const found: [number, number][] = [];
  for (let at = 8; bytes[at] !== 0x0f; ) {
    const end = at + 9 + Number(view.getBigUint64(at + 1, true));
    if (bytes[at] === 0x06) found.push([at, end]);
    at = end;
  }
  return found;
}

test("a damaged chunk is left out and said, and the rest is read", async () => {
  const chunks = chunksOf(whole);
  assert.ok(chunks.length > 6);
  const [at, end] = chunks[Math.floor(chunks.length / 2)]!;
  const seen = new Set<string>();
  // Within its data, at its kind, and in its length: the middle, and the beginning with all that can go wrong there.
  for (const place of [Math.floor((at + end) / 2), end - 3, at, at + 3, at + 8, at + 60]) {
    const changed = whole.slice();
    changed[place]! ^= 0xff;
    const read = await readMatch(changed);
    assert.equal(read.game.end, match.game.end, `at ${place - at}: the end is reached`);
    assert.equal(read.gaps.length, 1, `at ${place - at}: ${read.faults.join()}`);
    const { from, to } = read.gaps[0]!;
    const missing = samples.filter((time) => time > from + 0.05 && time < to! - 0.05);
    assert.ok(missing.length > 3 && missing.length < samples.length / 4);
    assert.deepEqual(
      [...read.game.times.subarray(0, read.game.count)],
      samples.filter((time) => !missing.includes(time)),
    );
    assert.match(
      read.faults[0]!,
      new RegExp(
        `^This recording is damaged: ${timeText(from)} to ${timeText(to!)} is missing, the rest is shown\\. ` +
          "1 part of it cannot be read: .+\\.$",
      ),
    );
    seen.add(`${from} ${to}`);
    // Nothing is said of what is not known: no role is held through the gap, no packet missed in it.
    for (const course of read.courses)
      for (const stretch of [...course.overlaps, ...course.uncovered])
        assert.ok(stretch.to <= from + 0.15 || stretch.from >= to! - 0.05, `${stretch.from} to ${stretch.to}`);
    for (const packet of read.packets.sent[0][1]!)
      if (packet.time > from - 1 && packet.time < to!) assert.equal(read.packets.lost(packet, 3), false);
  }
  assert.equal(seen.size, 1, "wherever it is damaged, the same is missing");
  const twice = whole.slice();
  for (const [from] of [chunks[1]!, chunks[4]!]) twice[from + 100]! ^= 1;
  const read = await readMatch(twice);
  assert.match(read.faults[0]!, / and \d:\d\d\.\d to \d:\d\d\.\d are missing, the rest is shown\. 2 parts of it/);
  assert.equal(read.gaps.length, 2);
});

test("damage at the beginning and at the end", async () => {
  const chunks = chunksOf(whole);
  const flipped = async (place: number) => {
    const changed = whole.slice();
    changed[place]! ^= 0x55;
    return readMatch(changed);
  };
  const first = await flipped(chunks[0]![0] + 100);
  assert.equal(first.gaps[0]!.from, 0);
  assert.equal(first.gaps[0]!.to, first.game.begin);
  assert.equal(first.game.end, match.game.end);
  assert.equal(first.packets.unmatched <= 2, true);
  const last = await flipped(chunks[chunks.length - 1]![0] + 100);
  assert.ok(last.game.end < match.game.end);
  assert.match(last.faults[0]!, /^This recording is damaged: /);
  // The place of the footer: the summary is not found, and all is read all the same.
  assert.deepEqual((await flipped(whole.length - 25)).game.count, match.game.count);
});

const refused = (name: string, bytes: () => Promise<Uint8Array>, expected: RegExp) =>
  test(`refused: ${name}`, async () => {
    await assert.rejects(readMatch(await bytes()), { message: expected });
  });
const bytesOf = (text: string) => async () => new TextEncoder().encode(text);
refused("empty", bytesOf(""), /The file is empty/);
refused("something else", bytesOf("PK\u0003\u0004 not a recording"), /not in the MCAP format/);
refused("three bytes of one", async () => whole.slice(0, 3), /cut off/);
refused(
  "one that ends before its match is described",
  async () => whole.slice(0, 60),
  /^This recording breaks off before it describes its match\. It is cut off\.$/,
);
refused(
  "another program's",
  () => recording({ without: Object.keys(metadata()) }),
  /not the recording of a match by Regista/,
);
refused(
  "a newer format",
  () => recording({ metadata: { format: "2" } }),
  /has format 2; this page reads format 1\. It was written by regista test/,
);
refused("no format", () => recording({ without: ["format"] }), /which format/);
refused("no field", () => recording({ without: ["field"] }), /has no "field"/);
refused("a field that is no JSON", () => recording({ metadata: { field: "{" } }), /"field" is not JSON/);
refused(
  "a field without length",
  () => recording({ metadata: { field: '{"length":0}' } }),
  /field\.length is not positive/,
);
refused("a team of text", () => recording({ metadata: { home: '"x"' } }), /home is not an object but "x"/);
refused(
  "no moment",
  () => recording({ message: (topic, message) => (topic === "/game" ? undefined : message) }),
  /holds no moment/,
);
refused(
  "moments of another form",
  () => recording({ message: (topic, message) => (topic === "/game" ? { ...message, ball: [1, 2] } : message) }),
  /no moment of the match\. 601 messages of \/game cannot be read, the first one at 0:00\.0: ball has 2 numbers, not 4/,
);

test("single messages that are wrong are left out and counted", async () => {
  const read = await readMatch(
    await recording({
      raw: (topic, index) =>
        topic === "/game" && index === 100 ? "{" : topic === "/event" && index === 1 ? "[]" : undefined,
      message: (topic, message, index) => (topic === "/packet" && index < 2 ? { ...message, robot: "two" } : message),
    }),
  );
  assert.equal(read.game.count, match.game.count - 1);
  assert.deepEqual(read.faults, [
    '2 messages of /packet cannot be read, the first one at 0:00.0: robot is not a whole number but "two".',
    "1 message of /event cannot be read, the first one at 0:05.0: the message is not an object but [].",
    "1 message of /game cannot be read, the first one at 0:10.0: it is not JSON.",
  ]);
});

test("a decision or belief that is wrong is refused when it is asked for", async () => {
  const read = await readMatch(
    await recording({
      message: (topic, message) =>
        topic === "/decision/home/2"
          ? { ...message, utility: [[1]] }
          : topic === "/belief/home/2"
            ? { ...message, mine: { ...(message.mine as object), teammates: { number: [1], pose: [] } } }
            : message,
    }),
  );
  assert.deepEqual(read.faults, []);
  const look = lookAt(read, 0, 2, 20);
  assert.equal(look.decision, null);
  assert.match(
    look.fault,
    /^This decision .*: utility does not have 3 x 3 entries\. This belief .*: mine\.teammates\.pose has 0 entries/,
  );
  assert.notEqual(lookAt(read, 0, 3, 20).decision, null);
});

test("names of any kind stay what they are", async () => {
  const teams: [string, string] = ["<script>alert(1)</script>\"'&", "\u202Eabc " + "x".repeat(200)];
  const read = await readMatch(await recording({ teams }));
  assert.deepEqual(
    read.about.teams.map((team) => team.name),
    teams,
  );
});
