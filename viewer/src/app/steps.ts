// SPDX-License-Identifier: MIT
// Jumps in time: from decision to decision, from event to event, from goal to goal, to a time that is typed.
import type { Game } from "../model/game";
import { parsedTime } from "../model/text";
import { isGoal } from "../recording/messages";
import { lastNotAfter } from "../recording/log";
import type { Match } from "../recording/match";
import type { View } from "./state";

const tolerance = 1e-6;

function neighbour(times: readonly number[], time: number, direction: 1 | -1): number | null {
  if (direction === 1) return times[lastNotAfter(times, time + tolerance) + 1] ?? null;
  return times[lastNotAfter(times, time - tolerance)] ?? null;
}

// Time of the next or previous decision: of the chosen robot, of the pair compared, or of the team shown.
export function decisionStep(match: Match, view: View, direction: 1 | -1): number | null {
  const all = match.decisions;
  const pair = view.panel === "compare" ? view.pair : null;
  const logs =
    pair !== null
      ? pair.robots.map((n) => all[pair.side][n - 1])
      : view.robot !== null
        ? [all[view.robot.side][view.robot.number - 1]]
        : all[view.side];
  const times = logs.map((log) => neighbour(log?.times ?? [], view.time, direction)).filter((time) => time !== null);
  if (times.length === 0) return null;
  return direction === 1 ? Math.min(...times) : Math.max(...times);
}

export function eventStep(match: Match, view: View, direction: 1 | -1): number | null {
  return neighbour(
    match.events.map((event) => event.time),
    view.time,
    direction,
  );
}

export function goalStep(match: Match, time: number, direction: 1 | -1): number | null {
  return neighbour(
    match.events.filter(isGoal).map((event) => event.time),
    time,
    direction,
  );
}

// The match time that a typed text names; null when it names none.
export function timeOf(game: Game, text: string): number | null {
  const typed = parsedTime(text);
  if (typed === null || typed.half === null) return typed?.seconds ?? null;
  for (let i = 0; i < game.count; ++i) {
    // Clocks are those of the samples: to a hundredth of the distance between two.
    if (game.half[i] === typed.half && game.clock[i]! >= typed.seconds - 1e-3) return game.times[i]!;
  }
  return null;
}
