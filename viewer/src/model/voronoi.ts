// SPDX-License-Identifier: MIT
// The Voronoi diagram of a few sites and its dual, the Delaunay triangulation (Aurenhammer, "Voronoi diagrams", ACM
// Computing Surveys 23, 1991). A cell is what remains of a rectangle once it is cut along the bisector with each other
// site; two sites are joined by a Delaunay edge where their cells share a side.
import type { Point } from "../recording/messages";

interface Corner {
  at: Point;
  beyond: number; // site beyond the side that begins here; -1: the rectangle ends
}

const shortestSide = 1e-9; // m; four sites on one circle meet in a point

// The part of the cell of site `i` that lies in the rectangle |x| <= halfX, |y| <= halfY, anticlockwise.
function cellOf(sites: readonly Point[], i: number, halfX: number, halfY: number): Corner[] {
  const rectangle: Point[] = [
    [-halfX, -halfY],
    [halfX, -halfY],
    [halfX, halfY],
    [-halfX, halfY],
  ];
  let corners: Corner[] = rectangle.map((at) => ({ at, beyond: -1 }));
  const [x, y] = sites[i]!;
  for (const [j, [otherX, otherY]] of sites.entries()) {
    const [dx, dy] = [otherX - x, otherY - y];
    if (dx === 0 && dy === 0) continue;
    // Negative on this side of the bisector, positive beyond it.
    const side = ([px, py]: Point) => (px - (x + otherX) / 2) * dx + (py - (y + otherY) / 2) * dy;
    const kept: Corner[] = [];
    for (const [k, corner] of corners.entries()) {
      const next = corners[(k + 1) % corners.length]!;
      const [here, there] = [side(corner.at), side(next.at)];
      const share = here / (here - there);
      const crossing = (): Point => [
        corner.at[0] + share * (next.at[0] - corner.at[0]),
        corner.at[1] + share * (next.at[1] - corner.at[1]),
      ];
      if (here <= 0) kept.push(corner);
      if (here <= 0 && there > 0) kept.push({ at: crossing(), beyond: j });
      if (here > 0 && there <= 0) kept.push({ at: crossing(), beyond: corner.beyond });
    }
    corners = kept;
  }
  return corners;
}

// Of each site its cell in the rectangle; empty where another site's cell covers it all.
export const voronoiCells = (sites: readonly Point[], halfX: number, halfY: number): Point[][] =>
  sites.map((_, i) => cellOf(sites, i, halfX, halfY).map(({ at }) => at));

// Pairs of sites, the lesser first. Cells may meet far away: outermost sites are joined, too.
export function delaunayEdges(sites: readonly Point[]): [number, number][] {
  const far = 1e4; // m
  return sites.flatMap((_, i) => {
    const corners = cellOf(sites, i, far, far);
    const beyond = corners
      .filter(({ at: [x, y] }, k) => {
        const [nextX, nextY] = corners[(k + 1) % corners.length]!.at;
        return Math.hypot(nextX - x, nextY - y) > shortestSide;
      })
      .map((corner) => corner.beyond);
    return [...new Set(beyond)]
      .filter((j) => j > i)
      .sort((a, b) => a - b)
      .map((j): [number, number] => [i, j]);
  });
}
