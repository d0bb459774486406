// SPDX-License-Identifier: MIT
// The field and its lines: drawn once for a projection and a theme.
import type { FieldSize } from "../recording/about";
import type { Palette } from "../app/palette";
import type { Projection } from "./projection";

export function drawGround(
  context: CanvasRenderingContext2D,
  size: { width: number; height: number },
  to: Projection,
  field: FieldSize,
  palette: Palette,
): void {
  context.fillStyle = palette.surround;
  context.fillRect(0, 0, size.width, size.height);
  context.fillStyle = palette.grass;
  const strip = 0.35; // the border, a little beyond the lines
  const box = (x: number, y: number, length: number, width: number) =>
    [to.x(x), to.y(y + width), length * to.scale, width * to.scale] as const;
  const { length, width } = field;
  context.beginPath();
  context.roundRect(...box(-length / 2 - strip, -width / 2 - strip, length + 2 * strip, width + 2 * strip), 6);
  context.fill();

  context.strokeStyle = palette.chalk;
  context.lineWidth = Math.max(1.5, 0.05 * to.scale * 0.6);
  context.strokeRect(...box(-length / 2, -width / 2, length, width));
  context.beginPath();
  context.moveTo(to.x(0), to.y(-width / 2));
  context.lineTo(to.x(0), to.y(width / 2));
  context.stroke();
  context.beginPath();
  context.arc(to.x(0), to.y(0), field.centreCircleRadius * to.scale, 0, 2 * Math.PI);
  context.stroke();
  context.fillStyle = palette.chalk;
  for (const end of [-1, 1]) {
    for (const [depth, across] of [field.goalArea, field.penaltyArea]) {
      context.strokeRect(...box(end < 0 ? -length / 2 : length / 2 - depth, -across / 2, depth, across));
    }
    context.beginPath();
    context.arc(to.x(end * (length / 2 - field.penaltyMarkDistance)), to.y(0), 2, 0, 2 * Math.PI);
    context.fill();
    context.save();
    context.strokeStyle = palette.muted;
    const goal = box(
      end < 0 ? -length / 2 - field.goalDepth : length / 2,
      -field.goalWidth / 2,
      field.goalDepth,
      field.goalWidth,
    );
    context.lineWidth = 2;
    context.strokeRect(...goal);
    context.restore();
  }
  context.beginPath();
  context.arc(to.x(0), to.y(0), 2, 0, 2 * Math.PI);
  context.fill();
}
