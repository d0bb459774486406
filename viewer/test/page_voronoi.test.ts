// SPDX-License-Identifier: MIT
// What the positioner gave, its Voronoi cells and their Delaunay edges in a real browser; and, with REGISTA, the cells
// against the nodes that the positioner itself wrote into a recording.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { sitesOf } from "../src/model/positioner";
import { voronoiCells } from "../src/model/voronoi";
import { readMatch } from "../src/recording/match";
import type { Point } from "../src/recording/messages";
import { contrast, folder, open, pixels, placeOnField, settle, synthetic } from "./page_kit";
import { metadata, recording } from "./synthetic";

const program = process.env.REGISTA ?? "";
const between = ([x, y]: Point, [otherX, otherY]: Point) => Math.hypot(x - otherX, y - otherY);

test("nodes, Voronoi cells and Delaunay edges are choices, named after what they draw", async () => {
  const pairs = metadata();
  const away = JSON.parse(pairs.away!);
  away.contexts[1].positioner = "";
  const bytes = await recording({ metadata: { away: JSON.stringify(away) } });
  const { page } = await open(`${await synthetic("positioner", bytes)}#t=20.5&robot=home/2`);
  for (const layer of ["belief", "tasks", "trails"]) await page.click(`#layer-${layer}`);
  // Whether something is drawn within 5 px: at a node of the made-up decisions; on the bisector of the sites (2, 0),
  // which is an opponent, and (0, 3), an end of the halfway line; and between the two.
  const drawn = async (x: number, y: number) => {
    const place = await placeOnField(page, [x, y]);
    const around = await pixels(page, place.x, place.y, 5);
    const grass = (await pixels(page, place.x + 14, place.y + 14, 0))[0]![0]!;
    return around.flat().some((colour) => contrast(colour, grass) > 2);
  };
  const shown = async () => {
    await settle(page);
    return [await drawn(2, -1), await drawn(1.6, 1.9), await drawn(1.5, 0.75)];
  };
  const choices = [
    ["nodes", "Nodes, edges", "u"],
    ["cells", "Voronoi cells", "v"],
    ["delaunay", "Delaunay edges", "Shift+V"],
  ] as const;
  for (const [i, [layer, name, key]] of choices.entries()) {
    const choice = page.locator(`#layer-${layer}`);
    assert.deepEqual([await choice.textContent(), await choice.getAttribute("aria-pressed")], [name, "false"]);
    assert.deepEqual(await shown(), [false, false, false]);
    await choice.click();
    assert.deepEqual(
      await shown(),
      choices.map((_, j) => i === j),
      name,
    );
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    await page.keyboard.press(key);
    assert.equal(await choice.getAttribute("aria-pressed"), "false");
  }
  await page.keyboard.press("t");
  await settle(page);
  for (const [layer, name, key] of choices) {
    const choice = page.locator(`#layer-${layer}`);
    const text = layer === "nodes" ? "No positioner" : name;
    assert.deepEqual([await choice.textContent(), await choice.isDisabled()], [text, true]);
    await page.keyboard.press(key);
    assert.equal(await choice.getAttribute("aria-pressed"), "false", "no key for what is not there");
  }
  await page.close();
});

test(
  "the nodes that the positioner recorded are corners of these cells",
  { skip: program === "" && "REGISTA names no program" },
  async () => {
    const file = join(folder, "voronoi.mcap");
    const teams = ["paper", "fixed_rate"].map((name) => join("..", "configs", "teams", `${name}.yaml`));
    const alone = ["--set", "a.positioner.params={merge: 0, at_least: 0}", "--limit", "120", "--quiet"];
    execFileSync(program, ["match", ...teams, ...alone, "--record", file], { stdio: "ignore" });
    const match = await readMatch(new Uint8Array(readFileSync(file)));
    let seen = 0;
    for (const [robot, log] of match.decisions[0].entries()) {
      const beliefs = match.beliefs[0][robot]!;
      for (let i = 0; i < log.length; ++i) {
        const decision = log.at(i);
        // Only where the belief is of the decision's own moment, and nodes that were not moved to the field's edge.
        if (Math.abs(beliefs.times[beliefs.indexAt(decision.time + 1e-9)]! - decision.time) > 1e-6) continue;
        const sites = sitesOf(match, 0, robot + 1, decision);
        if (sites === null) continue;
        for (const [x, y] of decision.waypoints) {
          if (Math.abs(x) > 4.3 || Math.abs(y) > 2.8) continue;
          const corners = voronoiCells(sites, 4.5, 3).flat();
          const nearest = Math.min(...corners.map((corner) => between(corner, [x, y])));
          // Beliefs are written to the centimetre; a flat triangle carries that farther.
          const [third] = sites
            .map((site) => between(site, [x, y]))
            .sort((a, b) => a - b)
            .slice(2);
          const [first] = sites.map((site) => between(site, [x, y])).sort((a, b) => a - b);
          assert.ok(nearest < 0.05 || third! - first! < 0.03, `robot ${robot + 1} at ${decision.time}: ${x}, ${y}`);
          ++seen;
        }
      }
    }
    assert.ok(seen > 200, `${seen} nodes`);
  },
);
