// SPDX-License-Identifier: MIT
// What the reader of the page looks at: the moment, the chosen robot, the pair compared, what is drawn.
import type { Pair } from "../model/compare";
import type { Knowledge } from "../model/look";
import type { Side } from "../recording/about";

export interface Robot {
  side: Side;
  number: number;
}

export const panelNames = [
  "overlaps",
  "robot",
  "compare",
  "goals",
  "plays",
  "ball",
  "segments",
  "log",
  "match",
] as const;
export type PanelName = (typeof panelNames)[number];

// The last three are of the positioner, and drawn only when wanted: the points that it gave with their edges, the cells
// of its Voronoi diagram, and the edges of the dual.
export const layerNames = ["belief", "ellipses", "tasks", "trails", "nodes", "cells", "delaunay"] as const;
export type LayerName = (typeof layerNames)[number];

// Heat maps: of what, and over which stretch of the match. "window": what the timeline shows.
export const heatWhats = ["ball", "home", "away", "robot"] as const;
export type HeatWhat = (typeof heatWhats)[number];
export const heatStretches = ["match", "first", "second", "window"] as const;
export type HeatStretch = (typeof heatStretches)[number];

export const speeds = [0.25, 0.5, 1, 2, 4, 8, 16] as const;

export interface View {
  time: number;
  playing: boolean;
  speed: number;
  robot: Robot | null;
  side: Side; // whose robots the timeline shows
  pair: Pair | null;
  panel: PanelName;
  knowledge: Knowledge;
  follow: boolean; // the field follows the chosen robot, or the ball
  layers: Record<LayerName, boolean>;
  heat: HeatWhat | null;
  heatStretch: HeatStretch;
  drawings: readonly number[]; // layers of plugins, as places in the recording's, ascending
}

export class State {
  view: View = {
    time: 0,
    playing: false,
    speed: 1,
    robot: null,
    side: 0,
    pair: null,
    panel: "overlaps",
    knowledge: "decided",
    follow: false,
    layers: { belief: true, ellipses: true, tasks: true, trails: true, nodes: false, cells: false, delaunay: false },
    heat: null,
    heatStretch: "match",
    drawings: [],
  };
  private readonly listeners: ((changed: ReadonlySet<keyof View>) => void)[] = [];

  constructor(
    readonly begin: number,
    readonly end: number,
  ) {
    this.view.time = begin;
  }

  listen(listener: (changed: ReadonlySet<keyof View>) => void): void {
    this.listeners.push(listener);
  }

  set(change: Partial<View>): void {
    if (change.time !== undefined) change.time = Math.min(this.end, Math.max(this.begin, change.time));
    // The same robot chosen again is no other one.
    const { robot } = this.view;
    if (robot !== null && change.robot?.side === robot.side && change.robot.number === robot.number)
      change.robot = robot;
    const changed = new Set<keyof View>();
    for (const key of Object.keys(change) as (keyof View)[]) if (this.view[key] !== change[key]) changed.add(key);
    if (changed.size === 0) return;
    this.view = { ...this.view, ...change };
    for (const listener of this.listeners) listener(changed);
  }

  // Something that is no part of the view has changed: draw again.
  touch(): void {
    for (const listener of this.listeners) listener(new Set());
  }

  choose(robot: Robot | null): void {
    this.set(robot === null ? { robot } : { robot, side: robot.side });
  }

  toggle(layer: LayerName): void {
    this.set({ layers: { ...this.view.layers, [layer]: !this.view.layers[layer] } });
  }

  toggleDrawing(layer: number): void {
    const { drawings } = this.view;
    const without = drawings.filter((other) => other !== layer);
    const added = [...drawings, layer].sort((a, b) => a - b);
    this.set({ drawings: without.length < drawings.length ? without : added });
  }
}
