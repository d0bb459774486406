// SPDX-License-Identifier: MIT
// Recordings that another program wrote anew: messages in another order, log times since 1970, chunks of LZ4, damage.
// The match that is read is the one of the recording as it was.
import assert from "node:assert/strict";
import { test } from "node:test";

import { loadDecompressHandlers } from "@mcap/support";

import { fromBase64 } from "../src/recording/embedded";
import { unpackLz4 } from "../src/recording/lz4";
import { readMatch } from "../src/recording/match";
import { lz4Frame } from "../lz4_frame.mjs";
import { bytesOfTheTool, ofTheTool, storedByTheTool, textOfTheTool } from "./lz4_frames";
import { type Anew, type Logged, recording, withPlays } from "./synthetic";

const written = (anew: Anew, chunkBytes = 20_000) =>
  recording({ ...withPlays, segments: true, plugins: true, anew, chunkBytes });
const original = await readMatch(await written({}));
const in2026 = 1_790_000_000_123_456_789n;

// mulberry32
function shuffled(messages: readonly Logged[], reach = messages.length): Logged[] {
  let state = 1;
  const chance = () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
  const out: Logged[] = [];
  for (let begin = 0; begin < messages.length; begin += reach) {
    const part = messages.slice(begin, begin + reach);
    for (let i = part.length - 1; i > 0; --i) {
      const j = Math.floor(chance() * (i + 1));
      [part[i], part[j]] = [part[j]!, part[i]!];
    }
    out.push(...part);
  }
  return out;
}
const byTopic = (messages: readonly Logged[]) => [...messages].sort((a, b) => a.channelId - b.channelId);

for (const [name, anew] of Object.entries<Anew>({
  "shuffled within a second": { order: (messages) => shuffled(messages, 30) },
  "shuffled as a whole": { order: shuffled },
  "from the end to the beginning": { order: (messages) => [...messages].reverse() },
  "one topic behind the other": { order: byTopic },
  "times since 1970": { later: in2026 },
  "shuffled, and times since 1970": { order: shuffled, later: in2026 },
  "chunks of LZ4": { compression: "lz4", compress: lz4Frame },
  "chunks that are not compressed": { compression: "", compress: (chunk) => chunk },
  "who plays at the end": { metadataLast: true },
  "all of it": { order: shuffled, later: in2026, compression: "lz4", compress: lz4Frame, metadataLast: true },
}))
  test(`the same match: ${name}`, async () => {
    const read = await readMatch(await written(anew));
    assert.deepEqual(read.faults, []);
    assert.deepEqual(read, original);
  });

test("times of the log that begin a little later than the match stay as they are", async () => {
  // Such as those of a writer that rounds otherwise: what is said of a moment does not move.
  assert.deepEqual((await readMatch(await written({ later: 400_000n }))).game, original.game);
});

test("a file that was cut off and is in no order is shown as far as it goes", async () => {
  const bytes = await written({ order: (messages) => shuffled(messages, 30), later: in2026 });
  const read = await readMatch(bytes.slice(0, bytes.length / 2));
  assert.match(read.faults[0]!, /^This recording is cut off\. What is complete is shown, up to 0:/);
  assert.ok(read.game.count > 100);
});

// Turns a byte within the data of a chunk, by its place in the file.
function damaged(bytes: Uint8Array, ...places: number[]): Uint8Array {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const out = bytes.slice();
  for (let at = 8, chunk = 0; bytes[at] !== 0x0f; at += 9 + Number(view.getBigUint64(at + 1, true))) {
    if (bytes[at] === 0x06 && places.includes(chunk++)) out[at + 300]! ^= 0xff;
  }
  return out;
}

test("of LZ4 a damaged chunk is left out, and those after it are read", async () => {
  const bytes = await written({ compression: "lz4", compress: lz4Frame, later: in2026 });
  const read = await readMatch(damaged(bytes, 4, 9));
  assert.equal(read.game.end, original.game.end);
  assert.equal(read.gaps.length, 2);
  assert.match(read.faults[0]!, /^This recording is damaged: .+ and .+ are missing, the rest is shown\. 2 parts/);
});

test("of damage in a file that is in no order the first cause is named", async () => {
  const bytes = await written({ order: shuffled, compression: "lz4", compress: lz4Frame });
  await assert.rejects(readMatch(damaged(bytes, 4, 9)), {
    name: "Error",
    message:
      /^Of this recording the messages are not in the order of time, so this page cannot say what is missing of it\. The file is damaged: (a chunk of LZ4 cannot be decompressed|Incorrect chunk CRC .+)\.$/,
  });
});

test("a compression that nobody knows is named", async () => {
  const bytes = await written({ compression: "snappy", compress: (chunk) => chunk });
  await assert.rejects(readMatch(bytes), { message: /holds no moment of the match\..*Unsupported compression snappy/ });
});

const { lz4: official } = await loadDecompressHandlers();
const text = new TextEncoder().encode(textOfTheTool);
const same = (frame: Uint8Array, bytes: Uint8Array, what: string) =>
  assert.deepEqual(unpackLz4(frame, BigInt(bytes.length)), bytes, what);

test("frames of the program lz4 are unpacked: linked blocks, stored ones, checksums, sizes", () => {
  for (const [options, frame] of Object.entries(ofTheTool)) same(fromBase64(frame), text, options);
  same(fromBase64(storedByTheTool), bytesOfTheTool, "stored");
  const twice = fromBase64(storedByTheTool);
  same(Uint8Array.from([...twice, ...twice]), Uint8Array.from([...bytesOfTheTool, ...bytesOfTheTool]), "two frames");
});

test("what the tests pack, the decompressor of @mcap/support unpacks, too", () => {
  for (const length of [1, 5, 12, 13, 100, 1000, 156_000]) {
    const bytes = text.subarray(0, length);
    const frame = lz4Frame(bytes);
    assert.deepEqual(official!(frame, BigInt(length)), bytes);
    same(frame, bytes, `${length} bytes`);
  }
});

test("no damaged frame reads or writes beyond its ends", () => {
  const frame = lz4Frame(text.subarray(0, 3000));
  for (let at = 0; at < frame.length; ++at) {
    for (const bit of [1, 16, 128]) {
      const changed = frame.slice();
      changed[at]! ^= bit;
      try {
        assert.equal(unpackLz4(changed, 3000n).length, 3000);
      } catch (error) {
        assert.match((error as Error).message, /^a chunk of LZ4 cannot be decompressed$/, `byte ${at}`);
      }
    }
    assert.throws(() => unpackLz4(frame.subarray(0, at), 3000n), `cut at ${at}`);
  }
  for (const size of [0n, 2999n, 3001n, 2n ** 62n]) assert.throws(() => unpackLz4(frame, size));
});
