// SPDX-License-Identifier: MIT
// Names upon the field that keep clear of each other: each takes the first of its places that is free.
import { type Context, label } from "./shapes";

const maxBoxes = 512;

export class Labels {
  private readonly boxes = new Float32Array(4 * maxBoxes); // left, top, right, bottom
  private count = 0;

  private width = 0;
  private height = 0;

  // Of a canvas of this size.
  clear(width: number, height: number): void {
    this.count = 0;
    this.width = width;
    this.height = height;
  }

  // Nothing may be written here.
  take(x: number, y: number, halfWidth: number, halfHeight: number): void {
    if (this.count === maxBoxes) return;
    this.boxes.set([x - halfWidth, y - halfHeight, x + halfWidth, y + halfHeight], 4 * this.count++);
  }

  private free(x: number, y: number, halfWidth: number, halfHeight: number): boolean {
    const { boxes } = this;
    if (x < halfWidth || x + halfWidth > this.width || y < halfHeight || y + halfHeight > this.height) return false;
    for (let i = 0; i < 4 * this.count; i += 4) {
      if (
        x + halfWidth > boxes[i]! &&
        x - halfWidth < boxes[i + 2]! &&
        y + halfHeight > boxes[i + 1]! &&
        y - halfHeight < boxes[i + 3]!
      )
        return false;
    }
    return true;
  }

  // Beside something of this radius: below, above, right, left. false: nowhere is room, and nothing is written, unless
  // it must be.
  beside(
    context: Context,
    text: string,
    x: number,
    y: number,
    radius: number,
    ink: string,
    rim: string,
    must: boolean,
  ): boolean {
    const width = context.measureText(text).width / 2;
    const height = 5;
    const side = radius + width + 3;
    const places = [
      [0, radius + 8],
      [0, -radius - 8],
      [side, 0],
      [-side, 0],
      [0, radius + 18],
      [0, -radius - 18],
      [side, radius + 4],
      [-side, radius + 4],
      [side, -radius - 4],
      [-side, -radius - 4],
    ] as const;
    const found = places.find(([dx, dy]) => this.free(x + dx, y + dy, width, height)) ?? (must ? places[0] : null);
    if (found === null) return false;
    const at = Math.min(this.width - width, Math.max(width, x + found[0]));
    label(context, text, at, y + found[1], ink, rim);
    this.take(at, y + found[1], width, height);
    return true;
  }
}
