// SPDX-License-Identifier: MIT
// Shots, meant passes, clearances and duels on the timeline: a lane of marks below the axis, in the colours of the teams.
// Every kind has a shape; what came of it fills the shape, or not.
import type { Palette } from "../app/palette";
import { playText, winner } from "../model/plays";
import { timeText } from "../model/text";
import type { Match } from "../recording/match";
import type { PlayMessage } from "../recording/play_messages";
import type { TimeScale } from "./scale";

// Where there is nothing to mark there is no lane.
export const playLane = (match: Match): number => (match.plays.length > 0 ? 13 : 0); // px

const reach = 5; // px: half a mark
const size = 4;

function shape(context: CanvasRenderingContext2D, play: PlayMessage, x: number, y: number): void {
  context.beginPath();
  if (play.kind === "shot") {
    context.arc(x, y, size, 0, 2 * Math.PI);
  } else if (play.kind === "pass") {
    context.moveTo(x - size, y - size);
    context.lineTo(x + size, y);
    context.lineTo(x - size, y + size);
  } else {
    context.moveTo(x - size, y);
    context.lineTo(x, y - size);
    context.lineTo(x + size, y);
    context.lineTo(x, y + size);
  }
  context.closePath();
}

export function drawPlays(
  context: CanvasRenderingContext2D,
  scale: TimeScale,
  match: Match,
  palette: Palette,
  top: number,
): void {
  const y = top + playLane(match) / 2;
  const visible = match.plays.filter(
    (play) => play.began + play.duration >= scale.from - 2 && play.began <= scale.to + 2,
  );
  const colour = (side: 0 | 1 | null) => (side === null ? palette.muted : side === 0 ? palette.home : palette.away);
  for (const play of visible) {
    if (play.kind !== "duel") continue;
    const x = scale.x(play.began);
    context.fillStyle = colour(winner(play));
    context.globalAlpha = 0.55;
    context.fillRect(x, y - 2, Math.max(3, scale.x(play.began + play.duration) - x), 4);
    context.globalAlpha = 1;
  }
  for (const play of visible) {
    if (play.kind === "duel") continue;
    const x = scale.x(play.began);
    const filled = play.outcome === null || ["goal", "saved", "arrived"].includes(play.outcome);
    shape(context, play, x, y);
    context.fillStyle = filled ? colour(play.side) : palette.panel;
    context.fill();
    context.lineWidth = 1.5;
    context.strokeStyle = colour(play.side);
    context.stroke();
    if (play.outcome !== "goal") continue;
    context.beginPath();
    context.arc(x, y, 1.6, 0, 2 * Math.PI);
    context.fillStyle = palette.panel;
    context.fill();
  }
}

// What stands under a place of the lane, in words.
export function playsUnderPointer(match: Match, scale: TimeScale, px: number): string[] {
  const near = match.plays.filter(
    (play) =>
      scale.x(play.began) - reach <= px &&
      px <= Math.max(scale.x(play.began + play.duration), scale.x(play.began) + reach),
  );
  return near
    .slice(0, 4)
    .map(
      (play) => `${timeText(play.began)} ${match.about.teams[play.side].name} ${play.robot}: ${playText(match, play)}`,
    );
}
