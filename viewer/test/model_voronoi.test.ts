// SPDX-License-Identifier: MIT
// Voronoi cells against brute force, Delaunay edges against the empty circle, the sites against the script of the
// recording. page_voronoi.test.ts holds them against the nodes of the positioner itself.
import assert from "node:assert/strict";
import { test } from "node:test";

import { sitesOf } from "../src/model/positioner";
import { delaunayEdges, voronoiCells } from "../src/model/voronoi";
import { readMatch } from "../src/recording/match";
import type { Point } from "../src/recording/messages";
import { metadata, recording } from "./synthetic";

const [halfX, halfY] = [4.5, 3];

// A generator of chance, written out: the same sites each time.
function chances(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

const between = ([x, y]: Point, [otherX, otherY]: Point) => Math.hypot(x - otherX, y - otherY);

// Anticlockwise corners: inside is left of every side.
const inside = (cell: readonly Point[], [x, y]: Point) =>
  cell.length > 2 &&
  cell.every(([x0, y0], i) => {
    const [x1, y1] = cell[(i + 1) % cell.length]!;
    return (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) >= 0;
  });

const areaOf = (cell: readonly Point[]) =>
  cell.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = cell[(i + 1) % cell.length]!;
    return sum + (x * nextY - nextX * y) / 2;
  }, 0);

function chosenSites(count: number, seed: number): Point[] {
  const chance = chances(seed);
  // Some beyond the lines, as opponents may be.
  return Array.from({ length: count }, (): Point => [11 * (chance() - 0.5), 8 * (chance() - 0.5)]);
}

test("each point of the field lies in the cell of its nearest site, and in no other", () => {
  for (const [round, count] of [1, 2, 3, 7, 11, 20].entries()) {
    const sites = chosenSites(count, 11 + round);
    const cells = voronoiCells(sites, halfX, halfY);
    const chance = chances(97 + round);
    let seen = 0;
    for (let i = 0; i < 4000; ++i) {
      const point: Point = [2 * halfX * (chance() - 0.5), 2 * halfY * (chance() - 0.5)];
      const distances = sites.map((site) => between(site, point));
      const nearest = Math.min(...distances);
      if (distances.filter((distance) => distance < nearest + 1e-9).length > 1) continue; // upon a side
      ++seen;
      for (const [k, cell] of cells.entries())
        assert.equal(inside(cell, point), distances[k] === nearest, `${count} sites, ${point}, cell ${k}`);
    }
    assert.ok(seen > 3900);
    const area = cells.map(areaOf).reduce((sum, each) => sum + each, 0);
    assert.ok(Math.abs(area - 4 * halfX * halfY) < 1e-9, "the cells fill the field");
  }
});

test("two sites are joined where a circle through both holds no other site", () => {
  for (const seed of [3, 5, 8]) {
    const sites = chosenSites(9, seed);
    // Brute force: some triangle of both and a third has an empty circle.
    const expected: string[] = [];
    for (let i = 0; i < sites.length; ++i) {
      for (let j = i + 1; j < sites.length; ++j) {
        const joined = sites.some((third, k) => {
          if (k === i || k === j) return false;
          const [[ax, ay], [bx, by], [cx, cy]] = [sites[i]!, sites[j]!, third];
          const twice = 2 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by));
          const [a2, b2, c2] = [ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy];
          const x = (a2 * (by - cy) + b2 * (cy - ay) + c2 * (ay - by)) / twice;
          const y = (a2 * (cx - bx) + b2 * (ax - cx) + c2 * (bx - ax)) / twice;
          const radius = between([x, y], third);
          return sites.every((site, m) => m === i || m === j || m === k || between([x, y], site) > radius);
        });
        if (joined) expected.push(`${i} ${j}`);
      }
    }
    assert.deepEqual(
      delaunayEdges(sites).map((edge) => edge.join(" ")),
      expected,
    );
  }
  // Four on one circle: the sides of the square, and no diagonal or one.
  const square: Point[] = [
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
  ];
  assert.deepEqual(delaunayEdges(square), [
    [0, 1],
    [0, 3],
    [1, 2],
    [2, 3],
  ]);
  assert.deepEqual(delaunayEdges([[0, 0]]), []);
});

test("the sites are those of the positioner: opponents and fixed ones, or the own team", async () => {
  const match = await readMatch(await recording());
  const decision = match.decisions[0][1]!.at(0);
  const posts = [
    [4.5, -0.8],
    [4.5, 0.8],
  ];
  const corners = [
    [-4.5, -3],
    [-4.5, 3],
    [4.5, -3],
    [4.5, 3],
  ];
  const halfway = [
    [0, -3],
    [0, 3],
  ];
  assert.deepEqual(sitesOf(match, 0, 2, decision), [[2, 0], ...corners, ...halfway, ...posts]);
  // The other team attacks the other goal.
  assert.deepEqual(sitesOf(match, 1, 1, match.decisions[1][0]!.at(0))!.slice(-1), [[-4.5, 0.8]]);
  const pairs = metadata();
  const home = JSON.parse(pairs.home!);
  home.contexts[1].positioner = "voronoi_cells";
  const team = await readMatch(await recording({ metadata: { home: JSON.stringify(home) } }));
  const sites = sitesOf(team, 0, 2, team.decisions[0][1]!.at(0))!;
  assert.equal(sites.length, 3, "all three are active");
  home.contexts[1].positioner = "delaunay_formation";
  const none = await readMatch(await recording({ metadata: { home: JSON.stringify(home) } }));
  assert.equal(sitesOf(none, 0, 2, none.decisions[0][1]!.at(0)), null);
});
