// SPDX-License-Identifier: MIT
// What the page is given: hostile names, files that are damaged, foreign or too large, and a file that is chosen.
import assert from "node:assert/strict";
import { truncateSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { lz4Frame } from "../lz4_frame.mjs";
import { folder, open, pageOf, settle, synthetic, text } from "./page_kit";
import { type Logged, metadata, recording } from "./synthetic";

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
    ["cut early", (await recording()).slice(0, 60), /breaks off before it describes its match/],
    ["newer", await recording({ metadata: { format: "3" } }), /has format 3; this page reads format 1/],
  ] as const) {
    const { page } = await open(await synthetic(name, bytes), "failed");
    assert.match(await text(page, "#start-text"), expected);
    assert.equal(await page.locator("#start-choose").isVisible(), true);
    assert.equal(await page.locator("#viewer").isVisible(), false);
    await page.close();
  }
});

test("one damaged byte in the middle costs one chunk", async () => {
  const changed = (await recording()).slice();
  changed[Math.floor(changed.length / 2)]! ^= 0x10;
  const { page, complaints } = await open(await synthetic("flipped", changed));
  const said = /^This recording is damaged: (\d):(\d\d\.\d) to \d:\d\d\.\d is missing, the rest is shown\. 1 part /;
  const [, minutes, rest] = said.exec(await text(page, "#faults"))!;
  await page.keyboard.press("End");
  await settle(page);
  assert.equal(await page.locator("#time").inputValue(), "1:00.0");
  assert.match(await text(page, "#game"), /^half 1/);
  await page.fill("#time", `${minutes}:${(Number(rest) + 0.4).toFixed(1).padStart(4, "0")}`);
  await page.press("#time", "Enter");
  await settle(page);
  assert.equal(await text(page, "#game"), "this part of the recording is damaged");
  assert.deepEqual(complaints, []);
  await page.close();
});

test("of several files the one chosen last counts", async () => {
  const address = pageOf(null, "several");
  const names = ["first", "second", "third"];
  const files = await Promise.all(
    names.map(async (name) => [...(await recording({ teams: [name, "red"] }))] as number[]),
  );
  for (const pauses of [0, 3, 15]) {
    const { page, complaints } = await open(address, "asking");
    const hidden = await page.evaluate(
      async ({ names, files, pauses }) => {
        const drop = (i: number) => {
          const dataTransfer = new DataTransfer();
          dataTransfer.items.add(new File([new Uint8Array(files[i]!)], `${names[i]}.mcap`));
          document.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
        };
        const seen: boolean[] = [];
        for (let i = 0; i < files.length && document.body.dataset.state !== "ready"; ++i) {
          drop(i);
          seen.push(document.getElementById("start-choose")!.hidden);
          if (pauses > 0) await new Promise((resolve) => setTimeout(resolve, pauses));
        }
        return seen;
      },
      { names, files, pauses },
    );
    assert.ok(hidden.every(Boolean), "no chooser while one is read");
    await page.waitForFunction(() => document.body.dataset.state === "ready");
    await page.waitForTimeout(300);
    assert.equal(await text(page, "#home-name"), names[hidden.length - 1]);
    assert.equal(await page.locator('[role="tab"]:visible').count(), 7, "one viewer");
    assert.deepEqual(complaints, []);
    await page.close();
  }
  // One that cannot be read gives way to one that can, and says nothing more.
  const { page } = await open(address, "asking");
  await page.evaluate((bytes) => {
    for (const [name, data] of [
      ["bad", [1, 2, 3]],
      ["good", bytes],
    ] as const) {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([new Uint8Array(data)], `${name}.mcap`));
      document.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    }
  }, files[0]!);
  await page.waitForFunction(() => document.body.dataset.state === "ready");
  assert.equal(await page.locator("#start").isVisible(), false);
  await page.close();
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
  // As another program may write it.
  const order = (messages: readonly Logged[]) => [...messages].reverse();
  const anew = { order, later: 1_790_000_000_000_000_000n, compression: "lz4", compress: lz4Frame };
  writeFileSync(good, await recording({ anew }));
  await page.setInputFiles("#file", good);
  await page.waitForFunction(() => document.body.dataset.state === "ready");
  assert.equal(await text(page, "#home-name"), "blue");
  assert.equal(await text(page, "#faults"), "");
  await page.close();
});
