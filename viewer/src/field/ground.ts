// SPDX-License-Identifier: MIT
// The field and its lines: drawn once for a size and a theme. Metres become pixels here.
import type { FieldSize } from "../recording/about";
import type { Palette } from "../app/palette";

// World frame (centre, x to the right, y up) to pixels.
export class Projection {
  scale = 1; // pixels per metre
  centreX = 0;
  centreY = 0;

  constructor(private readonly field: FieldSize) {}

  get aspect(): number {
    return (this.field.length + 2 * this.margin) / (this.field.width + 2 * this.margin);
  }

  private get margin(): number {
    return Math.max(this.field.borderStrip, this.field.goalDepth + 0.1);
  }

  fit(width: number, height: number): void {
    const { field, margin } = this;
    this.scale = Math.min(width / (field.length + 2 * margin), height / (field.width + 2 * margin));
    this.centreX = width / 2;
    this.centreY = height / 2;
  }

  x(x: number): number {
    return this.centreX + this.scale * x;
  }

  y(y: number): number {
    return this.centreY - this.scale * y;
  }

  world(px: number, py: number): [number, number] {
    return [(px - this.centreX) / this.scale, (this.centreY - py) / this.scale];
  }
}

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
