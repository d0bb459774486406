// SPDX-License-Identifier: MIT
// The life of segments, put together from a recording: against the script that the recording was made from.
import assert from "node:assert/strict";
import { test } from "node:test";

import { around } from "../src/recording/log";
import { type Segment, reachOf, spacedBytes } from "../src/model/segments";
import { readMatch } from "../src/recording/match";
import { recording, seconds } from "./synthetic";

const match = await readMatch(await recording({ segments: true }));
const { all } = match.segments;
const of = (robot: number) => all.filter((each) => each.robot === robot);
const reach = (segment: Segment) => reachOf(segment, match.packets, match.game.sizes[0]);

test("a bid is followed from its offer to those who heard it", () => {
  assert.deepEqual(match.faults, []);
  assert.equal(match.segments.unmatched, 0);
  assert.deepEqual(
    of(2).map(({ handle, from, fate, at, text }) => [handle, from.toFixed(1), fate, at.toFixed(1), text]),
    Array.from({ length: seconds / 5 }, (_, i) => i + 1).map((k) => [
      k,
      (5 * k - 0.4).toFixed(1),
      "sent",
      (5 * k).toFixed(1),
      `bid ${k} for \u201cstriker\u201d`,
    ]),
  );
  const numbers = of(2)
    .slice(0, 5)
    .map((segment) => {
      const { heard, undelivered, lost } = reach(segment);
      return [heard.map(({ robot }) => robot), undelivered.map(({ robot, why }) => [robot, why]), lost];
    });
  // The packet of 20 s came to robot 3, whose plugin got nothing; those of 5, 15 and 25 s never did.
  assert.deepEqual(numbers, [
    [[1], [], [3]],
    [[1, 3], [], []],
    [[1], [], [3]],
    [[1], [[3, "no_mailbox"]], []],
    [[1], [], [3]],
  ]);
  assert.equal(reach(of(2)[0]!).heard[0]!.time.toFixed(2), "5.05");
});

test("what no packet took was dropped, refused, or is pending still", () => {
  assert.deepEqual(
    [...of(3), ...of(1)].map(({ handle, bytes, fate, why, by, at }) => [handle, bytes, fate, why, by, at]),
    [
      [1, "0a1f", "dropped", "replaced", 2, 12.5],
      [2, "ff00", "dropped", "expired", 0, 15.5],
      [0, "", "refused", "too_long", 0, 15],
      [1, "0a1f", "pending", "", 0, Infinity],
    ],
  );
  assert.equal(of(1)[0]!.length, 300);
  for (const segment of [...of(3), ...of(1)])
    assert.deepEqual(reach(segment), { heard: [], undelivered: [], lost: [] });
});

test("a packet that never left reached nobody, and nothing is said of what is not recorded", async () => {
  const silent = await readMatch(
    await recording({
      segments: true,
      message: (topic, message) => {
        if (topic === "/packet" || topic === "/heard") return undefined;
        return topic === "/segment" && message.segment === "sent" ? { ...message, left: false } : message;
      },
    }),
  );
  const first = silent.segments.all.find(({ robot }) => robot === 2)!;
  assert.equal(first.left, false);
  assert.deepEqual(reachOf(first, silent.packets, 3).lost, []);

  const cut = await readMatch(
    await recording({
      segments: true,
      message: (topic, message) => (topic === "/segment" && message.segment === "offered" ? undefined : message),
    }),
  );
  const known = cut.segments.all.find(({ robot }) => robot === 2)!;
  assert.deepEqual([known.from, known.length, known.text, known.fate], [5, null, "", "sent"]);
});

test("messages of an unknown form are told of, and left out", async () => {
  const odd = await readMatch(
    await recording({
      segments: true,
      message: (topic, message, index) =>
        topic === "/segment" && index === 0 ? { ...message, segment: "eaten" } : message,
    }),
  );
  assert.equal(odd.faults.length, 1);
  assert.match(odd.faults[0]!, /^1 message of \/segment cannot be read, the first one at 0:04\.6: segment is "eaten"/);
  assert.equal(odd.segments.all.length, all.length); // what follows of it is known
  const stray = await readMatch(
    await recording({
      segments: true,
      message: (topic, message) =>
        topic === "/segment" && message.segment === "heard" ? { ...message, handle: 0 } : message,
    }),
  );
  assert.ok(stray.segments.unmatched > 10);
});

test("a recording without segments has none", async () => {
  assert.deepEqual((await readMatch(await recording())).segments.all, []);
});

test("around a moment: the last ones before it, and the next", () => {
  const froms = all.map(({ from }) => from);
  assert.deepEqual(froms, [...froms].sort((a, b) => a - b));
  const { shown, last } = around(all, froms, 12.2, 2, 1);
  assert.deepEqual(
    shown.map(({ from }) => from.toFixed(1)),
    ["9.6", "12.0", "12.5"],
  );
  assert.equal(last, shown[1]);
  assert.deepEqual(around(all, froms, 0, 2, 1), { shown: [all[0]], last: null });
  assert.equal(spacedBytes("0a1bff"), "0a 1b ff");
  assert.equal(spacedBytes(""), "");
});
