// SPDX-License-Identifier: MIT
// The frame of an MCAP file (https://mcap.dev/spec): records one after the other, each with its kind and length, and a
// summary at the end that says where the chunks begin. With it the chunks after a damaged place are found again.
import { crc32 } from "@foxglove/crc";

export const magic = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];

export const opcodes = {
  header: 0x01,
  footer: 0x02,
  schema: 0x03,
  channel: 0x04,
  message: 0x05,
  chunk: 0x06,
  chunkIndex: 0x08,
  metadata: 0x0c,
  dataEnd: 0x0f,
} as const;

const headBytes = 9; // kind and length
const footerBytes = headBytes + 20;

export interface RecordPlace {
  opcode: number;
  content: number; // bytes from the beginning of the file
  end: number;
}

const viewOf = (bytes: Uint8Array) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);

// null: the file ends within the record.
export function recordAt(bytes: Uint8Array, at: number): RecordPlace | null {
  if (at + headBytes > bytes.length) return null;
  const content = at + headBytes;
  const end = content + Number(viewOf(bytes).getBigUint64(at + 1, true));
  return end > bytes.length ? null : { opcode: bytes[at]!, content, end };
}

// The file ends as it should: it was not cut off.
export const endsWell = (bytes: Uint8Array): boolean =>
  bytes.length >= 2 * magic.length && magic.every((byte, i) => bytes[bytes.length - magic.length + i] === byte);

// Where the chunks begin, ascending, and the records of channels of the summary; nothing when there is no summary, or
// when it cannot be read.
export function chunkStarts(bytes: Uint8Array): { starts: number[]; channels: Uint8Array } {
  const none = { starts: [], channels: new Uint8Array(0) };
  const footer = bytes.length - magic.length - footerBytes;
  if (footer < magic.length || !endsWell(bytes)) return none;
  const place = recordAt(bytes, footer);
  if (place === null || place.opcode !== opcodes.footer || place.end !== footer + footerBytes) return none;
  const view = viewOf(bytes);
  const summary = Number(view.getBigUint64(place.content, true));
  // The checksum, where there is one, is that of all from the summary's beginning up to itself.
  const checksum = view.getUint32(place.content + 16, true);
  if (summary < magic.length || summary > footer) return none;
  if (checksum !== 0 && checksum !== crc32(bytes.subarray(summary, place.content + 16))) return none;
  const starts: number[] = [];
  const channels: Uint8Array[] = [];
  for (let at = summary; at < footer; ) {
    const record = recordAt(bytes, at);
    if (record === null || record.end > footer) return none;
    if (record.opcode === opcodes.channel) channels.push(bytes.subarray(at, record.end));
    // Times of the first and the last message, then where the chunk begins.
    if (record.opcode === opcodes.chunkIndex && record.end >= record.content + 24) {
      starts.push(Number(view.getBigUint64(record.content + 16, true)));
    }
    at = record.end;
  }
  if (starts.some((start) => start < magic.length || start >= footer)) return none;
  const joined = new Uint8Array(channels.reduce((total, channel) => total + channel.length, 0));
  let filled = 0;
  for (const channel of channels) {
    joined.set(channel, filled);
    filled += channel.length;
  }
  return { starts: starts.sort((a, b) => a - b), channels: joined };
}
