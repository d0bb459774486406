// SPDX-License-Identifier: MIT
// Where the bytes of a recording come from: the page itself, as base64, or a file that the reader of the page chose.
import { UnreadableRecording } from "./about";
import { mostBytes } from "./match";

export interface Source {
  name: string;
  bytes(): Promise<Uint8Array>;
}

const values = new Int16Array(256).fill(-1);
for (const [value, letter] of [..."ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"].entries()) {
  values[letter.charCodeAt(0)] = value;
}

export function fromBase64(text: string): Uint8Array {
  const native = (Uint8Array as unknown as { fromBase64?: (text: string) => Uint8Array }).fromBase64;
  if (native !== undefined) {
    try {
      return native.call(Uint8Array, text);
    } catch {
      throw new UnreadableRecording("The recording in this page is damaged: make the page again.");
    }
  }
  let length = text.length;
  while (length > 0 && text.charCodeAt(length - 1) === 61) --length;
  const bytes = new Uint8Array((length * 3) >> 2);
  let bits = 0;
  let held = 0;
  let at = 0;
  for (let i = 0; i < length; ++i) {
    const value = values[text.charCodeAt(i) & 255]!;
    if (value < 0) throw new UnreadableRecording("The recording in this page is damaged: make the page again.");
    bits = ((bits << 6) | value) & 0xffff;
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes[at++] = (bits >> held) & 255;
    }
  }
  return bytes;
}

// null: none stands in the page. The text leaves the document, for it is never needed again.
export function embedded(document: Document): Source | null {
  const element = document.getElementById("recording");
  const text = element?.textContent?.trim() ?? "";
  if (element === null || text.startsWith("@")) return null;
  const name = element.dataset.name ?? "";
  element.textContent = "";
  return { name, bytes: async () => fromBase64(text) };
}

export function ofFile(file: File): Source {
  return {
    name: file.name,
    bytes: async () => {
      if (file.size > mostBytes) {
        const megabytes = (bytes: number) => Math.round(bytes / 2 ** 20);
        throw new UnreadableRecording(
          `The file holds ${megabytes(file.size)} MiB; this page opens recordings of up to ` +
            `${megabytes(mostBytes)} MiB.`,
        );
      }
      try {
        return new Uint8Array(await file.arrayBuffer());
      } catch {
        throw new UnreadableRecording("The browser cannot read this file.");
      }
    },
  };
}
