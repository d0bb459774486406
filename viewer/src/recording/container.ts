// SPDX-License-Identifier: MIT
// The container: MCAP (https://mcap.dev/spec), read by its official library from front to back, so that everything
// complete in a file that was cut off or damaged is still found.
import { McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";

import { UnreadableRecording } from "./about";

export interface ContainerMessage {
  topic: string;
  time: number; // s, of the log
  data: Uint8Array;
}

export interface Visitor {
  metadata(name: string, pairs: ReadonlyMap<string, string>): void;
  message(message: ContainerMessage): void;
}

// What went wrong after which record, in words; "" when the file is whole.
export type Damage = "" | "cut off" | "damaged";

const magic = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];
const sliceBytes = 1 << 20;
const sliceMilliseconds = 40; // then the browser may paint

const pause = () => new Promise<void>((resolve) => setTimeout(resolve, 0));

export async function readContainer(
  bytes: Uint8Array,
  visitor: Visitor,
  progress: (share: number) => void = () => {},
): Promise<{ damage: Damage; reason: string }> {
  if (bytes.length === 0) throw new UnreadableRecording("The file is empty: nothing was recorded into it.");
  if (!magic.every((byte, i) => i >= bytes.length || bytes[i] === byte)) {
    throw new UnreadableRecording("This is no recording of a match: the file is not in the MCAP format.");
  }
  const reader = new McapStreamReader({ decompressHandlers: await loadDecompressHandlers(), validateCrcs: true });
  const topics = new Map<number, string>();
  let whole = false;
  let pausedAt = performance.now();
  try {
    for (let at = 0; at < bytes.length; at += sliceBytes) {
      reader.append(bytes.subarray(at, at + sliceBytes));
      for (let record; (record = reader.nextRecord()) !== undefined; ) {
        if (record.type === "Message") {
          visitor.message({
            topic: topics.get(record.channelId) ?? "",
            time: Number(record.logTime) * 1e-9,
            data: record.data,
          });
        } else if (record.type === "Channel") {
          topics.set(record.id, record.topic);
        } else if (record.type === "Metadata") {
          visitor.metadata(record.name, record.metadata);
        } else if (record.type === "Footer") {
          whole = true;
        }
      }
      if (reader.done()) break;
      if (performance.now() - pausedAt > sliceMilliseconds) {
        progress(at / bytes.length);
        await pause();
        pausedAt = performance.now();
      }
    }
  } catch (error) {
    if (error instanceof UnreadableRecording) throw error;
    return { damage: "damaged", reason: error instanceof Error ? error.message : String(error) };
  }
  return whole ? { damage: "", reason: "" } : { damage: "cut off", reason: "" };
}
