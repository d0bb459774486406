// SPDX-License-Identifier: MIT
// Of a long list by time, what stands around a moment: a panel that follows time shows no more of it.
import { lastNotAfter } from "../recording/log";

// So many that are not after `time`, and so many of the next ones; `last`: the last that is not after it. times: those
// of `all`, ascending.
export function around<T>(
  all: readonly T[],
  times: readonly number[],
  time: number,
  before: number,
  after: number,
): { shown: readonly T[]; last: T | null } {
  const at = lastNotAfter(times, time + 1e-9);
  return {
    shown: all.slice(Math.max(0, at + 1 - before), at + 1 + after),
    last: all[at] ?? null,
  };
}
