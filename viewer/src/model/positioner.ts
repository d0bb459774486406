// SPDX-License-Identifier: MIT
// What a team's positioner computed, in the words of who reads the page: the name of the choice by which it is drawn.
import type { Side } from "../recording/about";
import { WrongForm } from "../recording/checked";
import type { Match } from "../recording/match";

// Of a plugin's points with the edges between them, and of its points alone. A recording need not hold edges:
// delaunay_formation gives places and keeps its triangulation to itself.
const known: Readonly<Record<string, { edges: string; points: string }>> = {
  voronoi: { edges: "Voronoi cells", points: "Voronoi nodes" },
  voronoi_cells: { edges: "Voronoi cells", points: "Voronoi points" },
  delaunay_formation: { edges: "Delaunay edges", points: "Delaunay places" },
};

export const computedName = (plugin: string, hasEdges: boolean): string =>
  known[plugin]?.[hasEdges ? "edges" : "points"] ?? plugin;

const mostRead = 12; // decisions of a robot, evenly over the match

function hasEdges(match: Match, side: Side, plugin: string): boolean {
  const { contexts } = match.about.teams[side];
  for (const log of match.decisions[side]) {
    for (let i = 0; i < Math.min(mostRead, log.length); ++i) {
      try {
        const { context, edges } = log.at(Math.floor((i * log.length) / mostRead));
        if (edges.length > 0 && contexts[context]?.positioner === plugin) return true;
      } catch (error) {
        if (!(error instanceof WrongForm)) throw error;
      }
    }
  }
  return false;
}

// Of all contexts of a team, each name once; none where no context has a positioner.
export function computedNames(match: Match, side: Side): string[] {
  const plugins = new Set(match.about.teams[side].contexts.map((context) => context.positioner));
  plugins.delete("");
  return [...new Set([...plugins].map((plugin) => computedName(plugin, hasEdges(match, side, plugin))))];
}
