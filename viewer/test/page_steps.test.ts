// SPDX-License-Identifier: MIT
// What follows the moment, in a real browser: where a match opens, whose terms are shown while roles change, and lists
// of goals, role overlaps and lines of the log that lead to their moments.
import assert from "node:assert/strict";
import { test } from "node:test";

import type { Page } from "playwright-core";

import { type Json, messages, open, pageOf, folder, settle, shownTime, synthetic, text } from "./page_kit";
import { recording, rolesAt } from "./synthetic";
import { join } from "node:path";
import { writeFileSync } from "node:fs";

const roles = ["goalkeeper", "striker", "defender"];

test("a match opens at its first kick-off, unless the address names a moment", async () => {
  const address = await synthetic("opens", await recording());
  for (const [fragment, expected] of [
    ["", "0:10.0"],
    ["#robot=home/2", "0:10.0"],
    ["#t=7", "0:07.0"],
    ["#t=0&robot=home/2", "0:00.0"],
  ] as const) {
    const { page } = await open(address + fragment);
    await settle(page);
    assert.equal(await shownTime(page), expected);
    await page.keyboard.press("Home");
    await settle(page);
    assert.equal(await shownTime(page), "0:00.0");
    await page.close();
  }
});

// In the header and above the terms; the entry that is marked in the matrix.
async function shownRoles(page: Page) {
  await settle(page);
  const header = await text(page, "#decided");
  const terms = await text(page, ".mind .terms h3");
  const marked = await page.locator(".mind td[aria-selected]").getAttribute("aria-label");
  return { header, terms, marked };
}

test("the terms shown are those of the role held, whatever the way to the moment", async () => {
  const file = join(folder, "terms.mcap");
  writeFileSync(file, await recording());
  const { page } = await open(`${pageOf(file, "terms")}#t=15&robot=home/2`);
  const checked = async (robot: number, role: string) => {
    const { header, terms, marked } = await shownRoles(page);
    assert.match(header, new RegExp(`^${role} since`));
    assert.equal(terms.replace(/, \d+\.\d s old$/, ""), `robot ${robot} as ${role}`);
    assert.match(marked!, new RegExp(`^robot ${robot}, ${role}: .*, chosen$`));
  };
  // Every decision of robot 2, forwards and back; none of them pointed at.
  const decisions = (await messages(file)).get("/decision/home/2")!;
  const names = decisions.map((decision: Json) => roles[decision.role]!);
  assert.deepEqual(names, ["defender", "striker", "defender", "striker", "defender"]);
  assert.ok(decisions.every((decision: Json) => decision.role === rolesAt(decision.time)[0][1]));
  await checked(2, names[0]!);
  for (const name of names.slice(1)) {
    await page.keyboard.press(".");
    await checked(2, name);
  }
  for (const name of names.slice(0, -1).reverse()) {
    await page.keyboard.press(",");
    await checked(2, name);
  }
  // Jumps: the goal at 25 s, and a typed time.
  await page.keyboard.press("g");
  await checked(2, "defender");
  await page.fill("#time", "30.5");
  await page.press("#time", "Enter");
  await checked(2, "striker");
  await page.keyboard.press("3");
  await checked(3, "striker");
  await page.close();
});

test("an entry that is pointed at stays, until another one or another robot is, or it vanishes", async () => {
  // From 30 s on robot 2 computes nothing for the goalkeeper; from 40 s on robot 1 holds no role.
  const bytes = await recording({
    message: (topic, message) => {
      if (topic !== "/decision/home/2" || (message.time as number) < 29.9) return message;
      const tail = (rows: Json[]) => rows.map((row) => row.slice(1));
      const { columns, utility, terms } = message as Json;
      return { ...message, columns: columns.slice(1), utility: tail(utility), terms: terms.map(tail) };
    },
  });
  const { page } = await open(`${await synthetic("pointed", bytes)}#t=15&robot=home/2`);
  const terms = async () => (await shownRoles(page)).terms.replace(/, \d+\.\d s old$/, "");
  const cell = (row: number, column: number) =>
    page.locator(".mind table.matrix tbody tr").nth(row).locator("td").nth(column);
  await settle(page);
  await cell(0, 0).hover();
  assert.equal(await terms(), "robot 1 as goalkeeper");
  await page.keyboard.press(".");
  assert.match((await shownRoles(page)).header, /^striker since/);
  assert.equal(await terms(), "robot 1 as goalkeeper", "it stays");
  await cell(2, 1).hover();
  assert.equal(await terms(), "robot 3 as striker", "until another one is pointed at");
  await cell(1, 0).hover();
  await page.mouse.move(5, 5);
  await page.keyboard.press("3");
  await page.keyboard.press("2");
  assert.equal(await terms(), "robot 2 as striker", "another robot");
  await cell(0, 0).hover();
  await page.fill("#time", "30.2");
  await page.press("#time", "Enter");
  assert.equal(await terms(), "robot 2 as striker", "it has vanished, and the pointer rests upon another");
  await page.fill("#time", "15");
  await page.press("#time", "Enter");
  assert.equal(await terms(), "robot 2 as defender", "it does not come back");
  // With the keyboard.
  await cell(0, 0).focus();
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("ArrowRight");
  assert.equal(await terms(), "robot 2 as striker");
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.fill("#time", "40.5");
  await page.press("#time", "Enter");
  await page.keyboard.press("1");
  const { header, terms: none } = await shownRoles(page);
  assert.match(header, /^none; /);
  assert.match(none, /^robot 1 holds no role; shown: its best entry, as goalkeeper/);
  await page.close();
});

test("goals, role overlaps and lines lead to their moments, by a click and by the keyboard", async () => {
  const bytes = await recording({
    plugins: true,
    message: (topic, message) =>
      topic === "/event" && message.event === "kick_off"
        ? { ...message, event: "goal", side: "away", robot: 2, score: [0, 1] }
        : message,
  });
  const { page, complaints } = await open(`${await synthetic("lists", bytes)}#t=5`);
  // The row of this place by a click, the next one by the keyboard.
  const leads = async (key: string, list: string, place: number, expected: [string, string]) => {
    await page.keyboard.press(key);
    await settle(page);
    const buttons = page.locator(`${list} tbody button`);
    await buttons.nth(place).click();
    await settle(page);
    assert.equal(await shownTime(page), expected[0]);
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    await page.keyboard.press(key);
    await settle(page);
    await buttons.filter({ hasText: expected[0] }).first().focus();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Enter");
    await settle(page);
    assert.equal(await shownTime(page), expected[1]);
  };
  await leads("q", "#goal-list", 0, ["0:10.0", "0:25.0"]);
  assert.deepEqual(
    (await page.locator("#goal-list tbody tr").allInnerTexts()).map((row) =>
      row.split("\t").map((part) => part.trim()),
    ),
    [
      ["0:10.0", "goal", "red 2", "0 : 1"],
      ["0:25.0", "goal", "blue 3", "1 : 0"],
    ],
  );
  assert.equal(await text(page, "#goals-count"), "blue 1, red 1");
  assert.match(await text(page, "#goal-list tr[aria-current]"), /^0:25\.0/);
  await page.selectOption("#goals-kind", "all");
  assert.equal(await page.locator("#goal-list tbody tr").count(), 5);
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await leads("o", "#list", 0, ["0:20.0", "0:30.0"]);
  await page.keyboard.press("Escape");
  // Lines come anew with the moment; the focus goes along.
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await page.keyboard.press("k");
  await page.selectOption("#log-level", "warning");
  await page.evaluate(() => (document.activeElement as HTMLElement).blur());
  await leads("k", "#log", 0, ["0:12.5", "0:20.0"]);
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await settle(page);
  assert.equal(await shownTime(page), "0:20.1", "the focus has stayed in the list");
  assert.deepEqual(complaints, []);
  await page.close();
});

test("a match without goals says so, and the page has one word for a role that several hold", async () => {
  const bytes = await recording({ message: (_, m) => (m.event === "goal" ? undefined : m) });
  const { page } = await open(await synthetic("no goals listed", bytes));
  await page.keyboard.press("q");
  await settle(page);
  assert.equal(await text(page, "#goal-list tbody"), "No goal");
  const words = await page.evaluate(() => {
    const titles = [...document.querySelectorAll("#viewer [title], #help [title]")].map((each) =>
      each.getAttribute("title"),
    );
    return `${document.getElementById("viewer")!.textContent} ${document.getElementById("help")!.textContent} ${titles}`;
  });
  assert.doesNotMatch(words, /held twice|holds? .* twice/i);
  for (const [around] of words.matchAll(/.{8}overlap/gi)) assert.match(around, /role.overlap$/i);
  assert.ok([...words.matchAll(/role.overlap/gi)].length > 8);
  await page.close();
});
