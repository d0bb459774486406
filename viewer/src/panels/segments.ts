// SPDX-License-Identifier: MIT
// What plugins say to their counterparts in teammates, around the moment: which bytes were offered, what became of
// them, and who heard them. What has not happened yet stands there in grey.
import { around } from "../recording/log";
import { type Reach, type Segment, reachOf, spacedBytes } from "../model/segments";
import { shortened, timeText, words } from "../model/text";
import { bothSides, sideNames } from "../recording/about";
import type { Match } from "../recording/match";
import { element, heading, named, row, titleOf } from "./elements";
import { jumpFrom, replaceRows, timeCell } from "./jump_list";

const rowsBefore = 40;
const rowsAfter = 10;
const mostLetters = 90; // of what a segment says

const fates = {
  "": "all segments",
  sent: "sent",
  lost: "sent, not heard by all",
  dropped: "dropped",
  refused: "refused",
};

export class SegmentPanel {
  private readonly side = element("select", { "aria-label": "Team", id: "segment-side" });
  private readonly robot = element("select", { "aria-label": "Who offered it", id: "segment-robot" });
  private readonly plugin = element("select", { "aria-label": "Plugin", id: "segment-plugin" });
  private readonly fate = element("select", { "aria-label": "What became of it", id: "segment-fate" });
  private readonly count = element("span", { class: "muted", id: "segment-count" });
  private readonly body = element("tbody");
  private readonly reaches = new Map<Segment, Reach>();
  private listed: Segment[] = [];
  private froms: number[] = [];
  private drawn = ""; // what the rows were made of
  private time = 0; // that they were made for

  constructor(
    box: HTMLElement,
    private readonly match: Match,
    jump: (time: number) => void,
  ) {
    const option = (select: HTMLSelectElement, value: string, text: string) =>
      select.append(element("option", { value }, text));
    const { all } = match.segments;
    option(this.side, "", "both teams");
    for (const side of bothSides)
      option(this.side, String(side), `${match.about.teams[side].name} (${sideNames[side]})`);
    option(this.robot, "", "all robots");
    for (const number of [...new Set(all.map((each) => each.robot))].sort((a, b) => a - b))
      option(this.robot, String(number), `robot ${number}`);
    option(this.plugin, "", "all plugins");
    for (const plugin of [...new Set(all.map((each) => each.plugin))].sort()) option(this.plugin, `=${plugin}`, plugin);
    for (const [value, text] of Object.entries(fates)) option(this.fate, value, text);
    for (const select of this.selects)
      select.addEventListener("change", () => {
        this.fill();
        this.update(this.time);
      });
    const heads = heading(["offered", "robot", "plugin", "says", "then", "heard by"]);
    const table = element("table", { class: "list tight", id: "segments" }, heads, this.body);
    box.append(
      element("div", { class: "filters" }, ...this.selects, this.count),
      element("div", { class: "scroll" }, table),
    );
    jumpFrom(table, ({ dataset }) => jump(Number(dataset.time)));
    this.fill();
  }

  private get selects(): HTMLSelectElement[] {
    return [this.side, this.robot, this.plugin, this.fate];
  }

  private fill(): void {
    const [side, robot, plugin, fate] = this.selects.map(({ value }) => value) as [string, string, string, string];
    this.listed = this.match.segments.all.filter(
      (each) =>
        (side === "" || side === String(each.side)) &&
        (robot === "" || robot === String(each.robot)) &&
        (plugin === "" || plugin === `=${each.plugin}`) &&
        (fate === "" || fate === each.fate || (fate === "lost" && this.isLost(each))),
    );
    this.froms = this.listed.map(({ from }) => from);
    const sums = (["sent", "dropped", "refused"] as const).map(
      (name) => `${this.listed.filter((each) => each.fate === name).length} ${name}`,
    );
    this.count.textContent = `${this.listed.length}: ${sums.join(", ")}`;
    for (const select of this.selects) titleOf(select);
    this.drawn = "";
  }

  private reach(segment: Segment): Reach {
    let reach = this.reaches.get(segment);
    if (reach === undefined) {
      reach = reachOf(segment, this.match.packets, this.match.game.sizes[segment.side]);
      this.reaches.set(segment, reach);
    }
    return reach;
  }

  private isLost(segment: Segment): boolean {
    const { lost, undelivered } = this.reach(segment);
    return segment.fate === "sent" && (!segment.left || lost.length > 0 || undelivered.length > 0);
  }

  update(time: number): void {
    this.time = time;
    const { shown, last } = around(this.listed, this.froms, time, rowsBefore, rowsAfter);
    const now = time + 1e-9;
    const happened = shown.map((each) =>
      [each.from <= now, each.at <= now, each.heard.filter((hearing) => hearing.time <= now).length].join(),
    );
    const drawn = `${shown[0]?.from} ${this.listed.length} ${happened.join(" ")}`;
    if (drawn === this.drawn && this.body.childElementCount > 0) return;
    this.drawn = drawn;
    const rows = shown.map((segment) => this.rowOf(segment, now));
    const current = last === null ? null : (rows[shown.indexOf(last)] ?? null);
    replaceRows(this.body, rows, current, "No such segment");
  }

  private rowOf(segment: Segment, now: number): HTMLTableRowElement {
    const { side, robot, from, plugin, place } = segment;
    const later = (time: number) => (time <= now ? "" : "muted");
    const team = this.match.about.teams[side].name;
    const who = element(
      "td",
      { title: `${team} ${robot}` },
      element("span", { class: `mark ${sideNames[side]}`, "aria-hidden": "true" }),
      String(robot),
    );
    const then = element("td", { class: later(segment.at), title: this.fateTitle(segment) }, fateText(segment));
    return row(
      [
        timeCell(from),
        who,
        named(plugin, {}, `${plugin}, place ${place}`),
        this.says(segment),
        then,
        this.heardBy(segment, now),
      ],
      {
        class: later(from),
        "data-time": String(from),
        "data-segment": `${sideNames[side]}/${robot}/${segment.handle}`,
      },
    );
  }

  private says({ text, bytes, length }: Segment): HTMLTableCellElement {
    const spaced = spacedBytes(bytes);
    const size = length === null ? "its offer is not recorded" : `${length} bytes`;
    const title = [text, spaced, size].filter((part) => part !== "").join("\n");
    if (text !== "") return named(shortened(text, mostLetters), { dir: "auto" }, title);
    if (spaced === "") return named(size, { class: "muted" }, title);
    return named(shortened(spaced, mostLetters), { class: "bytes" }, title);
  }

  private heardBy(segment: Segment, now: number): HTMLTableCellElement {
    const cell = element("td", { class: "name" });
    if (segment.fate !== "sent") return cell;
    const { heard, undelivered, lost } = this.reach(segment);
    const part = (title: string, text: string, later: boolean, warn = false) =>
      cell.append(element("span", { title, class: `${later ? "muted" : ""} ${warn ? "warn" : ""}`.trim() }, text), " ");
    for (const { robot, time } of heard)
      part(`robot ${robot} heard it at ${timeText(time, 2)}`, `${robot}`, time > now);
    for (const { robot, time, why } of undelivered)
      part(`came to robot ${robot} at ${timeText(time, 2)}`, `${robot}: ${words(why)}`, time > now, true);
    if (!segment.left) part("its radio was silent, or it may not send", "the packet never left", false, true);
    else if (lost.length > 0) part("the radio lost their packets", `lost: ${lost.join(" ")}`, segment.at > now, true);
    else if (heard.length + undelivered.length === 0) part("", "nobody yet", false);
    return cell;
  }

  private fateTitle({ urgency, expires, by }: Segment): string {
    const parts = [];
    if (urgency !== null) parts.push(`urgency ${urgency}`);
    if (expires !== null) parts.push(`expires at ${timeText(expires, 2)}`);
    if (by !== 0) parts.push(`replaced by offer ${by}`);
    return parts.join(", ");
  }
}

// "sent 0:12.3", "replaced 0:12.3", "refused: too long", "pending"
function fateText({ fate, at, why }: Segment): string {
  if (fate === "pending") return "pending";
  if (fate === "refused") return `refused: ${words(why)}`;
  return `${fate === "sent" ? "sent" : words(why)} ${timeText(at)}`;
}

// Where nobody has said anything there is nothing to list.
export const hasSegments = (match: Match): boolean => match.segments.all.length > 0;
