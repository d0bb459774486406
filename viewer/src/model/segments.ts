// SPDX-License-Identifier: MIT
// The life of each segment that a plugin offered: refused at once, or pending until it was sent or dropped; and, once
// sent, which teammates heard it. What the radio lost tells the packet that it was in.
import type { Side } from "../recording/about";
import type { SegmentMessage } from "../recording/messages";
import type { Packets } from "./packets";

// It came to this robot, and to its plugin unless `why` says why not.
export interface Hearing {
  robot: number;
  time: number; // when it arrived
  why: string;
}

export type Fate = "pending" | "refused" | "sent" | "dropped";

export interface Segment {
  side: Side;
  robot: number; // that offered it
  handle: number; // 0: refused
  plugin: string;
  place: number;
  from: number; // when it was offered; else, where that is missing in the recording, the first that is known of it
  length: number | null; // bytes; null: its offer is missing
  bytes: string; // hexadecimal
  text: string; // what its plugin says that they say, or empty
  urgency: number | null;
  expires: number | null;
  fate: Fate; // at the end of the recording
  at: number; // when it was sent, dropped or refused; Infinity while it is pending
  why: string; // it was dropped or refused
  by: number; // handle of the offer that replaced it; 0: none did
  left: boolean; // if sent: the packet left the robot
  heard: Hearing[]; // in the order in which they are told
}

// Teammates of the sender, in the order of their numbers.
export interface Reach {
  heard: Hearing[];
  undelivered: Hearing[]; // the packet came, its plugin got nothing
  lost: number[]; // the radio lost it
}

const sameTime = 1e-3; // s: times are written rounded

export class Segments {
  readonly all: Segment[] = []; // by `from`
  // Came in a packet of which no segment is recorded as sent, or whose segments do not end where it does.
  unmatched = 0;
  private readonly byHandle = new Map<string, Segment>();

  add(message: SegmentMessage): void {
    const { side, robot, time } = message;
    switch (message.segment) {
      case "offered":
        Object.assign(this.of(message, robot), this.offer(message));
        return;
      case "refused":
        this.all.push({ ...this.made(message, robot), ...this.offer(message), fate: "refused", at: time });
        return;
      case "sent":
        Object.assign(this.of(message, robot), { fate: "sent", at: time, left: message.left });
        return;
      case "dropped":
        Object.assign(this.of(message, robot), { fate: "dropped", at: time, why: message.why, by: message.by });
        return;
      case "heard":
      case "undelivered":
        if (message.handle === 0) ++this.unmatched;
        else this.of({ ...message, side }, message.sender).heard.push({ robot, time: message.heard, why: message.why });
    }
  }

  private offer({ length, bytes, text, urgency, expires, why }: SegmentMessage) {
    return { length, bytes, text, urgency, expires, why };
  }

  private made({ side, handle, plugin, place, time }: SegmentMessage, robot: number): Segment {
    return {
      ...{ side, robot, handle, plugin, place, from: time },
      ...{ length: null, bytes: "", text: "", urgency: null, expires: null },
      ...{ fate: "pending", at: Infinity, why: "", by: 0, left: true, heard: [] },
    };
  }

  // The one that `robot` offered under the message's handle.
  private of(message: SegmentMessage, robot: number): Segment {
    const key = `${message.side}/${robot}/${message.handle}`;
    const known = this.byHandle.get(key);
    if (known !== undefined) return known;
    const made = this.made(message, robot);
    this.byHandle.set(key, made);
    this.all.push(made);
    return made;
  }

  // Messages of one moment may stand in the file in any order of robots.
  close(): void {
    this.all.sort((a, b) => a.from - b.from);
  }
}

// size: robots of its team.
export function reachOf(segment: Segment, packets: Packets, size: number): Reach {
  const arrived = (delivered: boolean) =>
    segment.heard.filter(({ why }) => (why === "") === delivered).sort((a, b) => a.robot - b.robot);
  const reach: Reach = { heard: arrived(true), undelivered: arrived(false), lost: [] };
  if (segment.fate !== "sent") return reach;
  const packet = packets.last(segment.side, segment.robot, segment.at + sameTime);
  if (packet === null || packet.time < segment.at - sameTime) return reach;
  for (let number = 1; number <= size; ++number) if (packets.lost(packet, number)) reach.lost.push(number);
  return reach;
}

// "0a1bff" -> "0a 1b ff"
export const spacedBytes = (bytes: string): string => bytes.replace(/..(?=.)/g, "$& ");
