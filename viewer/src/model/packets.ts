// SPDX-License-Identifier: MIT
// Packets, and who heard them.
import type { Side } from "../recording/about";
import type { HeardMessage, PacketMessage } from "../recording/messages";
import { lastNotAfter } from "../recording/log";

export interface Packet extends PacketMessage {
  heard: Map<number, number>; // robot: time when it heard it
}

export interface News {
  heard: Packet | null;
  missed: Packet[];
  underWay: Packet[];
}

const sameTime = 1e-3; // s: times are written rounded
const longestDelivery = 1; // s; what has not arrived by then never will

// By side and robot (n - 1), in the order of time.
export class Packets {
  readonly sent: [Packet[][], Packet[][]];
  private readonly times: [number[][], number[][]];
  unmatched = 0; // heard, but no packet of that time is recorded
  // Where nothing is known of who heard what: what is missing of the recording, and all after its end; s.
  private unknown: { from: number; to: number | null }[] = [];

  constructor(sizes: readonly [number, number]) {
    const empty = (size: number) => Array.from({ length: size }, () => []);
    this.sent = [empty(sizes[0]), empty(sizes[1])];
    this.times = [empty(sizes[0]), empty(sizes[1])];
  }

  addSent(message: PacketMessage): void {
    this.sent[message.side][message.robot - 1]?.push({ ...message, heard: new Map() });
    this.times[message.side][message.robot - 1]?.push(message.time);
  }

  addHeard(message: HeardMessage): void {
    const packet = this.last(message.side, message.sender, message.sent + sameTime);
    if (packet === null || packet.time < message.sent - sameTime) ++this.unmatched;
    else packet.heard.set(message.robot, message.time);
  }

  // The last one that a robot sent, not after `time`.
  last(side: Side, robot: number, time: number): Packet | null {
    const times = this.times[side][robot - 1];
    if (times === undefined) return null;
    return this.sent[side][robot - 1]![lastNotAfter(times, time)] ?? null;
  }

  between(side: Side, robot: number, from: number, to: number): Packet[] {
    const times = this.times[side][robot - 1] ?? [];
    return this.sent[side][robot - 1]?.slice(lastNotAfter(times, from) + 1, lastNotAfter(times, to) + 1) ?? [];
  }

  // The recording is complete up to `end`, but for gaps.
  close(end: number, gaps: readonly { from: number; to: number | null }[]): void {
    this.unknown = [...gaps, { from: end, to: null }];
  }

  // `robot` never heard this packet, in all of the recording, and would have: the recording goes on long enough.
  lost(packet: Packet, robot: number): boolean {
    if (packet.heard.has(robot) || robot === packet.robot) return false;
    const latest = packet.time + longestDelivery;
    return !this.unknown.some(({ from, to }) => from < latest && (to ?? Infinity) > packet.time);
  }

  // What `robot` had heard of `sender` by `time`: the newest packet that reached it, those sent since that never did,
  // and those that were still on their way.
  news(side: Side, robot: number, sender: number, time: number): News {
    const times = this.times[side][sender - 1] ?? [];
    const all = this.sent[side][sender - 1] ?? [];
    const found: News = { heard: null, missed: [], underWay: [] };
    for (let i = lastNotAfter(times, time); i >= 0 && found.heard === null; --i) {
      const packet = all[i]!;
      const when = packet.heard.get(robot);
      if (when !== undefined && when <= time) found.heard = packet;
      else if (when !== undefined) found.underWay.unshift(packet);
      else if (this.lost(packet, robot)) found.missed.unshift(packet);
    }
    return found;
  }
}
