// SPDX-License-Identifier: MIT
// JSON that somebody else wrote, taken apart with a check at every step: what is wrong is said with its place.

export class WrongForm extends Error {}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

function shown(value: unknown): string {
  const text = JSON.stringify(value) ?? "missing";
  return text.length > 40 ? `${text.slice(0, 40)}…` : text;
}

export function object(value: unknown, where: string): Record<string, unknown> {
  if (!isObject(value)) throw new WrongForm(`${where} is not an object but ${shown(value)}`);
  return value;
}

export function number(value: unknown, where: string): number {
  if (typeof value !== "number" || !Number.isFinite(value)) {
    throw new WrongForm(`${where} is not a number but ${shown(value)}`);
  }
  return value;
}

export function integer(value: unknown, where: string): number {
  if (!Number.isInteger(value)) throw new WrongForm(`${where} is not a whole number but ${shown(value)}`);
  return value as number;
}

export function text(value: unknown, where: string): string {
  if (typeof value !== "string") throw new WrongForm(`${where} is not a text but ${shown(value)}`);
  return value;
}

export function boolean(value: unknown, where: string): boolean {
  if (typeof value !== "boolean") throw new WrongForm(`${where} is neither true nor false but ${shown(value)}`);
  return value;
}

export function array(value: unknown, where: string): unknown[] {
  if (!Array.isArray(value)) throw new WrongForm(`${where} is not a list but ${shown(value)}`);
  return value;
}

export function list<T>(value: unknown, where: string, item: (value: unknown, where: string) => T): T[] {
  const values = array(value, where);
  for (let i = 0; i < values.length; ++i) values[i] = item(values[i], `${where}[${i}]`);
  return values as T[];
}

// Exactly `count` finite numbers.
export function numbers(value: unknown, where: string, count: number): number[] {
  const values = array(value, where);
  if (values.length !== count) throw new WrongForm(`${where} has ${values.length} numbers, not ${count}`);
  for (let i = 0; i < count; ++i) {
    if (typeof values[i] !== "number" || !Number.isFinite(values[i])) number(values[i], `${where}[${i}]`);
  }
  return values as number[];
}

// One value for each side, [home, away].
export function both<T>(value: unknown, where: string, item: (value: unknown, where: string) => T): [T, T] {
  const values = array(value, where);
  if (values.length !== 2) throw new WrongForm(`${where} is not one value for each side`);
  return [item(values[0], `${where}[0]`), item(values[1], `${where}[1]`)];
}

export function oneOf<T extends string>(value: unknown, where: string, names: readonly T[]): T {
  if (!names.includes(value as T)) throw new WrongForm(`${where} is ${shown(value)}, not one of ${names.join(", ")}`);
  return value as T;
}
