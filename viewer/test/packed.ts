// SPDX-License-Identifier: MIT
// Recordings as a page holds them (host/recording/packed_recording.hpp), made anew from that description.
import { crc32 } from "@foxglove/crc";
import zstd from "@foxglove/wasm-zstd";
import { McapRecordBuilder } from "@mcap/core";

import type { Logged } from "./synthetic";

const number = /(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.])/g;
const decimalsOf = (text: string) => text.split(".")[1]?.length ?? 0;
// As differences only numbers of up to five decimals stand, which JavaScript writes in the same way.
const isPlain = (text: string) => String(Number(text)) === text && !text.includes("e") && decimalsOf(text) <= 5;

function tablesOf(topics: string[], messages: readonly Logged[]): Uint8Array {
  const out: number[] = [];
  const whole = (value: number) => {
    for (; value >= 128; value = Math.floor(value / 128)) out.push((value % 128) + 128);
    out.push(value);
  };
  const zigzag = (value: number) => (value < 0 ? -2 * value - 1 : 2 * value);
  const text = (value: string) => {
    const bytes = new TextEncoder().encode(value);
    whole(bytes.length);
    out.push(...bytes);
  };
  const sums = (values: number[]) => values.forEach((value, i) => whole(zigzag(value - (values[i - 1] ?? 0))));
  const forms = new Map<string, { place: number; message: Logged; numbers: string[] }[]>();
  for (const [place, message] of messages.entries()) {
    const json = new TextDecoder().decode(message.data);
    const form = JSON.stringify(json.split(number));
    forms.set(form, [...(forms.get(form) ?? []), { place, message, numbers: json.match(number) ?? [] }]);
  }
  whole(topics.length);
  topics.forEach(text);
  whole(messages.length);
  sums(messages.map(({ logTime }) => Number(logTime)));
  const tables = [...forms].map(([form, rows]) => {
    const columns = rows[0]!.numbers.map((_, i) => rows.map(({ numbers }) => numbers[i]!));
    const decimals = columns.map((column) => Math.max(0, ...column.filter(isPlain).map(decimalsOf)));
    return { pieces: JSON.parse(form) as string[], rows, columns, decimals };
  });
  whole(tables.length);
  for (const { pieces, rows, decimals } of tables) {
    whole(decimals.length);
    pieces.forEach(text);
    decimals.forEach(whole);
    whole(rows.length);
  }
  const texts: string[] = [];
  for (const { rows, columns, decimals } of tables) {
    sums(rows.map(({ place }) => place));
    sums(rows.map(({ message }) => topics.indexOf(message.topic)));
    for (const [i, column] of columns.entries()) {
      let before = 0;
      for (const each of column) {
        const units = Math.round(Number(each) * 10 ** decimals[i]!);
        if (!isPlain(each) || Math.abs(units) >= 2 ** 31) {
          whole(0);
          texts.push(each);
        } else {
          whole(zigzag(units - before) + 1);
          before = units;
        }
      }
    }
  }
  texts.forEach(text);
  return Uint8Array.from(out);
}

// most: messages in one record.
export function packed(pairs: Record<string, string>, messages: readonly Logged[], most: number): Uint8Array {
  const topics = [...new Set(messages.map(({ topic }) => topic))];
  const records: Uint8Array[] = [];
  const builder = new McapRecordBuilder();
  const take = () => {
    records.push(builder.buffer.slice());
    builder.reset();
  };
  builder.writeMagic();
  builder.writeHeader({ profile: "", library: "regista test" });
  builder.writeMetadata({ name: "match", metadata: new Map(Object.entries(pairs)) });
  take();
  for (let begin = 0; begin < messages.length; begin += most) {
    const tables = tablesOf(topics, messages.slice(begin, begin + most));
    const frame = new Uint8Array(zstd.compress(tables, 1));
    const record = new Uint8Array(9 + 12 + frame.length);
    const view = new DataView(record.buffer);
    record[0] = 0x80;
    view.setBigUint64(1, BigInt(12 + frame.length), true);
    view.setBigUint64(9, BigInt(tables.length), true);
    view.setUint32(17, crc32(tables), true);
    record.set(frame, 21);
    records.push(record);
  }
  builder.writeDataEnd({ dataSectionCrc: 0 });
  builder.writeFooter({ summaryStart: 0n, summaryOffsetStart: 0n, summaryCrc: 0 });
  builder.writeMagic();
  take();
  return new Uint8Array(Buffer.concat(records));
}
