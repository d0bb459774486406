// SPDX-License-Identifier: MIT
// What is drawn on the field when, which part of it is shown, and the way from goal to goal, in a real browser.
import assert from "node:assert/strict";
import { test } from "node:test";

import { contrast, open, pixels, placeOnField, settle, shownTime, synthetic, text } from "./page_kit";
import { ballAt, posesAt, recording } from "./synthetic";

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

test("from goal to goal, by keys, by buttons, and in the help", async () => {
  const bytes = await recording({
    message: (topic, message) =>
      topic === "/event" && message.event === "kick_off"
        ? { ...message, event: "goal", side: "away", robot: 2 }
        : message,
  });
  const { page } = await open(`${await synthetic("goals", bytes)}#t=0`);
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
  assert.match(await text(page, "#keys"), /g, Shift gnext, previous goal/);
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

test("the field is zoomed at the pointer, moved by a drag, follows, and is shown whole again", async () => {
  const { page, complaints } = await open(`${await synthetic("zoom", await recording())}#t=20.5`);
  for (const layer of ["trails", "tasks"]) await page.click(`#layer-${layer}`);
  const box = (await page.locator("#field").boundingBox())!;
  const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  const pose = (time: number) => posesAt(time)[0][1]!; // of robot 2 of home
  const home = await placeOnField(page, pose(20.5));
  // Beside its number the robot is blue.
  const isBlue = async ({ x, y }: { x: number; y: number }) => {
    const [red, green, blue] = (await pixels(page, x, y, 0))[0]![0]!;
    return red! < 40 && Math.abs(green! - 114) < 40 && Math.abs(blue! - 178) < 40;
  };
  const shows = async (place: { x: number; y: number }, scale: number) => {
    await settle(page);
    return isBlue({ x: place.x - 0.11 * scale, y: place.y });
  };
  assert.equal(await shows(home, home.scale), true);
  await page.mouse.move(home.x, home.y);
  for (let i = 0; i < 5; ++i) await page.mouse.wheel(0, -200);
  await settle(page);
  const zoom = Math.exp(0.002 * 200 * 5);
  assert.equal(await shows(home, zoom * home.scale), true, "it stays below the pointer, and is larger");
  assert.equal(await page.evaluate(() => scrollY), 0);
  // Dragged 80 px to the right and 50 down; a drag chooses no robot.
  await page.mouse.down();
  await page.mouse.move(home.x + 40, home.y + 20);
  await page.mouse.move(home.x + 80, home.y + 50);
  await page.mouse.up();
  const drawn = { x: home.x + 80, y: home.y + 50 };
  assert.equal(await shows(drawn, zoom * home.scale), true);
  assert.equal(await page.locator("#panel-robot").isVisible(), false);
  await page.mouse.click(drawn.x, drawn.y);
  await settle(page);
  assert.equal(await text(page, "#panel-robot h2"), "blue 2", "a click finds it where it is now");
  // Follows the chosen robot in time, until it is moved by hand.
  assert.equal(await text(page, "#field-follow"), "follow 2");
  await page.keyboard.press("y");
  for (const time of ["0:20.5", "0:35"]) {
    await page.fill("#time", time);
    await page.press("#time", "Enter");
    assert.equal(await shows(middle, zoom * home.scale), true, `in the middle at ${time}`);
  }
  assert.equal(await page.getAttribute("#field-follow", "aria-pressed"), "true");
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.down();
  await page.mouse.move(middle.x + 30, middle.y, { steps: 3 });
  await page.mouse.up();
  await settle(page);
  assert.equal(await page.getAttribute("#field-follow", "aria-pressed"), "false");
  assert.equal(await shows({ x: middle.x + 30, y: middle.y }, zoom * home.scale), true);
  // The whole field: by a key, by a double click, by its button.
  const whole = await placeOnField(page, pose(35));
  const resets = [
    () => page.keyboard.press("x"),
    () => page.mouse.dblclick(box.x + 5, box.y + box.height - 5),
    () => page.click("#field-whole"),
  ];
  for (const reset of resets) {
    await reset();
    assert.equal(await shows(whole, whole.scale), true);
    assert.equal(await page.locator("#field-whole").isDisabled(), true);
    await page.click("#field-in");
    assert.equal(await page.locator("#field-whole").isDisabled(), false);
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  }
  await page.keyboard.press("Shift+Z");
  assert.equal(await page.locator("#field-whole").isDisabled(), true);
  for (const does of ["z, Shift zless, more of the field", "xthe whole field", "ythe field follows"])
    assert.match(await text(page, "#keys"), new RegExp(does));
  assert.deepEqual(complaints, []);
  await page.close();
});

test("two fingers zoom, and one moves the field", async () => {
  const { page } = await open(`${await synthetic("fingers", await recording())}#t=20.5`);
  const box = (await page.locator("#field").boundingBox())!;
  const client = await page.context().newCDPSession(page);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const touch = (type: string, ...xs: number[]) =>
    client.send("Input.dispatchTouchEvent", {
      type: type as "touchStart",
      touchPoints: xs.map((at, id) => ({ x: at, y, id })),
    });
  await touch("touchStart", x - 20, x + 20);
  for (const reach of [30, 50, 80]) await touch("touchMove", x - reach, x + reach);
  await touch("touchEnd");
  await settle(page);
  const zoomed = () => page.locator("#field.zoomed").count();
  assert.equal(await zoomed(), 1);
  const before = await page.screenshot({ clip: box });
  await touch("touchStart", x);
  for (const reach of [10, 40, 60]) await touch("touchMove", x - reach);
  await touch("touchEnd");
  await settle(page);
  assert.notDeepEqual(await page.screenshot({ clip: box }), before);
  await page.close();
});
