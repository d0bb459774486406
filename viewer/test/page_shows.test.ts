// SPDX-License-Identifier: MIT
// The page in a real browser, headless: what stands on the screen is what the recording holds, as @mcap/core reads it.
// REGISTA names the program; without it only made-up recordings are played.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

import {
  type Json,
  browser,
  checkMatrix,
  folder,
  goTo,
  lastBefore,
  messages,
  open,
  pageOf,
  placeOnField,
  secondsOf,
  settle,
  shownTime,
  synthetic,
  text,
} from "./page_kit";
import type {} from "../src/main";
import { metadata, recording, seconds } from "./synthetic";

const program = process.env.REGISTA ?? "";

test("a match opens, plays, and shows what was recorded", async () => {
  const file = join(folder, "whole.mcap");
  writeFileSync(file, await recording());
  const all = await messages(file);
  const { page, complaints } = await open(pageOf(file, "whole"));
  assert.equal(await page.title(), "blue \u2013 red");
  assert.equal(await text(page, "#home-name"), "blue");
  assert.equal(
    await page.evaluate(
      () =>
        document.documentElement.scrollHeight <= window.innerHeight &&
        document.documentElement.scrollWidth <= window.innerWidth,
    ),
    true,
    "the page does not scroll",
  );

  // Typed times, keys, slider.
  const go = async (time: string) => {
    await page.fill("#time", time);
    await page.press("#time", "Enter");
    await settle(page);
  };
  await go("0:24.9");
  assert.equal(await text(page, "#goals"), "0 : 0");
  await page.keyboard.press("Shift+ArrowRight");
  await settle(page);
  assert.equal(await shownTime(page), "0:25.0");
  assert.equal(await text(page, "#goals"), "1 : 0");
  assert.match(await text(page, "#game"), /^half 1, clock 0:15, playing$/);
  await page.keyboard.press("ArrowLeft");
  await settle(page);
  assert.equal(await shownTime(page), "0:24.0");
  await go("1/0:30");
  assert.equal(await shownTime(page), "0:40.0");
  await go("nonsense");
  assert.equal(await page.locator("#time.wrong").count(), 1);
  await page.press("#time", "Escape");
  await page.locator("#scrub").fill("33.3");
  await settle(page);
  assert.equal(await shownTime(page), "0:33.3");
  const overview = (await page.locator("#overview").boundingBox())!;
  await page.mouse.click(overview.x + 92 + (overview.width - 92 - 14) / 2, overview.y + 25);
  await settle(page);
  assert.ok(Math.abs(secondsOf(await shownTime(page)) - seconds / 2) <= 0.1, "a click in the middle of the match");
  await page.keyboard.press("Home");
  await settle(page);
  assert.equal(await shownTime(page), "0:00.0");

  // Playing, at two speeds.
  const shifts = () =>
    page.evaluate(() => {
      const boxes = ["head", "middle", "stage", "field", "panels", "transport", "timeline", "detail", "play", "scrub"];
      return boxes.map((id) => JSON.stringify(document.getElementById(id)!.getBoundingClientRect())).join();
    });
  const steady = await shifts();
  for (const speed of [1, 16]) {
    await page.keyboard.press("Home");
    await page.selectOption("#speed", String(speed));
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    const began = performance.now();
    await page.keyboard.press("Space");
    assert.equal(await text(page, "#play"), "Pause");
    const goal = speed;
    await page.waitForFunction((least) => window.regista!.viewer.state.view.time >= least, goal);
    await page.keyboard.press("Space");
    const passed = (performance.now() - began) / 1000;
    await settle(page);
    const reached = secondsOf(await shownTime(page));
    assert.ok(reached >= goal && reached <= speed * passed + 0.1, `after ${passed} s at ${speed}x: ${reached}`);
    assert.equal(await shifts(), steady, "nothing moves while the match plays");
  }

  // A robot, by its number and by a click.
  await go("0:20.5");
  await page.keyboard.press("2");
  await settle(page);
  assert.equal(await text(page, "#panel-robot h2"), "blue 2");
  const decision = lastBefore(all.get("/decision/home/2")!, 20.5);
  assert.equal(decision.time, 20);
  await checkMatrix(page, decision);
  assert.match(await text(page, ".mind-head .muted"), /^striker since 0:19\.0; decision of 0:20\.00, 0\.5 s ago$/);
  await page.locator("table.matrix:not(.difference) tbody tr").nth(1).locator("td").nth(2).hover();
  assert.equal(await text(page, ".mind .terms h3"), "robot 2 as defender");
  const terms = await page.locator(".mind .terms tbody tr").allInnerTexts();
  const cell = (row: string) => row.split("\t").map((part) => part.trim());
  assert.deepEqual(cell(terms[0]!).slice(0, 4), [
    "distance",
    "0.70",
    decision.terms[0][1][2].toFixed(3),
    (0.7 * decision.terms[0][1][2]).toFixed(3),
  ]);
  assert.equal(await text(page, "#utility-sum"), decision.utility[1][2].toFixed(3));
  const belief = lastBefore(all.get("/belief/home/2")!, 20.5);
  const ballRow = await page.locator(".mind-left table.list tbody tr").first().innerText();
  assert.deepEqual(cell(ballRow).slice(0, 4), ["ball", "sees it", `${belief.mine.ball.age.toFixed(1)} s`, "0.50 m"]);
  assert.match(
    await text(page, ".contexts li:nth-child(1)"),
    /^search does not hold priority 50: ball_lost after=4\.5$/,
  );
  assert.match(
    await text(page, ".contexts li:nth-child(2)"),
    /^playing holds priority 0: always.*positioner voronoi; assigner greedy/,
  );
  assert.deepEqual(cell(await page.locator(".mind-right > div:last-child tbody tr").nth(1).innerText()), [
    "striker",
    "0.00, 0.50",
    "0.30, 0.90",
    "0.50",
  ]);
  await page.waitForFunction(() => location.hash === "#t=20.5&robot=home/2");
  const away = await placeOnField(page, lastBefore(all.get("/game")!, 20.5).away[1]);
  await page.mouse.click(away.x, away.y);
  await settle(page);
  assert.equal(await text(page, "#panel-robot h2"), "red 2");
  await page.keyboard.press(".");
  await settle(page);
  assert.equal(await shownTime(page), "0:20.5", "no later decision");
  await page.keyboard.press(",");
  await settle(page);
  assert.equal(await shownTime(page), "0:15.0");

  // The truth is drawn where it was.
  await page.keyboard.press("Escape");
  for (const layer of ["trails", "belief"]) await page.click(`#layer-${layer}`);
  await go("0:35");
  const game = lastBefore(all.get("/game")!, 35);
  for (const [side, robots] of [game.home, game.away].entries()) {
    for (const pose of robots) {
      const { x, y, scale } = await placeOnField(page, pose); // looked at beside the number
      const colour = await page.evaluate(
        ({ x, y }) => {
          const field = document.getElementById("field") as HTMLCanvasElement;
          const box = field.getBoundingClientRect();
          const pixel = document.createElement("canvas").getContext("2d")!;
          pixel.drawImage(field, Math.round(box.x - x), Math.round(box.y - y));
          return [...pixel.getImageData(0, 0, 1, 1).data].slice(0, 3);
        },
        { x: x - 0.11 * scale, y },
      );
      const expected = side === 0 ? [0, 114, 178] : [213, 94, 0];
      assert.ok(
        colour.every((part, i) => Math.abs(part - expected[i]!) < 30),
        `${colour} where ${expected} was`,
      );
    }
  }
  assert.deepEqual(complaints, []);
  await page.close();
});

test("overlaps are listed, jumped to and compared", async () => {
  const { page, complaints } = await open(await synthetic("overlaps", await recording()));
  const listed = page.locator("#panel-overlaps .stretches tr");
  const rows = async () =>
    (await listed.allInnerTexts()).map((row) =>
      row
        .split("\t")
        .map((part) => part.trim())
        .slice(0, 4),
    );
  const long = [
    ["0:20.0", "1.0 s", "striker", "2 3"],
    ["0:30.0", "1.0 s", "striker", "2 3"],
  ];
  // Those of a second or more; the short one is folded, and jumps pass it by.
  assert.deepEqual(await rows(), long);
  assert.equal(await text(page, "#list-count"), "3 stretches, 2.5 s");
  assert.equal(await text(page, "#panel-overlaps .group"), "1 s or longer: 2, by time");
  assert.equal(await text(page, "#list-short"), "show 1 shorter than 1 s (0.5 s)");
  for (const expected of ["0:20.0", "0:30.0", "0:30.0"]) {
    await page.keyboard.press("]");
    await settle(page);
    assert.equal(await shownTime(page), expected);
  }
  await page.keyboard.press("Home");
  await page.keyboard.press("o");
  await page.focus("#list-short");
  await page.keyboard.press("Enter");
  assert.equal(await text(page, "#list-short"), "hide 1 shorter than 1 s (0.5 s)");
  assert.equal(await page.getAttribute("#list-short", "aria-expanded"), "true");
  assert.equal(await page.evaluate(() => document.activeElement?.id), "list-short", "the focus stays");
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  assert.deepEqual(await rows(), [...long, ["0:32.0", "0.5 s", "striker", "2 3"]]);
  for (const expected of ["0:20.0", "0:30.0", "0:32.0", "0:32.0"]) {
    await page.keyboard.press("]");
    await settle(page);
    assert.equal(await shownTime(page), expected);
  }
  await page.keyboard.press("[");
  await settle(page);
  assert.equal(await shownTime(page), "0:30.0");
  assert.match(await text(page, "#verdict"), /^2 and 3 both are striker, 0:30\.0 to 0:31\.0, 1\.0 s\./);
  const heads = await page.locator("#compare-assigned tbody tr").allInnerTexts();
  assert.deepEqual(
    heads.map((row) => row.split("\t").map((part) => part.trim())),
    [
      ["1", "goalkeeper", "goalkeeper", "goalkeeper"],
      ["2 \u2260", "striker", "defender", "striker"],
      ["3 \u2260", "defender", "striker", "striker"],
    ],
  );
  // Robot 3 heard that of 20 s, not that of 25; that of 30 s has not yet arrived.
  assert.deepEqual(await page.locator(".packets li").allInnerTexts(), [
    "2 has never heard 3",
    "3 last heard 2: packet of 0:20.00 (period)",
    "3 did not hear 2 at 0:25.00 (period)",
    "under way to 3: packet of 0:30.00 (period)",
  ]);
  assert.match(await text(page, "#verdict"), / 3 missed 1 of 2's packets since 0:20\.0\. /);
  // Robot 3 decided at 0 s: its numbers are not those of the moment.
  assert.match(await text(page, "#verdict"), / 3's matrix is 30\.0 s old: utilities are not compared here\. ?/);
  assert.equal(await text(page, "#compare-utilities"), "Utilities: of 3 less of 2; 3's 30.0 s old");
  assert.equal(await page.locator("table.difference.old").count(), 1);
  await page.keyboard.press("o");
  await page.selectOption("#list-least", "1");
  assert.equal(await listed.count(), 2);
  await page.selectOption("#list-kind", "uncovered");
  await page.selectOption("#list-least", "0.1");
  assert.match((await listed.allInnerTexts()).join("\n"), /0:40\.0\s+1\.0 s\s+goalkeeper\s+none\s+blue/);
  await listed.filter({ hasText: "goalkeeper" }).click();
  await settle(page);
  assert.equal(await shownTime(page), "0:40.0");
  assert.equal(await page.locator("#panel-overlaps .stretches tr[aria-current]").count(), 1);
  assert.deepEqual(complaints, []);
  await page.close();
});

test("an address names a moment and a robot", async () => {
  const address = await synthetic("address", await recording());
  const { page } = await open(`${address}#t=42.5&robot=away/1`);
  await settle(page);
  assert.equal(await shownTime(page), "0:42.5");
  assert.equal(await text(page, "#panel-robot h2"), "red 1");
  await goTo(page, "#t=7&robot=home/3");
  assert.equal(await shownTime(page), "0:07.0");
  assert.equal(await text(page, "#panel-robot h2"), "blue 3");
  // The page writes its address some time after a change: what is pasted just before that counts all the same.
  await page.evaluate(() => {
    location.hash = "#t=9";
    history.replaceState(null, "", "#t=7&robot=home/3");
  });
  await page.waitForFunction(() => location.hash === "#t=9&robot=home/3");
  assert.equal(await shownTime(page), "0:09.0");
  await page.close();
});

test("an address names a comparison", async () => {
  const address = await synthetic("comparison", await recording());
  const { page } = await open(`${address}#t=1e9`);
  await page.waitForFunction((end) => location.hash === `#t=${end}`, seconds);
  assert.equal(await shownTime(page), "1:00.0");
  await goTo(page, "#t=2e9");
  await page.waitForFunction((end) => location.hash === `#t=${end}`, seconds);
  await page.click("#list-short");
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.keyboard.press("[");
  await page.waitForFunction(() => location.hash === "#t=32&robot=home/2&compare=home/2,3/1");
  const said = await text(page, "#verdict");
  await page.close();
  const shared = await open(`${address}#t=32&robot=home/2&compare=home/2,3/1`);
  await settle(shared.page);
  assert.equal(await shared.page.locator("#panel-compare").isVisible(), true);
  assert.equal(await text(shared.page, "#verdict"), said);
  assert.match(said, /^2 and 3 both are striker/);
  // At the beginning both have just decided.
  await goTo(shared.page, "#t=0.5&compare=home/3,2/1");
  assert.match(await text(shared.page, "#verdict"), /Utilities as striker: in 3 own/);
  assert.equal(await shared.page.locator("table.difference.old").count(), 0);
  await shared.page.keyboard.press("o");
  await shared.page.waitForFunction(() => location.hash === "#t=0.5&robot=home/2");
  await shared.page.close();
});

test("numbers of another moment are marked", async () => {
  const { page } = await open(`${await synthetic("ages", await recording())}#t=20.5&robot=home/2`);
  await settle(page);
  assert.equal(await text(page, "table.matrix .corner"), "utility");
  assert.equal(await page.locator(".mind .old").count(), 0);
  await page.keyboard.press("3");
  await settle(page);
  assert.equal(await text(page, "table.matrix .corner"), "20.5 s old");
  assert.equal(await text(page, ".mind .terms h3"), "robot 3 as striker, 20.5 s old");
  assert.equal(await page.locator(".mind table.matrix.old").count(), 1);
  await page.close();
});

test("a team that decides on common knowledge is shown with it", async () => {
  const pairs = metadata();
  const home = JSON.parse(pairs.home!);
  home.contexts[1].utility_knowledge = "common";
  const bytes = await recording({
    metadata: { home: JSON.stringify(home) },
    message: (topic, message) => {
      if (topic.startsWith("/decision/home")) return { ...message, knowledge: "common" };
      if (!topic.startsWith("/belief/home")) return message;
      const mine = message.mine as Json;
      const ball = { at: [0, 0], velocity: [0, 0], covariance: [1, 0, 1], age: 9.5 };
      return { ...message, common: { ...mine, ball } };
    },
  });
  const { page } = await open(`${await synthetic("common", bytes)}#t=20.5&robot=home/2`);
  await settle(page);
  const ball = async () => (await page.locator(".mind-left table.list tbody tr").first().innerText()).split("\t")[2];
  const world = () => page.locator("#knowledge").inputValue();
  const caption = () => text(page, ".mind-left caption");
  assert.deepEqual([await world(), await ball()], ["decided", "9.5 s"]);
  assert.match(await caption(), /^common belief of 0:20\.50/);
  await page.selectOption("#knowledge", "mine");
  await settle(page);
  assert.deepEqual([await world(), await ball()], ["mine", "1.5 s"]);
  assert.match(await caption(), /^belief of 0:20\.50/);
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.keyboard.press("t");
  await settle(page);
  assert.equal(await world(), "decided");
  assert.equal(await page.locator("#knowledge").isDisabled(), true);
  await page.close();
});

test("robots beyond the ninth have keys", async () => {
  const many = (list: unknown, more: unknown) => [...(list as unknown[]), ...Array.from({ length: 9 }, () => more)];
  const bytes = await recording({
    message: (topic, message) => {
      if (topic !== "/game") return message;
      const roles = message.roles as unknown[];
      return { ...message, home: many(message.home, [0, 0, 0]), roles: [many(roles[0], -1), roles[1]] };
    },
  });
  const { page } = await open(await synthetic("twelve", bytes));
  for (const [key, name] of [
    ["0", "blue 10"],
    ["Shift+Digit1", "blue 11"],
    ["Shift+Digit2", "blue 12"],
    ["Shift+Digit3", "blue 12"], // there is none
    ["9", "blue 9"],
  ] as const) {
    await page.keyboard.press(key);
    await settle(page);
    assert.equal(await text(page, "#panel-robot h2"), name);
  }
  await page.close();
});

test("light, dark and help", async () => {
  const { page } = await open(await synthetic("themes", await recording()));
  const theme = () =>
    page.evaluate(() =>
      [document.documentElement.dataset.theme, getComputedStyle(document.body).backgroundColor].join(),
    );
  const light = await theme();
  assert.match(light, /^light/);
  await page.keyboard.press("d");
  assert.match(await theme(), /^dark/);
  assert.notEqual((await theme()).split(",").slice(1).join(), light.split(",").slice(1).join());
  await page.keyboard.press("d");
  await page.emulateMedia({ colorScheme: "dark" });
  assert.match(await theme(), /^light/, "what was chosen stays");
  await page.keyboard.press("?");
  assert.equal(await page.locator("#help").isVisible(), true);
  assert.ok((await page.locator("#keys tr").count()) > 25);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#help").isVisible(), false);
  // Every control has a name that can be read aloud.
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, select, input")]
      .filter(
        (element) =>
          !(
            element.textContent?.trim() ||
            element.getAttribute("aria-label") ||
            element.closest("label")?.textContent?.trim()
          ),
      )
      .map((element) => element.outerHTML),
  );
  assert.deepEqual(nameless, []);
  await page.close();
  const fresh = await browser.newPage();
  await fresh.emulateMedia({ colorScheme: "dark" });
  await fresh.goto(pathToFileURL(join(folder, "themes.html")).href);
  await fresh.waitForFunction(() => document.documentElement.dataset.theme === "dark");
  await fresh.close();
});

test(
  "a match that was played: sums are those of the program, entries those of the file",
  { skip: program === "" && "REGISTA names no program" },
  async (t) => {
    const file = join(folder, "played.mcap");
    const teams = ["paper", "fixed_rate"].map((name) => join("..", "configs", "teams", `${name}.yaml`));
    const result = JSON.parse(
      execFileSync(program, ["match", ...teams, "--limit", "150", "--record", file, "--json", "--quiet"], {
        encoding: "utf8",
      }),
    );
    let address: string;
    if (existsSync(join(dirname(program), "../share/regista/viewer.html"))) {
      execFileSync(program, ["view", file, "-o", join(folder, "played.html")]);
      address = pathToFileURL(join(folder, "played.html")).href;
    } else {
      t.diagnostic("the program has no page: build.mjs makes it");
      address = pageOf(file, "played");
    }
    const all = await messages(file);
    const { page, complaints } = await open(`${address}#t=120&robot=home/3`);
    await page.waitForFunction(() => document.body.dataset.counted === "true");
    await settle(page);
    const { time } = all.get("/game")!.at(-1)!;
    assert.ok(time > 140);
    await checkMatrix(page, lastBefore(all.get("/decision/home/3")!, 120));
    await page.keyboard.press("m");
    for (const [side, name] of ["home", "away"].entries()) {
      const shown = await page.locator(`#sums-${name} tbody tr`).allInnerTexts();
      const expected = Object.entries(result.roles[side] as Record<string, Json>).map(([role, of]) => [
        role,
        of.overlap_seconds.toFixed(1),
        of.uncovered_seconds.toFixed(1),
        String(of.switches),
      ]);
      assert.deepEqual(
        shown.map((row) => row.split("\t").map((part) => part.trim())),
        expected,
      );
    }
    assert.deepEqual(complaints, []);
    await page.close();
  },
);

test("eleven a side fit the page", { skip: program === "" && "REGISTA names no program" }, async () => {
  const file = join(folder, "eleven.mcap");
  const teams = ["paper", "fixed_rate"].map((name) => join("..", "configs", "teams", `${name}.yaml`));
  const rules = ["--set", "rules.team_size=11", "--limit", "75", "--quiet"];
  execFileSync(program, ["match", ...teams, ...rules, "--record", file]);
  const { page, complaints } = await open(`${pageOf(file, "eleven")}#t=70&robot=home/11`);
  const clipped = () =>
    page.evaluate(() => ({
      cells: [...document.querySelectorAll<HTMLElement>("table.matrix td, table.matrix th")]
        .filter((cell) => cell.offsetParent !== null && cell.scrollWidth > cell.clientWidth)
        .map((cell) => cell.textContent),
      scrolls: document.documentElement.scrollHeight > window.innerHeight,
    }));
  for (const key of ["r", "c"]) {
    await page.keyboard.press(key);
    for (const time of ["55", "62", "70"]) {
      await page.fill("#time", time);
      await page.press("#time", "Enter");
      await settle(page);
      assert.ok((await page.locator("table.matrix td:visible").count()) > 0);
      assert.deepEqual(await clipped(), { cells: [], scrolls: false }, `${key} at ${time}`);
    }
  }
  assert.deepEqual(complaints, []);
  await page.close();
});
