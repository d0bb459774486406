// SPDX-License-Identifier: MIT
// Stretches of time that may overlap, side by side: each lies in the first lane that is free when it begins.
import type { Stretch } from "./roles";

export interface Lanes {
  lane: Map<Stretch, number>;
  count: number; // lanes needed
}

// `all` in the order of time.
export function inLanes(all: readonly Stretch[]): Lanes {
  const lane = new Map<Stretch, number>();
  const until: number[] = [];
  for (const stretch of all) {
    const free = until.findIndex((end) => end <= stretch.from + 1e-6);
    const at = free < 0 ? until.length : free;
    until[at] = stretch.to;
    lane.set(stretch, at);
  }
  return { lane, count: until.length };
}

// Of stretches for which there is no room: when there are some, and how many at most at a time.
export function crowds(hidden: readonly Stretch[]): { from: number; to: number; most: number }[] {
  const found: { from: number; to: number; most: number }[] = [];
  let open: Stretch[] = [];
  for (const stretch of hidden) {
    open = open.filter((other) => other.to > stretch.from + 1e-6);
    open.push(stretch);
    const last = found[found.length - 1];
    if (last !== undefined && stretch.from <= last.to + 1e-6) {
      last.to = Math.max(last.to, stretch.to);
      last.most = Math.max(last.most, open.length);
    } else {
      found.push({ from: stretch.from, to: stretch.to, most: 1 });
    }
  }
  return found;
}
