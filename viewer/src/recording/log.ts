// SPDX-License-Identifier: MIT
// Messages of one topic by time, kept as they are written and taken apart when they are asked for.
import { WrongForm } from "./checked";
import type { Content } from "./content";

export function parsedJson(content: Content): unknown {
  try {
    return JSON.parse(content.text());
  } catch {
    throw new WrongForm("it is not JSON");
  }
}

// Place of the last of `times` (ascending) that is not after `time`; -1 when all are.
export function lastNotAfter(times: ArrayLike<number>, time: number, count = times.length): number {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

export class Log<T> {
  readonly times: number[] = [];
  private readonly contents: Content[] = [];
  private readonly recent = new Map<number, T | WrongForm>();

  constructor(private readonly form: (json: unknown) => T) {}

  get length(): number {
    return this.times.length;
  }

  // Times may not fall.
  add(time: number, content: Content): void {
    const last = this.times.length - 1;
    if (last >= 0 && time < this.times[last]!) throw new WrongForm("it is earlier than the one before it");
    this.times.push(time);
    this.contents.push(content);
  }

  // Throws WrongForm when the message is not as it should be.
  at(index: number): T {
    const known = this.recent.get(index);
    if (known instanceof WrongForm) throw known;
    if (known !== undefined) return known;
    if (this.recent.size >= 32) this.recent.delete(this.recent.keys().next().value!);
    try {
      const value = this.read(index);
      this.recent.set(index, value);
      return value;
    } catch (error) {
      if (error instanceof WrongForm) this.recent.set(index, error);
      throw error;
    }
  }

  // The same, remembering nothing: for walks over all of them.
  read(index: number): T {
    return this.form(parsedJson(this.contents[index]!));
  }

  json(index: number): unknown {
    return parsedJson(this.contents[index]!);
  }

  indexAt(time: number): number {
    return lastNotAfter(this.times, time);
  }
}

// Of a long list by time, what stands around a moment: a panel that follows time shows no more of it. Up to `before`
// that are not after `time`, up to `after` of the next ones; `last`: the last that is not after it. times: those of
// `all`, ascending.
export function around<T>(
  all: readonly T[],
  times: readonly number[],
  time: number,
  before: number,
  after: number,
): { shown: readonly T[]; last: T | null } {
  const at = lastNotAfter(times, time + 1e-9);
  return {
    shown: all.slice(Math.max(0, at + 1 - before), at + 1 + after),
    last: all[at] ?? null,
  };
}
