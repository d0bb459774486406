// SPDX-License-Identifier: MIT
// A packet in words: what it was sent for, and who heard it.
import type { Packet } from "../model/packets";
import { listText, timeText, words } from "../model/text";
import type { Match } from "../recording/match";

export function packetLines(match: Match, packet: Packet): string[] {
  const others = Array.from({ length: match.game.sizes[packet.side] }, (_, i) => i + 1).filter(
    (n) => n !== packet.robot,
  );
  const heard = others.filter((n) => packet.heard.has(n));
  const not = others.filter((n) => match.packets.lost(packet, n));
  return [
    `packet of ${packet.robot} at ${timeText(packet.time, 2)}: ${words(packet.reason)}, ${packet.bytes} bytes`,
    `heard by ${heard.length > 0 ? listText(heard) : "nobody"}${not.length > 0 ? `, not by ${listText(not)}` : ""}`,
  ];
}
