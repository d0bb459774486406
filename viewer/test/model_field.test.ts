// SPDX-License-Identifier: MIT
// What is drawn on the field, without a browser: where names stand, how large the ball and the ellipses are.
import assert from "node:assert/strict";
import { test } from "node:test";
import { shownBallRadius } from "../src/field/ball";
import { drawShapes, styleOf } from "../src/field/drawings";
import type { Projection } from "../src/field/projection";
import { Labels } from "../src/field/labels";
import { type Wanted, placeNames } from "../src/field/placement";
import { ellipseOf, ellipsePath } from "../src/field/shapes";
import type { Shape } from "../src/recording/plugin_messages";

// Notes what is drawn instead of drawing it; every letter is 6 wide.
function noting() {
  const ellipses: number[][] = [];
  const texts: { text: string; x: number; y: number }[] = [];
  const context = {
    beginPath: () => {},
    save: () => {},
    restore: () => {},
    setLineDash: () => {},
    moveTo: () => {},
    lineTo: () => {},
    stroke: () => {},
    strokeText: () => {},
    measureText: (text: string) => ({ width: 6 * text.length }),
    fillText: (text: string, x: number, y: number) => texts.push({ text, x, y }),
    ellipse: (...all: number[]) => ellipses.push(all),
  } as unknown as CanvasRenderingContext2D;
  return { context, ellipses, texts };
}

test("ellipses are drawn two standard deviations wide", () => {
  const { context, ellipses } = noting();
  ellipsePath(context, { x: (x: number) => x, y: (y: number) => y, scale: 10 } as Projection, 0, 0, [0.25, 0, 0.01]);
  assert.deepEqual(
    ellipses[0]!.slice(2, 4).map((axis) => axis.toFixed(9)),
    ["10.000000000", "2.000000000"],
  );
});

const picture = { width: 400, height: 300 };
const name = (x: number, y: number, more: Partial<Wanted> = {}): Wanted => ({
  ...{ x, y, radius: 8, width: 60, height: 12, far: false, before: -1 },
  ...more,
});

// Whether two boxes given by centre and size share an area.
const share = (a: { x: number; y: number }, b: { x: number; y: number }, width: number, height: number) =>
  Math.abs(a.x - b.x) < width - 1e-9 && Math.abs(a.y - b.y) < height - 1e-9;

test("names on the field lie neither over each other nor over what is there, and stay in the picture", () => {
  // Ten scrums of twelve robots, placed by a generator of chance written out here.
  let seed = 7;
  const chance = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  let placed = 0;
  let farPlaced = 0;
  for (let scrum = 0; scrum < 10; ++scrum) {
    const [x, y] = [chance() * picture.width, chance() * picture.height];
    const names = Array.from({ length: 12 }, (_, i) =>
      name(x + 80 * (chance() - 0.5), y + 80 * (chance() - 0.5), { far: i % 2 === 0 }),
    );
    const bodies = names.map((at) => ({ left: at.x - 8, right: at.x + 8, top: at.y - 8, bottom: at.y + 8 }));
    const places = placeNames(names, bodies, picture);
    assert.equal(places.length, names.length);
    for (const [i, place] of places.entries()) {
      if (place === null) continue;
      ++placed;
      if (place.far) ++farPlaced;
      assert.ok(place.far === false || names[i]!.far, "only those that may stand farther off");
      assert.ok(place.x >= 30 && place.x <= picture.width - 30 && place.y >= 6 && place.y <= picture.height - 6);
      for (const other of places.slice(i + 1))
        assert.ok(other === null || !share(place, other, 60, 12), `scrum ${scrum}`);
      for (const body of bodies)
        assert.ok(!share(place, { x: (body.left + body.right) / 2, y: (body.top + body.bottom) / 2 }, 38, 14));
    }
  }
  assert.ok(placed > 60 && farPlaced > 5, `${placed} placed, ${farPlaced} of them far`);
});

test("a name stands below, then elsewhere beside, then at a line's end, then nowhere", () => {
  const [first] = placeNames([name(200, 150)], [], picture);
  assert.deepEqual([first!.x, first!.y, first!.far], [200, 150 + 8 + 3 + 6, false]);
  const same = Array.from({ length: 60 }, () => name(200, 150));
  const near = placeNames(same, [], picture).filter((place) => place !== null);
  assert.ok(near.length >= 4 && near.length <= 8 && near.every((place) => !place.far));
  const all = placeNames(
    same.map((one) => ({ ...one, far: true })),
    [],
    picture,
  );
  const far = all.filter((place) => place?.far);
  assert.ok(far.length >= 8 && all.some((place) => place === null));
  assert.ok(far.every((place) => Math.hypot(place!.x - 200, place!.y - 150) <= 8 + 3 + 58 + 31));
  // At the edge it is pushed aside; where nothing is free there is none.
  assert.equal(placeNames([name(5, 150)], [], picture)[0]!.x, 30);
  assert.deepEqual(placeNames([name(200, 150)], [{ left: 0, top: 0, right: 400, bottom: 300 }], picture), [null]);
});

test("a name keeps its place while that is free", () => {
  const above = placeNames([name(200, 150)], [{ left: 150, top: 160, right: 250, bottom: 170 }], picture)[0]!;
  assert.ok(above.y < 150);
  const later = name(201, 150, { before: above.place });
  assert.equal(placeNames([later], [], picture)[0]!.place, above.place);
  const taken = { left: 150, top: 130, right: 250, bottom: 140 };
  assert.notEqual(placeNames([later], [taken], picture)[0]!.place, above.place);
  // From farther off it comes back as soon as there is room beside.
  const far = placeNames(
    [name(200, 150, { far: true })],
    [{ left: 100, top: 125, right: 300, bottom: 175 }],
    picture,
  )[0]!;
  assert.equal(far.far, true);
  assert.equal(placeNames([name(200, 150, { far: true, before: far.place })], [], picture)[0]!.far, false);
});

test("of the names of a picture the chosen robot's is written first, and none twice", () => {
  const { context, texts } = noting();
  const labels = new Labels();
  const add = (key: string, rank: "chosen" | "other") =>
    labels.add({ key, text: key, x: 100, y: 50, radius: 8, ink: "", rank, pixels: 10 });
  labels.clear();
  for (let i = 0; i < 20; ++i) add(`other ${i}`, "other");
  add("chosen", "chosen");
  add("", "chosen");
  labels.write(context, { width: 200, height: 100 }, "");
  assert.equal(texts[0]!.text, "chosen");
  assert.deepEqual([texts[0]!.x, texts[0]!.y], [100, 50 + 8 + 3 + 6]);
  assert.ok(texts.length > 3 && texts.length < 12, `${texts.length} have room`);
  assert.equal(new Set(texts.map(({ text }) => text)).size, texts.length);
});

test("the ball has at least 12 pixels", () => {
  for (const scale of [10, 30, 60, 120]) assert.equal(shownBallRadius(0.05, scale), 6);
  assert.equal(shownBallRadius(0.05, 200), 10);
});

test("an ellipse has the axes of its covariance", () => {
  assert.deepEqual(ellipseOf([4, 0, 1]), { major: 2, minor: 1, angle: 0 });
  const { major, minor, angle } = ellipseOf([2.5, 1.5, 2.5]);
  assert.ok(Math.abs(major - 2) < 1e-12 && Math.abs(minor - 1) < 1e-12 && Math.abs(angle - Math.PI / 4) < 1e-12);
});

test("a name that may stand upon its point does so while that is free, else beside it", () => {
  const wanted = name(200, 150, { radius: 0, upon: true, far: true });
  const [free] = placeNames([wanted], [], picture);
  assert.deepEqual([free!.x, free!.y, free!.far], [200, 150, false]);
  const robot = { left: 192, right: 208, top: 142, bottom: 158 };
  const beside = placeNames([{ ...wanted, before: free!.place }], [robot], picture)[0]!;
  assert.ok(!share(beside, { x: 200, y: 150 }, 38, 14));
  assert.deepEqual(placeNames([{ ...wanted, before: beside.place }], [], picture)[0]!.place, free!.place);
});

// Notes the calls that paint, with the colours and widths they paint in.
function painting() {
  const calls: unknown[][] = [];
  const state = { strokeStyle: "", fillStyle: "", lineWidth: 0, globalAlpha: 1 };
  let dash: number[] = [];
  const context = Object.assign(state, {
    save: () => {},
    restore: () => {},
    beginPath: () => {},
    moveTo: (x: number, y: number) => calls.push(["move", x, y]),
    lineTo: (x: number, y: number) => calls.push(["line", x, y]),
    arc: (x: number, y: number, radius: number) => calls.push(["dot", x, y, radius]),
    closePath: () => calls.push(["close"]),
    setLineDash: (to: number[]) => (dash = to),
    fill: () => calls.push(["fill", state.fillStyle, state.globalAlpha]),
    stroke: () => calls.push(["stroke", state.strokeStyle, state.lineWidth, dash.length > 0]),
  });
  return { calls, context: context as unknown as CanvasRenderingContext2D };
}

test("shapes are drawn in metres, with what the viewer chooses where the plugin does not", () => {
  const to = { x: (x: number) => 100 * x, y: (y: number) => -100 * y, scale: 100 } as Projection;
  const shape = (kind: Shape["kind"], more: Partial<Shape> = {}): Shape => ({
    ...{ kind, text: "", colour: null, width: null, filled: false },
    ...{ at: [[0, 0] as [number, number], [1, 2] as [number, number]] },
    ...more,
  });
  const drawn = (shapes: Shape[], style = styleOf(0, ["#111", "#222"])) => {
    const { calls, context } = painting();
    const labels = new Labels();
    drawShapes(context, to, shapes, style, labels, "key");
    return calls;
  };
  const path = [
    ["move", 0, -0],
    ["line", 100, -200],
  ];
  assert.deepEqual(drawn([shape("line")]), [...path, ["stroke", "#111", 2, false]]);
  assert.deepEqual(drawn([shape("line", { width: 0.001 })]), [...path, ["stroke", "#111", 1, false]]);
  const own = { colour: "#12345678", width: 0.5 };
  assert.deepEqual(drawn([shape("line", own)]), [...path, ["stroke", "#12345678", 50, false]]);
  const closed = [...path, ["close"]];
  assert.deepEqual(drawn([shape("polygon")]), [...closed, ["stroke", "#111", 2, false]]);
  const pale = ["fill", "#111", 0.2];
  assert.deepEqual(drawn([shape("polygon", { filled: true })]), [...closed, pale, ["stroke", "#111", 2, false]]);
  const full = ["fill", "#12345678", 1];
  const edge = ["stroke", "#12345678", 50, false];
  assert.deepEqual(drawn([shape("polygon", { ...own, filled: true })]), [...closed, full, edge]);
  assert.deepEqual(drawn([shape("points")]), [
    ["move", 4, -0],
    ["dot", 0, -0, 4],
    ["move", 104, -200],
    ["dot", 100, -200, 4],
    ["fill", "#111", 1],
  ]);
  // Colours that are used up come again, dashed.
  assert.deepEqual(drawn([shape("line")], styleOf(3, ["#111", "#222"])), [...path, ["stroke", "#222", 2, true]]);
  assert.deepEqual(drawn([shape("line", { at: [] })]), []);
});

test("texts of drawings are names, and of very many only so many are held against each other", () => {
  const { context } = painting();
  const labels = new Labels();
  labels.clear();
  const to = { x: (x: number) => x, y: (y: number) => y, scale: 1 } as Projection;
  const shapes = Array.from({ length: 20_000 }, (_, i): Shape => ({
    ...{ kind: "text", at: [[(17 * i) % 400, (29 * i) % 300]], text: `text ${i}` },
    ...{ colour: null, width: null, filled: false },
  }));
  drawShapes(context, to, shapes, { colour: "#111", dashed: false }, labels, "key");
  const noted = noting();
  const began = performance.now();
  labels.write(noted.context, picture, "");
  assert.ok(performance.now() - began < 500);
  assert.ok(noted.texts.length > 20 && noted.texts.length <= 200, `${noted.texts.length}`);
  assert.deepEqual(noted.texts[0], { text: "text 0", x: 19.5, y: 9 }); // pushed into the picture
});
