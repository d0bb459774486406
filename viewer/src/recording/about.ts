// SPDX-License-Identifier: MIT
// What a recording says about its match: the metadata record "match".
import * as checked from "./checked";

export const readableFormat = 1;

export type Side = 0 | 1; // home, away: places in arrays of both sides
export const sideNames = ["home", "away"] as const;
export const bothSides: readonly Side[] = [0, 1];
export const otherSide = (side: Side): Side => (side === 0 ? 1 : 0);

// Lengths in metres.
export interface FieldSize {
  length: number;
  width: number;
  borderStrip: number;
  goalWidth: number;
  goalDepth: number;
  goalArea: [number, number]; // length, width
  penaltyArea: [number, number];
  penaltyMarkDistance: number;
  centreCircleRadius: number;
}

export interface Role {
  name: string;
  list: string;
  priority: number;
  robots: number[]; // the only ones that may take it; empty: any
  leastInPlay: number; // it is open while at least so many robots are active
  playsBall: boolean | null; // null: not recorded
}

export interface Term {
  name: string;
  weight: number;
}

export interface Context {
  name: string;
  priority: number;
  plugin: string;
  parameters: string;
  list: string;
  utilityKnowledge: string;
  tasksKnowledge: string;
  waypointsKnowledge: string; // world that the positioner is given
  terms: Term[];
  positioner: string;
  assigner: string;
  sender: string;
}

export interface Team {
  name: string;
  file: string;
  robotRadius: number;
  walkSpeed: number | null; // m/s, forward at most; null: not recorded
  roles: Role[];
  contexts: Context[];
}

export interface About {
  program: string;
  command: string;
  seed: string;
  rules: string;
  opening: string;
  field: FieldSize;
  ballRadius: number;
  packetBudget: number;
  halfSeconds: number;
  teams: [Team, Team];
}

// A recording that this page cannot show at all; the message is for the reader of the page.
export class UnreadableRecording extends Error {}

function parsed(pairs: ReadonlyMap<string, string>, key: string): unknown {
  const text = pairs.get(key);
  if (text === undefined) throw new UnreadableRecording(`The recording's description of the match has no "${key}".`);
  try {
    return JSON.parse(text);
  } catch {
    throw new UnreadableRecording(`The recording's description of the match is damaged: "${key}" is not JSON.`);
  }
}

function positive(value: unknown, where: string): number {
  const result = checked.number(value, where);
  if (!(result > 0)) throw new checked.WrongForm(`${where} is not positive`);
  return result;
}

function fieldOf(value: unknown): FieldSize {
  const field = checked.object(value, "field");
  const length = (key: string) => checked.number(field[key], `field.${key}`);
  const area = (key: string) => checked.numbers(field[key], `field.${key}`, 2) as [number, number];
  return {
    length: positive(field.length, "field.length"),
    width: positive(field.width, "field.width"),
    borderStrip: length("border_strip"),
    goalWidth: length("goal_width"),
    goalDepth: length("goal_depth"),
    goalArea: area("goal_area"),
    penaltyArea: area("penalty_area"),
    penaltyMarkDistance: length("penalty_mark_distance"),
    centreCircleRadius: length("centre_circle_radius"),
  };
}

// Recordings of earlier versions name one robot, or 0 for any.
function robotsOf(role: Record<string, unknown>, where: string): number[] {
  if (role.robots !== undefined)
    return checked.list(role.robots, `${where}.robots`, checked.integer);
  const robot = checked.integer(role.robot, `${where}.robot`);
  return robot > 0 ? [robot] : [];
}

function roleOf(value: unknown, where: string): Role {
  const role = checked.object(value, where);
  return {
    name: checked.text(role.name, `${where}.name`),
    list: checked.text(role.list, `${where}.list`),
    priority: checked.integer(role.priority, `${where}.priority`),
    robots: robotsOf(role, where),
    leastInPlay: checked.integer(role.least_in_play ?? 1, `${where}.least_in_play`),
    playsBall: (role.plays_ball ?? null) === null ? null : checked.boolean(role.plays_ball, `${where}.plays_ball`),
  };
}

function termOf(value: unknown, where: string): Term {
  const term = checked.object(value, where);
  return {
    name: checked.text(term.name, `${where}.name`),
    weight: checked.number(term.weight, `${where}.weight`),
  };
}

function contextOf(value: unknown, where: string): Context {
  const context = checked.object(value, where);
  const word = (key: string) => checked.text(context[key] ?? "", `${where}.${key}`);
  return {
    name: checked.text(context.name, `${where}.name`),
    priority: checked.number(context.priority ?? 0, `${where}.priority`),
    plugin: word("plugin"),
    parameters: word("parameters"),
    list: word("list"),
    utilityKnowledge: word("utility_knowledge"),
    tasksKnowledge: word("tasks_knowledge"),
    waypointsKnowledge: word("waypoints_knowledge") || word("tasks_knowledge"),
    terms: checked.list(context.terms ?? [], `${where}.terms`, termOf),
    positioner: word("positioner"),
    assigner: word("assigner"),
    sender: word("sender"),
  };
}

function teamOf(value: unknown, where: string): Team {
  const team = checked.object(value, where);
  return {
    name: checked.text(team.title ?? team.team, `${where}.title`),
    file: checked.text(team.file ?? "", `${where}.file`),
    robotRadius: positive(team.robot_radius, `${where}.robot_radius`),
    walkSpeed: (team.walk_speed ?? null) === null ? null : positive(team.walk_speed, `${where}.walk_speed`),
    roles: checked.list(team.roles, `${where}.roles`, roleOf),
    contexts: checked.list(team.contexts, `${where}.contexts`, contextOf),
  };
}

export function aboutOf(pairs: ReadonlyMap<string, string>): About {
  const format = pairs.get("format") ?? "";
  if (!/^\d+$/.test(format)) throw new UnreadableRecording("The recording does not say which format it has.");
  if (Number(format) > readableFormat) {
    throw new UnreadableRecording(
      `This recording has format ${format}; this page reads format ${readableFormat}. It was written by ` +
        `${pairs.get("program") ?? "a newer program"}: make the page again with that program's "regista view".`,
    );
  }
  try {
    return {
      program: pairs.get("program") ?? "",
      command: pairs.get("command") ?? "",
      seed: pairs.get("seed") ?? "",
      rules: pairs.get("rules") ?? "",
      opening: pairs.get("opening") ?? "",
      field: fieldOf(parsed(pairs, "field")),
      ballRadius: positive(parsed(pairs, "ball_radius"), "ball_radius"),
      packetBudget: checked.number(parsed(pairs, "packet_budget"), "packet_budget"),
      halfSeconds: checked.number(parsed(pairs, "half_seconds"), "half_seconds"),
      teams: [teamOf(parsed(pairs, "home"), "home"), teamOf(parsed(pairs, "away"), "away")],
    };
  } catch (error) {
    if (!(error instanceof checked.WrongForm)) throw error;
    throw new UnreadableRecording(`The recording's description of the match is damaged: ${error.message}.`);
  }
}
