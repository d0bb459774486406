// SPDX-License-Identifier: MIT
// A window of the match: what happened with the ball; a row for each robot of one team with the roles it held and the
// packets it sent; role overlaps are framed in the rows and named below, in a lane each, and so are uncovered roles.
import { Canvas, font } from "../app/canvas";
import type { Palette } from "../app/palette";
import type { View } from "../app/state";
import { label } from "../field/shapes";
import { inMask, sampleSeconds } from "../model/game";
import { shortRoleName } from "../model/look";
import { type Lanes, crowds, inLanes } from "../model/lanes";
import type { Stretch } from "../model/roles";
import { timeText } from "../model/text";
import type { Side } from "../recording/about";
import type { Match } from "../recording/match";
import { eventText } from "../recording/messages";
import { drawPlays, playLane } from "./plays";
import { type TimeScale, gutter, margin, tickSeconds } from "./scale";

const axisHeight = 24; // times above, events below
const laneHeight = 10; // of role overlaps and of uncovered roles, below the rows
const mostLanes = [3, 2]; // of role overlaps, of uncovered roles
const stripsMargin = 9; // above, between and below them
const leastRoom = 24; // for a name
const foot = 2; // of each row, for packets

// What stands below the rows.
export interface Strip {
  kind: "overlaps" | "uncovered";
  top: number;
  lanes: number;
}

const kinds = ["overlaps", "uncovered"] as const;

// Some stretches have no lane: from `x` to `end`; `text` says how many and reaches to `to`.
interface Badge {
  x: number;
  end: number;
  to: number;
  text: string;
}

// The widest part between two places that no badge takes.
function widestFree(from: number, to: number, taken: readonly Badge[]): [number, number] {
  let best: [number, number] = [from, from];
  let at = from;
  for (const badge of [...taken, { x: to, to }]) {
    const until = Math.min(to, badge.x);
    if (until - at > best[1] - best[0]) best = [at, until];
    at = Math.max(at, badge.to);
  }
  return best;
}

// How many lanes the strips take: of both teams the same, so that nothing moves when the other one is shown.
export function stripLanes(match: Match): [number, number] {
  const needed = (kind: Strip["kind"]) => Math.max(...match.courses.map((course) => inLanes(course[kind]).count));
  return kinds.map((kind, i) => Math.min(mostLanes[i]!, Math.max(1, needed(kind)))) as [number, number];
}

export class Detail {
  readonly canvas: Canvas;
  private readonly lanes: [number, number];
  private readonly placed: Record<Strip["kind"], Lanes>[]; // by side

  constructor(
    element: HTMLCanvasElement,
    readonly match: Match,
    readonly scale: TimeScale,
  ) {
    this.canvas = new Canvas(element);
    this.lanes = stripLanes(match);
    this.placed = match.courses.map((course) => ({
      overlaps: inLanes(course.overlaps),
      uncovered: inLanes(course.uncovered),
    }));
  }

  get strips(): [Strip, Strip] {
    const [over, under] = this.lanes;
    const top = this.canvas.height - (over + under) * laneHeight - 6;
    return [
      { kind: "overlaps", top, lanes: over },
      { kind: "uncovered", top: top + over * laneHeight + 2, lanes: under },
    ];
  }

  // Where the lane of what happened with the ball ends, and the rows of the robots begin.
  get rowsTop(): number {
    return axisHeight + playLane(this.match);
  }

  isPlayLane(py: number): boolean {
    return py >= axisHeight && py < this.rowsTop;
  }

  resize(width: number, height: number): boolean {
    this.scale.width = width;
    return this.canvas.fit(width, height);
  }

  rowHeight(side: Side): number {
    const strips = (this.lanes[0] + this.lanes[1]) * laneHeight + stripsMargin;
    return (this.canvas.height - this.rowsTop - strips) / Math.max(1, this.match.game.sizes[side]);
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
    drawPlays(context, this.scale, this.match, palette, axisHeight);
    this.drawRuns(view, palette);
    this.drawGaps(palette);
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
    const end = this.canvas.width - margin;
    context.font = font(10);
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (let i = Math.ceil(scale.from / step); i * step <= scale.to; ++i) {
      const x = Math.round(scale.x(i * step));
      context.fillStyle = palette.line;
      context.fillRect(x, axisHeight - 10, 1, height);
      const text = timeText(i * step, step < 1 ? 1 : 0);
      const half = context.measureText(text).width / 2;
      if (x - half < gutter || x + half > end) continue; // no time is cut
      context.fillStyle = palette.muted;
      context.fillText(text, x, 7);
    }
    context.textAlign = "left";
    let free = -Infinity;
    for (const event of match.events) {
      if (event.time < scale.from - 5 || event.time > scale.to) continue;
      const x = scale.x(event.time);
      const goal = event.event === "goal";
      context.fillStyle = event.side === 0 ? palette.home : palette.away;
      context.fillRect(x, axisHeight - 9, goal ? 3 : 1.5, goal ? height : 9);
      const text = `${eventText(event)}${event.robot > 0 ? ` ${event.robot}` : ""}`;
      if (x < free || x + 4 < gutter) continue;
      context.font = font(10, goal ? 700 : 400);
      const after = x + 4 + context.measureText(text).width;
      if (after > end) continue;
      context.fillText(text, x + 4, axisHeight - 4);
      free = after + 4;
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
    context.font = font(Math.min(10.5, rowHeight - 2.2));
    for (const [n, runs] of match.courses[side].runs.entries()) {
      const y = this.rowsTop + n * rowHeight;
      for (const { role, from, to } of runs) {
        const begin = game.times[from]!;
        const end = game.until(to - 1);
        if (end < scale.from) continue;
        if (begin > scale.to) break;
        const x = Math.max(gutter - 1, scale.x(begin));
        const w = Math.min(this.canvas.width, scale.x(end)) - x;
        context.fillStyle = role < 0 ? palette.sunken : palette.roles[role % 8]!;
        context.fillRect(x, y + 1, Math.max(0.5, w - 0.5), rowHeight - 1 - foot);
        if (w > 24) {
          context.fillStyle = role < 0 ? palette.muted : palette.text;
          const name = shortRoleName(match, side, role).replaceAll("_", " ");
          context.fillText(fitted(context, name, w - 6), x + 3, y + (rowHeight - foot) / 2 + 1.2);
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

  // What cannot be read of the recording: hatched, and named where there is room.
  private drawGaps(palette: Palette): void {
    const { context } = this.canvas;
    const bottom = this.strips[0].top - 2;
    for (const { from, to } of this.match.gaps) {
      if (from > this.scale.to || (to ?? Infinity) < this.scale.from) continue;
      const x = Math.max(gutter, this.scale.x(from + sampleSeconds));
      const w = Math.min(this.canvas.width - margin, this.scale.x(to ?? this.scale.to)) - x;
      context.save();
      context.beginPath();
      context.rect(x, this.rowsTop, w, bottom - this.rowsTop);
      context.clip();
      context.strokeStyle = palette.line;
      context.lineWidth = 1;
      context.beginPath();
      for (let at = x - (bottom - this.rowsTop); at < x + w; at += 7) {
        context.moveTo(at, bottom);
        context.lineTo(at + bottom - this.rowsTop, this.rowsTop);
      }
      context.stroke();
      context.font = font(11);
      context.textAlign = "center";
      context.textBaseline = "middle";
      const text = ["not recorded: damaged", "damaged"].find((one) => context.measureText(one).width < w - 4) ?? "";
      label(context, text, x + w / 2, (this.rowsTop + bottom) / 2, palette.text, palette.panel);
      context.restore();
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
          const y = this.rowsTop + (robot - 1) * rowHeight;
          context.strokeRect(x + 0.5, y + 1.5, w - 1, rowHeight - 2 - foot);
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
      const base = this.rowsTop + n * rowHeight - 0.5;
      for (const packet of match.packets.between(view.side, n, scale.from, scale.to)) {
        const x = scale.x(packet.time);
        const missed = listener > 0 && match.packets.lost(packet, listener);
        context.beginPath();
        context.moveTo(x - size, base);
        context.lineTo(x, base - 1.45 * size);
        context.lineTo(x + size, base);
        context.closePath();
        context.fillStyle = missed ? palette.panel : palette.text;
        context.strokeStyle = missed ? palette.text : palette.panel;
        context.lineWidth = missed ? 1.25 : 0.75;
        context.fill();
        context.stroke();
        if (missed) {
          context.beginPath();
          context.moveTo(x - size, base - 1.45 * size);
          context.lineTo(x + size, base);
          context.stroke();
        }
      }
    }
  }

  private drawStrips(side: Side, palette: Palette): void {
    for (const strip of this.strips) {
      const { lane } = this.placed[side]![strip.kind];
      const hidden: Stretch[] = [];
      for (const stretch of this.visible(this.match.courses[side][strip.kind])) {
        const at = lane.get(stretch)!;
        if (at >= strip.lanes) hidden.push(stretch);
      }
      const badges = this.badges(hidden);
      for (const stretch of this.visible(this.match.courses[side][strip.kind])) {
        const at = lane.get(stretch)!;
        if (at >= strip.lanes) continue;
        const taken = at === strip.lanes - 1 ? badges : [];
        this.drawStretch(stretch, strip, strip.top + at * laneHeight, taken, palette);
      }
      this.drawCrowds(badges, strip, palette);
    }
  }

  // taken: where the lane's foot says how many more there are, and no name can stand.
  private drawStretch(stretch: Stretch, { kind }: Strip, top: number, taken: readonly Badge[], palette: Palette): void {
    const { context } = this.canvas;
    const { scale, match } = this;
    const x = scale.x(stretch.from);
    const w = Math.max(1.5, scale.x(stretch.to) - x);
    const over = kind === "overlaps";
    context.globalAlpha = over ? 1 : 0.38;
    context.fillStyle = over ? palette.overlap : palette.uncovered;
    context.fillRect(x, top + 0.5, Math.max(1, w - 0.5), laneHeight - 1);
    context.globalAlpha = 1;
    const [shown, until] = widestFree(
      Math.max(x, gutter),
      Math.min(scale.x(stretch.to), this.canvas.width - margin),
      taken,
    );
    const room = until - shown - 4;
    if (room < leastRoom) return;
    const name = shortRoleName(match, stretch.side, stretch.role).replaceAll("_", " ");
    context.font = font(9);
    context.textAlign = "left";
    context.textBaseline = "middle";
    context.fillStyle = over ? "#111" : palette.text;
    context.fillText(
      fitted(context, over ? `${name} ${stretch.robots.join(" ")}` : name, room),
      shown + 2,
      top + laneHeight / 2 + 0.5,
    );
  }

  // Of what has no lane: in the last one a line for its time, and how many they are.
  private drawCrowds(badges: readonly Badge[], strip: Strip, palette: Palette): void {
    const { context } = this.canvas;
    const bottom = strip.top + strip.lanes * laneHeight;
    context.font = font(9, 700);
    context.textAlign = "left";
    context.textBaseline = "middle";
    for (const { x, end, to, text } of badges) {
      context.fillStyle = palette.text;
      context.fillRect(x, bottom - 1.5, end - x, 1.5);
      if (text === "") continue;
      context.fillRect(x, bottom - laneHeight, to - x, laneHeight);
      context.fillStyle = palette.panel;
      context.fillText(text, x + 1.5, bottom - laneHeight / 2 + 0.5);
    }
  }

  private badges(hidden: readonly Stretch[]): Badge[] {
    const { context } = this.canvas;
    context.font = font(9, 700);
    let free = -Infinity;
    return crowds(hidden).map(({ from, to, most }) => {
      const x = Math.max(gutter, this.scale.x(from));
      const end = Math.max(x + 2, this.scale.x(to));
      const text = `+${most}`;
      const after = x + context.measureText(text).width + 3;
      if (x < free || after > this.canvas.width - margin) return { x, end, to: x, text: "" };
      free = after + 2;
      return { x, end, to: after, text };
    });
  }

  private drawNames(view: View, palette: Palette): void {
    const { context } = this.canvas;
    const { side } = view;
    const rowHeight = this.rowHeight(side);
    context.font = font(10);
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (let n = 1; n <= this.match.game.sizes[side]; ++n) {
      const y = this.rowsTop + (n - 0.5) * rowHeight;
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
        context.arc(14, this.rowsTop + (n - 0.5) * rowHeight, Math.min(4, rowHeight / 2 - 1), 0, 2 * Math.PI);
        context.stroke();
      }
      context.setLineDash([]);
    }
    context.font = font(10);
    context.fillStyle = palette.muted;
    if (this.rowsTop > axisHeight) context.fillText("with the ball", gutter - 8, (axisHeight + this.rowsTop) / 2);
    for (const { kind, top, lanes } of this.strips) {
      const text = kind === "overlaps" ? "role overlap" : "uncovered";
      context.fillText(text, gutter - 8, top + (lanes * laneHeight) / 2);
    }
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
    const to = game.until(run.to - 1);
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
