// SPDX-License-Identifier: MIT
// What a team's positioner computed, in the words of the page, and the sites of its Voronoi diagram. A recording holds
// the points that the positioner gave, and the edges that it kept between them; sites are those of the robot's belief.
import type { FieldSize, Side } from "../recording/about";
import { WrongForm } from "../recording/checked";
import type { Log } from "../recording/log";
import type { Match } from "../recording/match";
import type { Belief, Decision, Point } from "../recording/messages";
import { worldOf } from "./look";

// Of a plugin its points, its points with edges between them, and whose cells its diagram has. A recording need not
// hold edges: delaunay_formation gives places and keeps its triangulation to itself.
const known: Readonly<Record<string, { points: string; edges: string; sites: "opponents" | "team" | null }>> = {
  voronoi: { points: "Voronoi nodes", edges: "Nodes, edges", sites: "opponents" },
  voronoi_cells: { points: "Cell points", edges: "Points, edges", sites: "team" },
  delaunay_formation: { points: "Formation places", edges: "Places, edges", sites: null },
};
const of = (plugin: string) => (Object.hasOwn(known, plugin) ? known[plugin] : undefined);

export const pointsName = (plugin: string, hasEdges: boolean): string =>
  of(plugin)?.[hasEdges ? "edges" : "points"] ?? plugin;

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

// points: of all contexts of a team, each name once; none where no context has a positioner. diagram: some positioner
// has a Voronoi diagram.
export interface Computed {
  points: string[];
  diagram: boolean;
}

export function computedBy(match: Match, side: Side): Computed {
  const plugins = new Set(match.about.teams[side].contexts.map((context) => context.positioner));
  plugins.delete("");
  const points = [...plugins].map((plugin) => pointsName(plugin, hasEdges(match, side, plugin)));
  return { points: [...new Set(points)], diagram: [...plugins].some((plugin) => (of(plugin)?.sites ?? null) !== null) };
}

// The belief nearest in time: decisions and beliefs are not always recorded together.
function beliefNear(log: Log<Belief> | undefined, time: number): Belief | null {
  if (log === undefined || log.length === 0) return null;
  const at = Math.max(0, log.indexAt(time + 1e-9));
  const later = (log.times[at + 1] ?? Infinity) - time < Math.abs(time - log.times[at]!);
  try {
    return log.at(later ? at + 1 : at);
  } catch (error) {
    if (!(error instanceof WrongForm)) throw error;
    return null;
  }
}

// The sites of `voronoi` that are no robots, as it has them by default: the corners of the field, both ends of the halfway
// line and the posts of the goal that is attacked. Recordings do not say which of them a team left out.
function fixedSites({ length, width, goalWidth }: FieldSize, towards: 1 | -1): Point[] {
  const post = goalWidth / 2 + 0.05; // of a post 0.1 m thick; recordings do not say
  return [
    [-length / 2, -width / 2],
    [-length / 2, width / 2],
    [length / 2, -width / 2],
    [length / 2, width / 2],
    [0, -width / 2],
    [0, width / 2],
    [(towards * length) / 2, -post],
    [(towards * length) / 2, post],
  ];
}

// The sites of the diagram that a decision was taken on, each place once; null: its positioner has none.
export function sitesOf(match: Match, side: Side, number: number, decision: Decision): Point[] | null {
  const { field, teams } = match.about;
  const context = teams[side].contexts[decision.context];
  const kind = context === undefined ? null : (of(context.positioner)?.sites ?? null);
  const belief = beliefNear(match.beliefs[side][number - 1], decision.time);
  if (context === undefined || kind === null || belief === null) return null;
  const world = worldOf(belief, context.waypointsKnowledge === "common" ? "common" : "mine");
  const half = match.game.half[match.game.indexAt(decision.time)] ?? 1;
  const towards = (side === 0) === (half % 2 === 1) ? 1 : -1;
  const sites: Point[] =
    kind === "team"
      ? world.teammates.filter(({ active }) => active).map(({ pose: [x, y] }) => [x, y])
      : [
          ...world.opponents
            .map(({ at }) => at)
            .filter(([x, y]) => Math.abs(x) <= field.length / 2 && Math.abs(y) <= field.width / 2),
          ...fixedSites(field, towards),
        ];
  return [...new Map(sites.map((site) => [site.join(), site])).values()];
}
