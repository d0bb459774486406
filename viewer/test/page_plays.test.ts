// SPDX-License-Identifier: MIT
// Shots, meant passes, clearances and duels in a real browser: listed, marked on the timeline, jumped to; heat maps; who
// goes for the ball. SCREENSHOT names a PNG file to look at.
import assert from "node:assert/strict";
import { test } from "node:test";

import { colourAt, open, settle, shownTime, synthetic, text } from "./page_kit";
import { recording, withPlays } from "./synthetic";

const bytes = await recording(withPlays);

test("actions are listed, filtered and jumped to, and stand on the timeline", async () => {
  const { page, complaints } = await open(`${await synthetic("plays", bytes)}#t=20`);
  await page.keyboard.press("a");
  await settle(page);
  const what = async () => (await page.locator("#plays tbody td:nth-child(3)").allInnerTexts()).map((t) => t.trim());
  assert.deepEqual(await what(), [
    "pass to 3: arrived",
    "duel with 1 of red, 2.2 s: won by red",
    "clearance",
    "shot: goal",
    "pass to 1: intercepted",
  ]);
  assert.equal(await text(page, "#plays-count"), "1 shot, 2 passes, 1 clearance, 1 duel");
  assert.match(await text(page, "#plays tr[aria-current]"), /clearance/);
  await page.selectOption("#plays-kind", "pass");
  await page.selectOption("#plays-side", "1");
  assert.deepEqual(await what(), ["pass to 1: intercepted"]);
  await page.locator("#plays tbody button").first().click();
  await settle(page);
  assert.equal(await shownTime(page), "0:26.0", "2 s before");

  // Under the pointer: the goal's shot at 23 s; the lane is below the axis of 24 px.
  const box = (await page.locator("#detail").boundingBox())!;
  const x = await page.evaluate(() => {
    const canvas = document.getElementById("detail") as HTMLCanvasElement;
    return 92 + (23 / 60) * (canvas.clientWidth - 92 - 14);
  });
  await page.mouse.move(box.x + x, box.y + 30);
  assert.match(await text(page, "#tip"), /0:23\.0 blue 3: shot: goal/);
  if (process.env.SCREENSHOT) await page.screenshot({ path: process.env.SCREENSHOT });
  assert.deepEqual(complaints, []);
  await page.close();
});

test("heat maps are drawn on the ground, of what is chosen", async () => {
  const { page, complaints } = await open(`${await synthetic("heat", bytes)}#t=20`);
  // Where the ball was at 40 s, and where nothing ever is.
  const rolled = () => colourAt(page, 1.1, 0.45);
  const empty = () => colourAt(page, 1.1, -2.4);
  const [before, grass] = [await rolled(), await empty()];
  assert.deepEqual(before, grass);
  await page.keyboard.press("h");
  await settle(page);
  assert.notDeepEqual(await rolled(), grass);
  assert.deepEqual(await empty(), grass);
  assert.equal(await page.locator("#heat-open").getAttribute("aria-pressed"), "true");
  await page.locator("#heat-open").click();
  assert.deepEqual(await page.locator("#heat button").allInnerTexts(), [
    "no heat map",
    "ball",
    "robots of blue",
    "robots of red",
    "chosen robot",
  ]);
  await page.locator("#heat button").nth(3).click();
  await settle(page);
  assert.deepEqual(await rolled(), grass, "no robot of red was there");
  assert.equal(
    await page.locator("#heat-open").getAttribute("title"),
    "Heat map: robots of red, whole match (h: on or off)",
  );
  await page.keyboard.press("h");
  await settle(page);
  assert.equal(await page.locator("#heat-open").getAttribute("aria-pressed"), "false");
  assert.deepEqual(complaints, []);
  await page.close();
});

test("at the ball: who goes, and why nobody does", async () => {
  const { page, complaints } = await open(`${await synthetic("at_ball", bytes)}#t=37`);
  await page.keyboard.press("f");
  await settle(page);
  assert.match(await text(page, "#ball-verdict"), /^The ball has rested for 2\.0 s, and nobody goes for it\./);
  const cells = async (line: number) =>
    (await page.locator(`#ball-home tbody tr:nth-child(${line}) td`).allInnerTexts()).map((t) => t.trim());
  assert.deepEqual(await cells(1), ["2", "2.4", "0.74", "defender", "no", "no", "leaves the ball to 3 (0:36.0)"]);
  assert.deepEqual((await cells(2)).slice(3, 6), ["striker", "yes", "no"]);
  assert.deepEqual(complaints, []);
  await page.close();
});

test("a recording of an earlier version opens, and says what it does not tell", async () => {
  const { page, complaints } = await open(`${await synthetic("before_plays", await recording())}#t=37`);
  await page.keyboard.press("a");
  await settle(page);
  assert.match(await text(page, "#panel-plays"), /was written before Regista recorded shots/);
  await page.keyboard.press("f");
  await settle(page);
  assert.match(await text(page, "#panel-ball"), /This recording does not tell who goes for the ball/);
  assert.deepEqual(complaints, []);
  await page.close();
});
