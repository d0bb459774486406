// SPDX-License-Identifier: MIT
// What the page is given: hostile names, files that are damaged, foreign or too large, and a file that is chosen.
import assert from "node:assert/strict";
import { truncateSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { folder, open, pageOf, settle, synthetic, text } from "./page_kit";
import { metadata, recording } from "./synthetic";

test("hostile names are text, and do not spread", async () => {
  const teams: [string, string] = [
    "<img src=x onerror=hacked=1><script>hacked=1</script>\"'&amp;",
    `\u202E\u05D0${"long name ".repeat(20)}`,
  ];
  const pairs = metadata(teams);
  const home = JSON.parse(pairs.home!);
  home.roles[1].name = "<b onmouseover=hacked=1>striker</b>".repeat(6);
  home.contexts[1].name = "</script><script>hacked=1</script>";
  const bytes = await recording({
    teams,
    metadata: { home: JSON.stringify(home), command: "</script><script>hacked=1</script>" },
    message: (topic, message) =>
      topic === "/packet"
        ? { ...message, reason: "<i>x</i>" }
        : topic === "/event"
          ? { ...message, event: "<u>goal</u>" }
          : message,
  });
  const { page, complaints } = await open(await synthetic("hostile <&>", bytes));
  assert.equal(await text(page, "#home-name"), teams[0]);
  assert.equal(await text(page, "#away-name"), teams[1]);
  for (const key of ["]", "2", "r", "c", "m", "t", "o"]) {
    await page.keyboard.press(key);
    await settle(page);
    const { width, injected } = await page.evaluate(() => ({
      width: document.documentElement.scrollWidth,
      injected: document.querySelectorAll("img, b[onmouseover], i, u").length,
    }));
    assert.ok(width <= 1280, `after ${key}: ${width} wide`);
    assert.equal(injected, 0);
  }
  assert.match(await text(page, ".facts"), /hostile <&>\.mcap/);
  assert.equal(await page.evaluate(() => "hacked" in window), false);
  assert.deepEqual(complaints, []);
  await page.close();
});

test("what cannot be shown is said", async () => {
  const whole = await recording();
  const cut = await open(await synthetic("cut", whole.slice(0, Math.floor(0.7 * whole.length))));
  assert.match(
    await text(cut.page, "#faults"),
    /^This recording is cut off\. What is complete is shown, up to 0:\d\d\.\d\.$/,
  );
  await cut.page.close();
  for (const [name, bytes, expected] of [
    ["empty", new Uint8Array(0), /The file is empty/],
    ["foreign", new TextEncoder().encode("\u0089PNG nothing of ours"), /not in the MCAP format/],
    ["another", await recording({ without: Object.keys(metadata()) }), /not the recording of a match by Regista/],
    ["newer", await recording({ metadata: { format: "3" } }), /has format 3; this page reads format 1/],
  ] as const) {
    const { page } = await open(await synthetic(name, bytes), "failed");
    assert.match(await text(page, "#start-text"), expected);
    assert.equal(await page.locator("#start-choose").isVisible(), true);
    assert.equal(await page.locator("#viewer").isVisible(), false);
    await page.close();
  }
});

test("a page without a recording opens a file that is chosen", async () => {
  const { page } = await open(pageOf(null, "none"), "asking");
  const bad = join(folder, "bad.mcap");
  writeFileSync(bad, "no recording");
  await page.setInputFiles("#file", bad);
  await page.waitForFunction(() => document.body.dataset.state === "failed");
  assert.match(await text(page, "#start-text"), /bad\.mcap/);
  const large = join(folder, "large.mcap");
  writeFileSync(large, "");
  truncateSync(large, 257 * 2 ** 20);
  await page.setInputFiles("#file", large);
  await page.waitForFunction(() => document.getElementById("start-text")!.textContent!.includes("257 MiB"));
  const good = join(folder, "good.mcap");
  writeFileSync(good, await recording());
  await page.setInputFiles("#file", good);
  await page.waitForFunction(() => document.body.dataset.state === "ready");
  assert.equal(await text(page, "#home-name"), "blue");
  await page.close();
});
