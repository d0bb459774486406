// SPDX-License-Identifier: MIT
// Two robots that took the same role, side by side: what each assigned to whom, what each computed for the role, where
// their beliefs differ, and which packets passed between them. Everything here is read off the recording; nothing is
// guessed.
import type { Side } from "../recording/about";
import type { Match } from "../recording/match";
import type { Point } from "../recording/messages";
import { Moment } from "./game";
import { type Look, ageOf, isOld, lookAt, worldOf } from "./look";
import type { News } from "./packets";

// Two robots whose decisions are laid side by side, because both hold, or claim, a role.
export interface Pair {
  side: Side;
  robots: [number, number];
  role: number;
}

export interface AssignedRow {
  robot: number;
  assigned: [number | null, number | null]; // by each of the pair; null: not known to it
  holds: number;
  penalised: boolean;
  differs: boolean;
}

// What one of the pair believes of a thing: how far from the truth, how old.
export interface Estimate {
  error: number; // m
  age: number; // s
  role: number | null; // that it is known by; null: the ball
}

export interface BeliefRow {
  robot: number; // 0: the ball
  apart: number | null; // m between the two beliefs; null: one has none
  by: [Estimate | null, Estimate | null];
}

// One entry of both matrices.
export interface EntryComparison {
  known: [boolean, boolean]; // whether the entry stands in the matrix at all
  utility: [number | null, number | null]; // null: no entry, or forbidden
  difference: number | null; // second minus first
  // Weighted, those that differ most first.
  terms: { name: string; values: [number | null, number | null]; difference: number }[];
}

export interface Comparison {
  looks: [Look, Look];
  ages: [number | null, number | null]; // s, of the decisions; null: none yet
  old: [boolean, boolean]; // whose matrix is of another moment than the one shown
  assigned: AssignedRow[];
  beliefs: BeliefRow[]; // the farthest apart first
  news: [News, News]; // of the second at the first, of the first at the second
}

const distance = (a: ArrayLike<number>, b: ArrayLike<number>) => Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!);

function entry(look: Look, match: Match, pair: Pair, robot: number, role: number) {
  const { decision } = look;
  const row = decision?.rows.indexOf(robot) ?? -1;
  const column = decision?.columns.indexOf(role) ?? -1;
  if (decision === null || row < 0 || column < 0) return null;
  const terms = match.about.teams[pair.side].contexts[decision.context]?.terms ?? [];
  return {
    utility: decision.utility[row]?.[column] ?? null,
    terms: new Map(terms.map((term, i) => [term.name, (decision.terms[i]?.[row]?.[column] ?? 0) * term.weight])),
  };
}

export function compareEntry(
  match: Match,
  pair: Pair,
  looks: [Look, Look],
  robot: number,
  role: number,
): EntryComparison {
  const a = entry(looks[0], match, pair, robot, role);
  const b = entry(looks[1], match, pair, robot, role);
  const utility: [number | null, number | null] = [a?.utility ?? null, b?.utility ?? null];
  const names = new Set([...(a?.terms.keys() ?? []), ...(b?.terms.keys() ?? [])]);
  return {
    known: [a !== null, b !== null],
    utility,
    difference: utility[0] !== null && utility[1] !== null ? utility[1] - utility[0] : null,
    terms: [...names]
      .map((name) => {
        const values: [number | null, number | null] = [a?.terms.get(name) ?? null, b?.terms.get(name) ?? null];
        return { name, values, difference: (values[1] ?? 0) - (values[0] ?? 0) };
      })
      .sort((x, y) => Math.abs(y.difference) - Math.abs(x.difference)),
  };
}

// The entry whose utilities lie farthest apart; null when no entry stands in both matrices.
export function greatestDifference(
  match: Match,
  pair: Pair,
  looks: [Look, Look],
): { robot: number; role: number; entry: EntryComparison } | null {
  let found: { robot: number; role: number; entry: EntryComparison } | null = null;
  for (const robot of looks[0].decision?.rows ?? []) {
    for (const role of looks[0].decision?.columns ?? []) {
      const entry = compareEntry(match, pair, looks, robot, role);
      if (entry.difference === null) continue;
      if (found === null || Math.abs(entry.difference) > Math.abs(found.entry.difference!))
        found = { robot, role, entry };
    }
  }
  return found;
}

function beliefRows(looks: [Look, Look], match: Match, pair: Pair): BeliefRow[] {
  const { game } = match;
  const known = looks.map(({ belief, decision }) => {
    if (belief === null) return null;
    const truth = new Moment(game).set(belief.time);
    const world = worldOf(belief, decision?.knowledge ?? "mine");
    const found = new Map<number, { at: Point } & Estimate>();
    if (world.ball !== null) {
      found.set(0, { at: world.ball.at, error: distance(world.ball.at, truth.ball), age: world.ball.age, role: null });
    }
    for (const mate of world.teammates) {
      if (mate.number < 1 || mate.number > game.sizes[pair.side]) continue;
      const place = 3 * game.place(pair.side, mate.number);
      const at: Point = [mate.pose[0], mate.pose[1]];
      found.set(mate.number, { at, error: distance(at, truth.poses.subarray(place)), age: mate.age, role: mate.role });
    }
    return found;
  });
  const rows: BeliefRow[] = [];
  for (let robot = 0; robot <= game.sizes[pair.side]; ++robot) {
    const by = known.map((found) => found?.get(robot) ?? null) as [
      ({ at: Point } & Estimate) | null,
      ({ at: Point } & Estimate) | null,
    ];
    if (by[0] === null && by[1] === null) continue;
    rows.push({ robot, by, apart: by[0] !== null && by[1] !== null ? distance(by[0].at, by[1].at) : null });
  }
  return rows.sort((x, y) => (y.apart ?? Infinity) - (x.apart ?? Infinity));
}

export function compare(match: Match, pair: Pair, time: number): Comparison {
  const { game } = match;
  const [first, second] = pair.robots;
  const looks: [Look, Look] = [lookAt(match, pair.side, first, time), lookAt(match, pair.side, second, time)];
  const index = game.indexAt(time + 1e-9);
  const assigned: AssignedRow[] = [];
  for (let robot = 1; robot <= game.sizes[pair.side]; ++robot) {
    const by = looks.map(({ decision }) => decision?.assigned[robot - 1] ?? null) as [number | null, number | null];
    assigned.push({
      robot,
      assigned: by,
      holds: game.role(index, pair.side, robot),
      penalised: game.isPenalised(index, pair.side, robot),
      differs: by[0] !== by[1],
    });
  }
  const ages = looks.map(({ decision }) => ageOf(decision, time)) as [number | null, number | null];
  return {
    looks,
    ages,
    old: ages.map(isOld) as [boolean, boolean],
    assigned,
    beliefs: beliefRows(looks, match, pair),
    news: [
      match.packets.news(pair.side, first, second, time + 1e-9),
      match.packets.news(pair.side, second, first, time + 1e-9),
    ],
  };
}

function holders(match: Match, side: Side, role: number, time: number): number[] {
  const { game } = match;
  const index = game.indexAt(time + 1e-9);
  const numbers = Array.from({ length: game.sizes[side] }, (_, i) => i + 1);
  return numbers.filter((n) => game.role(index, side, n) === role && !game.isPenalised(index, side, n));
}

// The first two robots that hold `role` twice at `time`; null when nobody does.
export function pairAt(match: Match, pair: { side: Side; role: number }, time: number): [number, number] | null {
  const [first, second] = holders(match, pair.side, pair.role, time);
  return first !== undefined && second !== undefined ? [first, second] : null;
}

// Two robots of this side that share a role at `time`, the chosen one with another where it shares its own.
export function pairNow(
  match: Match,
  side: Side,
  chosen: { side: Side; number: number } | null,
  time: number,
): Pair | null {
  const roles = match.about.teams[side].roles.map((_, role) => role);
  const own = chosen?.side === side ? chosen.number : 0;
  let found: Pair | null = null;
  for (const role of roles) {
    const all = holders(match, side, role, time);
    if (all.length < 2) continue;
    if (all.includes(own)) {
      const other = all.find((n) => n !== own)!;
      return { side, role, robots: own < other ? [own, other] : [other, own] };
    }
    found ??= { side, role, robots: [all[0]!, all[1]!] };
  }
  return found;
}
