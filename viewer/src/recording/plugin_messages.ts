// SPDX-License-Identifier: MIT
// What plugins write and draw: lines of the log, and shapes in layers of the field. Both name the robot whose decision
// they were made in, its plugin, and the time of the decision. A match may hold 10^5 drawings: of each only the head is
// taken apart when the recording is opened.
import type { Side } from "./about";
import * as checked from "./checked";
import type { Content } from "./content";
import { parsedJson } from "./log";
import { type Point, point, sideOf } from "./messages";

export const levels = ["debug", "info", "warning", "error"] as const; // from the least to the greatest
export type Level = (typeof levels)[number];

export interface LogLine {
  time: number;
  side: Side;
  robot: number;
  plugin: string;
  level: Level;
  text: string;
}

export interface DrawingHead {
  time: number;
  side: Side;
  robot: number;
  plugin: string;
  layer: string;
}

export const shapeKinds = ["points", "line", "polygon", "text"] as const;

export interface Shape {
  kind: (typeof shapeKinds)[number];
  at: Point[]; // a text: its one place
  text: string;
  colour: string | null; // #rrggbbaa; null: the viewer chooses
  width: number | null; // m: of a line, of dots across; null: the viewer chooses
  filled: boolean; // a polygon
}

function robotOf(value: unknown): number {
  const number = checked.integer(value, "robot");
  if (number < 1) throw new checked.WrongForm(`robot is ${number}, not 1 or more`);
  return number;
}

export function logLineOf(json: unknown): LogLine {
  const m = checked.object(json, "the message");
  return {
    time: checked.number(m.time, "time"),
    side: sideOf(m.side, "side"),
    robot: robotOf(m.robot),
    plugin: checked.text(m.plugin, "plugin"),
    level: checked.oneOf(m.level, "level", levels),
    text: checked.text(m.text, "text"),
  };
}

const mostHeadLetters = 600;

// What stands before the shapes, closed again: within a text of JSON no quotation mark stands without its backslash, so
// this is the key itself. null: the shapes stand elsewhere.
function beforeShapes(content: Content): unknown {
  const start = content.text(mostHeadLetters);
  const end = start.search(/,\s*"shapes"\s*:/);
  if (end < 0) return null;
  try {
    return JSON.parse(`${start.slice(0, end)}}`);
  } catch {
    return null;
  }
}

const headKeys = ["time", "side", "robot", "plugin", "layer"];

export function drawingHeadOf(content: Content): DrawingHead {
  const start = beforeShapes(content);
  const complete = typeof start === "object" && start !== null && headKeys.every((key) => key in start);
  const m = checked.object(complete ? start : parsedJson(content), "the message");
  return {
    time: checked.number(m.time, "time"),
    side: sideOf(m.side, "side"),
    robot: robotOf(m.robot),
    plugin: checked.text(m.plugin, "plugin"),
    layer: checked.text(m.layer, "layer"),
  };
}

function colourOf(value: unknown, where: string): string {
  const colour = checked.text(value, where);
  if (!/^#[0-9a-f]{8}$/i.test(colour)) throw new checked.WrongForm(`${where} is not a colour as #rrggbbaa`);
  return colour;
}

function widthOf(value: unknown, where: string): number {
  const width = checked.number(value, where);
  if (width < 0) throw new checked.WrongForm(`${where} is less than 0`);
  return width;
}

function shapeOf(value: unknown, where: string): Shape {
  const shape = checked.object(value, where);
  const kind = checked.oneOf(shape.shape, `${where}.shape`, shapeKinds);
  const at = checked.list(shape.at, `${where}.at`, point);
  if (kind === "text" && at.length !== 1) throw new checked.WrongForm(`${where}.at is not one point`);
  return {
    kind,
    at,
    text: checked.text(shape.text ?? "", `${where}.text`),
    colour: (shape.colour ?? null) === null ? null : colourOf(shape.colour, `${where}.colour`),
    width: (shape.width ?? 0) === 0 ? null : widthOf(shape.width, `${where}.width`),
    filled: checked.boolean(shape.filled ?? false, `${where}.filled`),
  };
}

export const shapesOf = (json: unknown): Shape[] =>
  checked.list(checked.object(json, "the message").shapes, "shapes", shapeOf);
