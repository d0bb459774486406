// SPDX-License-Identifier: MIT
// What happened with the ball, as the match judged it: shots, meant passes, clearances, duels. docs/recordings.md says
// what counts.
import type { Side } from "./about";
import * as checked from "./checked";
import { type Point, point, sideOf } from "./messages";

export const playKinds = ["shot", "pass", "clearance", "duel"] as const;
export type PlayKind = (typeof playKinds)[number];
export const playOutcomes = [
  ...(["goal", "saved", "missed"] as const), // of a shot
  ...(["arrived", "intercepted", "lost"] as const), // of a pass
  ...(["won", "undecided"] as const), // of a duel, which may be lost, too
] as const;

export interface PlayMessage {
  time: number; // when it was decided what became of it
  kind: PlayKind;
  side: Side; // of a duel: whose robot was nearer to the ball
  robot: number;
  began: number;
  at: Point; // of the ball when it began
  outcome: (typeof playOutcomes)[number] | null; // null: a clearance
  receiver: number; // of a pass
  opponent: number; // of a duel: the robot of the other side
  duration: number; // of a duel, s
}

export function playOf(json: unknown): PlayMessage {
  const m = checked.object(json, "the message");
  return {
    time: checked.number(m.time, "time"),
    kind: checked.oneOf(m.kind, "kind", playKinds),
    side: sideOf(m.side, "side"),
    robot: checked.integer(m.robot, "robot"),
    began: checked.number(m.began, "began"),
    at: point(m.at, "at"),
    outcome: (m.outcome ?? null) === null ? null : checked.oneOf(m.outcome, "outcome", playOutcomes),
    receiver: checked.integer(m.receiver ?? 0, "receiver"),
    opponent: checked.integer(m.opponent ?? 0, "opponent"),
    duration: checked.number(m.duration ?? 0, "duration"),
  };
}
