// SPDX-License-Identifier: MIT
// The whole match in one line: when the ball was in play, goals and penalties, role overlaps, and which part
// the window below shows.
import { Canvas, font } from "../app/canvas";
import type { Palette } from "../app/palette";
import { playing } from "../model/game";
import { timeText } from "../model/text";
import { bothSides } from "../recording/about";
import type { Match } from "../recording/match";
import { type TimeScale, gutter, margin, tickSeconds } from "./scale";

export const overviewHeight = 44;
const bandTop = 15;
const bandHeight = 24;

export class Overview {
  readonly canvas: Canvas;
  private readonly fixed: Canvas; // all but the window
  private stale = true;

  constructor(
    element: HTMLCanvasElement,
    private readonly match: Match,
    readonly scale: TimeScale,
  ) {
    this.canvas = new Canvas(element);
    this.fixed = new Canvas(document.createElement("canvas"));
  }

  invalidate(): void {
    this.stale = true;
  }

  resize(width: number): void {
    this.scale.width = width;
    if (this.canvas.fit(width, overviewHeight)) this.stale = true;
    this.fixed.fit(width, overviewHeight);
  }

  draw(palette: Palette, window: TimeScale): void {
    if (this.stale) this.drawFixed(palette);
    this.stale = false;
    const { context } = this.canvas;
    context.drawImage(this.fixed.element, 0, 0, this.canvas.width, this.canvas.height);
    const from = this.scale.x(window.from);
    const width = Math.max(2, this.scale.x(window.to) - from);
    context.fillStyle = palette.accent;
    context.globalAlpha = 0.14;
    context.fillRect(from, bandTop, width, bandHeight + 4);
    context.globalAlpha = 1;
    context.strokeStyle = palette.accent;
    context.lineWidth = 1;
    context.strokeRect(from + 0.5, bandTop + 0.5, width - 1, bandHeight + 3);
  }

  private drawFixed(palette: Palette): void {
    const { context, width } = this.fixed;
    const { match, scale } = this;
    const { game } = match;
    context.fillStyle = palette.panel;
    context.fillRect(0, 0, width, overviewHeight);
    context.font = font(10);
    context.textBaseline = "middle";
    context.textAlign = "right";
    context.fillStyle = palette.muted;
    context.fillText("match", gutter - 8, bandTop + bandHeight / 2);
    // Not in play: darker.
    context.fillStyle = palette.sunken;
    context.fillRect(gutter, bandTop, width - gutter - margin, bandHeight);
    context.fillStyle = palette.panel;
    for (let i = 0, from = -1; i <= game.count; ++i) {
      const inPlay = i < game.count && game.phase[i] === playing;
      if (inPlay && from < 0) from = i;
      if (!inPlay && from >= 0) {
        const x = scale.x(game.times[from]!);
        context.fillRect(x, bandTop, scale.x(game.times[i - 1]! + 0.1) - x, bandHeight);
        from = -1;
      }
    }
    // Role overlaps: home hangs from the top, away stands on the bottom.
    for (const side of bothSides) {
      context.fillStyle = palette.overlap;
      for (const { from, to } of match.courses[side].overlaps) {
        const x = scale.x(from);
        context.fillRect(
          x,
          side === 0 ? bandTop : bandTop + bandHeight / 2,
          Math.max(1, scale.x(to) - x),
          bandHeight / 2 - 1,
        );
      }
    }
    this.drawGaps(palette);
    context.strokeStyle = palette.line;
    context.strokeRect(gutter + 0.5, bandTop + 0.5, width - gutter - margin - 1, bandHeight - 1);
    context.beginPath();
    context.moveTo(gutter, bandTop + bandHeight / 2);
    context.lineTo(width - margin, bandTop + bandHeight / 2);
    context.stroke();

    context.textAlign = "center";
    context.fillStyle = palette.muted;
    const step = tickSeconds(scale);
    for (let t = Math.ceil(scale.from / step) * step; t <= scale.to; t += step) {
      context.fillText(timeText(t, 0), scale.x(t), 7);
      context.fillRect(scale.x(t), bandTop - 3, 1, 3);
    }
    for (const event of match.events) {
      if (event.event !== "goal") continue;
      const x = scale.x(event.time);
      context.fillStyle = event.side === 0 ? palette.home : palette.away;
      context.fillRect(x - 1, bandTop, 2, bandHeight);
      context.beginPath();
      context.moveTo(x - 6, bandTop + bandHeight + 5);
      context.lineTo(x, bandTop + bandHeight - 5);
      context.lineTo(x + 6, bandTop + bandHeight + 5);
      context.closePath();
      context.fill();
      context.strokeStyle = palette.panel;
      context.stroke();
    }
  }
  // What cannot be read of the recording: hatched.
  private drawGaps(palette: Palette): void {
    const { context } = this.fixed;
    for (const { from, to } of this.match.gaps) {
      const x = this.scale.x(from);
      const w = Math.max(2, this.scale.x(to ?? this.scale.to) - x);
      context.save();
      context.beginPath();
      context.rect(x, bandTop, w, bandHeight);
      context.clip();
      context.fillStyle = palette.sunken;
      context.fillRect(x, bandTop, w, bandHeight);
      context.strokeStyle = palette.text;
      context.lineWidth = 1;
      context.beginPath();
      for (let at = x - bandHeight; at < x + w; at += 5) {
        context.moveTo(at, bandTop + bandHeight);
        context.lineTo(at + bandHeight, bandTop);
      }
      context.stroke();
      context.restore();
    }
  }
}
