// SPDX-License-Identifier: MIT
// Metres become pixels here: the whole field, or a part of it that the reader has zoomed and moved to.
import type { FieldSize } from "../recording/about";

const mostZoom = 12;

// World frame (centre, x to the right, y up) to pixels.
export class Projection {
  scale = 1; // pixels per metre
  zoom = 1; // 1: the whole field
  private centreX = 0; // pixels, of the field's centre
  private centreY = 0;
  private width = 0;
  private height = 0;
  private middleX = 0; // metres, of the picture's middle
  private middleY = 0;

  constructor(private readonly field: FieldSize) {}

  get aspect(): number {
    return (this.field.length + 2 * this.margin) / (this.field.width + 2 * this.margin);
  }

  private get margin(): number {
    return Math.max(this.field.borderStrip, this.field.goalDepth + 0.1);
  }

  // The same while the picture shows the same part of the field.
  get key(): string {
    return [this.scale, this.centreX, this.centreY].join();
  }

  fit(width: number, height: number): void {
    [this.width, this.height] = [width, height];
    this.place();
  }

  // The place of the field at this point of the picture stays there.
  zoomAt(px: number, py: number, factor: number): void {
    const [x, y] = this.world(px, py);
    this.zoom = Math.min(mostZoom, Math.max(1, this.zoom * factor));
    this.place();
    const [nextX, nextY] = this.world(px, py);
    this.centreOn(this.middleX + x - nextX, this.middleY + y - nextY);
  }

  zoomBy(factor: number): void {
    this.zoomAt(this.width / 2, this.height / 2, factor);
  }

  // By pixels: the field goes with the pointer.
  pan(px: number, py: number): void {
    this.centreOn(this.middleX - px / this.scale, this.middleY + py / this.scale);
  }

  // Metres; as near to the middle of the picture as the field's edges allow.
  centreOn(x: number, y: number): void {
    [this.middleX, this.middleY] = [x, y];
    this.place();
  }

  whole(): void {
    this.zoom = 1;
    this.centreOn(0, 0);
  }

  // The picture never leaves what it shows of the whole field.
  private place(): void {
    const { field, margin, width, height } = this;
    const whole = Math.min(width / (field.length + 2 * margin), height / (field.width + 2 * margin));
    this.scale = whole * this.zoom;
    const within = (value: number, size: number) => {
      const room = whole > 0 ? (size / whole - size / this.scale) / 2 : 0;
      return Math.min(room, Math.max(-room, value));
    };
    this.middleX = within(this.middleX, width);
    this.middleY = within(this.middleY, height);
    this.centreX = width / 2 - this.scale * this.middleX;
    this.centreY = height / 2 + this.scale * this.middleY;
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
