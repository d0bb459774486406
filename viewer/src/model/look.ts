// SPDX-License-Identifier: MIT
// What a robot decided and believed last, at some time.
import type { Side } from "../recording/about";
import { shortened } from "./text";
import { WrongForm } from "../recording/checked";
import type { Log } from "../recording/log";
import type { Match } from "../recording/match";
import type { Belief, Decision, World } from "../recording/messages";

export interface Look {
  decision: Decision | null;
  belief: Belief | null;
  fault: string; // why one of them cannot be shown
}

function last<T>(log: Log<T> | undefined, time: number, what: string, faults: string[]): T | null {
  const index = log?.indexAt(time + 1e-9) ?? -1;
  if (log === undefined || index < 0) return null;
  try {
    return log.at(index);
  } catch (error) {
    if (!(error instanceof WrongForm)) throw error;
    faults.push(`This ${what} cannot be read: ${error.message}.`);
    return null;
  }
}

export function lookAt(match: Match, side: Side, number: number, time: number): Look {
  const faults: string[] = [];
  const decision = last(match.decisions[side][number - 1], time, "decision", faults);
  const belief = last(match.beliefs[side][number - 1], time, "belief", faults);
  return { decision, belief, fault: faults.join(" ") };
}

// Decisions are recorded when what was decided changes and every few seconds; the numbers behind them change all the
// time. Older than this they are not those of the moment, and may not be taken, or compared, as such.
const oldSeconds = 1;

export const ageOf = (of: Decision | Belief | null, time: number): number | null =>
  of === null ? null : Math.max(0, time - of.time);
export const isOld = (age: number | null): boolean => age !== null && age > oldSeconds + 1e-6;

// The world that is looked at: one of the two, or the one that the decision was taken on.
export type Knowledge = "decided" | "mine" | "common";

export function knowledgeOf(look: Look, wanted: Knowledge): "mine" | "common" {
  const knowledge = wanted === "decided" ? (look.decision?.knowledge ?? "mine") : wanted;
  return look.belief?.common === null ? "mine" : knowledge;
}

export const hasCommon = (match: Match, side: Side): boolean =>
  match.about.teams[side].contexts.some((c) => c.utilityKnowledge === "common" || c.tasksKnowledge === "common");

export const worldOf = (belief: Belief, knowledge: "mine" | "common"): World =>
  (knowledge === "common" ? belief.common : null) ?? belief.mine;

export function roleName(match: Match, side: Side, role: number): string {
  if (role === -2) return "unknown";
  return role < 0 ? "none" : (match.about.teams[side].roles[role]?.name ?? `role ${role}`);
}

// Without the list that makes it unique: where there is little room.
export const shortRoleName = (match: Match, side: Side, role: number): string =>
  shortened(roleName(match, side, role).replace(/^.*\./, ""), 24);
