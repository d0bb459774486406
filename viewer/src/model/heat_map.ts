// SPDX-License-Identifier: MIT
// How long the ball, a robot or a team was where: seconds in squares of the field, while the ball was in play. Penalised
// robots are not counted, and of a team all robots add up.
import type { FieldSize, Side } from "../recording/about";
import { type Game, inPlay, sampleSeconds } from "./game";

export const squareMetres = 0.25;

export type HeatOf = { what: "ball" } | { what: "team"; side: Side } | { what: "robot"; side: Side; number: number };

export interface HeatMap {
  columns: number;
  rows: number; // from y = -y0 upwards
  x0: number; // m: the left edge of the first column, world frame
  y0: number; // the lower edge of the first row
  seconds: Float64Array; // [row * columns + column]
  total: number; // s, of all squares
  full: number; // s: of a square that is drawn in full colour
}

// Few squares, as that of a kick-off, hold far more than the others: full colour is that of the 95th percentile of those
// that hold anything, so that the others can be told apart.
const percentile = 0.95;

export function heatMap(game: Game, field: FieldSize, of: HeatOf, from: number, to: number): HeatMap {
  const x0 = -(field.length / 2 + field.borderStrip);
  const y0 = -(field.width / 2 + field.borderStrip);
  const columns = Math.ceil((-2 * x0) / squareMetres - 1e-9);
  const rows = Math.ceil((-2 * y0) / squareMetres - 1e-9);
  const seconds = new Float64Array(columns * rows);
  let total = 0;
  const add = (x: number, y: number) => {
    const column = Math.floor((x - x0) / squareMetres);
    const row = Math.floor((y - y0) / squareMetres);
    if (column < 0 || row < 0 || column >= columns || row >= rows) return;
    seconds[row * columns + column]! += sampleSeconds;
    total += sampleSeconds;
  };
  for (let i = 0; i < game.count; ++i) {
    if (game.times[i]! < from - 1e-9 || game.times[i]! > to + 1e-9) continue;
    if (!inPlay(game, i)) continue;
    if (of.what === "ball") {
      add(game.ball[4 * i]!, game.ball[4 * i + 1]!);
      continue;
    }
    const numbers = of.what === "robot" ? [of.number] : Array.from({ length: game.sizes[of.side] }, (_, n) => n + 1);
    for (const number of numbers) {
      if (game.isPenalised(i, of.side, number)) continue;
      const at = 3 * (i * game.robots + game.place(of.side, number));
      add(game.poses[at]!, game.poses[at + 1]!);
    }
  }
  const held = seconds.filter((value) => value > 0).sort();
  const full = held.length === 0 ? 0 : held[Math.min(held.length - 1, Math.floor(percentile * held.length))]!;
  return { columns, rows, x0, y0, seconds, total, full };
}
