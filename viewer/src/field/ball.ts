// SPDX-License-Identifier: MIT
// The ball, to be seen at every size of the field and in light and dark: true, a white disc with a black rim and a
// black middle; believed, an empty ring with a cross.
import type { Context } from "./shapes";

const leastRadius = 6; // px; the ball of 5 cm would have 2 or 3
const white = "#ffffff";
const black = "#000000";

// In pixels. metres: the true one; scale: pixels per metre.
export const shownBallRadius = (metres: number, scale: number): number => Math.max(leastRadius, metres * scale);

export function drawTrueBall(context: Context, x: number, y: number, radius: number): void {
  for (const [size, colour] of [
    [radius + 1.5, white], // parts the rim from dark grass and dark robots
    [radius, black],
    [radius - 2, white],
    [radius / 3, black],
  ] as const) {
    context.beginPath();
    context.arc(x, y, size, 0, 2 * Math.PI);
    context.fillStyle = colour;
    context.fill();
  }
}

// Larger than the true ball: both are seen where they are at the same place.
export function drawBelievedBall(context: Context, x: number, y: number, radius: number, colour: string): void {
  const ring = radius + 3.5;
  context.setLineDash([]);
  context.lineWidth = 1.75;
  context.strokeStyle = colour;
  context.beginPath();
  context.arc(x, y, ring, 0, 2 * Math.PI);
  for (const [dx, dy] of [
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ] as const) {
    context.moveTo(x + dx * (radius - 2), y + dy * (radius - 2));
    context.lineTo(x + dx * (ring + 4), y + dy * (ring + 4));
  }
  context.stroke();
}
