// SPDX-License-Identifier: MIT
// Shots, meant passes, clearances and duels: those that the reader of the page wants, and what is said of each.
import { type Side, otherSide } from "../recording/about";
import type { Match } from "../recording/match";
import { type PlayKind, type PlayMessage, playKinds } from "../recording/play_messages";
import { secondsText } from "./text";

export const before = 2; // s: a jump to one of them leads to this long before it began

export interface PlayChoice {
  kind: PlayKind | null; // null: all
  side: Side | null; // null: both
}

// Both teams are in a duel.
export const isOf = (play: PlayMessage, side: Side): boolean => play.kind === "duel" || play.side === side;

// The order stays.
export const chosenPlays = (plays: readonly PlayMessage[], { kind, side }: PlayChoice): PlayMessage[] =>
  plays.filter((play) => (kind === null || play.kind === kind) && (side === null || isOf(play, side)));

// Of a duel: who had the ball after it; null: nobody.
export function winner(play: PlayMessage): Side | null {
  if (play.outcome === "won") return play.side;
  return play.outcome === "lost" ? otherSide(play.side) : null;
}

// "shot: saved", "pass to 3: arrived", "duel with 5 of red, 1.4 s: won by red"
export function playText(match: Match, play: PlayMessage): string {
  const team = (side: Side) => match.about.teams[side].name;
  switch (play.kind) {
    case "shot":
      return `shot: ${play.outcome ?? "missed"}`;
    case "pass":
      return `pass to ${play.receiver}: ${play.outcome ?? "lost"}`;
    case "clearance":
      return "clearance";
    case "duel": {
      const won = winner(play);
      const end = won === null ? "undecided" : `won by ${team(won)}`;
      return `duel with ${play.opponent} of ${team(otherSide(play.side))}, ${secondsText(play.duration)}: ${end}`;
    }
  }
}

// "3 shots, 12 passes, 1 clearance, 0 duels"
export const playCounts = (plays: readonly PlayMessage[]): string =>
  playKinds
    .map((kind) => [kind, plays.filter((play) => play.kind === kind).length] as const)
    .map(([kind, count]) => `${count} ${kind}${count === 1 ? "" : kind === "pass" ? "es" : "s"}`)
    .join(", ");

// Whether the recording tells of these at all: those of earlier versions do not.
export const tellsPlays = (match: Match): boolean => match.game.tellsChases;
