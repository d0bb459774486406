// SPDX-License-Identifier: MIT
// What a plugin drew, upon the field: points, lines, polygons, and texts as names that keep clear of others. What the
// plugin leaves open is chosen here; nothing is so thin that it cannot be seen.
import { shortened } from "../model/text";
import type { Shape } from "../recording/plugin_messages";
import type { Projection } from "./projection";
import type { Labels } from "./labels";
import type { Context } from "./shapes";

export interface DrawingStyle {
  colour: string; // of shapes without one
  dashed: boolean; // their lines
}

const usualLine = 0.02; // m
const usualDot = 0.08; // m
const leastLine = 1; // px
const leastDot = 3; // px
const paleFill = 0.2; // of the viewer's colour: what lies below is seen
const mostLetters = 60; // of a text

// Layers come in the colours of the palette; when these are used up they come again, dashed.
export const styleOf = (layer: number, colours: readonly string[]): DrawingStyle => ({
  colour: colours[layer % colours.length]!,
  dashed: layer >= colours.length,
});

// key: of the names of this drawing, the same from picture to picture.
export function drawShapes(
  context: Context,
  to: Projection,
  shapes: readonly Shape[],
  style: DrawingStyle,
  labels: Labels,
  key: string,
): void {
  context.save();
  context.lineJoin = "round";
  context.lineCap = "round";
  for (const [i, { kind, at, text, colour, width, filled }] of shapes.entries()) {
    const ink = colour ?? style.colour;
    const [first, ...rest] = at;
    if (first === undefined) continue;
    if (kind === "text") {
      const [x, y] = [to.x(first[0]), to.y(first[1])];
      const name = { text: shortened(text, mostLetters), x, y, radius: 0, ink, pixels: 10 };
      labels.add({ ...name, key: `${key} ${i}`, rank: "drawing" });
      continue;
    }
    context.strokeStyle = ink;
    context.fillStyle = ink;
    context.beginPath();
    if (kind === "points") {
      const radius = Math.max(leastDot, (width ?? usualDot) * to.scale) / 2;
      for (const [x, y] of at) {
        context.moveTo(to.x(x) + radius, to.y(y));
        context.arc(to.x(x), to.y(y), radius, 0, 2 * Math.PI);
      }
      context.fill();
      continue;
    }
    context.moveTo(to.x(first[0]), to.y(first[1]));
    for (const [x, y] of rest) context.lineTo(to.x(x), to.y(y));
    if (kind === "polygon") context.closePath();
    if (kind === "polygon" && filled) {
      context.globalAlpha = colour === null ? paleFill : 1;
      context.fill();
      context.globalAlpha = 1;
    }
    context.lineWidth = Math.max(leastLine, (width ?? usualLine) * to.scale);
    const step = 3 * context.lineWidth + 2;
    context.setLineDash(style.dashed && colour === null ? [step, step] : []);
    context.stroke();
  }
  context.restore();
}
