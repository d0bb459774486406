// SPDX-License-Identifier: MIT
// Switches: how often a robot took a role in play that it did not hold at its last decision. Every decision must be
// read for that, so it is done in slices beside the rest.
import { type Side, bothSides } from "../recording/about";
import { WrongForm } from "../recording/checked";
import type { Match } from "../recording/match";

export interface Switches {
  byRole: [number[], number[]];
  unreadable: number; // decisions
}

const sliceMilliseconds = 8;

export async function countSwitches(match: Match, pause: () => Promise<void>): Promise<Switches> {
  const count = (side: Side) => match.about.teams[side].roles.map(() => 0);
  const result: Switches = { byRole: [count(0), count(1)], unreadable: 0 };
  let began = performance.now();
  for (const side of bothSides) {
    for (const [n, log] of match.decisions[side].entries()) {
      let held = -1;
      for (let i = 0; i < log.length; ++i) {
        try {
          const { role } = log.json(i) as { role?: unknown };
          if (!Number.isInteger(role)) throw new WrongForm("role");
          const taken = role as number;
          if (match.inPlay[side][n]![i] && taken >= 0 && taken !== held && taken in result.byRole[side]) {
            ++result.byRole[side][taken]!;
          }
          held = taken;
        } catch (error) {
          if (!(error instanceof WrongForm) && !(error instanceof TypeError)) throw error;
          ++result.unreadable;
        }
        if (performance.now() - began > sliceMilliseconds) {
          await pause();
          began = performance.now();
        }
      }
    }
  }
  return result;
}
