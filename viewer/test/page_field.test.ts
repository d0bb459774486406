// SPDX-License-Identifier: MIT
// What is drawn on the field when, and the way from goal to goal, in a real browser.
import assert from "node:assert/strict";
import { test } from "node:test";

import type { Page } from "playwright-core";

import { open, placeOnField, settle, shownTime, synthetic, text } from "./page_kit";
import { ballAt, metadata, recording } from "./synthetic";

// Colours of the field around a point of the page, by row.
async function pixels(page: Page, x: number, y: number, reach: number): Promise<number[][][]> {
  return page.evaluate(
    ({ x, y, reach }) => {
      const field = document.getElementById("field") as HTMLCanvasElement;
      const box = field.getBoundingClientRect();
      const size = 2 * reach + 1;
      const copy = document.createElement("canvas");
      [copy.width, copy.height] = [size, size];
      const context = copy.getContext("2d")!;
      context.drawImage(field, Math.round(box.x - x) + reach, Math.round(box.y - y) + reach);
      const { data } = context.getImageData(0, 0, size, size);
      return Array.from({ length: size }, (_, row) =>
        Array.from({ length: size }, (__, column) => [
          ...data.slice(4 * (row * size + column), 4 * (row * size + column) + 3),
        ]),
      );
    },
    { x, y, reach },
  );
}

// Contrast of two colours by the Web Content Accessibility Guidelines 2.1: 1 to 21.
function contrast(a: number[], b: number[]): number {
  const luminance = (colour: number[]) => {
    const [red, green, blue] = colour.map((part) => {
      const share = part / 255;
      return share <= 0.03928 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * red! + 0.7152 * green! + 0.0722 * blue!;
  };
  const [least, most] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (most! + 0.05) / (least! + 0.05);
}

test("the ball is seen in light and dark, at every size of the window, beside the one that is believed", async () => {
  const { page } = await open(`${await synthetic("ball", await recording())}#t=20.5`);
  await page.click("#layer-trails");
  const [ballX, ballY] = ballAt(20.5);
  for (const theme of ["light", "dark"]) {
    if (theme === "dark") await page.keyboard.press("d");
    for (const [width, height] of [
      [960, 600],
      [1280, 720],
      [1920, 1080],
    ] as const) {
      await page.setViewportSize({ width, height });
      await page.keyboard.press("Escape");
      await settle(page);
      const { x, y } = await placeOnField(page, [ballX, ballY]);
      const around = await pixels(page, x, y, 14);
      const grass = around[0]![0]!;
      // From grass to grass through the ball's centre: at least 12 pixels are something else, and black and white both.
      const row = around[14]!;
      const other = row.filter((colour) => contrast(colour, grass) > 1.15 || Math.abs(colour[1]! - grass[1]!) > 12);
      assert.ok(other.length >= 12, `${theme}, ${width}: ${other.length} pixels`);
      assert.ok(Math.max(...row.map((colour) => contrast(colour, grass))) > 7, `${theme}, ${width}: it stands out`);
      const inside = around.slice(8, 21).flatMap((line) => line.slice(8, 21));
      assert.ok(
        inside.some((colour) => contrast(colour, [255, 255, 255]) < 1.2),
        "white",
      );
      assert.ok(
        inside.some((colour) => contrast(colour, [0, 0, 0]) < 1.4),
        "black",
      );
    }
  }
  // What robot 2 believes: 0.4 m on and 0.3 m down, empty in the middle.
  await page.keyboard.press("i"); // no ellipses
  await page.keyboard.press("j"); // no tasks
  await page.keyboard.press("2");
  await settle(page);
  const { x, y } = await placeOnField(page, [ballX + 0.4, ballY - 0.3]);
  const around = await pixels(page, x, y, 14);
  const grass = around[0]![0]!;
  const drawn = around.map((line) => line.map((colour) => contrast(colour, grass) > 2));
  assert.equal(drawn[14]![14], false, "its middle is empty");
  assert.ok(drawn[14]!.filter(Boolean).length >= 6, "its ring and cross");
  await page.close();
});

test("what the positioner computed is a choice, named after it", async () => {
  const pairs = metadata();
  const away = JSON.parse(pairs.away!);
  away.contexts[1].positioner = "";
  const bytes = await recording({ metadata: { away: JSON.stringify(away) } });
  const { page } = await open(`${await synthetic("positioner", bytes)}#t=20.5&robot=home/2`);
  for (const layer of ["belief", "tasks", "trails"]) await page.click(`#layer-${layer}`);
  await settle(page);
  const choice = page.locator("#layer-computed");
  assert.deepEqual([await choice.textContent(), await choice.getAttribute("aria-pressed")], ["Voronoi cells", "false"]);
  // A waypoint of the made-up decisions.
  const node = async () => {
    const { x, y } = await placeOnField(page, [2, -1]);
    const around = await pixels(page, x, y, 5);
    return contrast(around[5]![5]!, around[0]![0]!) > 2;
  };
  assert.equal(await node(), false);
  await choice.click();
  await settle(page);
  assert.deepEqual([await node(), await choice.getAttribute("aria-pressed")], [true, "true"]);
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.keyboard.press("v");
  await settle(page);
  assert.deepEqual([await node(), await choice.getAttribute("aria-pressed")], [false, "false"]);
  await page.keyboard.press("t");
  await settle(page);
  assert.deepEqual([await choice.textContent(), await choice.isDisabled()], ["No positioner", true]);
  await page.keyboard.press("v");
  await page.keyboard.press("t");
  await settle(page);
  assert.equal(await choice.getAttribute("aria-pressed"), "false", "no key for what is not there");
  await page.close();
});

test("from goal to goal, by keys, by buttons, and in the help", async () => {
  const bytes = await recording({
    message: (topic, message) =>
      topic === "/event" && message.event === "kick_off"
        ? { ...message, event: "goal", side: "away", robot: 2 }
        : message,
  });
  const { page } = await open(await synthetic("goals", bytes));
  const presses = async (press: () => Promise<void>, expected: string) => {
    await press();
    await settle(page);
    assert.equal(await shownTime(page), expected);
  };
  await presses(() => page.keyboard.press("g"), "0:10.0");
  await presses(() => page.keyboard.press("g"), "0:25.0");
  await presses(() => page.keyboard.press("g"), "0:25.0");
  await presses(() => page.keyboard.press("Shift+G"), "0:10.0");
  await presses(() => page.click("#next-goal"), "0:25.0");
  await presses(() => page.click("#previous-goal"), "0:10.0");
  assert.match(await text(page, "#keys"), /gnext goalShift gprevious goal/);
  for (const which of ["next", "previous"])
    assert.match((await page.getAttribute(`#${which}-goal`, "title"))!, new RegExp(`^${which} goal \\(.*g\\)$`, "i"));
  // The line of the whole match says what stands under the pointer.
  const overview = (await page.locator("#overview").boundingBox())!;
  await page.mouse.move(overview.x + 92 + ((overview.width - 92 - 14) * 25) / 60, overview.y + 30);
  assert.equal(await text(page, "#tip"), "0:25.00 goal, blue 3, 1 : 0 (g: next goal, Shift g: previous goal)");
  await page.mouse.move(overview.x + 200, overview.y + 30);
  assert.equal(await page.locator("#tip").isVisible(), false);
  await page.close();
  const without = await open(
    await synthetic("no goals", await recording({ message: (_, m) => (m.event === "goal" ? undefined : m) })),
  );
  assert.equal(await without.page.locator("#next-goal").isDisabled(), true);
  await without.page.close();
});
