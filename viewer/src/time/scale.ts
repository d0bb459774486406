// SPDX-License-Identifier: MIT
// Time along the width of the page: the whole match above, a window of it below.
export const gutter = 92; // for names, left
export const margin = 14; // right

export class TimeScale {
  width = 0;

  constructor(
    public from: number,
    public to: number,
  ) {}

  x(time: number): number {
    return gutter + ((time - this.from) / Math.max(1e-9, this.to - this.from)) * (this.width - gutter - margin);
  }

  time(x: number): number {
    const share = (x - gutter) / Math.max(1, this.width - gutter - margin);
    return this.from + Math.min(1, Math.max(0, share)) * (this.to - this.from);
  }

  get pixelsPerSecond(): number {
    return (this.width - gutter - margin) / Math.max(1e-9, this.to - this.from);
  }
}

// Distance of the marks of an axis: the first that leaves room for their texts.
export function tickSeconds(scale: TimeScale): number {
  return (
    [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600].find((step) => step * scale.pixelsPerSecond >= 62) ?? 1200
  );
}
