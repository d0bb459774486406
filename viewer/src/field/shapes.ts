// SPDX-License-Identifier: MIT
// The marks of the field. Teams differ in shape as well as in colour: home are discs, away squares.
import { type Side } from "../recording/about";
import type { Covariance } from "../recording/messages";
import type { Projection } from "./projection";

export type Context = CanvasRenderingContext2D;

// Ellipses reach as many standard deviations as in the program's pictures; of a normal law 86 % lies within two.
export const shownDeviations = 2;

export function bodyPath(context: Context, side: Side, x: number, y: number, radius: number): void {
  context.beginPath();
  if (side === 0) context.arc(x, y, radius, 0, 2 * Math.PI);
  else context.roundRect(x - 0.92 * radius, y - 0.92 * radius, 1.84 * radius, 1.84 * radius, 0.28 * radius);
}

// Where it looks: a short line from the rim outwards.
export function headingPath(context: Context, x: number, y: number, heading: number, from: number, to: number): void {
  const dx = Math.cos(heading);
  const dy = -Math.sin(heading);
  context.beginPath();
  context.moveTo(x + from * dx, y + from * dy);
  context.lineTo(x + to * dx, y + to * dy);
}

export function arrow(context: Context, x0: number, y0: number, x1: number, y1: number, head = 6): void {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < 1) return;
  const dx = (x1 - x0) / length;
  const dy = (y1 - y0) / length;
  const size = Math.min(head, length);
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.moveTo(x1 - size * (dx + 0.5 * dy), y1 - size * (dy - 0.5 * dx));
  context.lineTo(x1, y1);
  context.lineTo(x1 - size * (dx - 0.5 * dy), y1 - size * (dy + 0.5 * dx));
  context.stroke();
}

// Half axes in metres and direction in radians of the ellipse of one standard deviation.
export function ellipseOf([xx, xy, yy]: Covariance): { major: number; minor: number; angle: number } {
  const middle = (xx + yy) / 2;
  const apart = Math.hypot((xx - yy) / 2, xy);
  return {
    major: Math.sqrt(Math.max(0, middle + apart)),
    minor: Math.sqrt(Math.max(0, middle - apart)),
    angle: 0.5 * Math.atan2(2 * xy, xx - yy),
  };
}

export function ellipsePath(context: Context, to: Projection, x: number, y: number, covariance: Covariance): void {
  const { major, minor, angle } = ellipseOf(covariance);
  const scale = shownDeviations * to.scale;
  context.beginPath();
  context.ellipse(to.x(x), to.y(y), scale * major, scale * minor, -angle, 0, 2 * Math.PI);
}

// Text that can be read upon lines: with a rim of the ground's colour.
export function label(context: Context, text: string, x: number, y: number, ink: string, rim: string): void {
  context.lineJoin = "round";
  context.lineWidth = 3;
  context.strokeStyle = rim;
  context.strokeText(text, x, y);
  context.fillStyle = ink;
  context.fillText(text, x, y);
}
