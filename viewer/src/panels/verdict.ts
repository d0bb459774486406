// SPDX-License-Identifier: MIT
// What can be read off a comparison, in sentences: facts of the recording, no conclusions.
import { type Comparison, type Pair, compareEntry, greatestDifference } from "../model/compare";
import { shortRoleName } from "../model/look";
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
  const value = (i: 0 | 1, robot: number) => compareEntry(match, pair, found.looks, robot, pair.role).utility[i];
  const computed = ([0, 1] as const)
    .map((i) => {
      const own = value(i, pair.robots[i]);
      const other = value(i, pair.robots[1 - i]!);
      return own === null || other === null
        ? ""
        : `${pair.robots[i]} computes ${fixed(own, 2)} for itself and ${fixed(other, 2)} for ${pair.robots[1 - i]}`;
    })
    .filter((text) => text !== "");
  if (computed.length > 0) result.push(`As ${role}, ${listText(computed)}.`);
  const most = greatestDifference(match, pair, found.looks);
  if (most !== null && Math.abs(most.entry.difference!) > 0.02) {
    const term = most.entry.terms[0];
    const by = term === undefined ? "" : `, most by ${term.name} (${signed(term.difference, 2)})`;
    result.push(
      `Their utilities differ most for robot ${most.robot} as ${shortRoleName(match, pair.side, most.role)}: ` +
        `${signed(most.entry.difference!, 2)}${by}${known(match, pair, found, most.robot)}.`,
    );
  }
  const farthest = found.beliefs.find((line) => line.apart !== null);
  if (farthest !== undefined && farthest.apart! > 0.3) {
    const what = farthest.robot === 0 ? "the ball" : `robot ${farthest.robot}`;
    result.push(`They believe ${what} ${fixed(farthest.apart!, 1)} m apart.`);
  }
  found.news.forEach(({ missed }, i) => {
    if (missed.length > 0) {
      const times = missed.length === 1 ? "the last packet" : `the last ${missed.length} packets`;
      result.push(`${pair.robots[i]} missed ${times} of ${pair.robots[1 - i]}.`);
    }
  });
  return result;
}

// The roles by which the two know a robot, where they differ.
function known(match: Match, pair: Pair, found: Comparison, robot: number): string {
  const roles = found.beliefs.find((line) => line.robot === robot)?.by.map((of) => of?.role ?? null);
  if (roles === undefined || roles[0] === null || roles[1] === null || roles[0] === roles[1]) return "";
  const [a, b] = roles.map((role) => shortRoleName(match, pair.side, role!));
  return `; ${pair.robots[0]} knew it as ${a}, ${pair.robots[1]} as ${b}`;
}
