// SPDX-License-Identifier: MIT
// LZ4 frames (https://github.com/lz4/lz4/blob/dev/doc/lz4_Frame_format.md): other programs pack chunks so. The
// library's own decompressor takes no frame any more after one that was damaged. Checksums are left alone: a chunk has its own.

const magicNumber = 0x184d2204;
const flags = { version: 0xc0, blockChecksum: 0x10, contentSize: 0x08, contentChecksum: 0x04, dictionary: 0x01 };
const thisVersion = 0x40;
const isStored = 0x80000000; // a block that is not compressed

function refuse(): never {
  throw new Error("a chunk of LZ4 cannot be decompressed");
}

// Unpacks one block into `out` from `at` on; gives where it ends. first: where the frame begins, which it may refer to.
function unpackBlock(block: Uint8Array, out: Uint8Array, at: number, first: number): number {
  let from = 0;
  // Four bits, and further bytes as long as they are full.
  const length = (nibble: number): number => {
    let sum = nibble;
    for (let byte = nibble === 15 ? 255 : 0; byte === 255; sum += byte) byte = block[from++] ?? refuse();
    return sum;
  };
  for (;;) {
    const token = block[from++] ?? refuse();
    const literals = length(token >> 4);
    if (from + literals > block.length || at + literals > out.length) refuse();
    for (const end = at + literals; at < end; ) out[at++] = block[from++]!;
    if (from === block.length) return at;
    if (from + 2 > block.length) refuse();
    const distance = block[from]! | (block[from + 1]! << 8);
    from += 2;
    const copied = length(token & 15) + 4;
    if (distance === 0 || at - distance < first || at + copied > out.length) refuse();
    // Byte by byte, for what is copied may be what was copied just before.
    for (const end = at + copied; at < end; ++at) out[at] = out[at - distance]!;
  }
}

// size: bytes of all frames in `packed` together.
export function unpackLz4(packed: Uint8Array, size: bigint): Uint8Array {
  // One byte of a frame stands for at most 255 bytes, so no size can ask for all memory.
  if (size > 255n * BigInt(packed.length)) refuse();
  const view = new DataView(packed.buffer, packed.byteOffset, packed.byteLength);
  const out = new Uint8Array(Number(size));
  let from = 0;
  let at = 0;
  const whole = () => {
    if (from + 4 > packed.length) refuse();
    from += 4;
    return view.getUint32(from - 4, true);
  };
  while (from < packed.length) {
    if (whole() !== magicNumber) refuse();
    const first = at;
    const flag = packed[from] ?? refuse();
    if ((flag & flags.version) !== thisVersion || (flag & flags.dictionary) !== 0) refuse();
    from += 3 + ((flag & flags.contentSize) !== 0 ? 8 : 0); // flags, size of blocks, checksum of this head
    for (let head; (head = whole()) !== 0; ) {
      const end = from + (head & ~isStored);
      if (end > packed.length) refuse();
      const block = packed.subarray(from, end);
      if ((head & isStored) === 0) {
        at = unpackBlock(block, out, at, first);
      } else {
        if (at + block.length > out.length) refuse();
        out.set(block, at);
        at += block.length;
      }
      from = end + ((flag & flags.blockChecksum) !== 0 ? 4 : 0);
    }
    if ((flag & flags.contentChecksum) !== 0) whole();
  }
  if (at !== out.length) refuse();
  return out;
}
