// SPDX-License-Identifier: MIT
// Recordings made up for tests: three robots against two for a minute, roles by a script, everything else simple enough
// to be computed again by hand.
import { McapWriter, TempBuffer } from "@mcap/core";
import zstd from "@foxglove/wasm-zstd";

import { packed } from "./packed";

export const sizes = [3, 2] as const;
export const seconds = 60;

type Json = Record<string, unknown>;

export interface Change {
  teams?: [string, string];
  metadata?: Record<string, string>; // added, or in place of what would be written
  without?: string[]; // of the metadata
  message?: (topic: string, message: Json, index: number) => unknown; // what is written instead; undefined: nothing
  raw?: (topic: string, index: number) => string | undefined; // text in place of a message
  chunkBytes?: number;
  more?: (time: number) => { topic: string; message: Json }[]; // written at each moment besides
  segments?: boolean; // plugins talk: see segmentsAt
  plugins?: boolean; // plugins write and draw: see linesAt and drawingsAt
  anew?: Anew; // another program wrote it
}

// How another program writes a recording: the messages in the order that `order` gives, log times later by `later`
// (ns), chunks compressed by `compress`, and who plays at the end.
export interface Anew {
  order?: (messages: readonly Logged[]) => Logged[];
  later?: bigint;
  compression?: string;
  compress?: (chunk: Uint8Array) => Uint8Array;
  metadataLast?: boolean;
  packed?: number; // not another program's, but a page's: so many messages in one record (packed.ts)
}

export interface Logged {
  topic: string;
  channelId: number;
  sequence: number;
  logTime: bigint;
  data: Uint8Array;
}

// Half a minute of play between 10 and 50 s.
export const phaseAt = (time: number) => (time < 5 ? "ready" : time < 10 ? "set" : time < 50 ? "playing" : "finished");

// Roles: 0 goalkeeper (robot 1 alone), 1 striker, 2 defender, 3 searcher (of another list).
export function rolesAt(time: number): [number[], number[]] {
  const between = (from: number, to: number) => time > from - 0.05 && time < to - 0.05;
  const second = between(20, 21) || between(30, 32.5) ? 1 : 2;
  return [
    [between(40, 41) ? -1 : 0, second, 1],
    [0, between(12, 15) ? 3 : 1],
  ];
}

// Robot 3 of home is penalised from 31 to 32 s.
export const penalisedAt = (time: number): [number[], number[]] => [time > 30.95 && time < 31.95 ? [3] : [], []];

export const ballAt = (time: number): [number, number, number, number] => [-3 + 0.1 * time, 0.5, 0.1, 0];

export function posesAt(time: number): [number[][], number[][]] {
  const home = [
    [-4, 0, 0],
    [-2 + 0.05 * time, 1, 0.1],
    [-1, -1 + 0.02 * time, 3.1],
  ];
  return [
    home,
    [
      [4, 0, 3.14],
      [2, 0.03 * time, -3.1],
    ],
  ];
}

// Robot 2 of home offers a bid 0.4 s before each of its packets, which takes it along: robot 1 hears all of them, robot
// 3 each second one, but that of 20 s reaches no plugin of it. Robot 3 offers twice and sends nothing; robot 1 offers
// too much at 15 s, and something at 59 s that stays pending.
export function segmentsAt(time: number): Json[] {
  const at = (when: number) => Math.abs(time - when) < 1e-6;
  const base = { time, side: "home", place: 7, plugin: "bids" };
  const offer = { length: 2, bytes: "0a1f", urgency: 0.5, expires: time + 3 };
  const out: Json[] = [];
  const round = Math.round((time + 0.4) / 5);
  if (round > 0 && at(5 * round - 0.4))
    out.push({
      ...{ ...base, ...offer, robot: 2, segment: "offered", handle: round },
      text: `bid ${round} for “striker”`,
    });
  const sent = Math.round(time / 5);
  if (sent > 0 && at(5 * sent)) out.push({ ...base, robot: 2, segment: "sent", handle: sent, at: 0, left: true });
  const heard = Math.round((time - 0.1) / 5);
  if (heard > 0 && at(5 * heard + 0.1)) {
    const came = { sender: 2, sent: 5 * heard, heard: 5 * heard + 0.05 };
    const hearing = { ...base, ...came, segment: "heard", handle: heard, at: 0 };
    out.push({ ...hearing, robot: 1 });
    if (heard === 4) out.push({ ...hearing, robot: 3, segment: "undelivered", why: "no_mailbox" });
    else if (heard % 2 === 0) out.push({ ...hearing, robot: 3 });
  }
  if (at(12)) out.push({ ...base, ...offer, robot: 3, segment: "offered", handle: 1 });
  if (at(12.5)) out.push({ ...base, robot: 3, segment: "dropped", handle: 1, why: "replaced", by: 2 });
  if (at(12.5)) out.push({ ...base, ...offer, robot: 3, segment: "offered", handle: 2, bytes: "ff00" });
  if (at(15.5)) out.push({ ...base, robot: 3, segment: "dropped", handle: 2, why: "expired" });
  if (at(15)) out.push({ ...base, ...offer, robot: 1, segment: "refused", why: "too_long", length: 300, bytes: "" });
  if (at(59)) out.push({ ...base, ...offer, robot: 1, segment: "offered", handle: 1 });
  return out;
}

const whole = (value: number) => Math.abs(value - Math.round(value)) < 1e-6;

// Robot 2 of home writes each second where it stands, its bids twice as often and more softly; robot 3 warns at 12.5 s,
// and robot 1 of away fails at 20 s and warns at 20.1 s.
export function linesAt(time: number): Json[] {
  const home = { time, side: "home" };
  const out: Json[] = [];
  if (whole(time)) out.push({ ...home, robot: 2, plugin: "voronoi", level: "info", text: `cell ${Math.round(time)}` });
  if (whole(2 * time)) out.push({ ...home, robot: 2, plugin: "bids", level: "debug", text: "nobody bids" });
  const away = { time, side: "away", robot: 1, plugin: "voronoi" };
  const at = (when: number) => Math.abs(time - when) < 1e-6;
  if (at(12.5)) out.push({ ...home, robot: 3, plugin: "bids", level: "warning", text: "the bid of 2 came late" });
  if (at(20)) out.push({ ...away, level: "error", text: "less than three nodes" });
  if (at(20.1)) out.push({ ...away, level: "warning", text: "the cells of 20 s are drawn again" });
  return out;
}

// Robot 2 of home draws a cell each second second, 0.1 m farther on, and nothing from 40 s on; robot 3 another one at
// 10 s, which stays. Robot 1 of away draws dots of its own colour from 15 s on.
export const cellAt = (time: number): [number, number] => [-3 + 0.05 * 2 * Math.floor(time / 2 + 1e-6), 2];
export function drawingsAt(time: number): Json[] {
  const cells = { time, side: "home", plugin: "voronoi", layer: "cells" };
  const square = (x: number, y: number) => [
    [x - 0.5, y - 0.5],
    [x + 0.5, y - 0.5],
    [x + 0.5, y + 0.5],
    [x - 0.5, y + 0.5],
  ];
  const out: Json[] = [];
  if (whole(time / 2) && time < 39) {
    const [x, y] = cellAt(time);
    const shapes = [
      { shape: "polygon", at: square(x, y), colour: "#ff00ffff", width: 0.05, filled: true },
      { shape: "polygon", at: square(x, y) },
      { shape: "text", at: [[x, y]], text: `cell of ${Math.round(time)} s` },
    ];
    out.push({ ...cells, robot: 2, shapes });
  }
  const at = (when: number) => Math.abs(time - when) < 1e-6;
  if (at(40)) out.push({ ...cells, robot: 2, shapes: [] });
  if (at(10)) out.push({ ...cells, robot: 3, shapes: [{ shape: "line", at: square(3, -2), width: 0.2 }] });
  const dots = { shape: "points", at: [[3, 2]], colour: "#00ffffff", width: 0.4 };
  if (at(15)) out.push({ time, side: "away", robot: 1, plugin: "bids", layer: "targets", shapes: [dots] });
  return out;
}

const tables = ["striker", "defender"];

// What happened with the ball in recordings made `withPlays`.
export const played: Json[] = [
  { time: 13, kind: "pass", side: "home", robot: 2, began: 12, at: [-1.8, 0.5], outcome: "arrived", receiver: 3 },
  {
    ...{ time: 16.2, kind: "duel", side: "home", robot: 3, began: 14, at: [-1.6, 0.5] },
    ...{ outcome: "lost", opponent: 1, duration: 2.2 },
  },
  { time: 18.6, kind: "clearance", side: "home", robot: 1, began: 18, at: [-2, 0.5] },
  { time: 25, kind: "shot", side: "home", robot: 3, began: 23, at: [-0.7, 0.5], outcome: "goal" },
  { time: 29, kind: "pass", side: "away", robot: 2, began: 28, at: [-0.2, 0.5], outcome: "intercepted", receiver: 1 },
];
export const playsAt = (time: number): Json[] => played.filter((play) => Math.abs((play.time as number) - time) < 1e-6);

// Robot 2 of home goes for the ball, but from 35 to 38 s, when it lies still: then it leaves it to robot 3, the striker,
// which says that it takes it, and does not go.
const rests = (time: number) => time > 34.95 && time < 38.05;
function claimsAt(time: number): Json[] {
  const line = { time, side: "home", plugin: "play_ball", level: "debug" };
  const at = (when: number) => Math.abs(time - when) < 1e-6;
  if (at(35)) return [{ ...line, robot: 3, text: "claim: takes the ball, 6.2 s before 2" }];
  if (at(36)) return [{ ...line, robot: 2, text: "claim: leaves the ball to 3" }];
  return [];
}
const knowing = (team: string): string => {
  const out = JSON.parse(team) as Json & { roles: Json[] };
  const roles = out.roles.map((role) => ({ ...role, plays_ball: role.name === "striker" }));
  return JSON.stringify({ ...out, walk_speed: 0.25, roles });
};
export const withPlays: Change = {
  metadata: { home: knowing(metadata().home!), away: knowing(metadata().away!) },
  message: (topic, message) => {
    if (topic !== "/game") return message;
    const time = message.time as number;
    const ball = rests(time) ? [...ballAt(34).slice(0, 2), 0, 0] : message.ball;
    return { ...message, ball, chases: [rests(time) || phaseAt(time) !== "playing" ? [] : [2], []] };
  },
  more: (time) => [
    ...playsAt(time).map((message) => ({ topic: "/play", message })),
    ...claimsAt(time).map((message) => ({ topic: "/log", message })),
  ],
};

// Robots 2 and 3 of home each believe that the other takes the role that they do not.
function assignedBy(side: 0 | 1, robot: number, time: number): number[] {
  const own = rolesAt(time)[side];
  if (side === 1 || robot === 1) return own;
  const other = own[robot - 1] === 1 ? 2 : 1;
  return robot === 2 ? [0, own[1]!, other] : [0, other, own[2]!];
}

function decision(side: 0 | 1, robot: number, time: number): Json {
  const size = sizes[side];
  const rows = Array.from({ length: size }, (_, i) => i + 1);
  const columns = [0, 1, 2].slice(0, size);
  const term = (k: number) =>
    rows.map((i) => columns.map((j) => Math.round(1e4 * Math.abs(Math.sin(i + 2 * j + k + 0.1 * robot))) / 1e4));
  const terms = [term(0), term(1)];
  const forbidden = (i: number, j: number) => (j === 0) !== (i === 0);
  const utility = rows.map((_, i) =>
    columns.map((__, j) =>
      forbidden(i, j) ? null : Math.round(1e5 * (0.7 * terms[0]![i]![j]! + 0.3 * terms[1]![i]![j]!)) / 1e5,
    ),
  );
  const own = rolesAt(time)[side];
  return {
    time,
    context: 1,
    knowledge: "mine",
    waypoints: [
      [0, 0, 0.5],
      [1, 1, 0.9],
      [2, -1, 0.1],
    ],
    edges: [
      [0, 1],
      [1, 2],
    ],
    tasks: [
      { role: 0, before: [-4, 0, 0], after: [-4, 0, 0] },
      { role: 1, before: [0, 0.5, 0], after: [0.3, 0.9, 0] },
      { role: 2, before: [-2, -1, 0], after: size > 2 ? [-2, -0.5, 0] : null },
    ],
    columns,
    rows,
    utility,
    terms,
    assigned: assignedBy(side, robot, time),
    role: own[robot - 1],
    since: Math.max(0, time - 1),
  };
}

function belief(side: 0 | 1, robot: number, time: number): Json {
  const poses = posesAt(time)[side];
  const [x, y] = ballAt(time);
  const rest = poses.map((pose, i) => [pose[0]! + (i + 1 === robot ? 0 : 0.3), pose[1]!, pose[2]!]);
  return {
    time,
    pose: poses[robot - 1],
    sees_ball: robot === 2,
    mine: {
      ball: robot === 1 ? null : { at: [x + 0.4, y - 0.3], velocity: [0, 0], covariance: [0.04, 0.01, 0.02], age: 1.5 },
      teammates: {
        number: poses.map((_, i) => i + 1),
        pose: rest,
        covariance: poses.map(() => [0.02, 0, 0.01]),
        age: poses.map((_, i) => (i + 1 === robot ? 0 : 2.5)),
        role: rolesAt(time)[side],
        active: poses.map((_, i) => i + 1),
      },
      opponents: { at: [[2, 0]], covariance: [[0.1, 0, 0.1]], age: [0.7], weight: [0.9] },
    },
  };
}

export function metadata(teams: [string, string] = ["blue", "red"]): Record<string, string> {
  // Home's goalkeeper has a second choice, and is left out by one robot alone. Away is as earlier versions wrote it: one
  // robot, and no title.
  const team = (name: string, side: 0 | 1) => {
    const role = (name: string, list: string, priority: number, robots: number[] = []) =>
      side === 0
        ? { name, list, priority, robots, least_in_play: robots.length > 0 ? 2 : 1 }
        : { name, list, priority, robot: robots[0] ?? 0 };
    return JSON.stringify({
      team: side === 0 ? "a_word" : name,
      ...(side === 0 ? { title: name } : {}),
      file: `configs/${name}.yaml`,
      robot_radius: 0.15,
      roles: [
        role("goalkeeper", "playing", 0, [1, 2]),
        ...tables.map((t, i) => role(t, "playing", i + 1)),
        role("searcher", "searching", 0),
      ],
      contexts: [
        {
          name: "search",
          priority: 50,
          plugin: "ball_lost",
          parameters: "after=4.5",
          list: "searching",
          utility_knowledge: "mine",
          tasks_knowledge: "mine",
          terms: [],
          positioner: "",
          assigner: "greedy",
          sender: "event_based",
        },
        {
          name: "playing",
          priority: 0,
          plugin: "always",
          parameters: "",
          list: "playing",
          utility_knowledge: "mine",
          tasks_knowledge: "mine",
          terms: [
            { name: "distance", weight: 0.7 },
            { name: "bearing", weight: 0.3 },
          ],
          positioner: "voronoi",
          assigner: "greedy",
          sender: "event_based",
        },
      ],
    });
  };
  return {
    format: "1",
    program: "regista test",
    command: "regista match blue.yaml red.yaml --seed 7",
    seed: "7",
    rules: "spl2023",
    opening: "",
    field: JSON.stringify({
      length: 9,
      width: 6,
      border_strip: 0.7,
      goal_width: 1.5,
      goal_depth: 0.5,
      goal_area: [0.6, 2.2],
      penalty_area: [1.65, 4],
      penalty_mark_distance: 1.3,
      centre_circle_radius: 0.75,
    }),
    ball_radius: "0.05",
    packet_budget: "100",
    half_seconds: "600",
    home: team(teams[0], 0),
    away: team(teams[1], 1),
  };
}

export async function recording(change: Change = {}): Promise<Uint8Array> {
  await zstd.isLoaded;
  const anew = change.anew ?? {};
  const buffer = new TempBuffer();
  const writer = new McapWriter({
    writable: buffer,
    chunkSize: change.chunkBytes ?? 20_000,
    compressChunk: (data) => ({
      compression: anew.compression ?? "zstd",
      compressedData: anew.compress?.(data) ?? new Uint8Array(zstd.compress(data, 1)),
    }),
  });
  await writer.start({ profile: "", library: "regista test" });
  const pairs = { ...metadata(change.teams), ...change.metadata };
  for (const key of change.without ?? []) delete pairs[key];
  const describe = async () => {
    if (Object.keys(pairs).length > 0)
      await writer.addMetadata({ name: "match", metadata: new Map(Object.entries(pairs)) });
  };
  if (anew.metadataLast !== true) await describe();
  const messages: Logged[] = [];
  const channels = new Map<string, { id: number; count: number }>();
  const put = async (topic: string, message: Json) => {
    let channel = channels.get(topic);
    if (channel === undefined) {
      const id = await writer.registerChannel({ schemaId: 0, topic, messageEncoding: "json", metadata: new Map() });
      channel = { id, count: 0 };
      channels.set(topic, channel);
    }
    const index = channel.count++;
    const logTime = BigInt(Math.round((message.time as number) * 1e9)) + (anew.later ?? 0n);
    const changed = change.message === undefined ? message : change.message(topic, message, index);
    if (changed === undefined) return;
    const data = new TextEncoder().encode(change.raw?.(topic, index) ?? JSON.stringify(changed));
    messages.push({ topic, channelId: channel.id, sequence: index, logTime, data });
  };
  const names = ["home", "away"] as const;
  for (let i = 0; i <= 10 * seconds; ++i) {
    const time = i / 10;
    const phase = phaseAt(time);
    const [home, away] = posesAt(time);
    if (i === 0 || i === 50 || i === 100 || i === 250 || i === 500) {
      const event = { 0: "half_begins", 50: "set", 100: "kick_off", 250: "goal", 500: "finished" }[i];
      await put("/event", { time, event, side: "home", robot: i === 250 ? 3 : 0, score: [i >= 250 ? 1 : 0, 0] });
    }
    for (const side of [0, 1] as const) {
      for (let n = 1; n <= sizes[side]; ++n) {
        const before = i === 0 ? null : rolesAt(time - 0.1)[side][n - 1];
        const changes = rolesAt(time)[side][n - 1] !== before;
        if (changes) await put(`/decision/${names[side]}/${n}`, decision(side, n, time));
        if (changes || i % 5 === 0) await put(`/belief/${names[side]}/${n}`, belief(side, n, time));
      }
    }
    // Robot 2 of home sends every 5 s, robot 3 hears each second packet and robot 1 all.
    if (i % 50 === 0) {
      await put("/packet", { time, side: "home", robot: 2, reason: "period", bytes: 44 });
      await put("/heard", { time: time + 0.05, side: "home", robot: 1, sender: 2, sent: time });
      if (i % 100 === 0) await put("/heard", { time: time + 0.05, side: "home", robot: 3, sender: 2, sent: time });
    }
    if (change.segments === true) for (const segment of segmentsAt(time)) await put("/segment", segment);
    if (change.plugins === true) {
      for (const line of linesAt(time)) await put("/log", line);
      for (const drawing of drawingsAt(time)) await put("/draw", drawing);
    }
    for (const { topic, message } of change.more?.(time) ?? []) await put(topic, message);
    await put("/game", {
      time,
      half: 1,
      clock: Math.max(0, time - 10),
      phase,
      set_play: time < 10 ? "kick_off" : "none",
      kicking: "home",
      score: [time >= 25 ? 1 : 0, 0],
      packets_left: [100 - Math.floor(i / 50), 100],
      penalised: penalisedAt(time),
      fallen: [[], []],
      kicks: [[], []],
      ball: ballAt(time),
      home,
      away,
      roles: rolesAt(time),
    });
  }
  for (const message of anew.order?.(messages) ?? messages)
    await writer.addMessage({ ...message, publishTime: message.logTime });
  if (anew.metadataLast === true) await describe();
  await writer.end();
  return anew.packed === undefined ? buffer.get() : packed(pairs, messages, anew.packed);
}
