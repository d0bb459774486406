// SPDX-License-Identifier: MIT
// Reading and the model, without a browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fragmentOf, readFragment } from "../src/app/fragment";
import { decisionStep, goalStep } from "../src/app/steps";
import { type Pair, compare, compareEntry, greatestDifference, pairAt, pairNow } from "../src/model/compare";
import { Moment } from "../src/model/game";
import { knowledgeOf, lookAt } from "../src/model/look";
import { crowds, inLanes } from "../src/model/lanes";
import { computedBy, pointsName } from "../src/model/positioner";
import { type Stretch, groupedStretches, neighbour } from "../src/model/roles";
import { countSwitches } from "../src/model/switches";
import { parsedTime, signed, timeText } from "../src/model/text";
import { verdict } from "../src/panels/verdict";
import { fromBase64 } from "../src/recording/embedded";
import { lastNotAfter } from "../src/recording/log";
import { readMatch } from "../src/recording/match";
import type { State } from "../src/app/state";
import { ballAt, metadata, penalisedAt, phaseAt, posesAt, recording, rolesAt, seconds, sizes } from "./synthetic";

const whole = await recording();
const match = await readMatch(whole);
const noPause = async () => {};
const samples = Array.from({ length: 10 * seconds + 1 }, (_, i) => i / 10);

test("a recording is read as it was written", () => {
  assert.deepEqual(match.faults, []);
  assert.equal(match.game.count, samples.length);
  assert.deepEqual(
    match.about.teams.map((team) => team.name),
    ["blue", "red"],
  );
  assert.equal(match.packets.unmatched, 0);
  assert.deepEqual(
    match.events.map((event) => event.event),
    ["half_begins", "set", "kick_off", "goal", "finished"],
  );
  const moment = new Moment(match.game);
  for (const time of samples) {
    moment.set(time);
    assert.ok(Math.hypot(moment.ball[0]! - ballAt(time)[0], moment.ball[1]! - ballAt(time)[1]) < 1e-4);
    for (const side of [0, 1] as const) {
      for (let n = 1; n <= sizes[side]; ++n) {
        const at = 3 * match.game.place(side, n);
        const [x, y, heading] = posesAt(time)[side][n - 1]!;
        assert.ok(Math.hypot(moment.poses[at]! - x!, moment.poses[at + 1]! - y!) < 1e-4);
        assert.ok(Math.abs(moment.poses[at + 2]! - heading!) < 1e-5);
        assert.equal(match.game.role(moment.index, side, n), rolesAt(time)[side][n - 1]);
      }
    }
  }
});

test("overlap and uncovered are counted as the definition says", () => {
  for (const side of [0, 1] as const) {
    for (const [role, { list, priority, robots, leastInPlay }] of match.about.teams[side].roles.entries()) {
      let overlap = 0;
      let uncovered = 0;
      for (const time of samples) {
        if (phaseAt(time) !== "playing") continue;
        const active = rolesAt(time)
          [side].map((held, i) => ({ held, n: i + 1 }))
          .filter(({ n }) => !penalisedAt(time)[side].includes(n));
        const holders = active.filter(({ held }) => held === role).length;
        if (holders >= 2) ++overlap;
        const lists = ["playing", "searching"].map(
          (name) => active.filter(({ held }) => match.about.teams[side].roles[held]?.list === name).length,
        );
        const inForce = lists[0] === 0 && lists[1] === 0 ? "" : lists[0]! >= lists[1]! ? "playing" : "searching";
        const may =
          leastInPlay <= active.length && (robots.length === 0 || active.some(({ n }) => robots.includes(n)));
        if (holders === 0 && list === inForce && priority < active.length && may) ++uncovered;
      }
      assert.equal(match.courses[side].sums[role]!.overlap.toFixed(1), (overlap / 10).toFixed(1), `${side} ${role}`);
      assert.equal(
        match.courses[side].sums[role]!.uncovered.toFixed(1),
        (uncovered / 10).toFixed(1),
        `${side} ${role}`,
      );
    }
  }
  // By hand: 1 s, and 2.5 s of which robot 3 was penalised for one, and nothing else.
  assert.equal(match.courses[0].sums[1]!.overlap.toFixed(1), "2.5");
  const listed = match.courses[0].overlaps.map(({ role, robots, from, to, samples: count }) => [
    role,
    robots.join("+"),
    from.toFixed(1),
    to.toFixed(1),
    count,
  ]);
  assert.deepEqual(listed, [
    [1, "2+3", "20.0", "21.0", 10],
    [1, "2+3", "30.0", "31.0", 10],
    [1, "2+3", "32.0", "32.5", 5],
  ]);
  assert.deepEqual(match.courses[1].overlaps, []);
});

test("stretches add up to the sums", () => {
  for (const course of match.courses) {
    for (const [role, sum] of course.sums.entries()) {
      const of = (kind: "overlaps" | "uncovered") =>
        course[kind].filter((stretch) => stretch.role === role).reduce((total, stretch) => total + stretch.samples, 0) /
        10;
      assert.equal(of("overlaps").toFixed(1), sum.overlap.toFixed(1));
      assert.equal(of("uncovered").toFixed(1), sum.uncovered.toFixed(1));
    }
  }
});

test("switches count roles taken in play", async () => {
  const { byRole, unreadable } = await countSwitches(match, noPause);
  assert.equal(unreadable, 0);
  // Robot 2: striker at 20 and 30, defender again at 21 and 32.5; robot 1 its goal at 41. Taken at 0 s: not in play.
  assert.deepEqual(byRole[0], [1, 2, 2, 0]);
  // Robot 2 of away: searcher at 12, striker at 15.
  assert.deepEqual(byRole[1], [0, 1, 0, 1]);
});

test("jumps go to the next and the previous stretch", () => {
  const all = match.courses[0].overlaps;
  assert.equal(neighbour(all, 0, 1), all[0]);
  assert.equal(neighbour(all, all[0]!.from, 1), all[1]);
  assert.equal(neighbour(all, all[1]!.from, -1), all[0]);
  assert.equal(neighbour(all, all[0]!.from, -1), null);
  assert.equal(neighbour(all, 1000, 1), null);
  // Of three that begin together each has its turn, forwards and back.
  const together = [0, 1, 2].map((role) => ({ ...all[0]!, role }));
  assert.equal(neighbour(together, 20, 1, together[0]), together[1]);
  assert.equal(neighbour(together, 20, -1, together[2]), together[1]);
  assert.equal(neighbour(together, 20, 1, together[2]), null);
  assert.equal(neighbour(together, 10, 1, together[2]), together[0], "time has gone elsewhere");
});

test("between two samples things move evenly, but what was put elsewhere jumps", async () => {
  const moment = new Moment(match.game);
  moment.set(10.05);
  assert.ok(Math.abs(moment.ball[0]! - (-3 + 0.1 * 10.05)) < 1e-4);
  const far = await readMatch(
    await recording({
      message: (topic, message) => {
        if (topic !== "/game") return message;
        const time = message.time as number;
        const home = (message.home as number[][]).map((pose) => [...pose]);
        home[1] = time < 19.95 ? [0, 0, 3.1] : [3, 0, -3.1];
        home[2] = time < 19.95 ? [0, 0, 3.1] : [0.1, 0, -3.1];
        return { ...message, home, ball: time < 19.95 ? [0, 0, 0, 0] : [4, 0, 0, 0] };
      },
    }),
  );
  const between = new Moment(far.game).set(19.95);
  assert.equal(between.poses[3], 0, "was put elsewhere");
  assert.ok(Math.abs(between.poses[6]! - 0.05) < 1e-3, "walked");
  // From 3.1 to -3.1 it turns the short way, through pi.
  assert.ok(Math.abs(Math.abs(between.poses[8]!) - Math.PI) < 1e-3);
  assert.equal(between.ball[0], 0);
});

test("who heard which packet", () => {
  const { packets } = match;
  assert.equal(packets.sent[0][1]!.length, 13);
  assert.deepEqual(packets.sent[0][1]!.map((packet) => [...packet.heard.keys()].join("+")).slice(0, 4), [
    "1+3",
    "1",
    "1+3",
    "1",
  ]);
  // At 17 s robot 3 last heard the packet of 10 s and missed that of 15 s; robot 1 missed none.
  const news = packets.news(0, 3, 2, 17);
  assert.deepEqual([news.heard?.time, news.missed.map((packet) => packet.time)], [10, [15]]);
  assert.deepEqual([packets.news(0, 1, 2, 17).heard?.time, packets.news(0, 1, 2, 17).missed.length], [15, 0]);
  // Heard 50 ms after it was sent: not before.
  assert.equal(packets.news(0, 1, 2, 15.01).heard?.time, 10);
  assert.equal(packets.news(0, 2, 1, 17).heard, null);
  // Under way at 20.01 s to both of them: heard later, and so missed by nobody.
  for (const robot of [1, 3]) {
    const { missed, underWay } = packets.news(0, robot, 2, 20.01);
    assert.deepEqual([missed.map((p) => p.time), underWay.map((p) => p.time)], [robot === 1 ? [] : [15], [20]]);
  }
});

test("what is sent as the recording ends is not missed", async () => {
  // The last packet, of 60 s, is heard by robot 3 after the end of the truth; were it not recorded, nobody could tell.
  const read = await readMatch(
    await recording({
      message: (topic, message) => (topic === "/heard" && (message.sent as number) > 54 ? undefined : message),
    }),
  );
  const [before, last] = read.packets.sent[0][1]!.slice(-2);
  assert.deepEqual([before!.time, last!.time], [55, 60]);
  assert.deepEqual([read.packets.lost(before!, 1), read.packets.lost(last!, 1)], [true, false]);
});

test("decisions and beliefs are those of the moment", () => {
  assert.equal(lookAt(match, 0, 2, 20.5).decision?.role, 1);
  assert.equal(lookAt(match, 0, 2, 19.99).decision?.role, 2);
  assert.equal(lookAt(match, 0, 2, 20.6).belief?.time, 20.5);
  assert.equal(lookAt(match, 0, 1, 20).belief?.mine.ball, null);
  const view = {
    time: 20,
    robot: { side: 0, number: 2 },
    side: 0,
    panel: "robot",
    pair: null,
  } as unknown as State["view"];
  assert.equal(decisionStep(match, view, 1), 21);
  assert.equal(decisionStep(match, view, -1), 0);
});

test("two robots are compared", () => {
  const pair = { side: 0, role: 1, robots: pairAt(match, { side: 0, role: 1 }, 20.5) } as const;
  for (const chosen of [null, { side: 0, number: pair.robots![1] }, { side: 1, number: 1 }] as const)
    assert.deepEqual(pairNow(match, 0, chosen, 20.5), pair);
  assert.equal(pairNow(match, 1, null, 20.5), null);
  assert.deepEqual(pair.robots, [2, 3]);
  const given = { ...pair, robots: [2, 3] as [number, number] };
  const found = compare(match, given, 20.5);
  const [a, b] = [lookAt(match, 0, 2, 20.5).decision!, lookAt(match, 0, 3, 20.5).decision!];
  for (const line of found.assigned) {
    assert.deepEqual(line.assigned, [a.assigned[line.robot - 1], b.assigned[line.robot - 1]]);
    assert.equal(line.differs, line.assigned[0] !== line.assigned[1]);
    assert.equal(line.holds, rolesAt(20.5)[0][line.robot - 1]);
  }
  const entry = compareEntry(match, given, found.looks, 2, 1);
  assert.equal(entry.difference, b.utility[1]![1]! - a.utility[1]![1]!);
  const sum = entry.terms.reduce((total, term) => total + term.difference, 0);
  assert.ok(Math.abs(sum - entry.difference!) < 1e-4, "the terms explain the difference");
  let most = 0;
  for (const [i, row] of a.utility.entries()) {
    for (const [j, value] of row.entries()) {
      if (value !== null && b.utility[i]![j] !== null) most = Math.max(most, Math.abs(b.utility[i]![j]! - value));
    }
  }
  assert.equal(Math.abs(greatestDifference(match, given, found.looks)!.entry.difference!), most);
  const ball = found.beliefs.find((line) => line.robot === 0)!;
  assert.equal(ball.apart, 0);
  assert.ok(Math.abs(ball.by[0]!.error - 0.5) < 1e-4, "0.4 and 0.3 m off");
  assert.deepEqual(
    found.beliefs.find((line) => line.robot === 2)!.by.map((of) => of?.error.toFixed(2)),
    ["0.00", "0.30"],
  );
  assert.deepEqual([found.news[1].heard?.time, found.news[1].missed.length], [20, 0]);
});

test("a decision of another moment is known as old", () => {
  const pair = { side: 0, role: 1, robots: [2, 3] as [number, number] } as Pair;
  // Robot 2 decided at 20 s, robot 3 at 0 s.
  const found = compare(match, pair, 20.9);
  assert.deepEqual(
    found.ages.map((age) => age?.toFixed(3)),
    ["0.900", "20.900"],
  );
  assert.deepEqual(found.old, [false, true]);
  const said = (time: number) => verdict(match, pair, compare(match, pair, time), time).join(" ");
  assert.match(said(20.9), / 3's matrix is 20\.9 s old: utilities are not compared here\./);
  assert.doesNotMatch(said(20.9), /Utilities as|differ most/);
  assert.match(said(25), / 2's matrix is 4\.0 s old and 3's matrix is 25\.0 s old: /);
  assert.match(said(0.9), /Utilities as striker: in 2 own .* They differ most for robot /);
  assert.doesNotMatch(said(0.9), / old/);
  assert.deepEqual(compare(match, pair, 1).old, [false, false]);
  assert.deepEqual(compare(match, pair, 1.01).old, [true, true]);
});

test("the world shown is the one decided on, until another is wanted", () => {
  const look = lookAt(match, 0, 2, 20.5);
  const common = { ...look, decision: { ...look.decision!, knowledge: "common" as const } };
  const both = { ...common, belief: { ...look.belief!, common: look.belief!.mine } };
  assert.equal(knowledgeOf(look, "decided"), "mine");
  assert.equal(knowledgeOf(both, "decided"), "common");
  assert.equal(knowledgeOf(both, "mine"), "mine");
  assert.equal(knowledgeOf(common, "common"), "mine", "the recording holds no other");
});

test("stretches of a second or more come first", () => {
  const stretch = (from: number, samples: number): Stretch => ({
    ...match.courses[0].overlaps[0]!,
    ...{ from, samples, to: from + samples / 10 },
  });
  const all = [
    [3, 9],
    [5, 10],
    [1, 40],
    [2, 1],
    [9, 40],
    [4, 9],
  ].map(([from, samples]) => stretch(from!, samples!));
  const froms = (order: "time" | "length") => {
    const { long, short } = groupedStretches(all, order);
    return [long.map(({ from }) => from), short.map(({ from }) => from)];
  };
  assert.deepEqual(froms("time"), [
    [1, 5, 9],
    [2, 3, 4],
  ]);
  assert.deepEqual(froms("length"), [
    [1, 9, 5],
    [3, 4, 2],
  ]);
  assert.deepEqual(
    all.map(({ from }) => from),
    [3, 5, 1, 2, 9, 4],
    "the list itself stays as it is",
  );
});

test("from goal to goal", async () => {
  const goals = [12, 25, 40];
  const read = await readMatch(
    await recording({
      message: (topic, message, index) =>
        topic === "/event" && index > 0
          ? { ...message, event: index < 4 ? "goal" : "finished", time: goals[index - 1] ?? 50 }
          : message,
    }),
  );
  assert.deepEqual(
    [0, 12, 30, 40].map((time) => goalStep(read, time, 1)),
    [12, 25, 40, null],
  );
  assert.deepEqual(
    [60, 40, 25.5, 12].map((time) => goalStep(read, time, -1)),
    [40, 25, 25, null],
  );
  assert.equal(goalStep(match, 26, 1), null, "other events are no goals");
});

test("what a positioner gave is named after it, and edges only where there are some", async () => {
  assert.equal(pointsName("voronoi", false), "Voronoi nodes");
  assert.equal(pointsName("constructor", true), "constructor", "a plugin of any name");
  assert.deepEqual(computedBy(match, 0), { points: ["Nodes, edges"], diagram: true });
  const pairs = metadata();
  const [home, away] = [JSON.parse(pairs.home!), JSON.parse(pairs.away!)];
  home.contexts[0].positioner = "my_positioner";
  home.contexts[1].positioner = "delaunay_formation";
  away.contexts[1].positioner = "";
  const read = await readMatch(
    await recording({
      metadata: { home: JSON.stringify(home), away: JSON.stringify(away) },
      message: (topic, message) => (topic.startsWith("/decision") ? { ...message, edges: [] } : message),
    }),
  );
  assert.deepEqual(computedBy(read, 0), { points: ["my_positioner", "Formation places"], diagram: false });
  assert.deepEqual(computedBy(read, 1), { points: [], diagram: false });
});

test("a match opens at its first kick-off, and where it was never played at its beginning", async () => {
  assert.equal(match.game.kickOff, 10);
  const never = (topic: string, message: Record<string, unknown>) =>
    topic === "/game" ? { ...message, phase: "ready" } : message;
  assert.equal((await readMatch(await recording({ message: never }))).game.kickOff, 0);
});

test("moments, robots and comparisons go through the address", () => {
  const robot = { side: 0, number: 3 } as const;
  const pair = { side: 1, robots: [4, 6], role: 2 } as Pair;
  const read = (fragment: string) => readFragment(fragment, [7, 7], [4, 5]);
  assert.equal(fragmentOf(462.3, robot, null), "#t=462.3&robot=home/3");
  assert.equal(fragmentOf(12.345678, null, null), "#t=12.35");
  assert.equal(fragmentOf(462.3, robot, pair), "#t=462.3&robot=home/3&compare=away/4,6/2");
  assert.deepEqual(read("#t=462.3&robot=home/3"), { time: 462.3, robot, pair: null });
  assert.deepEqual(read(fragmentOf(462.3, robot, pair)), { time: 462.3, robot, pair });
  assert.deepEqual(read("#compare=away/4%2C6/2").pair, pair);
  assert.equal(read("#t=1e9").time, 1e9);
  for (const wrong of [
    "",
    "#",
    "#t=abc",
    "#t=",
    "#robot=home/8",
    "#robot=home/0",
    "#robot=guest/1",
    "#robot=away",
    "#t=NaN&robot=home/1.5",
    "#robot=home/3/1",
    "#compare=home/4,6",
    "#compare=home/4,6/4",
    "#compare=home/4,8/2",
    "#compare=home/4,4/2",
    "#compare=home/4/2",
    "#compare=home/4,6,7/2",
    "#compare=/4,6/2",
  ]) {
    assert.deepEqual(read(wrong), { time: null, robot: null, pair: null }, wrong);
  }
});

test("stretches lie in lanes side by side", () => {
  const stretch = (from: number, to: number) => ({ side: 0, role: 0, robots: [], from, to, samples: 1 }) as Stretch;
  const all = [stretch(0, 4), stretch(1, 3), stretch(2, 6), stretch(3, 5), stretch(4, 7), stretch(9, 10)];
  const { lane, count } = inLanes(all);
  assert.deepEqual([all.map((one) => lane.get(one)), count], [[0, 1, 2, 1, 0, 0], 3]);
  for (const a of all)
    for (const b of all)
      if (a !== b && lane.get(a) === lane.get(b)) assert.ok(a.to <= b.from || b.to <= a.from, "none covers another");
  assert.deepEqual(crowds(all), [
    { from: 0, to: 7, most: 3 },
    { from: 9, to: 10, most: 1 },
  ]);
});

test("times and numbers as text, and back", () => {
  assert.equal(timeText(462.3), "7:42.3");
  assert.equal(timeText(59.96), "1:00.0");
  assert.equal(timeText(0), "0:00.0");
  assert.equal(timeText(605, 0), "10:05");
  assert.equal(signed(-0.001, 2), "0.00");
  assert.equal(signed(0.25, 2), "+0.25");
  assert.deepEqual(parsedTime("7:42.3"), { half: null, seconds: 462.3 });
  assert.deepEqual(parsedTime(" 2/3:10 "), { half: 2, seconds: 190 });
  assert.deepEqual(parsedTime("462.3"), { half: null, seconds: 462.3 });
  for (const wrong of ["", "x", "1:2:3", "7:75", "/3:10"]) assert.equal(parsedTime(wrong), null, wrong);
});

test("base64 as in the page", () => {
  const native = (Uint8Array as { fromBase64?: unknown }).fromBase64;
  delete (Uint8Array as { fromBase64?: unknown }).fromBase64;
  try {
    for (let length = 0; length < 300; ++length) {
      const bytes = Uint8Array.from({ length }, (_, i) => (i * 151 + length) & 255);
      assert.deepEqual(fromBase64(Buffer.from(bytes).toString("base64")), bytes);
    }
    assert.throws(() => fromBase64("ab@d"), /damaged/);
  } finally {
    if (native !== undefined) (Uint8Array as { fromBase64?: unknown }).fromBase64 = native;
  }
});

test("places in ascending times", () => {
  const times = [1, 2, 2, 5];
  assert.deepEqual(
    [0.5, 1, 2, 3, 5, 9].map((time) => lastNotAfter(times, time)),
    [-1, 0, 2, 2, 3, 3],
  );
});
