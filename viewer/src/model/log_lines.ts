// SPDX-License-Identifier: MIT
// Lines that plugins wrote: those that the reader of the page wants, and what they sum up to.
import { type Level, type LogLine, levels } from "../recording/plugin_messages";
import type { Drawer } from "./drawings";

export interface LineChoice {
  robot: Drawer | null; // null: all robots
  least: Level;
  plugin: string | null; // null: all plugins
}

// The order stays.
export function chosenLines(lines: readonly LogLine[], { robot, least, plugin }: LineChoice): LogLine[] {
  const wanted = new Set<Level>(levels.slice(levels.indexOf(least)));
  return lines.filter(
    (line) =>
      wanted.has(line.level) &&
      (robot === null || (line.robot === robot.number && line.side === robot.side)) &&
      (plugin === null || line.plugin === plugin),
  );
}

// "12 lines: 1 error, 2 warnings"
export function sumText(lines: readonly LogLine[]): string {
  const count = (level: Level) => lines.reduce((sum, line) => sum + (line.level === level ? 1 : 0), 0);
  const many = (number: number, what: string) => `${number} ${what}${number === 1 ? "" : "s"}`;
  return `${many(lines.length, "line")}: ${many(count("error"), "error")}, ${many(count("warning"), "warning")}`;
}
