// SPDX-License-Identifier: MIT
// Packs bytes into a frame of LZ4, for the page's build and its tests; src/recording/lz4.ts unpacks it. Up to 4 MiB.

export function lz4Frame(bytes) {
  const out = [];
  const length = (nibble) => {
    for (let rest = nibble - 15; rest >= 0; rest -= 255) out.push(Math.min(rest, 255));
  };
  const sequence = (literals, distance, copied) => {
    out.push((Math.min(literals.length, 15) << 4) | Math.min(Math.max(copied - 4, 0), 15));
    length(literals.length);
    for (const byte of literals) out.push(byte);
    if (copied === 0) return;
    out.push(distance & 255, distance >> 8);
    length(copied - 4);
  };
  const known = new Map();
  let begun = 0; // of the literals
  // The last match begins 12 bytes before the end at the latest, and the last 5 bytes are literals.
  for (let at = 0; at + 12 <= bytes.length; ) {
    const four = bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16) | (bytes[at + 3] << 24);
    const before = known.get(four) ?? -65536;
    known.set(four, at);
    let copied = 0;
    const most = at - before < 65536 ? bytes.length - 5 - at : 0;
    while (copied < most && bytes[before + copied] === bytes[at + copied]) ++copied;
    if (copied < 4) {
      ++at;
      continue;
    }
    sequence(bytes.subarray(begun, at), at - before, copied);
    begun = at += copied;
  }
  sequence(bytes.subarray(begun), 0, 0);
  const whole = (value) => [value & 255, (value >> 8) & 255, (value >> 16) & 255, value >> 24];
  // Version 1, independent blocks of up to 4 MiB, no checksums; then the checksum of these two bytes.
  return Uint8Array.from([...whole(0x184d2204), 0x60, 0x70, 0x73, ...whole(out.length), ...out, ...whole(0)]);
}
