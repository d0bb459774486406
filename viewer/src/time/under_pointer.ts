// SPDX-License-Identifier: MIT
// What stands under a point of the timeline's window, in words.
import type { Robot, View } from "../app/state";
import { roleName } from "../model/look";
import type { Stretch } from "../model/roles";
import { listText, secondsText, timeText } from "../model/text";
import { lastNotAfter } from "../recording/log";
import type { Match } from "../recording/match";
import { type EventMessage, eventText, isGoal } from "../recording/messages";
import { packetLines } from "../panels/packet_lines";
import type { Detail } from "./detail";
import { playsUnderPointer } from "./plays";
import type { TimeScale } from "./scale";

// robot: whom a click there chooses.
export interface Found {
  lines: string[];
  robot: Robot | null;
}

const goalReach = 6; // px

function eventLine(match: Match, event: EventMessage): string {
  const whose = `${match.about.teams[event.side].name}${event.robot > 0 ? ` ${event.robot}` : ""}`;
  const score = isGoal(event) ? `, ${event.score.join(" : ")} (g: next goal, Shift g: previous goal)` : "";
  return `${timeText(event.time, 2)} ${eventText(event)}, ${whose}${score}`;
}

// Of the line of the whole match: the goals that are marked there.
export function goalsUnderPointer(match: Match, scale: TimeScale, px: number): string[] {
  const near = match.events.filter((event) => isGoal(event) && Math.abs(scale.x(event.time) - px) <= goalReach);
  return near.map((event) => eventLine(match, event));
}

export function underPointer(detail: Detail, view: View, px: number, py: number): Found {
  const { match, scale } = detail;
  const { side } = view;
  const time = scale.time(px);
  const lines = [timeText(time)];
  const inStretch = (stretch: Stretch) =>
    time >= stretch.from - 2 / scale.pixelsPerSecond && time <= stretch.to + 2 / scale.pixelsPerSecond;
  const strips = detail.strips;
  if (py >= strips[0].top) {
    const { kind } = py < strips[1].top ? strips[0] : strips[1];
    for (const stretch of match.courses[side][kind].filter(inStretch)) {
      const name = roleName(match, side, stretch.role);
      const length = secondsText(stretch.samples / 10);
      const what = kind === "overlaps" ? `role overlap of ${listText(stretch.robots)}` : "uncovered";
      lines.push(`${name}: ${what} for ${length}, from ${timeText(stretch.from)}`);
    }
    return { lines, robot: null };
  }
  if (detail.isPlayLane(py)) return { lines: [...lines, ...playsUnderPointer(match, scale, px)], robot: null };
  const row = Math.floor((py - detail.rowsTop) / detail.rowHeight(side));
  if (row < 0) {
    const near = match.events.filter((event) => Math.abs(scale.x(event.time) - px) < 5);
    for (const event of near.slice(0, 4)) {
      lines.push(eventLine(match, event));
    }
    return { lines, robot: null };
  }
  const number = row + 1;
  if (number > match.game.sizes[side]) return { lines, robot: null };
  const index = match.game.indexAt(time);
  const runs = match.courses[side].runs[row]!;
  const run =
    runs[
      lastNotAfter(
        runs.map((r) => r.from),
        index,
      )
    ];
  if (run !== undefined) {
    const from = match.game.times[run.from]!;
    const to = match.game.until(run.to - 1);
    const role = roleName(match, side, run.role);
    if (time <= to) lines.push(`robot ${number}: ${role} ${timeText(from)} to ${timeText(to)}`);
  }
  if (match.game.isPenalised(index, side, number)) lines.push("penalised");
  const reach = 6 / scale.pixelsPerSecond;
  for (const packet of match.packets.between(side, number, time - reach, time + reach).slice(0, 3)) {
    lines.push(...packetLines(match, packet));
  }
  return { lines, robot: { side, number } };
}
