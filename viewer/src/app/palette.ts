// SPDX-License-Identifier: MIT
// Colours of canvases, taken from the style sheet, which knows light and dark. Those that carry meaning are of Okabe
// and Ito's palette for all kinds of colour vision ("Color Universal Design", 2008).
const names = [
  "text",
  "muted",
  "line",
  "panel",
  "sunken",
  "accent",
  "home",
  "away",
  "ball",
  "grass",
  "chalk",
  "surround",
  "nodes",
  "tasks",
  "overlap",
  "uncovered",
  "first",
  "second",
  "heat",
  "on-home",
  "on-away",
] as const;
export type Palette = Record<(typeof names)[number], string> & { roles: string[]; drawings: string[] };

// Of layers that plugins draw in.
export const drawingColours = 6;

export function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  const read = (name: string) => style.getPropertyValue(`--${name}`).trim();
  const colors = Object.fromEntries(names.map((name) => [name, read(name)])) as Record<(typeof names)[number], string>;
  const roles = Array.from({ length: 8 }, (_, i) => read(`role-${i}`));
  const drawings = Array.from({ length: drawingColours }, (_, i) => read(`drawing-${i}`));
  return { ...colors, roles, drawings };
}

// Steps of the colour map "cividis" (Nuñez, Anderton and Renslow, 2018), from the least to the greatest value.
const cividis = [
  "#00224e",
  "#123570",
  "#3b496c",
  "#575d6d",
  "#707173",
  "#8a8678",
  "#a59c74",
  "#c3b369",
  "#e1cc55",
  "#fee838",
];

// share: 0..1. `ink` can be read upon `fill`.
export function heat(share: number): { fill: string; ink: string } {
  const place = Math.min(1, Math.max(0, share)) * (cividis.length - 1);
  const at = Math.min(cividis.length - 2, Math.floor(place));
  const part = (color: string, i: number) => Number.parseInt(color.slice(1 + 2 * i, 3 + 2 * i), 16);
  const mixed = [0, 1, 2].map((i) => {
    const from = part(cividis[at]!, i);
    return Math.round(from + (part(cividis[at + 1]!, i) - from) * (place - at));
  });
  return { fill: `rgb(${mixed.join(" ")})`, ink: place > 5.2 ? "#111" : "#fff" };
}
