// SPDX-License-Identifier: MIT
// What plugins write and draw, in a real browser: layers are switched on and drawn for the robots that are looked at,
// the log follows time and the chosen robot, and nothing that a plugin says is more than text. SCREENSHOT names a PNG
// file to look at.
import assert from "node:assert/strict";
import { test } from "node:test";

import type { Page } from "playwright-core";

import { colourAt, open, settle, shownTime, synthetic, text } from "./page_kit";
import { recording } from "./synthetic";

const magenta = [255, 0, 255];
const cyan = [0, 255, 255];
const inCell = [-1.3, 2.3] as const; // of robot 2 of home from 26 to 40 s, off its middle
const inDots = [3, 2] as const; // of robot 1 of away from 15 s on
const onLine = [3, -2.5] as const; // of robot 3 of home from 10 s on

test("layers are switched on one by one, and drawn for the robots that are looked at", async () => {
  const { page, complaints } = await open(`${await synthetic("drawings", await recording({ plugins: true }))}#t=30.2`);
  const open_ = page.locator("#drawings-open");
  assert.equal(await open_.innerText(), "Drawings 0/2");
  const grass = await colourAt(page, ...inCell);
  assert.notDeepEqual(grass, magenta);
  await open_.click();
  assert.deepEqual(await page.locator("#drawings button").allInnerTexts(), ["bids: targets", "voronoi: cells"]);
  const [targets, cells] = [page.locator("#drawings button").nth(0), page.locator("#drawings button").nth(1)];
  await cells.click();
  await settle(page);
  assert.equal(await open_.innerText(), "Drawings 1/2");
  assert.equal(await cells.getAttribute("aria-pressed"), "true");
  // None is chosen: what all robots drew.
  assert.deepEqual(await colourAt(page, ...inCell), magenta);
  assert.notDeepEqual(await colourAt(page, ...inDots), cyan);
  const line = await colourAt(page, ...onLine);
  assert.notDeepEqual(line, grass);
  await targets.click();
  await settle(page);
  assert.deepEqual(await colourAt(page, ...inDots), cyan);
  if (process.env.SCREENSHOT) await page.screenshot({ path: process.env.SCREENSHOT });

  // Escape closes the list and leaves the choice of the robot alone; so does a click beside the list.
  await page.locator("#drawings button").first().focus();
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#drawings").isVisible(), false);
  await open_.click();
  await page.click("#game");
  assert.equal(await page.locator("#drawings").isVisible(), false);
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());

  // The chosen robot's, both compared, and all again.
  const shown = async () => [
    String(await colourAt(page, ...inCell)) === String(magenta),
    String(await colourAt(page, ...onLine)) === String(line),
    String(await colourAt(page, ...inDots)) === String(cyan),
  ];
  await page.keyboard.press("2");
  await settle(page);
  assert.deepEqual(await shown(), [true, false, false]);
  await page.keyboard.press("3");
  await settle(page);
  assert.deepEqual(await shown(), [false, true, false]);
  await page.keyboard.press("c");
  await settle(page);
  assert.deepEqual(await shown(), [true, true, false]);
  await page.keyboard.press("Escape");
  await page.keyboard.press("o");
  await settle(page);
  assert.deepEqual(await shown(), [true, true, true]);

  // At every size of the window and in both themes.
  await page.setViewportSize({ width: 1920, height: 1080 });
  await page.keyboard.press("d");
  await settle(page);
  assert.deepEqual([await colourAt(page, ...inCell), await colourAt(page, ...inDots)], [magenta, cyan]);
  await page.setViewportSize({ width: 1280, height: 720 });

  // Once taken away it is gone; the key takes all away and brings all back.
  await page.fill("#time", "40.3");
  await page.press("#time", "Enter");
  await settle(page);
  assert.deepEqual((await shown()).slice(2), [true]);
  assert.notDeepEqual(await colourAt(page, ...inCell), magenta);
  await page.keyboard.press("w");
  await settle(page);
  assert.equal(await open_.innerText(), "Drawings 0/2");
  assert.notDeepEqual(await colourAt(page, ...inDots), cyan);
  await page.keyboard.press("w");
  await settle(page);
  assert.deepEqual([await open_.innerText(), await colourAt(page, ...inDots)], ["Drawings 2/2", cyan]);
  assert.match(await text(page, "#keys"), /wdrawings of plugins, if there are any: all or none/);
  assert.deepEqual(complaints, []);
  await page.close();
});

const rows = (page: Page) => page.locator("#log tbody tr[data-time]");
const cellsOf = async (page: Page, selector: string) =>
  (await page.locator(`${selector} td`).allInnerTexts()).map((each) => each.trim());

test("the log stands around the moment, of the chosen robot or of all, from a level on", async () => {
  const { page, complaints } = await open(`${await synthetic("log", await recording({ plugins: true }))}#t=12.7`);
  assert.equal(await page.locator("#tab-log").isVisible(), true);
  await page.keyboard.press("k");
  await settle(page);
  assert.equal(await page.locator("#panel-log").isVisible(), true);
  assert.equal(await text(page, "#log-count"), "185 lines: 1 error, 2 warnings; of all robots");
  const current = "#log tr[aria-current]";
  assert.deepEqual(await cellsOf(page, current), ["0:12.5", "3", "bids", "warning", "the bid of 2 came late"]);
  assert.equal(await page.locator(`${current} .level.warning`).innerText(), "warning");
  // What has not happened yet is grey.
  assert.equal(await rows(page).last().getAttribute("class"), "muted");
  assert.equal(await rows(page).first().getAttribute("class"), "");

  // It follows time.
  await page.keyboard.press("ArrowRight");
  await settle(page);
  assert.deepEqual(await cellsOf(page, current), ["0:13.5", "2", "bids", "debug", "nobody bids"]);
  await page.keyboard.press("Home");
  await settle(page);
  assert.deepEqual((await cellsOf(page, current))[0], "0:00.0");

  // A click on a line, or its time, leads to its moment.
  await page.selectOption("#log-level", "warning");
  await settle(page);
  assert.equal(await rows(page).count(), 3);
  await rows(page).nth(1).locator("td").last().click();
  await settle(page);
  assert.equal(await shownTime(page), "0:20.0");
  assert.deepEqual(await cellsOf(page, current), ["0:20.0", "1", "voronoi", "error", "less than three nodes"]);
  await rows(page).first().locator("button").focus();
  await page.keyboard.press("Enter");
  await settle(page);
  assert.equal(await shownTime(page), "0:12.5");

  // A robot is chosen: the log stays and shows its lines.
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.keyboard.press("3");
  await settle(page);
  assert.equal(await page.locator("#panel-log").isVisible(), true);
  assert.equal(await text(page, "#log-count"), "1 line: 0 errors, 1 warning; of blue 3");
  await page.keyboard.press("1");
  await settle(page);
  assert.equal((await page.locator("#log tbody").innerText()).trim(), "No such line");
  await page.keyboard.press("2");
  await page.selectOption("#log-level", "debug");
  await page.selectOption("#log-plugin", "=voronoi");
  await settle(page);
  assert.equal(await text(page, "#log-count"), "61 lines: 0 errors, 0 warnings; of blue 2");
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.keyboard.press("Escape");
  await settle(page);
  assert.equal(await text(page, "#log-count"), "63 lines: 1 error, 1 warning; of all robots");
  assert.deepEqual(complaints, []);
  await page.close();
});

const many = 100_000;

test("of 10^5 lines and drawings few are on the page, and it keeps up with time", async () => {
  const line = { side: "home", plugin: "p", level: "info" };
  const ring = Array.from({ length: 8 }, (_, i) => [i % 3, i % 2]);
  const bytes = await recording({
    chunkBytes: 1 << 20,
    more: (time) =>
      Array.from({ length: many / 600 }, (_, i) => [
        { topic: "/log", message: { ...line, time, robot: 1 + (i % 3), text: `line ${i} of ${time}` } },
        {
          topic: "/draw",
          message: {
            ...{ time, side: "home", robot: 1 + (i % 3), plugin: "p", layer: `layer ${i % 20}` },
            shapes: [{ shape: "line", at: ring }],
          },
        },
      ]).flat(),
  });
  const { page, complaints } = await open(`${await synthetic("many", bytes)}#t=30`);
  await page.keyboard.press("k");
  await page.keyboard.press("w");
  await settle(page);
  assert.match(await text(page, "#log-count"), /^9\d{4} lines: /);
  assert.ok((await rows(page).count()) <= 150);
  const spent = await page.evaluate(async () => {
    const { viewer } = window.regista!;
    const took: number[] = [];
    for (let i = 0; i < 30; ++i) {
      const began = performance.now();
      viewer.state.set({ time: 10 + i });
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      took.push(performance.now() - began);
    }
    return took.sort((a, b) => a - b)[15]!;
  });
  assert.ok(spent < 1000, `${spent} ms for a frame and its panel`);
  assert.deepEqual(complaints, []);
  await page.close();
});

test("what plugins say is text, and what they draw wrongly is told of once it is looked at", async () => {
  const evil = "<img src=x onerror=hacked=1><script>hacked=1</script>\u202E";
  const bytes = await recording({
    plugins: true,
    message: (topic, message, index) => {
      if (topic === "/log") return { ...message, plugin: evil, text: `${evil} ${"very long ".repeat(2000)}` };
      if (topic !== "/draw") return message;
      if (index === 3) return { ...message, shapes: [{ shape: evil, at: [] }] };
      return { ...message, plugin: evil, layer: evil, shapes: [{ shape: "text", at: [[0, 2]], text: evil }] };
    },
  });
  const { page, complaints } = await open(`${await synthetic("evil", bytes)}#t=5.2`);
  assert.equal(await text(page, "#faults"), "");
  await page.keyboard.press("k");
  await page.keyboard.press("w");
  await page.click("#drawings-open");
  await settle(page);
  const inside = (shown: string) => assert.ok(shown.includes(evil), shown.slice(0, 80));
  inside(await text(page, "#log td:nth-child(3)"));
  inside(await text(page, "#log td:nth-child(5)"));
  inside((await page.locator("#drawings").textContent()) ?? "");
  assert.ok((await page.locator("#drawings").boundingBox())!.width < 600);
  await page.fill("#time", "6.5");
  await page.press("#time", "Enter");
  await settle(page);
  const { width, injected } = await page.evaluate(() => ({
    width: document.documentElement.scrollWidth,
    injected: document.querySelectorAll("img, #viewer script").length,
  }));
  assert.deepEqual([width, injected], [1280, 0]);
  assert.match(await text(page, "#faults"), /^1 drawing cannot be read, one at 0:06\.0: shapes\[0\]\.shape is "<img/);
  assert.equal(await page.evaluate(() => "hacked" in window), false);
  assert.deepEqual(complaints, []);
  await page.close();
});

test("where plugins neither write nor draw there is neither log nor choice, and their keys do nothing", async () => {
  const { page, complaints } = await open(await synthetic("no_plugins", await recording()));
  assert.equal(await page.locator("#tab-log").isVisible(), false);
  assert.equal(await page.locator("#drawings-open").isVisible(), false);
  await page.keyboard.press("k");
  await page.keyboard.press("w");
  await settle(page);
  assert.equal(await page.locator("#panel-overlaps").isVisible(), true);
  assert.deepEqual(complaints, []);
  await page.close();
});
