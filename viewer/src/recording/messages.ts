// SPDX-License-Identifier: MIT
// The messages of a recording. Times are seconds since the start of the match; points and headings are in the world
// frame: metres and radians from the centre, the home team attacking +x in the first half. A role is a row of its
// team's table of roles, -1 none, -2 unknown.
import type { Side } from "./about";
import { words } from "../model/text";
import * as checked from "./checked";

export const phases = ["initial", "ready", "set", "playing", "finished"] as const;
export const setPlays = [
  "none",
  "kick_off",
  "kick_in",
  "goal_kick",
  "corner_kick",
  "pushing_free_kick",
  "penalty_kick",
] as const;
export type Point = [number, number];
export type Pose = [number, number, number];
export type Covariance = [number, number, number]; // xx, xy, yy in m^2

export interface GameMessage {
  time: number;
  half: number;
  clock: number;
  phase: (typeof phases)[number];
  setPlay: (typeof setPlays)[number];
  kicking: Side;
  score: [number, number];
  packetsLeft: [number, number];
  penalised: [number[], number[]];
  fallen: [number[], number[]];
  kicks: [number[], number[]];
  chases: [number[], number[]] | null; // who goes for the ball; null: not recorded
  ball: [number, number, number, number]; // x, y, vx, vy
  robots: [Pose[], Pose[]];
  roles: [number[], number[]];
}

export interface EventMessage {
  time: number;
  event: string;
  side: Side;
  robot: number; // 0 = none
  offence: string; // of a penalty, or empty
  score: [number, number];
}

export const isGoal = (event: EventMessage): boolean => event.event === "goal";

// "goal", "penalty: pushing"
export const eventText = (event: EventMessage): string =>
  words(event.event) + (event.offence === "" ? "" : `: ${words(event.offence)}`);

export interface PacketMessage {
  time: number;
  side: Side;
  robot: number;
  reason: string;
  bytes: number;
}

export interface HeardMessage {
  time: number;
  side: Side;
  robot: number;
  sender: number;
  sent: number; // when it was sent
}

export const segmentEvents = ["offered", "refused", "sent", "dropped", "heard", "undelivered"] as const;

// What became of bytes that a plugin offered for a packet; which fields hold something hangs on the event.
export interface SegmentMessage {
  time: number; // of the decision
  side: Side;
  robot: number; // whose mind it is of
  segment: (typeof segmentEvents)[number];
  why: string; // it is refused, dropped or not delivered
  place: number; // of the plugin in the mind; -1: not known
  plugin: string;
  handle: number; // of the offer; 0: none
  length: number | null;
  bytes: string; // hexadecimal
  text: string;
  urgency: number | null;
  expires: number | null;
  by: number; // the offer that replaced it
  left: boolean; // if sent: the packet left the robot
  sender: number; // of what is heard or not delivered
  sent: number;
  heard: number;
}

export interface Task {
  role: number;
  before: Pose;
  after: Pose | null; // null: not kept
}

export type Matrix = (number | null)[][]; // by row (robot) and column (kept task); null = forbidden

export interface Decision {
  time: number;
  context: number; // place in the team's contexts, -1 none
  knowledge: "mine" | "common";
  waypoints: Pose[]; // x, y, score
  edges: Point[]; // places in waypoints
  tasks: Task[];
  columns: number[]; // roles
  rows: number[]; // robots
  utility: Matrix;
  terms: Matrix[]; // one for each term of the context, not weighted
  assigned: number[]; // by robot (n - 1): role
  role: number; // the own one
  since: number; // match time when the robot took it
}

export interface BallEstimate {
  at: Point;
  velocity: Point;
  covariance: Covariance;
  age: number;
}

export interface TeammateEstimate {
  number: number;
  pose: Pose;
  covariance: Covariance;
  age: number; // s since the last news
  active: boolean;
  role: number;
}

export interface OpponentEstimate {
  at: Point;
  covariance: Covariance;
  age: number;
  weight: number;
}

export interface World {
  ball: BallEstimate | null;
  teammates: TeammateEstimate[];
  opponents: OpponentEstimate[];
}

export interface Belief {
  time: number;
  pose: Pose;
  seesBall: boolean;
  mine: World;
  common: World | null;
}

export const sideOf = (value: unknown, where: string): Side =>
  checked.oneOf(value, where, ["home", "away"]) === "home" ? 0 : 1;
const integers = (value: unknown, where: string): number[] => checked.list(value, where, checked.integer);
const pose = (value: unknown, where: string): Pose => checked.numbers(value, where, 3) as Pose;
const poses = (value: unknown, where: string): Pose[] => checked.list(value, where, pose);
export const point = (value: unknown, where: string): Point => checked.numbers(value, where, 2) as Point;
const covariance = (value: unknown, where: string): Covariance => checked.numbers(value, where, 3) as Covariance;

export function gameOf(json: unknown): GameMessage {
  const m = checked.object(json, "the message");
  return {
    time: checked.number(m.time, "time"),
    half: checked.integer(m.half, "half"),
    clock: checked.number(m.clock, "clock"),
    phase: checked.oneOf(m.phase, "phase", phases),
    setPlay: checked.oneOf(m.set_play, "set_play", setPlays),
    kicking: sideOf(m.kicking, "kicking"),
    score: checked.both(m.score, "score", checked.integer),
    packetsLeft: checked.both(m.packets_left, "packets_left", checked.number),
    penalised: checked.both(m.penalised, "penalised", integers),
    fallen: checked.both(m.fallen, "fallen", integers),
    kicks: checked.both(m.kicks ?? [[], []], "kicks", integers),
    chases: (m.chases ?? null) === null ? null : checked.both(m.chases, "chases", integers),
    ball: checked.numbers(m.ball, "ball", 4) as [number, number, number, number],
    robots: [poses(m.home, "home"), poses(m.away, "away")],
    roles: checked.both(m.roles, "roles", integers),
  };
}

export function eventOf(json: unknown): EventMessage {
  const m = checked.object(json, "the message");
  return {
    time: checked.number(m.time, "time"),
    event: checked.text(m.event, "event"),
    side: sideOf(m.side, "side"),
    robot: checked.integer(m.robot ?? 0, "robot"),
    offence: checked.text(m.offence ?? "", "offence"),
    score: checked.both(m.score, "score", checked.integer),
  };
}

export function packetOf(json: unknown): PacketMessage {
  const m = checked.object(json, "the message");
  return {
    time: checked.number(m.time, "time"),
    side: sideOf(m.side, "side"),
    robot: checked.integer(m.robot, "robot"),
    reason: checked.text(m.reason, "reason"),
    bytes: checked.number(m.bytes, "bytes"),
  };
}

export function heardOf(json: unknown): HeardMessage {
  const m = checked.object(json, "the message");
  return {
    time: checked.number(m.time, "time"),
    side: sideOf(m.side, "side"),
    robot: checked.integer(m.robot, "robot"),
    sender: checked.integer(m.sender, "sender"),
    sent: checked.number(m.sent, "sent"),
  };
}

export function segmentOf(json: unknown): SegmentMessage {
  const m = checked.object(json, "the message");
  const count = (key: string) => checked.integer(m[key] ?? 0, key);
  const word = (key: string) => checked.text(m[key] ?? "", key);
  const seconds = (key: string) => checked.number(m[key] ?? 0, key);
  const known = (key: string) => (m[key] === undefined || m[key] === null ? null : checked.number(m[key], key));
  return {
    time: checked.number(m.time, "time"),
    side: sideOf(m.side, "side"),
    robot: checked.integer(m.robot, "robot"),
    segment: checked.oneOf(m.segment, "segment", segmentEvents),
    why: word("why"),
    place: checked.integer(m.place ?? -1, "place"),
    plugin: word("plugin"),
    handle: count("handle"),
    length: known("length"),
    bytes: word("bytes"),
    text: word("text"),
    urgency: known("urgency"),
    expires: known("expires"),
    by: count("by"),
    left: checked.boolean(m.left ?? true, "left"),
    sender: count("sender"),
    sent: seconds("sent"),
    heard: seconds("heard"),
  };
}

function taskOf(value: unknown, where: string): Task {
  const task = checked.object(value, where);
  return {
    role: checked.integer(task.role, `${where}.role`),
    before: pose(task.before, `${where}.before`),
    after: task.after === null ? null : pose(task.after, `${where}.after`),
  };
}

const entry = (value: unknown, where: string): number | null => (value === null ? null : checked.number(value, where));
const matrixRow = (value: unknown, where: string) => checked.list(value, where, entry);
const matrix = (value: unknown, where: string): Matrix => checked.list(value, where, matrixRow);

export function decisionOf(json: unknown): Decision {
  const m = checked.object(json, "the message");
  const decision: Decision = {
    time: checked.number(m.time, "time"),
    context: checked.integer(m.context, "context"),
    knowledge: checked.oneOf(m.knowledge, "knowledge", ["mine", "common"] as const),
    waypoints: poses(m.waypoints, "waypoints"),
    edges: checked.list(m.edges, "edges", point),
    tasks: checked.list(m.tasks, "tasks", taskOf),
    columns: integers(m.columns, "columns"),
    rows: integers(m.rows, "rows"),
    utility: matrix(m.utility, "utility"),
    terms: checked.list(m.terms, "terms", matrix),
    assigned: integers(m.assigned, "assigned"),
    role: checked.integer(m.role, "role"),
    since: checked.number(m.since, "since"),
  };
  for (const [name, values] of [
    ["utility", decision.utility] as const,
    ...decision.terms.map((t) => ["terms", t] as const),
  ]) {
    const shape = `${decision.rows.length} x ${decision.columns.length}`;
    if (
      values.length !== 0 &&
      (values.length !== decision.rows.length || values.some((row) => row.length !== decision.columns.length))
    ) {
      throw new checked.WrongForm(`${name} does not have ${shape} entries`);
    }
  }
  return decision;
}

function ballOf(value: unknown, where: string): BallEstimate | null {
  if (value === null) return null;
  const ball = checked.object(value, where);
  return {
    at: point(ball.at, `${where}.at`),
    velocity: point(ball.velocity, `${where}.velocity`),
    covariance: covariance(ball.covariance, `${where}.covariance`),
    age: checked.number(ball.age, `${where}.age`),
  };
}

// Robots stand in columns, one entry for each of them.
function column<T>(value: unknown, where: string, item: (value: unknown, where: string) => T, length: number): T[] {
  const values = checked.list(value, where, item);
  if (values.length !== length) throw new checked.WrongForm(`${where} has ${values.length} entries, not ${length}`);
  return values;
}

function teammatesOf(value: unknown, where: string): TeammateEstimate[] {
  const columns = checked.object(value, where);
  const numbers = integers(columns.number, `${where}.number`);
  const places = column(columns.pose, `${where}.pose`, pose, numbers.length);
  const covariances = column(columns.covariance, `${where}.covariance`, covariance, numbers.length);
  const ages = column(columns.age, `${where}.age`, checked.number, numbers.length);
  const roles = column(columns.role, `${where}.role`, checked.integer, numbers.length);
  const active = integers(columns.active, `${where}.active`);
  return numbers.map((number, i) => ({
    number,
    pose: places[i]!,
    covariance: covariances[i]!,
    age: ages[i]!,
    role: roles[i]!,
    active: active.includes(number),
  }));
}

function opponentsOf(value: unknown, where: string): OpponentEstimate[] {
  const columns = checked.object(value, where);
  const places = checked.list(columns.at, `${where}.at`, point);
  const covariances = column(columns.covariance, `${where}.covariance`, covariance, places.length);
  const ages = column(columns.age, `${where}.age`, checked.number, places.length);
  const weights = column(columns.weight, `${where}.weight`, checked.number, places.length);
  return places.map((at, i) => ({ at, covariance: covariances[i]!, age: ages[i]!, weight: weights[i]! }));
}

function worldOf(value: unknown, where: string): World {
  const world = checked.object(value, where);
  return {
    ball: ballOf(world.ball ?? null, `${where}.ball`),
    teammates: teammatesOf(world.teammates, `${where}.teammates`),
    opponents: opponentsOf(world.opponents, `${where}.opponents`),
  };
}

export function beliefOf(json: unknown): Belief {
  const m = checked.object(json, "the message");
  return {
    time: checked.number(m.time, "time"),
    pose: pose(m.pose, "pose"),
    seesBall: checked.boolean(m.sees_ball, "sees_ball"),
    mine: worldOf(m.mine, "mine"),
    common: m.common === undefined || m.common === null ? null : worldOf(m.common, "common"),
  };
}
