// SPDX-License-Identifier: MIT
// A recording as full as a real one: seven a side, eleven roles of play and seven of search, many overlaps and events,
// wide numbers, and names as long as wanted. Built upon the made-up match of synthetic.ts.
import { metadata, recording, rolesAt } from "./synthetic";

type Json = Record<string, unknown>;

export interface Names {
  teams: [string, string];
  roles: string[]; // of play, then of search
  terms: [string, string];
  contexts: [string, string];
  plugins: [string, string];
  layers: string[];
  line: string; // of the log, again and again
}

const robots = 7;
const searching = 11; // the first role of search

export const usual: Names = {
  teams: ["paper", "fixed_rate"],
  roles: [
    ..."playing.goalkeeper striker defender_left supporter defender_right jolly libero midfielder wing_left".split(" "),
    ..."wing_right sweeper searching.goalkeeper searcher_centre searcher_front_left searcher_front_right".split(" "),
    ..."searcher_left searcher_right searcher_back_left searcher_back_right".split(" "),
  ],
  terms: ["distance", "persistence"],
  contexts: ["search", "playing"],
  plugins: ["voronoi_cells", "bids"],
  layers: ["cells", "nodes", "targets", "ways"],
  line: "robot 4 is nearer to its node than I am to mine, by 0.37 m",
};

export const long: Names = {
  teams: ["a_team_with_a_name_of_forty_letters_here", "another team whose name has forty letter"],
  roles: usual.roles.map(
    (_, i) => (i % 3 === 0 ? "searcher_front_right" : `defender_of_the_own_half_${"abcd"[i % 4]}`) + `_${i}`,
  ),
  terms: ["distance_to_the_own_goal", "persistence_of_the_last_role"],
  contexts: ["search_for_the_ball_together", "playing_with_everybody"],
  plugins: ["voronoi_cells_of_the_whole_field_by_sweeping_a_line", "auction_of_all_roles_among_those_who_are_awake"],
  layers: Array.from({ length: 14 }, (_, i) => `cells_of_the_robots_that_may_still_take_role_${i}_of_the_table`),
  line: "the_distance_between_the_node_and_the_robot_that_holds_it is longer than that of any other robot. ".repeat(7),
};

const places = Array.from({ length: robots }, (_, i) => [-4.25 + 1.3 * i, i % 2 === 0 ? -2.55 : 1.85, -0.5 * i]);
const numbers = Array.from({ length: robots }, (_, i) => i + 1);

// Most hold a role of their own; 4 and 5 the same one every third second for 0.4 s, and from 40 to 45 s.
function rolesOf(time: number, side: 0 | 1): number[] {
  const held = rolesAt(time)[side];
  const both = time % 3 < 0.4 || (time >= 40 && time < 45);
  return numbers.map((n) => (n <= 3 && side === 0 ? held[n - 1]! : n === 5 && both ? 4 : n - 1));
}

function decision(message: Json, side: 0 | 1): Json {
  const time = message.time as number;
  const columns = numbers.map((n) => n - 1);
  const value = (i: number, j: number, k: number) => Math.round(1e4 * Math.abs(Math.sin(i + 2 * j + k))) / 1e4;
  const term = (k: number) => columns.map((_, i) => columns.map((__, j) => value(i, j, k)));
  const terms = [term(0), term(1)];
  return {
    ...message,
    columns,
    rows: numbers,
    terms,
    utility: columns.map((_, i) =>
      columns.map((__, j) => ((i === 0) !== (j === 0) ? null : 0.7 * terms[0]![i]![j]! + 0.3 * terms[1]![i]![j]!)),
    ),
    tasks: Array.from({ length: searching }, (_, role) => ({
      role,
      before: [-4.11 + 0.7 * role, -2.98 + 0.5 * role, 0],
      after: role < robots ? [-4.35 + 0.75 * role, -2.85 + 0.6 * role, 0] : null,
    })),
    assigned: rolesOf(time, side),
  };
}

function belief(message: Json): Json {
  const mine = message.mine as Json;
  return {
    ...message,
    mine: {
      ...mine,
      teammates: {
        number: numbers,
        pose: places.map(([x, y, heading]) => [x! + 0.3, y! - 0.2, heading]),
        covariance: places.map(() => [0.2, 0, 0.1]),
        age: numbers.map((n) => 17.3 * n),
        role: numbers.map((n) => n + 10),
        active: [1, 2, 3],
      },
      opponents: {
        at: places.slice(0, 5).map(([x, y]) => [-x! + 0.2, y!]),
        covariance: places.slice(0, 5).map(() => [0.1, 0, 0.1]),
        age: [0.7, 1.5, 22.5, 3, 4],
        weight: [0.9, 0.8, 0.7, 0.6, 0.5],
      },
    },
  };
}

// Cells around the robots, each with its name.
function drawing(message: Json, { plugins, layers }: Names, index: number): Json {
  const layer = index % layers.length;
  const cell = ([x, y]: readonly number[]) => [0, 1, 2, 3, 4, 5].map((i) => [x! + hexagon(i, 0), y! + hexagon(i, 1)]);
  const shapes = places.flatMap((place, i) => [
    { shape: "polygon", at: cell(place), filled: i % 3 === layer % 3 },
    { shape: "text", at: [place.slice(0, 2)], text: `${layers[layer]} ${i}` },
  ]);
  return { ...message, plugin: plugins[layer % 2], layer: layers[layer], shapes };
}

const hexagon = (corner: number, axis: 0 | 1) => 0.9 * Math.cos((corner * Math.PI) / 3 - (axis * Math.PI) / 2);

// Something happens with the ball every half second.
function playsAsWell(time: number): { topic: string; message: Json }[] {
  const n = Math.round(2 * time);
  if (Math.abs(n / 2 - time) > 1e-6) return [];
  const play = {
    time,
    began: Math.max(0, time - 1),
    side: n % 3 === 0 ? "home" : "away",
    robot: (n % 7) + 1,
    at: [0, 0],
  };
  const duel = { kind: "duel", outcome: "lost", opponent: 7, duration: 12.3 };
  const kinds = [{ kind: "shot", outcome: "saved" }, { kind: "pass", outcome: "intercepted", receiver: 6 }, duel];
  return [{ topic: "/play", message: { ...play, ...kinds[n % 3] } }];
}

export async function crowded(names: Names): Promise<Uint8Array> {
  const pairs = metadata(names.teams);
  for (const key of ["home", "away"]) {
    const team = JSON.parse(pairs[key]!);
    team.roles = names.roles.map((name, i) => ({
      name,
      list: i < searching ? "playing" : "searching",
      priority: i < searching ? i : i - searching,
      robot: i === 0 || i === searching ? 1 : 0,
    }));
    team.file = `configs/teams/${team.team}.yaml`;
    team.contexts.forEach((context: Json, i: number) => {
      context.name = names.contexts[i];
    });
    team.contexts[1].terms = names.terms.map((name, i) => ({ name, weight: [0.7, 0.3][i] }));
    pairs[key] = JSON.stringify(team);
  }
  pairs.command = `regista match configs/teams/${names.teams[0]}.yaml configs/teams/${names.teams[1]}.yaml --seed 1`;
  return recording({
    teams: names.teams,
    metadata: pairs,
    segments: true,
    plugins: true,
    more: playsAsWell,
    message: (topic, message, index) => {
      const time = message.time as number;
      if (topic === "/game") {
        return {
          ...message,
          home: places,
          away: places.map(([x, y, heading]) => [-x!, y! + 0.5, heading]),
          roles: [rolesOf(time, 0), rolesOf(time, 1)],
          set_play: "pushing_free_kick",
          packets_left: [1200 - 10 * time, 1200],
          chases: [[2, 5], [3]],
        };
      }
      if (topic === "/event" && message.event === "kick_off")
        return { ...message, event: "penalty", offence: "illegal_position_in_set", robot: 5, side: "away" };
      if (topic === "/log") return { ...message, plugin: names.plugins[index % 2], text: names.line };
      if (topic === "/draw") return drawing(message, names, index);
      if (topic.startsWith("/decision")) return decision(message, topic.includes("home") ? 0 : 1);
      if (topic.startsWith("/belief")) return belief(message);
      return message;
    },
  });
}
