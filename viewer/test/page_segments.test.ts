// SPDX-License-Identifier: MIT
// The segments of plugins in a real browser: what the list shows is what the recording holds, and a bid can be followed
// from its offer to those who heard it. SCREENSHOT names a PNG file to look at.
import assert from "node:assert/strict";
import { test } from "node:test";

import { noteCanvasTexts, troubles } from "./boxes";
import { browser, open, settle, synthetic, text } from "./page_kit";
import { recording } from "./synthetic";

const cells = async (page: Awaited<ReturnType<typeof open>>["page"], key: string) =>
  (await page.locator(`#segments tr[data-segment="${key}"] td`).allInnerTexts()).map((each) => each.trim());

test("segments around the moment: offered, sent, heard or lost, dropped and why", async () => {
  const { page, complaints } = await open(`${await synthetic("segments", await recording({ segments: true }))}#t=12.2`);
  assert.equal(await page.locator("#tab-segments").isVisible(), true);
  await page.keyboard.press("s");
  await settle(page);
  assert.equal(await page.locator("#panel-segments").isVisible(), true);
  assert.equal(await text(page, "#segment-count"), "16: 12 sent, 2 dropped, 1 refused");
  const bid = (number: number) => `bid ${number} for \u201cstriker\u201d`;
  assert.deepEqual(await cells(page, "home/2/1"), ["0:04.6", "2", "bids", bid(1), "sent 0:05.0", "1 lost: 3"]);
  assert.deepEqual(await cells(page, "home/2/2"), ["0:09.6", "2", "bids", bid(2), "sent 0:10.0", "1 3"]);
  assert.deepEqual(await cells(page, "home/2/4"), ["0:19.6", "2", "bids", bid(4), "sent 0:20.0", "1 3: no mailbox"]);
  assert.deepEqual(await cells(page, "home/3/1"), ["0:12.0", "3", "bids", "0a 1f", "replaced 0:12.5", ""]);
  assert.deepEqual(await cells(page, "home/3/2"), ["0:12.5", "3", "bids", "ff 00", "expired 0:15.5", ""]);
  assert.deepEqual(await cells(page, "home/1/0"), ["0:15.0", "1", "bids", "300 bytes", "refused: too long", ""]);
  // The one that was offered last stands out, and what has not happened yet is grey.
  assert.equal(await page.locator("#segments tr[aria-current]").getAttribute("data-segment"), "home/3/1");
  const grey = (key: string) => page.locator(`#segments tr[data-segment="${key}"]`).getAttribute("class");
  assert.deepEqual([await grey("home/2/2"), await grey("home/2/4")], ["", "muted"]);
  assert.equal(await page.locator('#segments tr[data-segment="home/3/1"] td.muted').innerText(), "replaced 0:12.5");
  if (process.env.SCREENSHOT) await page.screenshot({ path: process.env.SCREENSHOT });

  // A click leads there, filters leave the others out.
  await page.locator('#segments tr[data-segment="home/2/4"] button').click();
  await settle(page);
  assert.equal(await page.locator("#time").inputValue(), "0:19.6");
  await page.selectOption("#segment-fate", "lost");
  await settle(page);
  const listed = async () =>
    Promise.all(
      (await page.locator("#segments tbody tr").all()).map(async (line) => await line.getAttribute("data-segment")),
    );
  // The last packet is followed by too little of the recording to say who will never hear it.
  assert.deepEqual(
    await listed(),
    [1, 3, 4, 5, 7, 9, 11].map((k) => `home/2/${k}`),
  );
  await page.selectOption("#segment-fate", "dropped");
  await page.selectOption("#segment-robot", "3");
  await settle(page);
  assert.deepEqual(await listed(), ["home/3/1", "home/3/2"]);
  await page.selectOption("#segment-side", "1");
  await settle(page);
  assert.equal((await page.locator("#segments tbody").innerText()).trim(), "No such segment");
  assert.deepEqual(complaints, []);
  await page.close();
});

test("nothing is cut or covered at the widths of usual screens", async () => {
  const address = await synthetic("segments_boxes", await recording({ segments: true }));
  const page = await browser.newPage();
  await noteCanvasTexts(page);
  await page.goto(`${address}#t=20.2&robot=home/2`);
  await page.waitForFunction(() => document.body.dataset.counted === "true");
  const found: string[] = [];
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    for (const width of [1280, 1920]) {
      await page.setViewportSize({ width, height: (width * 9) / 16 });
      for (const key of ["s", "c"]) {
        await page.keyboard.press(key);
        await settle(page);
        for (const trouble of await troubles(page, true)) found.push(`${key} at ${width}, ${colorScheme}: ${trouble}`);
      }
    }
  }
  assert.deepEqual(found, []);
  await page.close();
});

test("without segments there is no such tab, and its key does nothing", async () => {
  const { page, complaints } = await open(await synthetic("no_segments", await recording()));
  assert.equal(await page.locator("#tab-segments").isVisible(), false);
  await page.keyboard.press("s");
  await settle(page);
  assert.equal(await page.locator("#panel-overlaps").isVisible(), true);
  assert.deepEqual(complaints, []);
  await page.close();
});
