// SPDX-License-Identifier: MIT
// The heat map upon the ground, below everything else: the more colour, the longer. Its legend stands at the foot of the
// field.
import { type Canvas, font } from "../app/canvas";
import type { Palette } from "../app/palette";
import type { HeatStretch, HeatWhat, View } from "../app/state";
import { type HeatMap, type HeatOf, heatMap, squareMetres } from "../model/heat_map";
import { fixed } from "../model/text";
import { heatText, stretchTexts } from "../panels/heat_choice";
import type { Match } from "../recording/match";
import type { Projection } from "./projection";
import type { Labels } from "./labels";

const least = 0.1; // opacity of a square that holds anything
const most = 0.8;
// share: of the time of a square in full colour. The root, so that little and very little can be told apart.
const opacity = (share: number) => least + (most - least) * Math.sqrt(Math.min(1, share));
const barWidth = 40; // px
const left = 115; // px that stay free at the foot's left, for the age of a plan

function heatOf(what: HeatWhat, { robot }: View): HeatOf | null {
  if (what === "ball") return { what };
  if (what !== "robot") return { what: "team", side: what === "home" ? 0 : 1 };
  return robot === null ? null : { what, ...robot };
}

export class Heat {
  private readonly image = document.createElement("canvas"); // a pixel for each square
  private key = "";
  private map: HeatMap | null = null;

  constructor(
    private readonly match: Match,
    private readonly window: () => readonly [number, number], // what the timeline shows
  ) {}

  private rangeOf(stretch: HeatStretch): readonly [number, number] {
    const { game } = this.match;
    if (stretch === "window") return this.window();
    if (stretch === "match") return [game.begin, game.end];
    const wanted = stretch === "first" ? 1 : 2;
    const first = game.half.indexOf(wanted);
    const last = Math.min(game.half.lastIndexOf(wanted), game.count - 1);
    return first < 0 ? [0, -1] : [game.times[first]!, game.times[last]!];
  }

  // Nothing is computed again while what is looked at stays the same.
  private update(view: View, palette: Palette): HeatMap | null {
    const of = view.heat === null ? null : heatOf(view.heat, view);
    if (of === null) return null;
    const [from, to] = this.rangeOf(view.heatStretch);
    const key = JSON.stringify([of, from, to, palette.heat]);
    if (key === this.key) return this.map;
    this.key = key;
    const map = heatMap(this.match.game, this.match.about.field, of, from, to);
    this.map = map;
    [this.image.width, this.image.height] = [map.columns, map.rows];
    const context = this.image.getContext("2d")!;
    context.fillStyle = palette.heat;
    for (let row = 0; row < map.rows; ++row) {
      for (let column = 0; column < map.columns; ++column) {
        const value = map.seconds[row * map.columns + column]!;
        if (value <= 0) continue;
        context.globalAlpha = opacity(value / map.full);
        context.fillRect(column, map.rows - 1 - row, 1, 1);
      }
    }
    return map;
  }

  draw(canvas: Canvas, to: Projection, view: View, palette: Palette, labels: Labels): void {
    if (view.heat === null) return;
    const map = this.update(view, palette);
    const { context } = canvas;
    if (map !== null && map.total > 0) {
      const top = to.y(map.y0 + map.rows * squareMetres);
      context.imageSmoothingEnabled = false; // squares as they were counted
      context.drawImage(
        this.image,
        to.x(map.x0),
        top,
        map.columns * squareMetres * to.scale,
        map.rows * squareMetres * to.scale,
      );
      context.imageSmoothingEnabled = true;
    }
    this.drawLegend(canvas, view, map, palette, labels);
  }

  private drawLegend(canvas: Canvas, view: View, map: HeatMap | null, palette: Palette, labels: Labels): void {
    const { context, width, height } = canvas;
    const y = height - 10;
    context.font = font(11);
    context.textBaseline = "middle";
    context.textAlign = "right";
    const what = `${heatText(this.match, view.heat!, view)}, ${stretchTexts[view.heatStretch]}`;
    const texts =
      map === null
        ? ["heat map: choose a robot"]
        : map.total === 0
          ? [`${what}: never in play`]
          : [`${what}: seconds per square of ${squareMetres} m`, `${what}: s per ${squareMetres} m square`, what];
    const bar = map !== null && map.total > 0;
    const end = bar ? `${fixed(map.full, 1)} s and more` : "";
    const endWidth = bar ? context.measureText(end).width + 6 + barWidth + 6 + context.measureText("0").width + 12 : 0;
    const text =
      texts.find((one) => context.measureText(one).width + endWidth < width - left) ?? texts[texts.length - 1]!;
    let x = width - 10;
    context.fillStyle = palette.text;
    if (bar) {
      context.fillText(end, x, y);
      x -= context.measureText(end).width + 6;
      for (let i = 0; i < barWidth; ++i) {
        context.globalAlpha = opacity(i / (barWidth - 1));
        context.fillStyle = palette.heat;
        context.fillRect(x - barWidth + i, y - 5, 1, 10);
      }
      context.globalAlpha = 1;
      context.strokeStyle = palette.muted;
      context.lineWidth = 1;
      context.strokeRect(x - barWidth - 0.5, y - 5.5, barWidth + 1, 11);
      x -= barWidth + 6;
      context.fillStyle = palette.text;
      context.fillText("0", x, y);
      x -= context.measureText("0").width + 12;
    }
    context.fillText(text, x, y);
    x -= context.measureText(text).width;
    labels.take((x + width - 10) / 2, y, (width - 10 - x) / 2 + 2, 8);
  }
}
