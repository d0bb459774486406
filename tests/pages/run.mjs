// SPDX-License-Identifier: MIT
// Measures the boxes of the pages of all studies in a browser:
//
//     node run.mjs PROGRAM SOURCE [--screenshots FOLDER]
//
// At the widths that screens have, light and dark, with everything unfolded, no text may lie over another one or be cut,
// nothing may stick out of the page, and every text must be legible. Status 77: there is no browser.
import { mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { faultsOfPage } from "./boxes.mjs";
import { browserOf } from "./browser.mjs";
import { playStudies } from "./studies.mjs";

// Phone, tablet, the usual screens: px.
const screens = [[390, 844], [768, 1024], [1366, 768], [1920, 1080]];
const most = 12; // faults of a page that are told

const [program, source, option, screenshots] = process.argv.slice(2);
if (source === undefined || (option !== undefined && (option !== "--screenshots" || screenshots === undefined))) {
  console.error("usage: node run.mjs PROGRAM SOURCE [--screenshots FOLDER]");
  process.exit(2);
}
const startBrowser = await browserOf(source);

const folder = mkdtempSync(join(tmpdir(), "regista-pages-"));
const browser = await startBrowser();
let all = 0;
try {
  const page = await browser.newPage();
  for (const { name, file, figures } of playStudies(program, source, folder)) {
    await page.goto(pathToFileURL(file).href);
    const faults = new Map(); // where each was seen
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme });
      for (const [width, height] of screens) {
        await page.setViewportSize({ width, height });
        for (const open of [true, false]) {
          await page.evaluate((all) => document.querySelectorAll("details").forEach((each) => (each.open = all)), open);
          const where = `${width} px ${colorScheme}${open ? " unfolded" : ""}`;
          for (const fault of await page.evaluate(faultsOfPage, { figures })) {
            faults.set(fault, [...(faults.get(fault) ?? []), where]);
          }
        }
        if (screenshots !== undefined) {
          mkdirSync(screenshots, { recursive: true });
          await page.screenshot({ path: join(screenshots, `${name}_${width}_${colorScheme}.png`), fullPage: true });
        }
      }
    }
    console.log(`${name}: ${faults.size === 0 ? "no faults" : `${faults.size} faults`}`);
    for (const [fault, where] of [...faults].slice(0, most)) {
      console.log(`  ${fault} (${where[0]}${where.length > 1 ? ` and ${where.length - 1} more` : ""})`);
    }
    all += faults.size;
  }
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
process.exit(all === 0 ? 0 : 1);
