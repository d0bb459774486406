// SPDX-License-Identifier: MIT
// At the widths of a phone, a tablet and usual screens, in light and dark, in every panel: no text lies over another, no
// text or control is cut, and nothing sticks out of the page or makes it scroll sideways. With REGISTA, which names the program, also in a match that was played.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { noteCanvasTexts, troubles } from "./boxes";
import { crowded, long, usual } from "./crowded";
import { startBrowser } from "./browser.mjs";
import { folder, pageOf, settle, synthetic } from "./page_kit";

// With the bars that a panel scrolls by: they take room.
let browser: Awaited<ReturnType<typeof startBrowser>>;
before(async () => {
  browser = await startBrowser({ ignoreDefaultArgs: ["--hide-scrollbars"] });
});
after(() => browser?.close());

const program = process.env.REGISTA ?? "";
const screens = [
  { width: 390, height: 844 },
  { width: 768, height: 1024 },
  { width: 1280, height: 720 },
  { width: 1366, height: 768 },
  { width: 1920, height: 1080 },
];
const panels = {
  ...{ o: "Role overlaps", r: "Robot", c: "Compare", q: "Goals", a: "Actions", f: "At the ball", s: "Segments" },
  ...{ k: "Log", m: "Match" },
  ...{ Drawings: "Drawings", Heat: "Heat map", "?": "Help" },
};

async function measure(address: string, wholeNames: boolean): Promise<string[]> {
  const page = await browser.newPage();
  await noteCanvasTexts(page);
  await page.goto(address);
  await page.waitForFunction(() => document.body.dataset.counted === "true");
  await page.keyboard.press("w"); // what plugins drew
  await page.keyboard.press("h");
  const found: string[] = [];
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    for (const screen of screens) {
      await page.setViewportSize(screen);
      for (const [key, panel] of Object.entries(panels)) {
        const isList = key === "Drawings" || key === "Heat"; // above its button
        const button = page.locator(`#${key.toLowerCase()}-open`);
        if (isList && !(await button.isVisible())) continue;
        if (isList) await button.click();
        else await page.keyboard.press(key);
        await settle(page);
        for (const trouble of await troubles(page, wholeNames))
          found.push(`${panel} at ${screen.width}, ${colorScheme}: ${trouble}`);
        if (key === "?" || isList) await page.keyboard.press("Escape");
      }
    }
  }
  await page.close();
  return found;
}

// The first of them, and how many there are in each panel.
function summary(found: readonly string[]): string {
  const counts = Object.values(panels).map(
    (panel) => `${panel} ${found.filter((line) => line.startsWith(`${panel} `)).length}`,
  );
  const most = Number(process.env.REGISTA_TROUBLES ?? 30);
  return `${found.length} troubles (${counts.join(", ")}):\n${found.slice(0, most).join("\n")}`;
}

test("usual names: nothing overlaps, and nothing is cut", async () => {
  const found = await measure(
    `${await synthetic("usual", await crowded(usual))}#t=42.5&robot=home/2&compare=home/2,3/1`,
    true,
  );
  assert.equal(found.length, 0, summary(found));
});

test("long names: nothing overlaps, and what is cut stands whole in its title", async () => {
  const found = await measure(
    `${await synthetic("long", await crowded(long))}#t=42.5&robot=home/2&compare=home/2,3/1`,
    false,
  );
  assert.equal(found.length, 0, summary(found));
});

test(
  "a match that was played: nothing overlaps, and nothing is cut",
  { skip: program === "" && "REGISTA names no program" },
  async () => {
    const file = join(folder, "boxes.mcap");
    const teams = ["paper", "fixed_rate"].map((name) => join("..", "configs", "teams", `${name}.yaml`));
    execFileSync(program, ["match", ...teams, "--limit", "150", "--record", file, "--quiet"]);
    const found = await measure(`${pageOf(file, "boxes")}#t=120&robot=home/3&compare=home/2,3/1`, true);
    assert.equal(found.length, 0, summary(found));
  },
);
