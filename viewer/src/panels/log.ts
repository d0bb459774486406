// SPDX-License-Identifier: MIT
// What plugins wrote, around the moment: of the chosen robot, or, when none is chosen, of all robots. What has not
// happened yet stands there in grey; a click on a line leads to its moment.
import type { Robot, View } from "../app/state";
import { around } from "../recording/log";
import { chosenLines, sumText } from "../model/log_lines";
import { shortened } from "../model/text";
import { sideNames } from "../recording/about";
import type { Match } from "../recording/match";
import { type Level, type LogLine } from "../recording/plugin_messages";
import { element, heading, named, row, titleOf } from "./elements";
import { jumpFrom, replaceRows, timeCell } from "./jump_list";

const rowsBefore = 120; // robots decide at the same moment: many lines may be of one
const rowsAfter = 30;
const mostLetters = 400; // of a line

const leasts: Record<Level, string> = {
  debug: "all levels",
  info: "info and above",
  warning: "warnings and errors",
  error: "errors",
};

export class LogPanel {
  private readonly level = element("select", { "aria-label": "Least level", id: "log-level" });
  private readonly plugin = element("select", { "aria-label": "Plugin", id: "log-plugin" });
  private readonly count = element("span", { class: "muted", id: "log-count" });
  private readonly body = element("tbody");
  private robot: Robot | null = null;
  private listed: LogLine[] = [];
  private times: number[] = [];
  private drawn: { first: LogLine | undefined; last: LogLine | null } | null = null; // null: nothing of this list
  private time = 0; // that the rows were made for

  constructor(
    box: HTMLElement,
    private readonly match: Match,
    jump: (time: number) => void,
  ) {
    const option = (select: HTMLSelectElement, value: string, text: string) =>
      select.append(element("option", { value }, text));
    for (const [value, text] of Object.entries(leasts)) option(this.level, value, text);
    option(this.plugin, "", "all plugins");
    for (const plugin of [...new Set(match.lines.map((each) => each.plugin))].sort())
      option(this.plugin, `=${plugin}`, plugin);
    for (const select of [this.level, this.plugin])
      select.addEventListener("change", () => {
        this.fill();
        this.draw();
      });
    const heads = heading(["time", "robot", "plugin", "level", "line"]);
    const table = element("table", { class: "list tight", id: "log" }, heads, this.body);
    box.append(
      element("div", { class: "filters" }, this.level, this.plugin, this.count),
      element("div", { class: "scroll" }, table),
    );
    jumpFrom(table, ({ dataset }) => jump(Number(dataset.time)));
    this.fill();
  }

  private fill(): void {
    const { robot, match } = this;
    this.listed = chosenLines(match.lines, {
      robot,
      least: this.level.value as Level,
      plugin: this.plugin.value === "" ? null : this.plugin.value.slice(1),
    });
    this.times = this.listed.map(({ time }) => time);
    const of = robot === null ? "all robots" : `${match.about.teams[robot.side].name} ${robot.number}`;
    const text = `${sumText(this.listed)}; of ${of}`;
    this.count.textContent = text;
    this.count.title = text;
    for (const select of [this.level, this.plugin]) titleOf(select);
    this.drawn = null;
  }

  update({ time, robot }: View): void {
    this.time = time;
    if (robot?.side !== this.robot?.side || robot?.number !== this.robot?.number) {
      this.robot = robot;
      this.fill();
    }
    this.draw();
  }

  private draw(): void {
    const { shown, last } = around(this.listed, this.times, this.time, rowsBefore, rowsAfter);
    if (this.drawn !== null && this.drawn.first === shown[0] && this.drawn.last === last) return;
    this.drawn = { first: shown[0], last };
    const rows = shown.map((line) => this.rowOf(line));
    const current = last === null ? null : (rows[shown.indexOf(last)] ?? null);
    replaceRows(this.body, rows, current, "No such line");
  }

  private rowOf({ time, side, robot, plugin, level, text }: LogLine): HTMLTableRowElement {
    const team = this.match.about.teams[side].name;
    return row(
      [
        timeCell(time),
        element(
          "td",
          { title: `${team} ${robot}` },
          element("span", { class: `mark ${sideNames[side]}`, "aria-hidden": "true" }),
          String(robot),
        ),
        named(plugin),
        element("td", { class: `level ${level}` }, element("span", {}, level)),
        element("td", { class: "name", dir: "auto", title: text }, shortened(text, mostLetters)),
      ],
      { class: time <= this.time + 1e-9 ? "" : "muted", "data-time": String(time) },
    );
  }
}

// Where no plugin has written anything there is nothing to list.
export const hasLines = (match: Match): boolean => match.lines.length > 0;
