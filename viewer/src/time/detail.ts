// SPDX-License-Identifier: MIT
// A window of the match: a row for each robot of one team with the roles it held and the packets it sent; roles held
// twice are framed in the rows and named below, those that nobody held are counted in the last row.
import { Canvas, font } from "../app/canvas";
import type { Palette } from "../app/palette";
import type { View } from "../app/state";
import { inMask } from "../model/game";
import { shortRoleName } from "../model/look";
import type { Stretch } from "../model/roles";
import { timeText, words } from "../model/text";
import type { Side } from "../recording/about";
import type { Match } from "../recording/match";
import { type TimeScale, gutter, margin, tickSeconds } from "./scale";

export const axisHeight = 24; // times above, events below
export const stripHeight = 12;
const lane = 2.5; // at the foot of each row, for packets

export class Detail {
  readonly canvas: Canvas;

  constructor(
    element: HTMLCanvasElement,
    readonly match: Match,
    readonly scale: TimeScale,
  ) {
    this.canvas = new Canvas(element);
  }

  resize(width: number, height: number): boolean {
    this.scale.width = width;
    return this.canvas.fit(width, height);
  }

  rowHeight(side: Side): number {
    return (this.canvas.height - axisHeight - 2 * stripHeight - 4) / Math.max(1, this.match.game.sizes[side]);
  }

  draw(view: View, palette: Palette): void {
    const { context, width, height } = this.canvas;
    const { side } = view;
    context.fillStyle = palette.panel;
    context.fillRect(0, 0, width, height);
    context.save();
    context.beginPath();
    context.rect(gutter, 0, width - gutter - margin, height);
    context.clip();
    this.drawAxis(palette);
    this.drawRuns(view, palette);
    this.drawOverlapFrames(side, palette);
    this.drawPackets(view, palette);
    this.drawStrips(side, palette);
    context.restore();
    this.drawNames(view, palette);
  }

  private drawAxis(palette: Palette): void {
    const { context, height } = this.canvas;
    const { scale, match } = this;
    const step = tickSeconds(scale);
    context.font = font(10);
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (let i = Math.ceil(scale.from / step); i * step <= scale.to; ++i) {
      const x = Math.round(scale.x(i * step));
      context.fillStyle = palette.line;
      context.fillRect(x, axisHeight - 10, 1, height);
      context.fillStyle = palette.muted;
      context.fillText(timeText(i * step, step < 1 ? 1 : 0), x, 7);
    }
    context.textAlign = "left";
    let free = -Infinity;
    for (const event of match.events) {
      if (event.time < scale.from - 5 || event.time > scale.to) continue;
      const x = scale.x(event.time);
      const goal = event.event === "goal";
      context.fillStyle = event.side === 0 ? palette.home : palette.away;
      context.fillRect(x, axisHeight - 9, goal ? 3 : 1.5, goal ? height : 9);
      const text = `${words(event.event)}${event.robot > 0 ? ` ${event.robot}` : ""}`;
      if (x < free) continue;
      context.font = font(10, goal ? 700 : 400);
      context.fillText(text, x + 4, axisHeight - 4);
      free = x + 8 + context.measureText(text).width;
    }
  }

  private drawRuns(view: View, palette: Palette): void {
    const { context } = this.canvas;
    const { scale, match } = this;
    const { side } = view;
    const { game } = match;
    const rowHeight = this.rowHeight(side);
    context.textAlign = "left";
    context.textBaseline = "middle";
    context.font = font(Math.min(10.5, rowHeight - 2.6));
    for (const [n, runs] of match.courses[side].runs.entries()) {
      const y = axisHeight + n * rowHeight;
      for (const { role, from, to } of runs) {
        const begin = game.times[from]!;
        const end = game.times[Math.min(to, game.count - 1)]!;
        if (end < scale.from) continue;
        if (begin > scale.to) break;
        const x = Math.max(gutter - 1, scale.x(begin));
        const w = Math.min(this.canvas.width, scale.x(end)) - x;
        context.fillStyle = role < 0 ? palette.sunken : palette.roles[role % 8]!;
        context.fillRect(x, y + 1, Math.max(0.5, w - 0.5), rowHeight - 1 - lane);
        if (w > 24) {
          context.fillStyle = role < 0 ? palette.muted : palette.text;
          const name = shortRoleName(match, side, role).replaceAll("_", " ");
          context.fillText(fitted(context, name, w - 6), x + 3, y + (rowHeight - lane) / 2 + 1.2);
        }
      }
      // Penalised: struck through.
      const first = game.indexAt(scale.from);
      context.fillStyle = palette.text;
      for (let i = first; i < game.count && game.times[i]! < scale.to; ++i) {
        if (inMask(game.penalised[2 * i + side]!, n + 1)) {
          const x = scale.x(game.times[i]!);
          context.fillRect(x, y + rowHeight / 2 - 0.75, scale.x(game.times[i]! + 0.1) - x + 0.5, 1.5);
        }
      }
    }
  }

  private drawOverlapFrames(side: Side, palette: Palette): void {
    const { context } = this.canvas;
    const { scale, match } = this;
    const rowHeight = this.rowHeight(side);
    context.strokeStyle = palette.overlap;
    context.lineWidth = 2;
    for (const stretch of this.visible(match.courses[side].overlaps)) {
      for (const robot of stretch.robots) {
        for (const [from, to] of held(match, side, robot, stretch)) {
          const x = scale.x(from);
          const w = Math.max(2, scale.x(to) - x);
          const y = axisHeight + (robot - 1) * rowHeight;
          context.strokeRect(x + 0.5, y + 1.5, w - 1, rowHeight - 2 - lane);
        }
      }
    }
  }

  // A packet stands as a triangle on the foot of its sender's row; hollow and crossed when the chosen robot never
  // heard it.
  private drawPackets(view: View, palette: Palette): void {
    const { context } = this.canvas;
    const { scale, match } = this;
    const rowHeight = this.rowHeight(view.side);
    const size = 3.4;
    const listener = view.robot !== null && view.robot.side === view.side ? view.robot.number : 0;
    for (let n = 1; n <= match.game.sizes[view.side]; ++n) {
      const foot = axisHeight + n * rowHeight - 0.5;
      for (const packet of match.packets.between(view.side, n, scale.from, scale.to)) {
        const x = scale.x(packet.time);
        const missed = listener > 0 && listener !== n && !packet.heard.has(listener);
        context.beginPath();
        context.moveTo(x - size, foot);
        context.lineTo(x, foot - 1.45 * size);
        context.lineTo(x + size, foot);
        context.closePath();
        context.fillStyle = missed ? palette.panel : palette.text;
        context.strokeStyle = missed ? palette.text : palette.panel;
        context.lineWidth = missed ? 1.25 : 0.75;
        context.fill();
        context.stroke();
        if (missed) {
          context.beginPath();
          context.moveTo(x - size, foot - 1.45 * size);
          context.lineTo(x + size, foot);
          context.stroke();
        }
      }
    }
  }

  private drawStrips(side: Side, palette: Palette): void {
    const { context, height } = this.canvas;
    const { scale, match } = this;
    const top = height - 2 * stripHeight - 2;
    const course = match.courses[side];
    context.font = font(9.5);
    context.textAlign = "left";
    context.textBaseline = "middle";
    for (const stretch of this.visible(course.overlaps)) {
      const x = scale.x(stretch.from);
      const w = Math.max(1.5, scale.x(stretch.to) - x);
      context.fillStyle = palette.overlap;
      context.fillRect(x, top + 1, w, stripHeight - 2);
      if (w > 22) {
        context.fillStyle = "#111";
        context.fillText(
          fitted(context, `${shortRoleName(match, side, stretch.role)} ${stretch.robots.join(" ")}`, w - 4),
          x + 2,
          top + stripHeight / 2 + 0.5,
        );
      }
    }
    const missing = this.visible(course.uncovered);
    context.fillStyle = palette.uncovered;
    context.globalAlpha = 0.38; // of several at a time the strip grows darker
    for (const stretch of missing) {
      const x = scale.x(stretch.from);
      context.fillRect(x, top + stripHeight + 1, Math.max(1, scale.x(stretch.to) - x), stripHeight - 2);
    }
    context.globalAlpha = 1;
    let free = -Infinity;
    context.fillStyle = palette.text;
    for (const stretch of missing) {
      const x = Math.max(gutter, scale.x(stretch.from));
      const w = scale.x(stretch.to) - x;
      if (w < 30 || x < free) continue;
      const text = fitted(context, shortRoleName(match, side, stretch.role), w - 4);
      context.fillText(text, x + 2, top + stripHeight * 1.5 + 0.5);
      free = x + 4 + context.measureText(text).width;
    }
  }

  private drawNames(view: View, palette: Palette): void {
    const { context, height } = this.canvas;
    const { side } = view;
    const rowHeight = this.rowHeight(side);
    context.font = font(10);
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (let n = 1; n <= this.match.game.sizes[side]; ++n) {
      const y = axisHeight + (n - 0.5) * rowHeight;
      const chosen = view.panel !== "compare" && view.robot?.side === side && view.robot.number === n;
      if (chosen) {
        context.fillStyle = side === 0 ? palette.home : palette.away;
        context.fillRect(4, y - rowHeight / 2 + 1, gutter - 8, rowHeight - 2);
      }
      context.fillStyle = chosen ? (side === 0 ? palette["on-home"] : palette["on-away"]) : palette.text;
      context.font = font(Math.min(11, rowHeight), chosen ? 700 : 400);
      context.fillText(`robot ${n}`, gutter - 8, y + 0.5);
    }
    if (view.panel === "compare" && view.pair !== null && view.pair.side === side) {
      for (const [i, n] of view.pair.robots.entries()) {
        context.strokeStyle = i === 0 ? palette.first : palette.second;
        context.setLineDash(i === 0 ? [] : [2.5, 2]);
        context.lineWidth = 2.5;
        context.beginPath();
        context.arc(14, axisHeight + (n - 0.5) * rowHeight, Math.min(4, rowHeight / 2 - 1), 0, 2 * Math.PI);
        context.stroke();
      }
      context.setLineDash([]);
    }
    context.font = font(10);
    context.fillStyle = palette.muted;
    const top = height - 2 * stripHeight - 2;
    context.fillText("held twice", gutter - 8, top + stripHeight / 2);
    context.fillText("uncovered", gutter - 8, top + stripHeight * 1.5);
  }

  private visible(stretches: readonly Stretch[]): Stretch[] {
    return stretches.filter((stretch) => stretch.to >= this.scale.from && stretch.from <= this.scale.to);
  }
}

// When a robot held the role of a stretch, within it.
function held(match: Match, side: Side, robot: number, stretch: Stretch): [number, number][] {
  const { game } = match;
  const result: [number, number][] = [];
  const runs = match.courses[side].runs[robot - 1] ?? [];
  for (const run of runs) {
    const from = game.times[run.from]!;
    if (from > stretch.to) break;
    const to = game.times[Math.min(run.to, game.count - 1)]!;
    if (run.role === stretch.role && to >= stretch.from) {
      result.push([Math.max(from, stretch.from), Math.min(to, stretch.to)]);
    }
  }
  return result;
}

const fits = new Map<string, string>();

// As much of the text as fits, with an ellipsis.
function fitted(context: CanvasRenderingContext2D, text: string, width: number): string {
  const whole = Math.floor(width);
  const key = `${context.font}\n${whole}\n${text}`;
  let shown = fits.get(key);
  if (shown === undefined) {
    if (fits.size > 4000) fits.clear();
    shown = text;
    const letters = [...text];
    while (letters.length > 0 && context.measureText(shown).width > whole) {
      letters.pop();
      shown = letters.length > 0 ? `${letters.join("")}…` : "";
    }
    fits.set(key, shown);
  }
  return shown;
}
