// SPDX-License-Identifier: MIT
// The colours of layers that plugins draw in can be told apart, and from the grass, with every kind of colour vision.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { drawingColours } from "../src/app/palette";

type Triple = [number, number, number];

// Tests run in the viewer's folder.
const [light, dark] = readFileSync("src/style/1_colours_and_controls.css", "utf8").split(':root[data-theme="dark"]');

function colour(theme: string, name: string): Triple {
  const digits = new RegExp(`--${name}: #([0-9a-f]{6});`).exec(theme)![1]!;
  const linear = (part: number) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
  return [0, 2, 4].map((i) => linear(Number.parseInt(digits.slice(i, i + 2), 16) / 255)) as Triple;
}

const by = (rows: readonly Triple[], [a, b, c]: Triple) => rows.map(([x, y, z]) => x * a + y * b + z * c) as Triple;

// Of linear red, green and blue, for who lacks one kind of cone (Machado, Oliveira and Fernandes, 2009).
const visions: Record<string, Triple[]> = {
  normal: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protanopia: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranopia: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritanopia: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};

const toXyz: Triple[] = [
  [0.4124, 0.3576, 0.1805],
  [0.2126, 0.7152, 0.0722],
  [0.0193, 0.1192, 0.9505],
];

// CIE 1976 L*a*b*, white of D65.
function lab(seen: Triple): Triple {
  const [x, y, z] = by(toXyz, seen.map((part) => Math.min(1, Math.max(0, part))) as Triple);
  const f = (share: number) => (share > 0.008856 ? Math.cbrt(share) : 7.787 * share + 16 / 116);
  return [116 * f(y) - 16, 500 * (f(x / 0.95047) - f(y)), 200 * (f(y) - f(z / 1.08883))];
}

// By the Web Content Accessibility Guidelines 2.1.
function contrast(a: Triple, b: Triple): number {
  const [least, most] = [by(toXyz, a)[1], by(toXyz, b)[1]].sort((x, y) => x - y);
  return (most! + 0.05) / (least! + 0.05);
}

test("colours of layers differ from each other, and can be read upon the grass", () => {
  for (const [name, theme] of Object.entries({ light: light!, dark: dark! })) {
    const grass = colour(theme, "grass");
    const all = Array.from({ length: drawingColours }, (_, i) => colour(theme, `drawing-${i}`));
    for (const [i, one] of all.entries()) {
      assert.ok(contrast(one, grass) >= 4.5, `${name} ${i}: contrast ${contrast(one, grass)}`);
      for (const [j, other] of all.slice(0, i).entries()) {
        for (const [vision, rows] of Object.entries(visions)) {
          const [a, b] = [lab(by(rows, one)), lab(by(rows, other))];
          const apart = Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
          assert.ok(apart >= 15, `${name} ${j} and ${i}, ${vision}: ${apart}`);
        }
      }
    }
  }
});
