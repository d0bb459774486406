// SPDX-License-Identifier: MIT
// Recordings that another program wrote anew: messages in any order, log times that count from any moment, as from
// 1970. Here they get the order and the times of the match (host/recording does the same).
import type { ContainerMessage } from "./container";
import type { Content } from "./content";
import { parsedJson } from "./log";

// What was heard is written with the next decision, after others of that time: so it is in every recording.
const writtenLate = "/heard";

export function isInOrder(messages: readonly ContainerMessage[]): boolean {
  let latest = 0n;
  for (const { topic, logTime } of messages) {
    if (topic === writtenLate) continue;
    if (logTime < latest) return false;
    latest = logTime;
  }
  return true;
}

export function sortByTime(messages: ContainerMessage[]): void {
  messages.sort((a, b) =>
    a.logTime === b.logTime ? a.channel - b.channel || a.sequence - b.sequence : a.logTime < b.logTime ? -1 : 1,
  );
}

function timeOf(content: Content): number | null {
  try {
    const time: unknown = (parsedJson(content) as { time?: unknown } | null)?.time;
    return typeof time === "number" && Number.isFinite(time) ? time : null;
  } catch {
    return null;
  }
}

// By how many ns log times are ahead of those of the match: the first state of the game that can be read says its time.
export function aheadOfMatch(messages: readonly ContainerMessage[]): bigint {
  for (const { topic, logTime, content } of messages) {
    const time = topic === "/game" ? timeOf(content) : null;
    if (time === null) continue;
    const ahead = logTime - BigInt(Math.round(time * 1e9));
    // Messages tell whole milliseconds, so less than one means nothing.
    return ahead > -1_000_000n && ahead < 1_000_000n ? 0n : ahead;
  }
  return 0n;
}
