// SPDX-License-Identifier: MIT
export function lz4Frame(bytes: Uint8Array): Uint8Array;
