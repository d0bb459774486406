// SPDX-License-Identifier: MIT
// The content of a message, made into text when it is asked for.

const decoder = new TextDecoder();

export interface Content {
  // most: letters from the beginning that are needed; more may come.
  text(most?: number): string;
}

export class Encoded implements Content {
  constructor(private readonly bytes: Uint8Array) {}

  text(most = Infinity): string {
    return decoder.decode(this.bytes.subarray(0, most));
  }
}
