// SPDX-License-Identifier: MIT
// Packets, and who heard them.
import type { Side } from "../recording/about";
import type { HeardMessage, PacketMessage } from "../recording/messages";
import { lastNotAfter } from "../recording/log";

export interface Packet extends PacketMessage {
  heard: Map<number, number>; // robot: time when it heard it
}

const sameTime = 1e-3; // s: times are written rounded

// By side and robot (n - 1), in the order of time.
export class Packets {
  readonly sent: [Packet[][], Packet[][]];
  private readonly times: [number[][], number[][]];
  unmatched = 0; // heard, but no packet of that time is recorded

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

  // What `robot` had heard of `sender` by `time`: the newest packet that reached it, and those sent after that one.
  news(side: Side, robot: number, sender: number, time: number): { heard: Packet | null; missed: Packet[] } {
    const times = this.times[side][sender - 1] ?? [];
    const all = this.sent[side][sender - 1] ?? [];
    const missed: Packet[] = [];
    for (let i = lastNotAfter(times, time); i >= 0; --i) {
      const packet = all[i]!;
      const when = packet.heard.get(robot);
      if (when !== undefined && when <= time) return { heard: packet, missed: missed.reverse() };
      missed.push(packet);
    }
    return { heard: null, missed: missed.reverse() };
  }
}
