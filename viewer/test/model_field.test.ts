// SPDX-License-Identifier: MIT
// What is drawn on the field, without a browser: where names stand, how large the ball and the ellipses are.
import assert from "node:assert/strict";
import { test } from "node:test";
import { shownBallRadius } from "../src/field/ball";
import type { Projection } from "../src/field/ground";
import { Labels } from "../src/field/labels";
import { type Wanted, placeNames } from "../src/field/placement";
import { ellipseOf, ellipsePath } from "../src/field/shapes";

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
