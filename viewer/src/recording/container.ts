// SPDX-License-Identifier: MIT
// The container: MCAP (https://mcap.dev/spec), read from front to back, record by record, by its official library.
// What is complete in a file that was cut off is found; a chunk that is damaged is left out, and reading goes on with
// the next one.
import { McapRecordBuilder, McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";

import { UnreadableRecording } from "./about";
import { type Content, Encoded } from "./content";
import { unpackLz4 } from "./lz4";
import { packedOpcode, unpack } from "./packed";
import { chunkStarts, endsWell, magic, opcodes, recordAt } from "./records";

export interface ContainerMessage {
  topic: string;
  channel: number;
  sequence: number;
  logTime: bigint; // ns
  content: Content;
}

export interface Visitor {
  metadata(name: string, pairs: ReadonlyMap<string, string>): void;
  message(message: ContainerMessage): void;
  damage(): void; // between the messages before and after, some are missing
}

export interface Damage {
  cutOff: boolean;
  parts: number; // chunks and other records that cannot be read
  reason: string; // for the first of them
}

type RecordOfReader = NonNullable<ReturnType<McapStreamReader["nextRecord"]>>;
type Channel = Extract<RecordOfReader, { type: "Channel" }>;

type DecompressHandlers = Awaited<ReturnType<typeof loadDecompressHandlers>>;

const sliceMilliseconds = 40; // then the browser may paint

// Long work that lets the browser paint now and then, and says how far it is.
export class Slices {
  private began = performance.now();

  constructor(private readonly progress: (share: number) => void) {}

  get due(): boolean {
    return performance.now() - this.began > sliceMilliseconds;
  }

  async rest(share: number): Promise<void> {
    this.progress(share);
    await new Promise<void>((resolve) => setTimeout(resolve, 0));
    this.began = performance.now();
  }
}

// Takes whole records. One that it cannot read does no harm to those after it.
class Records {
  private reader: McapStreamReader | null = null;
  private readonly channels = new Map<number, Channel>();

  constructor(
    private readonly decompressHandlers: DecompressHandlers,
    private readonly visitor: Visitor,
    private readonly summary: Uint8Array, // records of channels, which may be missing before
  ) {}

  // After an error the library's reader can no longer be used: another one goes on, knowing the same channels.
  private fresh(): McapStreamReader {
    const { decompressHandlers } = this;
    const make = () => new McapStreamReader({ decompressHandlers, validateCrcs: true, noMagicPrefix: true });
    const known = new McapRecordBuilder();
    for (const channel of this.channels.values()) known.writeChannel(channel);
    for (const bytes of [this.summary, new Uint8Array(0)]) {
      const reader = make();
      try {
        reader.append(known.buffer);
        reader.append(bytes);
        for (let record; (record = reader.nextRecord()) !== undefined; )
          if (record.type === "Channel") this.channels.set(record.id, record);
        return reader;
      } catch {
        // The summary contradicts what stands before: without it.
      }
    }
    return make();
  }

  take(bytes: Uint8Array): void {
    this.reader ??= this.fresh();
    const read: RecordOfReader[] = [];
    try {
      this.reader.append(bytes);
      for (let record; (record = this.reader.nextRecord()) !== undefined; ) read.push(record);
      if (this.reader.bytesRemaining() > 0) throw new Error("A record is shorter than it says");
    } catch (error) {
      this.reader = null;
      throw error;
    }
    for (const record of read) {
      if (record.type === "Channel") {
        this.channels.set(record.id, record);
      } else if (record.type === "Message") {
        const { channelId: channel, sequence, logTime } = record;
        const topic = this.channels.get(channel)?.topic ?? "";
        this.visitor.message({ topic, channel, sequence, logTime, content: new Encoded(record.data) });
      } else if (record.type === "Metadata") {
        this.visitor.metadata(record.name, record.metadata);
      }
    }
  }
}

const read: readonly number[] = [
  opcodes.header,
  opcodes.schema,
  opcodes.channel,
  opcodes.message,
  opcodes.chunk,
  opcodes.metadata,
  packedOpcode,
];

export async function readContainer(
  bytes: Uint8Array,
  visitor: Visitor,
  progress: (share: number) => void = () => {},
): Promise<Damage> {
  if (bytes.length === 0) throw new UnreadableRecording("The file is empty: nothing was recorded into it.");
  if (!magic.every((byte, i) => i >= bytes.length || bytes[i] === byte)) {
    throw new UnreadableRecording("This is no recording of a match: the file is not in the MCAP format.");
  }
  const { starts, channels } = chunkStarts(bytes);
  const decompress: DecompressHandlers = { ...(await loadDecompressHandlers()), lz4: unpackLz4 };
  const records = new Records(decompress, visitor, channels);
  const found: Damage = { cutOff: false, parts: 0, reason: "" };
  const damaged = (reason: string) => {
    if (found.parts++ === 0) found.reason = reason;
    visitor.damage();
  };
  const slices = new Slices(progress);
  let next = 0; // place in `starts` of the first chunk after `at`
  for (let at = magic.length; ; ) {
    while (next < starts.length && starts[next]! <= at) ++next;
    const following = starts[next];
    const isChunk = next > 0 && starts[next - 1] === at;
    const record = recordAt(bytes, at);
    if (record === null || record.end > (following ?? bytes.length) || (isChunk && record.opcode !== opcodes.chunk)) {
      // It does not end where it may: it says a wrong length, or the file ends within it.
      if (following === undefined && !endsWell(bytes)) {
        found.cutOff = true;
        break;
      }
      damaged("a record says a wrong length or kind");
      if (following === undefined) break;
      at = following;
      continue;
    }
    if (record.opcode === opcodes.dataEnd || record.opcode === opcodes.footer) {
      found.cutOff = !endsWell(bytes);
      break;
    }
    if (read.includes(record.opcode)) {
      try {
        if (record.opcode === packedOpcode) {
          const tables = bytes.subarray(record.content, record.end);
          for (const message of unpack(tables, decompress.zstd!)) visitor.message(message);
        } else {
          records.take(bytes.subarray(at, record.end));
        }
      } catch (error) {
        if (error instanceof UnreadableRecording) throw error;
        damaged(error instanceof Error ? error.message : String(error));
      }
    }
    at = record.end;
    if (slices.due) await slices.rest(at / bytes.length);
  }
  return found;
}
