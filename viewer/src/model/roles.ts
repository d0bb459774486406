// SPDX-License-Identifier: MIT
// Who held which role when, which roles overlapped, and which nobody held: the measures of Affinita et al.,
// "Multi-Agent Coordination for a Partially Observable and Dynamic Robot Soccer Environment with Limited
// Communication", 2023. Every sample in the phase Playing counts 0.1 s; active is who is not penalised.
// - role overlap: two or more active robots hold the role;
// - uncovered: no active robot holds it although it is wanted: it stands in the list in force, its priority is below
//   the number of active robots, which are enough for it, and one of the robots that alone may take it, if there are
//   any, is active. In force is the list in which most active robots hold a role (of equals, the first of the table);
//   none while nobody holds any.
import { type Role, type Side } from "../recording/about";
import { type Game, playing, sampleSeconds } from "./game";

export interface Stretch {
  side: Side;
  role: number;
  robots: number[]; // all that held it at some time within; empty for an uncovered stretch
  from: number; // s; `to` is 0.1 s after its last sample
  to: number;
  samples: number;
}

export interface RoleSum {
  overlap: number; // s
  uncovered: number; // s
  robotSeconds: number[];
}

// A robot held one role from one sample up to another (not included).
export interface Run {
  role: number;
  from: number; // sample
  to: number;
}

export interface RoleCourse {
  overlaps: Stretch[];
  uncovered: Stretch[];
  sums: RoleSum[]; // by role
  runs: Run[][]; // by robot (n - 1)
}

function bits(mask: number): number {
  let count = 0;
  for (; mask !== 0; mask &= mask - 1) ++count;
  return count;
}

function robotsOf(mask: number): number[] {
  const numbers: number[] = [];
  for (let n = 1; mask !== 0; ++n, mask >>>= 1) if ((mask & 1) !== 0) numbers.push(n);
  return numbers;
}

export function roleCourse(game: Game, side: Side, roles: readonly Role[]): RoleCourse {
  const size = game.sizes[side];
  const names = [...new Set(roles.map((role) => role.list))];
  const listOf = roles.map((role) => names.indexOf(role.list));
  const holders = new Uint32Array(roles.length); // robots as bits
  const listHolders = new Uint32Array(names.length);
  const overlapSamples = new Float64Array(roles.length);
  const uncoveredSamples = new Float64Array(roles.length);
  const robotSamples = roles.map(() => new Float64Array(size));
  const open: (Stretch | null)[][] = [roles.map(() => null), roles.map(() => null)];
  const openMasks = new Uint32Array(roles.length);
  const found: [Stretch[], Stretch[]] = [[], []];
  const runs: Run[][] = Array.from({ length: size }, () => []);

  const note = (kind: 0 | 1, role: number, now: boolean, time: number, mask: number) => {
    let stretch = open[kind]![role]!;
    if (now && stretch === null) {
      stretch = { side, role, robots: [], from: time, to: time, samples: 0 };
      open[kind]![role] = stretch;
      found[kind].push(stretch);
      if (kind === 0) openMasks[role] = 0;
    }
    if (!now) {
      open[kind]![role] = null;
    } else if (stretch !== null) {
      stretch.to = time + sampleSeconds;
      ++stretch.samples;
      if (kind === 0 && (openMasks[role]! | mask) !== openMasks[role]) {
        openMasks[role]! |= mask;
        stretch.robots = robotsOf(openMasks[role]!);
      }
    }
  };

  for (let i = 0; i < game.count; ++i) {
    const follows = game.follows(i);
    if (!follows) for (const stretches of open) stretches.fill(null);
    const penalised = game.penalised[2 * i + side]!;
    for (let n = 1; n <= size; ++n) {
      const role = game.role(i, side, n);
      const of = runs[n - 1]!;
      const last = of[of.length - 1];
      if (last !== undefined && last.to === i && last.role === role && follows) last.to = i + 1;
      else of.push({ role, from: i, to: i + 1 });
    }
    const time = game.times[i]!;
    const inPlay = game.phase[i] === playing;
    holders.fill(0);
    listHolders.fill(0);
    let active = 0;
    if (inPlay) {
      for (let n = 1; n <= size; ++n) {
        if (((penalised >>> (n - 1)) & 1) !== 0) continue;
        active |= 1 << (n - 1);
        const role = game.role(i, side, n);
        if (role < 0 || role >= roles.length) continue;
        holders[role]! |= 1 << (n - 1);
        ++listHolders[listOf[role]!]!;
        ++robotSamples[role]![n - 1]!;
      }
    }
    let inForce = -1;
    for (let l = 0; l < names.length; ++l) {
      if (listHolders[l]! > 0 && (inForce < 0 || listHolders[l]! > listHolders[inForce]!)) inForce = l;
    }
    const activeCount = bits(active);
    for (let role = 0; role < roles.length; ++role) {
      const { priority, robots, leastInPlay } = roles[role]!;
      const mask = holders[role]!;
      const overlaps = bits(mask) >= 2;
      const uncovered =
        inPlay &&
        mask === 0 &&
        listOf[role] === inForce &&
        priority < activeCount &&
        leastInPlay <= activeCount &&
        (robots.length === 0 || robots.some((robot) => robot <= size && ((active >>> (robot - 1)) & 1) === 1));
      if (overlaps) ++overlapSamples[role]!;
      if (uncovered) ++uncoveredSamples[role]!;
      note(0, role, overlaps, time, mask);
      note(1, role, uncovered, time, 0);
    }
  }
  return {
    overlaps: found[0],
    uncovered: found[1],
    runs,
    sums: roles.map((_, role) => ({
      overlap: overlapSamples[role]! * sampleSeconds,
      uncovered: uncoveredSamples[role]! * sampleSeconds,
      robotSeconds: [...robotSamples[role]!].map((count) => count * sampleSeconds),
    })),
  };
}

// The stretch that a jump forwards or backwards in time leads to. `all` in the order of time; `last`: where the jump
// before led to, so that of several that begin together each gets its turn.
export function neighbour(
  all: readonly Stretch[],
  time: number,
  direction: 1 | -1,
  last: Stretch | null = null,
): Stretch | null {
  const tolerance = 1e-6;
  const at = last !== null && Math.abs(last.from - time) < tolerance ? all.indexOf(last) : -1;
  if (at >= 0) return all[at + direction] ?? null;
  if (direction === 1) return all.find((stretch) => stretch.from > time + tolerance) ?? null;
  for (let i = all.length - 1; i >= 0; --i) if (all[i]!.from < time - tolerance) return all[i]!;
  return null;
}

// --- The order of a list of stretches: those of a second or more first. The short ones follow; a list may fold them.

export const longSeconds = 1;
export type StretchOrder = "time" | "length";

export interface StretchGroups {
  long: Stretch[]; // of a second or more
  short: Stretch[];
}

// Both in the wanted order; of the same length the earlier one first.
export function groupedStretches(all: readonly Stretch[], order: StretchOrder): StretchGroups {
  const sorted = [...all].sort((a, b) => (order === "length" && b.samples - a.samples) || a.from - b.from);
  const isLong = ({ samples }: Stretch) => samples >= 10 * longSeconds;
  return { long: sorted.filter(isLong), short: sorted.filter((stretch) => !isLong(stretch)) };
}
