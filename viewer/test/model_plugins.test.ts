// SPDX-License-Identifier: MIT
// What plugins write and draw, read from a recording: against the script that the recording was made from.
import assert from "node:assert/strict";
import { test } from "node:test";

import { around } from "../src/recording/log";
import { Encoded } from "../src/recording/content";
import { Drawings, layerText } from "../src/model/drawings";
import { chosenLines, sumText } from "../src/model/log_lines";
import { readMatch } from "../src/recording/match";
import { type LogLine, drawingHeadOf, shapesOf } from "../src/recording/plugin_messages";
import { cellAt, linesAt, recording, seconds } from "./synthetic";

type Json = Record<string, unknown>;

const match = await readMatch(await recording({ plugins: true }));
const { drawings, lines } = match;
const [targets, cells] = [0, 1]; // places of the layers
const home = (number: number) => ({ side: 0, number }) as const;
const bytes = (json: unknown) =>
  new Encoded(new TextEncoder().encode(typeof json === "string" ? json : JSON.stringify(json)));

test("lines are read as they were written, in the order of time", () => {
  assert.deepEqual(match.faults, []);
  const written = Array.from({ length: 10 * seconds + 1 }, (_, i) => linesAt(i / 10)).flat();
  assert.deepEqual(
    lines.map(({ side, ...line }) => ({ ...line, side: side === 0 ? "home" : "away" })),
    written,
  );
});

test("of the lines those of a robot, of a plugin, from a level on", () => {
  const chosen = (choice: Partial<Parameters<typeof chosenLines>[1]>) =>
    chosenLines(lines, { robot: null, least: "debug", plugin: null, ...choice });
  assert.deepEqual(chosen({}), lines);
  assert.deepEqual(
    chosen({ least: "warning" }).map(({ time, level }) => [time, level]),
    [
      [12.5, "warning"],
      [20, "error"],
      [20.1, "warning"],
    ],
  );
  assert.deepEqual(
    chosen({ least: "error" }).map(({ text }) => text),
    ["less than three nodes"],
  );
  assert.equal(chosen({ least: "info" }).length, 64);
  assert.equal(chosen({ robot: home(2) }).length, 61 + 121);
  assert.equal(chosen({ robot: home(2), plugin: "bids" }).length, 121);
  assert.deepEqual(chosen({ robot: { side: 1, number: 2 } }), []);
  assert.equal(sumText(chosen({ least: "warning" })), "3 lines: 1 error, 2 warnings");
  assert.equal(sumText([]), "0 lines: 0 errors, 0 warnings");
});

test("around a moment of 10^5 lines stand few, and they are found at once", () => {
  const many: LogLine[] = Array.from({ length: 100_000 }, (_, i) => ({ ...lines[0]!, time: i / 100 }));
  const times = many.map(({ time }) => time);
  const began = performance.now();
  for (let i = 0; i < 1000; ++i) {
    const { shown, last } = around(many, times, i + 0.005, 120, 30);
    assert.equal(last!.time, i);
    assert.ok(shown.length <= 150);
  }
  assert.ok(performance.now() - began < 1000);
  assert.deepEqual(around(many, times, -1, 120, 30).last, null);
});

test("layers and those who drew in them", () => {
  assert.deepEqual(drawings.layers.map(layerText), ["bids: targets", "voronoi: cells"]);
  assert.deepEqual(drawings.drawers, [home(2), home(3), { side: 1, number: 1 }]);
  assert.equal(drawings.fault, "");
});

test("a drawing stays until its robot's plugin draws in that layer again, an empty one takes it away", () => {
  for (let i = 0; i <= 10 * seconds; ++i) {
    const time = i / 10;
    const shapes = drawings.at(cells, home(2), time);
    if (time > 39.95) {
      assert.deepEqual(shapes, []);
      continue;
    }
    const [x, y] = cellAt(time);
    assert.deepEqual(
      shapes.map(({ kind }) => kind),
      ["polygon", "polygon", "text"],
    );
    assert.deepEqual(shapes[0]!.at[0], [x - 0.5, y - 0.5], `at ${time}`);
    assert.deepEqual(shapes[2], {
      ...{ kind: "text", at: [[x, y]], text: `cell of ${2 * Math.floor(time / 2 + 1e-6)} s` },
      ...{ colour: null, width: null, filled: false },
    });
  }
  const [filled, plain] = drawings.at(cells, home(2), 7);
  assert.deepEqual([filled!.filled, filled!.colour, filled!.width], [true, "#ff00ffff", 0.05]);
  assert.deepEqual([plain!.filled, plain!.colour, plain!.width], [false, null, null]);
  // Of another robot, and in another layer, it is another one.
  assert.deepEqual([drawings.at(cells, home(3), 9.9), drawings.at(cells, home(3), 10).length], [[], 1]);
  assert.equal(drawings.at(cells, home(3), 60)[0]!.kind, "line");
  assert.equal(drawings.at(targets, { side: 1, number: 1 }, 30)[0]!.at.length, 1);
  assert.deepEqual(drawings.at(targets, home(1), 30), []);
  assert.deepEqual(drawings.at(7, home(2), 30), []);
});

test("10^5 drawings are neither taken apart when they are read, nor searched one by one", () => {
  const many = new Drawings();
  const shape = { shape: "line", at: Array.from({ length: 60 }, (_, i) => [i / 7, i / 9]) };
  for (let i = 0; i < 100_000; ++i) {
    const head = { time: i / 100, side: "home", robot: 1 + (i % 7), plugin: "p", layer: "l" };
    // Of a broken end nothing is known until it is looked at.
    many.add(bytes(i === 50_000 ? JSON.stringify({ ...head, shapes: [] }).slice(0, -2) : { ...head, shapes: [shape] }));
  }
  many.close();
  const began = performance.now();
  for (let i = 0; i < 1000; ++i) assert.equal(many.at(0, home(1), i)[0]!.at.length, 60);
  assert.ok(performance.now() - began < 1000);
  assert.equal(many.fault, "");
  const broken = home(1 + (50_000 % 7));
  assert.deepEqual(many.at(0, broken, 500.01), []);
  assert.equal(many.fault, "1 drawing cannot be read, one at 8:20.0: it is not JSON.");
  assert.equal(many.at(0, broken, 500.08).length, 1);
});

test("a drawing's head is found wherever its keys stand", () => {
  const head = { time: 1.5, side: "away", robot: 2, plugin: 'a,"shapes":', layer: 'x","shapes":[' };
  const expected = { ...head, side: 1 };
  assert.deepEqual(drawingHeadOf(bytes({ ...head, shapes: [] })), expected);
  assert.deepEqual(drawingHeadOf(bytes({ shapes: [], ...head })), expected);
  assert.deepEqual(drawingHeadOf(bytes({ more: { a: 1, shapes: [] }, ...head, shapes: [] })), expected);
  assert.deepEqual(drawingHeadOf(bytes({ ...head, layer: "é".repeat(700), shapes: [] })).layer, "é".repeat(700));
  assert.deepEqual(drawingHeadOf(bytes(JSON.stringify({ ...head, shapes: [] }, null, 2))), expected);
});

test("messages of an unknown form are told of, and left out", async () => {
  const changed = (change: (topic: string, message: Json, index: number) => Json) =>
    recording({ plugins: true, message: change });
  const odd = await readMatch(
    await changed((topic, message, index) => {
      if (topic === "/log" && index === 0) return { ...message, level: "fatal" };
      if (topic === "/log" && index === 1) return { ...message, robot: 0 };
      return topic === "/draw" && index === 0 ? { ...message, layer: 7 } : message;
    }),
  );
  assert.deepEqual(odd.faults, [
    '2 messages of /log cannot be read, the first one at 0:00.0: level is "fatal", not one of debug, info, warning, error.',
    "1 message of /draw cannot be read, the first one at 0:00.0: layer is not a text but 7.",
  ]);
  assert.equal(odd.lines.length, lines.length - 2);
  assert.deepEqual(odd.drawings.at(cells, home(2), 1), []);
  assert.equal(odd.drawings.at(cells, home(2), 2).length, 3);

  // What is wrong with shapes is told of when they are to be drawn, as it is of beliefs.
  const shapes = await readMatch(
    await changed((topic, message, index) =>
      topic === "/draw" && index < 2 ? { ...message, shapes: [{ shape: "circle", at: [] }] } : message,
    ),
  );
  assert.deepEqual([shapes.faults, shapes.drawings.fault], [[], ""]);
  assert.deepEqual([shapes.drawings.at(cells, home(2), 1), shapes.drawings.at(cells, home(2), 1.1)], [[], []]);
  const why = 'shapes[0].shape is "circle", not one of points, line, polygon, text';
  assert.equal(shapes.drawings.fault, `1 drawing cannot be read, one at 0:00.0: ${why}.`);
  shapes.drawings.at(cells, home(2), 3);
  assert.equal(shapes.drawings.fault, `2 drawings cannot be read, one at 0:00.0: ${why}.`);
});

test("shapes are checked", () => {
  const wrong = (shape: Json, expected: RegExp) => assert.throws(() => shapesOf({ shapes: [shape] }), expected);
  const line = { shape: "line", at: [[0, 0]] };
  assert.equal(shapesOf({ shapes: [line] })[0]!.kind, "line");
  wrong({ ...line, at: [[0, 0, 0]] }, /shapes\[0\]\.at\[0\] has 3 numbers, not 2/);
  wrong({ ...line, at: [[0, null]] }, /shapes\[0\]\.at\[0\]\[1\] is not a number/);
  wrong({ ...line, colour: "red;url(x)" }, /shapes\[0\]\.colour is not a colour as #rrggbbaa/);
  wrong({ ...line, width: -1 }, /shapes\[0\]\.width is less than 0/);
  wrong({ ...line, filled: 1 }, /shapes\[0\]\.filled is neither true nor false/);
  wrong({ shape: "text", at: [], text: "x" }, /shapes\[0\]\.at is not one point/);
  wrong({ shape: "text", at: [[0, 0]], text: 7 }, /shapes\[0\]\.text is not a text/);
  assert.throws(() => shapesOf({}), /shapes is not a list but missing/);
});

test("of more layers than anybody chooses among the first can be chosen, and the page says so", () => {
  const many = new Drawings();
  for (let i = 0; i < 130; ++i)
    many.add(bytes({ time: i, side: "home", robot: 1, plugin: "p", layer: `at ${1000 + i}`, shapes: [] }));
  many.close();
  assert.deepEqual([many.layers.length, many.layers[99]!.name], [100, "at 1099"]);
  assert.equal(many.fault, "Plugins drew in 130 layers; the first 100 can be chosen.");
});

test("a recording in which plugins neither write nor draw has no lines and no layers", async () => {
  const silent = await readMatch(await recording());
  assert.deepEqual([silent.lines, silent.drawings.layers, silent.drawings.drawers], [[], [], []]);
});
