// SPDX-License-Identifier: MIT
// Numbers and names as they are read.

// 462.3 -> "7:42.3"
export function timeText(seconds: number, digits = 1): string {
  const scale = 10 ** digits;
  const whole = Math.round(Math.abs(seconds) * scale);
  const minutes = Math.floor(whole / (60 * scale));
  const rest = (whole - minutes * 60 * scale) / scale;
  const padded = rest.toFixed(digits).padStart(digits > 0 ? 3 + digits : 2, "0");
  return `${seconds < 0 && whole > 0 ? "\u2212" : ""}${minutes}:${padded}`;
}

// "pushing_free_kick" -> "pushing free kick"
export const words = (name: string): string => name.replaceAll("_", " ");

export const fixed = (value: number, digits: number): string =>
  value
    .toFixed(digits)
    .replace(/^-(?=0(\.0*)?$)/, "")
    .replace("-", "\u2212");

export const signed = (value: number, digits: number): string => {
  const text = fixed(value, digits);
  return value > 0 && Number(text) !== 0 ? `+${text}` : text;
};

export const secondsText = (seconds: number): string => `${fixed(seconds, 1)} s`;

export const listText = (items: readonly (string | number)[], joiner = "and"): string =>
  items.length < 2 ? items.join("") : `${items.slice(0, -1).join(", ")} ${joiner} ${items[items.length - 1]}`;

// At most so many letters.
export function shortened(text: string, letters: number): string {
  const all = [...text];
  return all.length <= letters ? text : `${all.slice(0, letters - 1).join("")}…`;
}

// What a reader of the page types: "462.3" seconds and "7:42.3" since the match began, "2/3:10" on the clock of a half.
export function parsedTime(text: string): { half: number | null; seconds: number } | null {
  const found = /^\s*(?:(\d)\/)?(?:(\d+):(?=\d\d?(?:\.|\s*$)))?(\d+(?:\.\d*)?)\s*$/.exec(text);
  if (found === null) return null;
  const [, half, minutes, rest] = found;
  if (minutes !== undefined && Number(rest) >= 60) return null;
  return { half: half === undefined ? null : Number(half), seconds: 60 * Number(minutes ?? 0) + Number(rest) };
}
