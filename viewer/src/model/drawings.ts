// SPDX-License-Identifier: MIT
// What plugins draw in the field, by layer and robot. A drawing replaces what the same plugin of the same robot drew in
// the same layer before, and stays until the next one; an empty one takes it away.
import { type Side, bothSides } from "../recording/about";
import { WrongForm } from "../recording/checked";
import type { Content } from "../recording/content";
import { Log } from "../recording/log";
import { type Shape, drawingHeadOf, shapesOf } from "../recording/plugin_messages";
import { timeText } from "./text";

export interface Layer {
  plugin: string;
  name: string;
}

export interface Drawer {
  side: Side;
  number: number;
}

export const layerText = ({ plugin, name }: Layer): string => `${plugin}: ${name}`;

// More than anybody chooses among; a plugin that names a layer anew at each decision would fill the page with them.
const mostLayers = 100;

const nothing: readonly Shape[] = [];
const { compare: byName } = new Intl.Collator("en", { numeric: true }); // "cell 2" before "cell 10"

export class Drawings {
  layers: Layer[] = []; // by plugin and name
  drawers: Drawer[] = []; // by side and number
  private readonly found = new Map<string, { layer: Layer; logs: Map<string, Log<Shape[]>> }>();
  private logs: Map<string, Log<Shape[]>>[] = []; // by layer, then by robot
  private readonly unreadable = new Set<string>();
  private firstFault = "";
  private tooMany = "";

  add(content: Content): void {
    const { time, side, robot, plugin, layer: name } = drawingHeadOf(content);
    const key = JSON.stringify([plugin, name]);
    let entry = this.found.get(key);
    if (entry === undefined) this.found.set(key, (entry = { layer: { plugin, name }, logs: new Map() }));
    const drawer = `${side}/${robot}`;
    let log = entry.logs.get(drawer);
    if (log === undefined) entry.logs.set(drawer, (log = new Log(shapesOf)));
    log.add(time, content);
  }

  close(): void {
    const entries = [...this.found.values()].sort(
      (a, b) => byName(a.layer.plugin, b.layer.plugin) || byName(a.layer.name, b.layer.name),
    );
    if (entries.length > mostLayers)
      this.tooMany = `Plugins drew in ${entries.length} layers; the first ${mostLayers} can be chosen.`;
    entries.splice(mostLayers);
    this.layers = entries.map(({ layer }) => layer);
    this.logs = entries.map(({ logs }) => logs);
    const numbers = (side: Side) =>
      [...new Set(this.logs.flatMap((logs) => [...logs.keys()]))]
        .filter((drawer) => drawer.startsWith(`${side}/`))
        .map((drawer) => Number(drawer.slice(2)))
        .sort((a, b) => a - b);
    this.drawers = bothSides.flatMap((side) => numbers(side).map((number) => ({ side, number })));
    this.found.clear();
  }

  // What stands in a layer (place in `layers`) by a robot at a moment. Of a drawing that cannot be read: nothing.
  at(layer: number, { side, number }: Drawer, time: number): readonly Shape[] {
    const log = this.logs[layer]?.get(`${side}/${number}`);
    const index = log?.indexAt(time + 1e-9) ?? -1;
    if (log === undefined || index < 0) return nothing;
    try {
      return log.at(index);
    } catch (error) {
      if (!(error instanceof WrongForm)) throw error;
      this.unreadable.add(`${layer} ${side}/${number} ${index}`);
      this.firstFault ||= `at ${timeText(log.times[index]!)}: ${error.message}`;
      return nothing;
    }
  }

  // Sentences, or empty: on layers that cannot be chosen, and on drawings that were looked at and cannot be read.
  get fault(): string {
    const { size } = this.unreadable;
    const drawings = `${size} ${size === 1 ? "drawing" : "drawings"}`;
    const unread = size === 0 ? "" : `${drawings} cannot be read, one ${this.firstFault}.`;
    return `${this.tooMany} ${unread}`.trim();
  }
}
