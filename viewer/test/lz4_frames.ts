// SPDX-License-Identifier: MIT
// Frames of LZ4 for tests. `lz4Frame` packs them; that they are what they should be, the decompressor of @mcap/support
// says (model_rewritten.test.ts). `ofTheTool` were made by the program lz4, version 1.9.4, with -9 and what stands there.

export function lz4Frame(bytes: Uint8Array): Uint8Array {
  const out: number[] = [];
  const length = (nibble: number) => {
    for (let rest = nibble - 15; rest >= 0; rest -= 255) out.push(Math.min(rest, 255));
  };
  const sequence = (literals: Uint8Array, distance: number, copied: number) => {
    out.push((Math.min(literals.length, 15) << 4) | Math.min(Math.max(copied - 4, 0), 15));
    length(literals.length);
    out.push(...literals);
    if (copied === 0) return;
    out.push(distance & 255, distance >> 8);
    length(copied - 4);
  };
  const known = new Map<number, number>();
  let begun = 0; // of the literals
  // The last match begins 12 bytes before the end at the latest, and the last 5 bytes are literals.
  for (let at = 0; at + 12 <= bytes.length; ) {
    const four = bytes[at]! | (bytes[at + 1]! << 8) | (bytes[at + 2]! << 16) | (bytes[at + 3]! << 24);
    const before = known.get(four) ?? -65536;
    known.set(four, at);
    let copied = 0;
    if (at - before < 65536) while (at + copied < bytes.length - 5 && bytes[before + copied] === bytes[at + copied]) ++copied;
    if (copied < 4) {
      ++at;
      continue;
    }
    sequence(bytes.subarray(begun, at), at - before, copied);
    begun = at += copied;
  }
  sequence(bytes.subarray(begun), 0, 0);
  const whole = (value: number) => [value & 255, (value >> 8) & 255, (value >> 16) & 255, value >> 24];
  // Version 1, independent blocks of up to 4 MiB, no checksums; then the checksum of these two bytes.
  return Uint8Array.from([...whole(0x184d2204), 0x60, 0x70, 0x73, ...whole(out.length), ...out, ...whole(0)]);
}

export const textOfTheTool = Array.from(
  { length: 12000 },
  (_, i) => `robot ${(i % 7) + 1} at ${Math.floor(i / 2000)}\n`,
).join("");

export const ofTheTool: Readonly<Record<string, string>> = {
  "":
    "BCJNGGRQCCEDAADScm9ib3QgMSBhdCAwCg0AGDINABgzDQAYNA0AGDUNABg2DQAYNw0AD1sA////////////////////////////////////" +
    "//////////////////////////////////////////////////////////////////////////////////////////////////+MGDFbABgx" +
    "WwAYMVsAGDFbABgxWwAYMVsAHzFbAP//////////////////////////////////////////////////////////////////////////////" +
    "////////////////////////////////////////////////////////kxgyWwAYMlsAGDJbABgyWwAYMlsAGDJbAB8yWwD/////////////" +
    "////////////////////////////////////////////////////////////////////////////////////////////////////////////" +
    "/////////////5MYM1sAGDNbABgzWwAYM1sAGDNbABgzWwAfM1sA////////////////////////////////////////////////////////" +
    "//////////////////////////////////////////////////////////////////////////////+TGDRbABg0WwAYNFsAGDRbABg0WwAY" +
    "NFsAHzRbAP//////////////////////////////////////////////////////////////////////////////////////////////////" +
    "////////////////////////////////////kxg1WwAYNVsAGDVbABg1WwAYNVsAGDVbAB81WwD/////////////////////////////////" +
    "/////////////////////////////////////////////////////////////////////////////////////////////////////4NQYXQg" +
    "NQoAAAAAH2JUNA==",
  "-BD --content-size -BX -B4":
    "BCJNGFRArmoBAADScm9ib3QgMSBhdCAwCg0AGDINABgzDQAYNA0AGDUNABg2DQAYNw0AD1sA////////////////////////////////////" +
    "//////////////////////////////////////////////////////////////////////////////////////////////////+MGDFbABgx" +
    "WwAYMVsAGDFbABgxWwAYMVsAHzFbAP//////////////////////////////////////////////////////////////////////////////" +
    "////////////////////////////////////////////////////////kxgyWwAYMlsAGDJbABgyWwAYMlsAGDJbAB8yWwD/////////////" +
    "////////////////////////////////////////////////////////olAyCnJvYhApw51eAQAAD1sA////////////////////////////" +
    "////////////////////////////////////2BgzWwAYM1sAGDNbABgzWwAYM1sAGDNbAB8zWwD/////////////////////////////////" +
    "/////////////////////////////////////////////////////////////////////////////////////////////////////5MYNFsA" +
    "GDRbABg0WwAYNFsAGDRbABg0WwAfNFsA////////////////////////////////////////////////////////////////////////////" +
    "//////////////////////////////////////////////////////////+TGDVbABg1WwAYNVsAGDVbABg1WwAYNVsAHzVbAP///8FQb2Jv" +
    "dCBy93R8awAAAA9bAP//////////////////////////////////////////////////////////////////////////////////////////" +
    "//////////////////////////////////////+pUGF0IDUKNUC7NwAAAAAfYlQ0",
};

// 60 bytes that cannot be packed.
export const bytesOfTheTool = Uint8Array.from({ length: 60 }, (_, i) => (i * i * 31 + i * 7) % 251);
export const storedByTheTool =
    "BCJNGGRApzwAAIAAJooxFjmaPiBAnj8eO5Y0ECqCHfENYvXL3zbGmar5i1tptUQRHGXstr4JjVRZnCLh4yimZ2ajI9zYF48AAAAAA2ueFA==";
