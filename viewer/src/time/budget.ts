// SPDX-License-Identifier: MIT
// The budget of packets as it was spent, over the whole match.
import uPlot from "uplot";

import type { Palette } from "../app/palette";
import { bothSides } from "../recording/about";
import type { Match } from "../recording/match";
import { gutter, margin } from "./scale";

export const budgetHeight = 54;
const everySamples = 10;

function columns(match: Match): [number[], number[], number[], number[]] {
  const { game, about } = match;
  const times: number[] = [];
  const left: [number[], number[]] = [[], []];
  const even: number[] = [];
  const whole = Math.max(game.end, 2 * about.halfSeconds);
  for (
    let i = 0;
    i < game.count;
    i += i + everySamples < game.count || i === game.count - 1 ? everySamples : game.count - 1 - i
  ) {
    times.push(game.times[i]!);
    for (const side of bothSides) left[side].push(game.packetsLeft[2 * i + side]!);
    even.push(about.packetBudget * (1 - game.times[i]! / whole));
  }
  return [times, left[0], left[1], even];
}

export class Budget {
  private plot: uPlot | null = null;
  private readonly data: [number[], number[], number[], number[]];

  constructor(
    private readonly element: HTMLElement,
    private readonly match: Match,
  ) {
    this.data = columns(match);
  }

  // Anew, for a curve takes its colours when it is made.
  draw(width: number, palette: Palette): void {
    this.plot?.destroy();
    const most = Math.max(this.match.about.packetBudget, ...this.data[1].slice(0, 1), ...this.data[2].slice(0, 1), 1);
    this.plot = new uPlot(
      {
        width,
        height: budgetHeight,
        padding: [4, margin, 2, 0],
        legend: { show: false },
        cursor: { show: false },
        scales: {
          x: { time: false, range: [this.match.game.begin, this.match.game.end] },
          y: { range: [0, most * 1.04] },
        },
        axes: [
          { show: false },
          {
            size: gutter,
            stroke: palette.muted,
            font: '10px system-ui, "DejaVu Sans", sans-serif',
            gap: 6,
            grid: { stroke: palette.line, width: 1 },
            ticks: { show: false },
            splits: [0, most / 2, most],
            values: (_, splits) =>
              splits.map((value, i) => (i === 2 ? `packets ${Math.round(value)}` : String(Math.round(value)))),
          },
        ],
        series: [
          {},
          { stroke: palette.home, width: 2, points: { show: false } },
          { stroke: palette.away, width: 2, dash: [6, 3], points: { show: false } },
          { stroke: palette.muted, width: 1, dash: [2, 3], points: { show: false } },
        ],
      },
      this.data,
      this.element,
    );
  }
}
