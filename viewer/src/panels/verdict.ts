// SPDX-License-Identifier: MIT
// What can be read off a comparison, in sentences: facts of the recording, no conclusions.
import { type Comparison, type Pair, compareEntry, greatestDifference } from "../model/compare";
import { ageOf, isOld, shortRoleName } from "../model/look";
import { fixed, listText, secondsText, signed, timeText } from "../model/text";
import type { Match } from "../recording/match";

export function verdict(match: Match, pair: Pair, found: Comparison, time: number): string[] {
  const [a, b] = pair.robots;
  const role = shortRoleName(match, pair.side, pair.role);
  const result: string[] = [];
  const stretch = match.courses[pair.side].overlaps.find(
    (s) =>
      s.role === pair.role &&
      s.from <= time + 1e-6 &&
      time < s.to + 1e-6 &&
      s.robots.includes(a) &&
      s.robots.includes(b),
  );
  if (stretch !== undefined) {
    const all = stretch.robots.length > 2 ? ` (all that held it: ${listText(stretch.robots)})` : "";
    result.push(
      `${a} and ${b} both are ${role}, ${timeText(stretch.from)} to ${timeText(stretch.to)}, ` +
        `${secondsText(stretch.samples / 10)}${all}.`,
    );
  } else {
    result.push(`At this moment ${a} and ${b} do not both hold ${role}.`);
  }
  for (const i of [0, 1] as const) result.push(news(match, pair, found, i));
  if (found.old.includes(true)) result.push(`${oldText(pair, found)}: utilities are not compared here.`);
  else result.push(...utilities(match, pair, found, role));
  const farthest = found.beliefs.find((line) => line.apart !== null);
  const beliefsOld = found.looks.some(({ belief }) => isOld(ageOf(belief, time)));
  if (!beliefsOld && farthest !== undefined && farthest.apart! > 0.3) {
    const what = farthest.robot === 0 ? "the ball" : `robot ${farthest.robot}`;
    result.push(`They believe ${what} ${fixed(farthest.apart!, 1)} m apart.`);
  }
  return result.filter((sentence) => sentence !== "");
}

// "4's matrix is 3.2 s old"
function oldText(pair: Pair, { ages, old }: Comparison): string {
  return listText(
    pair.robots.flatMap((robot, i) => (old[i] ? [`${robot}'s matrix is ${secondsText(ages[i]!)} old`] : [])),
  );
}

// "; 4's 3.2 s old"; "" while both are of the moment.
export function ageText(pair: Pair, { ages, old }: Comparison): string {
  const parts = pair.robots.flatMap((robot, i) => (old[i] ? [`${robot}'s ${secondsText(ages[i]!)} old`] : []));
  return parts.length > 0 ? `; ${parts.join(", ")}` : "";
}

function utilities(match: Match, pair: Pair, found: Comparison, role: string): string[] {
  const result: string[] = [];
  const value = (i: 0 | 1, robot: number) => compareEntry(match, pair, found.looks, robot, pair.role).utility[i];
  const computed = ([0, 1] as const).flatMap((i) => {
    const own = value(i, pair.robots[i]);
    const other = value(i, pair.robots[1 - i]!);
    if (own === null || other === null) return [];
    return [`in ${pair.robots[i]} own ${fixed(own, 2)}, of ${pair.robots[1 - i]} ${fixed(other, 2)}`];
  });
  if (computed.length > 0) result.push(`Utilities as ${role}: ${computed.join("; ")}.`);
  const most = greatestDifference(match, pair, found.looks);
  if (most !== null && Math.abs(most.entry.difference!) > 0.02) {
    const term = most.entry.terms[0];
    const by = term === undefined ? "" : `, most by ${term.name} (${signed(term.difference, 2)})`;
    result.push(
      `They differ most for robot ${most.robot} as ${shortRoleName(match, pair.side, most.role)}: ` +
        `${signed(most.entry.difference!, 2)}${by}${known(match, pair, found, most.robot)}.`,
    );
  }
  return result;
}

// What the robot in place `i` of the pair has not heard of the other.
function news(match: Match, pair: Pair, found: Comparison, i: 0 | 1): string {
  const { heard, missed } = found.news[i]!;
  const listener = pair.robots[i]!;
  const sender = pair.robots[1 - i]!;
  const since = heard === null ? "" : ` since ${timeText(heard.time)}`;
  if (missed.length > 0) return `${listener} missed ${missed.length} of ${sender}'s packets${since}.`;
  const decision = found.looks[1 - i]!.decision;
  if (heard === null || decision === null || decision.role < 0 || decision.since <= heard.time) return "";
  const became = `${shortRoleName(match, pair.side, decision.role)} at ${timeText(decision.since)}`;
  return `${listener} last heard ${sender} at ${timeText(heard.time)}, before it became ${became}.`;
}

// The roles by which the two know a robot, where they differ.
function known(match: Match, pair: Pair, found: Comparison, robot: number): string {
  const roles = found.beliefs.find((line) => line.robot === robot)?.by.map((of) => of?.role ?? null);
  if (roles === undefined || roles[0] === null || roles[1] === null || roles[0] === roles[1]) return "";
  const [a, b] = roles.map((role) => shortRoleName(match, pair.side, role!));
  return `; ${pair.robots[0]} knew it as ${a}, ${pair.robots[1]} as ${b}`;
}
