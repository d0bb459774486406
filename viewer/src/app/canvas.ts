// SPDX-License-Identifier: MIT
// A canvas as large as its place in the page, sharp on every screen.
export class Canvas {
  readonly context: CanvasRenderingContext2D;
  width = 0; // of the place, in CSS pixels
  height = 0;
  scale = 0;

  constructor(
    readonly element: HTMLCanvasElement,
    alpha = false,
  ) {
    const context = element.getContext("2d", { alpha });
    if (context === null) throw new Error("no canvas");
    this.context = context;
  }

  // true: its size has changed, and it is empty.
  fit(width: number, height: number): boolean {
    const scale = Math.min(3, window.devicePixelRatio || 1);
    if (width === this.width && height === this.height && scale === this.scale) return false;
    this.width = width;
    this.height = height;
    this.scale = scale;
    this.element.width = Math.max(1, Math.round(width * scale));
    this.element.height = Math.max(1, Math.round(height * scale));
    this.context.setTransform(scale, 0, 0, scale, 0, 0);
    return true;
  }
}

export const font = (pixels: number, weight = 400) => `${weight} ${pixels}px system-ui, "DejaVu Sans", sans-serif`;
