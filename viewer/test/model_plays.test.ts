// SPDX-License-Identifier: MIT
// Shots, meant passes, clearances and duels, heat maps, and who goes for the ball: against a recording whose answers are
// counted by hand.
import assert from "node:assert/strict";
import { test } from "node:test";

import { Claims, ballMoment, ballSentences } from "../src/model/at_ball";
import { heatMap, squareMetres } from "../src/model/heat_map";
import { chosenPlays, playCounts, playText, tellsPlays, winner } from "../src/model/plays";
import { readMatch } from "../src/recording/match";
import { ballAt, played, playsAt, recording, withPlays } from "./synthetic";

const match = await readMatch(await recording(withPlays));
const old = await readMatch(await recording());
const claims = new Claims(match.lines);

test("plays are read as they were written, by when they began", () => {
  assert.deepEqual(match.faults, []);
  assert.deepEqual(
    match.plays.map(({ began, kind, outcome }) => [began, kind, outcome]),
    [
      [12, "pass", "arrived"],
      [14, "duel", "lost"],
      [18, "clearance", null],
      [23, "shot", "goal"],
      [28, "pass", "intercepted"],
    ],
  );
  assert.equal(played.length, playsAt(16.2).length + 4);
});

test("of the plays those of a kind and of a side; a duel is of both", () => {
  const begins = (choice: Parameters<typeof chosenPlays>[1]) => chosenPlays(match.plays, choice).map((p) => p.began);
  assert.deepEqual(begins({ kind: null, side: null }), [12, 14, 18, 23, 28]);
  assert.deepEqual(begins({ kind: "pass", side: null }), [12, 28]);
  assert.deepEqual(begins({ kind: "pass", side: 1 }), [28]);
  assert.deepEqual(begins({ kind: "duel", side: 0 }), [14]);
  assert.deepEqual(begins({ kind: "duel", side: 1 }), [14]);
  assert.equal(playCounts(match.plays), "1 shot, 2 passes, 1 clearance, 1 duel");
  assert.equal(playCounts([]), "0 shots, 0 passes, 0 clearances, 0 duels");
});

test("they are said in words", () => {
  assert.deepEqual(
    match.plays.map((play) => playText(match, play)),
    [
      "pass to 3: arrived",
      "duel with 1 of red, 2.2 s: won by red",
      "clearance",
      "shot: goal",
      "pass to 1: intercepted",
    ],
  );
  assert.equal(winner(match.plays[1]!), 1);
  assert.equal(winner({ ...match.plays[1]!, outcome: "won" }), 0);
  assert.equal(winner({ ...match.plays[1]!, outcome: "undecided" }), null);
});

test("recordings of earlier versions open, and say nothing of these", () => {
  assert.deepEqual(old.faults, []);
  assert.deepEqual(old.plays, []);
  assert.equal(tellsPlays(old), false);
  assert.equal(tellsPlays(match), true);
  const moment = ballMoment(old, new Claims(old.lines), 30);
  assert.deepEqual(
    moment.robots[0].map(({ seconds, plays, chases }) => [seconds, plays, chases]),
    [
      [null, null, null],
      [null, null, null],
      [null, null, null],
    ],
  );
  assert.deepEqual(ballSentences(old, moment, 30), ["This recording does not tell who goes for the ball."]);
});

// In play from 10 s to before 50 s: 400 samples. The ball rolls from x = -2 to 2 along y = 0.5, 0.1 m/s.
test("a heat map holds the seconds in each square", () => {
  const { game, about } = old;
  const map = heatMap(game, about.field, { what: "ball" }, game.begin, game.end);
  assert.equal(map.columns, Math.ceil((9 + 1.4) / squareMetres));
  assert.equal(map.rows, Math.ceil((6 + 1.4) / squareMetres));
  assert.ok(Math.abs(map.total - 40) < 1e-9);
  const row = Math.floor((0.5 - map.y0) / squareMetres);
  const at = (x: number) => map.seconds[row * map.columns + Math.floor((x - map.x0) / squareMetres)]!;
  assert.ok(Math.abs(at(0.1) - 2.5) < 0.11, "2.5 s for 0.25 m");
  assert.equal(at(-2.4), 0);
  assert.equal(at(2.4), 0);
  assert.ok(Math.abs(map.full - 2.5) < 0.11);
  // From 20 s on: the sample of 20 s counts, too.
  assert.ok(Math.abs(heatMap(game, about.field, { what: "ball" }, 20, 30).total - 10.1) < 1e-9);
});

test("a heat map of robots leaves out who is penalised", () => {
  const { game, about } = old;
  const robot = (number: number) =>
    heatMap(game, about.field, { what: "robot", side: 0, number }, game.begin, game.end);
  assert.ok(Math.abs(robot(1).total - 40) < 1e-9);
  assert.equal(robot(1).seconds.filter((value) => value > 0).length, 1, "it stands");
  assert.ok(Math.abs(robot(3).total - 39) < 1e-9, "1 s of penalty");
  const team = heatMap(game, about.field, { what: "team", side: 0 }, game.begin, game.end);
  assert.ok(Math.abs(team.total - 119) < 1e-9);
});

test("robots stand in the order in which they could be at the ball", () => {
  const moment = ballMoment(match, claims, 30);
  assert.equal(moment.inPlay, true);
  const [x, y] = ballAt(30);
  assert.deepEqual(
    moment.robots[0].map((robot) => robot.number),
    [2, 3, 1],
  );
  const first = moment.robots[0][0]!;
  const metres = Math.hypot(-2 + 0.05 * 30 - x, 1 - y);
  assert.ok(Math.abs(first.metres - metres) < 1e-6);
  assert.ok(Math.abs(first.seconds! - (metres - 0.15) / 0.25) < 1e-5);
  assert.deepEqual([first.role, first.plays, first.chases], [1, true, true], "striker");
  assert.equal(moment.robots[0][2]!.plays, false);
  assert.deepEqual(
    ballMoment(match, claims, 31.5).robots[0].map((robot) => robot.number),
    [2, 1],
    "3 is penalised",
  );
  assert.equal(moment.restsSince, null);
  const [blue, red] = ballSentences(match, moment, 30);
  assert.equal(blue, "blue: robot 2 (2.2 s away) goes for the ball.");
  assert.match(
    red!,
    /^red: nobody goes for the ball\. Nearest is robot 2 \(striker, .* away\); its role plays the ball\.$/,
  );
});

// From 35 to 38 s the ball lies at its place, and nobody goes.
test("why did nobody go?", () => {
  const moment = ballMoment(match, claims, 37);
  assert.ok(Math.abs(moment.restsSince! - 35) < 1e-9);
  assert.equal(moment.nobodyGoes, true);
  const [what, blue] = ballSentences(match, moment, 37);
  assert.equal(what, "The ball has rested for 2.0 s, and nobody goes for it.");
  assert.equal(
    blue,
    "blue: nobody goes for the ball. Nearest is robot 2 (defender, 2.4 s away), which said at 0:36.0: “leaves the " +
      "ball to 3”; the role that plays the ball is that of robot 3 (striker, 5.8 s away), which said at 0:35.0: " +
      "“takes the ball, 6.2 s before 2”.",
  );
  assert.equal(ballMoment(match, claims, 38.5).restsSince, null);
  assert.deepEqual(ballSentences(match, ballMoment(match, claims, 5), 5), ["The ball is not in play."]);
});

test("the last claim by a moment is that of the robot, and no later one", () => {
  assert.equal(claims.last(0, 3, 34.9), null);
  assert.equal(claims.last(0, 3, 35)?.time, 35);
  assert.equal(claims.last(0, 2, 60)?.text, "claim: leaves the ball to 3");
  assert.equal(claims.last(1, 2, 60), null);
});

test("a message that cannot be read is told of, and the others count", async () => {
  const damaged = await readMatch(
    await recording({
      ...withPlays,
      raw: (topic, i) => (topic === "/play" && i === 1 ? '{"kind":"dive"}' : undefined),
    }),
  );
  assert.equal(damaged.plays.length, 4);
  assert.match(damaged.faults[0]!, /^1 message of \/play cannot be read/);
});
