// SPDX-License-Identifier: MIT
// Messages as the page's own recording holds them (host/recording/packed_recording.hpp): tables of numbers, and what
// stands between them once for all rows. A message is put together when it is asked for.
import { crc32 } from "@foxglove/crc";

import type { ContainerMessage } from "./container";
import type { Content } from "./content";

export const packedOpcode = 0x80;

const decoder = new TextDecoder();

function refuse(why: string): never {
  throw new Error(`the page's tables ${why}`);
}

class Bytes {
  private at = 0;

  constructor(private readonly bytes: Uint8Array) {}

  whole(): number {
    let value = 0;
    for (let scale = 1; ; scale *= 128) {
      const byte = this.bytes[this.at++] ?? refuse("end too soon");
      value += (byte & 127) * scale;
      if (byte < 128) return value;
      if (scale > 2 ** 49) refuse("hold too large a number");
    }
  }

  // Of differences.
  sums(count: number): number[] {
    let sum = 0;
    return this.list(count, () => (sum += signedOf(this.whole())));
  }

  text(): string {
    const length = this.count();
    const begin = this.at;
    this.at += length;
    // Most are the commas between numbers, for which a decoder is slow.
    if (length === 1 && this.bytes[begin]! < 128) return String.fromCharCode(this.bytes[begin]!);
    return decoder.decode(this.bytes.subarray(begin, this.at));
  }

  // At least so many bytes follow: nothing that a file claims takes more memory than it has bytes.
  has(count: number): number {
    return count <= this.bytes.length - this.at ? count : refuse("end too soon");
  }

  // How many of something follow.
  count(): number {
    return this.has(this.whole());
  }

  // Texts, read when they are asked for: of most tables nobody ever looks at a row.
  textsLater(count: number): () => string[] {
    const there = new Bytes(this.bytes);
    there.at = this.at;
    for (let i = 0; i < count; ++i) {
      const length = this.count();
      this.at += length;
    }
    return () => there.list(count, () => there.text());
  }

  list<T>(count: number, item: () => T): T[] {
    const out: T[] = [];
    for (let i = 0; i < count; ++i) out.push(item());
    return out;
  }

  // A column of numbers, which are most of what there is. without: takes the places of those that are texts.
  column(units: Int32Array, begin: number, end: number, without: (place: number) => void): void {
    const { bytes } = this;
    let sum = 0;
    for (let place = begin; place < end; ++place) {
      const byte = bytes[this.at]!;
      let coded = byte;
      if (byte < 128) ++this.at;
      else coded = this.whole();
      if (coded === 0) without(place);
      else units[place] = sum += signedOf(coded - 1);
    }
  }
}

function signedOf(zigzag: number): number {
  if (zigzag < 2 ** 31) return (zigzag >>> 1) ^ -(zigzag & 1);
  return zigzag % 2 === 0 ? zigzag / 2 : -(zigzag + 1) / 2;
}

class Table {
  units = new Int32Array(0); // [column * rows + row]: of 10^-decimals
  readonly texts = new Map<number, string>(); // by the same place: numbers that are written otherwise
  private pieces: string[] | null = null; // before, between and after the columns
  private readonly suffixes: string[] = []; // by column; empty: the number is written out

  constructor(
    private readonly read: () => string[], // the pieces
    private readonly decimals: number[],
    readonly rows: number,
  ) {}

  get columns(): number {
    return this.decimals.length;
  }

  private prepared(): string[] {
    this.pieces = this.read();
    let inWord = false; // within a text of JSON a number keeps its form; elsewhere 1234e-3 is 1.234, and written faster
    for (const [i, decimals] of this.decimals.entries()) {
      const quotes = this.pieces[i]!.replace(/\\./gs, "").split('"').length - 1;
      if (quotes % 2 === 1) inWord = !inWord;
      this.suffixes.push(inWord || decimals === 0 ? "" : `e-${decimals}`);
    }
    return this.pieces;
  }

  // The beginning of a row's message, of `most` letters or a few more.
  text(row: number, most: number): string {
    const pieces = this.pieces ?? this.prepared();
    let out = pieces[0]!;
    for (let column = 0; column < this.columns && out.length < most; ++column) {
      const place = column * this.rows + row;
      const suffix = this.suffixes[column]!;
      const units = this.units[place]!;
      const text = this.texts.size === 0 ? undefined : this.texts.get(place);
      out += text ?? (suffix === "" ? units / 10 ** this.decimals[column]! : units + suffix);
      out += pieces[column + 1]!;
    }
    return out;
  }
}

class Row implements ContainerMessage, Content {
  readonly content = this;

  constructor(
    readonly topic: string,
    readonly channel: number,
    readonly sequence: number,
    readonly logTime: bigint,
    private readonly table: Table,
    private readonly row: number,
  ) {}

  text(most = Infinity): string {
    return this.table.text(this.row, most);
  }
}

// content: of the record. In the order in which the messages were recorded.
export function unpack(
  content: Uint8Array,
  decompress: (frame: Uint8Array, size: bigint) => Uint8Array,
): ContainerMessage[] {
  if (content.length < 12) refuse("end too soon");
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  const plain = decompress(content.subarray(12), view.getBigUint64(0, true));
  if (crc32(plain) !== view.getUint32(8, true)) refuse("have a wrong checksum");
  const bytes = new Bytes(plain);
  const topics = bytes.list(bytes.count(), () => bytes.text());
  const times = bytes.sums(bytes.count());
  const tables = bytes.list(bytes.count(), () => {
    const columns = bytes.count();
    const pieces = bytes.textsLater(columns + 1);
    const decimals = bytes.list(columns, () => bytes.whole());
    return new Table(pieces, decimals, bytes.count());
  });
  const messages = new Array<ContainerMessage>(times.length);
  let known = 0;
  const without: { table: Table; place: number }[] = []; // numbers that are texts
  for (const table of tables) {
    const [places, channels] = [bytes.sums(table.rows), bytes.sums(table.rows)];
    for (let row = 0; row < table.rows; ++row) {
      const [place, channel] = [places[row]!, channels[row]!];
      const [time, topic] = [times[place], topics[channel]];
      if (time === undefined || topic === undefined) refuse("name a message or topic that is missing");
      if (messages[place] === undefined) ++known;
      messages[place] = new Row(topic, channel, place, BigInt(time), table, row);
    }
    table.units = new Int32Array(bytes.has(table.rows * table.columns));
    for (let begin = 0; begin < table.units.length; begin += table.rows)
      bytes.column(table.units, begin, begin + table.rows, (place) => without.push({ table, place }));
  }
  for (const { table, place } of without) table.texts.set(place, bytes.text());
  if (known !== times.length) refuse("lack a message");
  return messages;
}
