// SPDX-License-Identifier: MIT
// The two functions of Node's Buffer that the decompressor calls; browsers have none.
export const Buffer = {
  allocUnsafe: (size) => new Uint8Array(size),
  from: (memory) => ({
    copy: (target, at, begin, end) => target.set(new Uint8Array(memory, begin, end - begin), at),
  }),
};
