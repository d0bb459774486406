// SPDX-License-Identifier: MIT
// From the headline of a study to the moment of a goal, and what else a reader does with its matches, in a browser:
//
//     node clicks.mjs PROGRAM SOURCE
//
// Pages are opened from disk. Status 77: there is no browser.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { browserOf } from "./browser.mjs";

const [program, source] = process.argv.slice(2);
if (source === undefined) {
  console.error("usage: node clicks.mjs PROGRAM SOURCE");
  process.exit(2);
}
const startBrowser = await browserOf(source);

const folder = mkdtempSync(join(tmpdir(), "regista-clicks-"));
function run(...words) {
  const { status, stdout, stderr } = spawnSync(resolve(program), words, { cwd: folder, encoding: "utf8" });
  assert.equal(status, 0, `${words.join(" ")}: ${stderr}`);
  return stdout;
}
const address = (name) => pathToFileURL(join(folder, name)).href;

// Scenes in which goals fall.
const team = (name) => join(source, "configs/teams", `${name}.yaml`);
run("tournament", "--team", team("paper"), "--team", team("spqr2023"), "--pairs", "6", "--limit", "30", "--quiet", "--play-once",
    "--openings", join(source, "configs/openings"), "--set", "rules.durations.ready=3", "--set", "rules.durations.set=1");
run("report", "tournament.db", "--replays", "2");
const rows = run("report", "tournament.db", "--csv").trim().split("\n").slice(1).map((line) => line.split(","));

const browser = await startBrowser();
const complaints = [];
async function open(name) {
  const page = await browser.newPage();
  page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(String(error)));
  await page.goto(address(name));
  return page;
}
const score = async (page) => (await page.locator("#goals").textContent()).replace(/\s/g, "");

// The page opens shortly before a goal, and the last click leads to it.
async function atTheGoal(page, clicks) {
  await page.waitForFunction(() => document.body.dataset.state === "ready", null, { timeout: 60_000 });
  assert.match(await score(page), /^0[:–]0$/, "the page opens before the first goal");
  const before = await page.locator("#time").inputValue();
  assert.notEqual(before, "0:00.0", "and not far before it");
  await page.click("#next-goal"); // the last click
  await page.waitForFunction((then) => document.getElementById("time").value !== then, before);
  const goal = await page.locator("#time").inputValue();
  await page.keyboard.press("ArrowRight"); // the score is that of the moment: a little later it counts
  await page.waitForFunction(() => !/^0.0$/.test(document.getElementById("goals").textContent.replace(/\s/g, "")));
  console.log(`a goal after ${clicks} clicks: from ${before} to ${goal}, ${await score(page)}`);
}

try {
  // 1. The match beside the headline. 2. "goal »".
  const study = await open("tournament.html");
  await study.click("header .beside a[href*='replays']");
  await atTheGoal(study, 2);
  await study.close();

  // 1. "the matches" beside the headline. 2. "watch" in the table. 3. "goal »".
  const list = await open("tournament.html");
  await list.click("header .beside a[href='#matches']");
  assert.ok(await list.locator("#matches h2").evaluate((h2) => Math.abs(h2.getBoundingClientRect().top) < innerHeight));
  await list.click("#matches table >> nth=0 >> text=watch >> nth=0");
  await atTheGoal(list, 3);
  await list.close();

  // All matches, sorted and filtered.
  const table = await open("tournament.html");
  const all = table.locator("#matches .sortable tbody tr");
  assert.equal(await all.count(), rows.length);
  await table.click("#matches summary");
  const column = async (number) => table.locator("#matches .sortable tbody tr:visible").evaluateAll(
    (found, cell) => found.map((row) => row.cells[cell].textContent), number);
  assert.deepEqual(await column(0), rows.map((row) => row[0]));
  const differences = (found) => found.map((text) => text.split(":")).map(([home, away]) => home - away);
  const expected = rows.map((row) => row[6] - row[7]).sort((a, b) => a - b);
  await table.click("#matches .sortable th:has-text('Score')");
  assert.deepEqual(differences(await column(2)), expected);
  await table.click("#matches .sortable th:has-text('Score')");
  assert.deepEqual(differences(await column(2)), [...expected].reverse());
  const opening = rows[2][3];
  await table.fill("#matches input", `${opening} SPQR`);
  const filtered = rows.filter((row) => row[3] === opening);
  assert.equal((await column(0)).length, filtered.length);
  assert.equal(await table.locator("#matches output").textContent(), `${filtered.length} of ${rows.length}`);
  await table.fill("#matches input", "nothing like this");
  assert.equal((await column(0)).length, 0);
  await table.close();

  // Another script than ours does nothing.
  writeFileSync(join(folder, "foreign.html"), readFileSync(join(folder, "tournament.html"), "utf8")
    .replace("</main>", "<script>document.title = 'taken'</script></main>"));
  const told = complaints.length;
  const foreign = await open("foreign.html");
  assert.notEqual(await foreign.title(), "taken");
  assert.ok(complaints.splice(told).some((line) => line.includes("Content Security Policy")));
  await foreign.close();

  // The page of a study that is still played loads itself again, and what was unfolded and typed stays.
  const still = readFileSync(join(folder, "tournament.html"), "utf8").replace('data-live="0"', 'data-live="1"');
  writeFileSync(join(folder, "live.html"), still);
  const live = await open("live.html");
  await live.click("#matches summary");
  await live.fill("#matches input", opening);
  await live.locator("#matches input").blur();
  await live.evaluate(() => scrollTo(0, 300));
  writeFileSync(join(folder, "live.html"), still.replace("<title>", "<title>renewed "));
  await live.waitForFunction(() => document.title.startsWith("renewed"), null, { timeout: 20_000 });
  await live.waitForFunction(() => Math.abs(scrollY - 300) < 2);
  assert.equal(await live.locator("#matches input").inputValue(), opening);
  assert.ok(await live.locator("#matches .sortable tbody tr:visible").count() > 0);
  assert.equal(await live.locator("#matches .sortable tbody tr:visible").count(), filtered.length);
  writeFileSync(join(folder, "live.html"), readFileSync(join(folder, "tournament.html"), "utf8"));
  await live.waitForFunction(() => document.body.dataset.live === "0", null, { timeout: 20_000 });
  await live.close();
  assert.deepEqual(complaints, []);
} finally {
  await browser.close();
}

// Without scripts the page shows the same.
const plain = await startBrowser({ javaScriptEnabled: false });
try {
  const page = await plain.newPage();
  await page.goto(address("tournament.html"));
  assert.equal(await page.locator("#matches .sortable tbody tr").count(), rows.length);
  await page.click("#matches summary");
  assert.ok(await page.locator("#matches .sortable tbody tr").last().isVisible());
  assert.equal(await page.locator("#matches input").count(), 0);
} finally {
  await plain.close();
  rmSync(folder, { recursive: true, force: true });
}
