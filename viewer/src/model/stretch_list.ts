// SPDX-License-Identifier: MIT
// The order of a list of stretches: those of a second or more first. The short ones follow; a list may fold them.
import type { Stretch } from "./roles";

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
