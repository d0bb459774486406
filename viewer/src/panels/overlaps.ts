// SPDX-License-Identifier: MIT
// The list of role overlaps, stretches in which two robots or more held one role, and of uncovered roles, to jump to. Those of a second or more come first;
// the shorter ones are folded, with their number.
import { roleName } from "../model/look";
import { type Stretch, type StretchOrder, groupedStretches, longSeconds } from "../model/roles";
import { fixed } from "../model/text";
import { type Side, bothSides, sideNames } from "../recording/about";
import { lastNotAfter } from "../recording/log";
import type { Match } from "../recording/match";
import { element, heading, named, numeric, row, setText, titleOf } from "./elements";
import { jumpFrom, reveal, timeCell } from "./jump_list";

type Kind = "overlaps" | "uncovered";

const mostRows = 2000;

const lengthOf = (stretches: readonly Stretch[]): string =>
  `${fixed(stretches.reduce((total, stretch) => total + stretch.samples, 0) / 10, 1)} s`;

const group = (content: string) =>
  element("tbody", { class: "group" }, element("tr", {}, element("th", { colspan: "5", scope: "rowgroup" }, content)));

export class OverlapList {
  // Those that are unfolded, in the order of time: what the jumps go along.
  private shown: Stretch[] = [];
  private begins: number[] = [];
  private listed: Stretch[] = []; // in the order of the list
  private unfolded = false; // the short ones are listed too
  chosen: Stretch | null = null; // that a jump led to
  private rows: HTMLTableRowElement[] = [];
  private marked: HTMLTableRowElement | null = null;
  private readonly table = element("table", { class: "list", id: "list" });
  private readonly fold = element("button", {
    class: "link",
    type: "button",
    id: "list-short",
    "aria-controls": "list",
  });
  private readonly kind = element("select", { "aria-label": "What is listed", id: "list-kind" });
  private readonly side = element("select", { "aria-label": "Team", id: "list-side" });
  private readonly role = element("select", { "aria-label": "Role", id: "list-role" });
  private readonly least = element("select", { "aria-label": "Least length", id: "list-least" });
  private readonly order = element("select", { "aria-label": "Order", id: "list-order" });
  private readonly count = element("span", { class: "muted", id: "list-count" });

  constructor(
    private readonly box: HTMLElement,
    private readonly match: Match,
    private readonly jump: (stretch: Stretch) => void,
  ) {
    const option = (select: HTMLSelectElement, value: string, text: string) =>
      select.append(element("option", { value }, text));
    option(this.kind, "overlaps", "role overlaps");
    option(this.kind, "uncovered", "uncovered roles");
    option(this.side, "", "both teams");
    for (const side of bothSides)
      option(this.side, String(side), `${match.about.teams[side].name} (${sideNames[side]})`);
    for (const seconds of ["0.1", "0.3", "0.5", "1", "2", "5"]) option(this.least, seconds, `at least ${seconds} s`);
    option(this.order, "time", "by time");
    option(this.order, "length", "longest first");
    for (const select of this.selects) {
      select.addEventListener("change", () => {
        if (select === this.side) this.fillRoles();
        this.fill();
      });
    }
    this.fold.addEventListener("click", () => this.unfold());
    this.box.append(
      element("div", { class: "filters" }, ...this.selects, this.count, this.fold),
      element("div", { class: "scroll" }, this.table),
    );
    jumpFrom(this.table, (found) => this.jump(this.listed[this.rows.indexOf(found)]!));
    this.fillRoles();
    this.fill();
  }

  private get selects(): HTMLSelectElement[] {
    return [this.kind, this.side, this.role, this.least, this.order];
  }

  private fillRoles(): void {
    const sides: readonly Side[] = this.side.value === "" ? bothSides : [Number(this.side.value) as Side];
    const names = new Set(sides.flatMap((side) => this.match.about.teams[side].roles.map((role) => role.name)));
    const before = this.role.value;
    this.role.replaceChildren(element("option", { value: "" }, "all roles"));
    for (const name of names) this.role.append(element("option", { value: `=${name}` }, name));
    this.role.value = names.has(before.slice(1)) ? before : "";
  }

  private fill(): void {
    const kind = this.kind.value as Kind;
    const samples = Math.round(Number(this.least.value) * 10);
    const all = bothSides.flatMap((side) =>
      this.side.value === "" || this.side.value === String(side) ? this.match.courses[side][kind] : [],
    );
    const wanted = all
      .filter((stretch) => stretch.samples >= samples)
      .filter(
        (stretch) =>
          this.role.value === "" || `=${roleName(this.match, stretch.side, stretch.role)}` === this.role.value,
      );
    const { long, short } = groupedStretches(wanted, this.order.value as StretchOrder);
    // Where there is no long one, the short ones are all there is.
    const open = this.unfolded || long.length === 0;
    const unfolded = open ? [...long, ...short] : long;
    this.shown = [...unfolded].sort((a, b) => a.from - b.from);
    this.begins = this.shown.map((stretch) => stretch.from);
    this.listed = unfolded.slice(0, mostRows);
    this.rows = this.listed.map((stretch) => this.rowOf(stretch));
    const order = this.order.value === "length" ? "longest first" : "by time";
    const groups: HTMLElement[] = [heading(["from", "#length", "role", "robots", "team"])];
    if (long.length > 0) {
      groups.push(group(`${longSeconds} s or longer: ${long.length}, ${order}`));
      groups.push(element("tbody", { class: "stretches" }, ...this.rows.slice(0, long.length)));
    }
    if (open && short.length > 0) {
      groups.push(group(`shorter than ${longSeconds} s: ${short.length}, ${order}`));
      groups.push(element("tbody", { class: "stretches" }, ...this.rows.slice(long.length)));
    }
    this.table.replaceChildren(...groups);
    this.fold.hidden = long.length === 0 || short.length === 0;
    setText(this.fold, `${open ? "hide" : "show"} ${short.length} shorter than ${longSeconds} s (${lengthOf(short)})`);
    this.fold.setAttribute("aria-expanded", String(open));
    const left = unfolded.length > mostRows ? `, the first ${mostRows} listed` : "";
    this.count.textContent = `${wanted.length} stretches, ${lengthOf(wanted)}${left}`;
    for (const select of this.selects) titleOf(select);
    this.marked = null;
  }

  private rowOf(stretch: Stretch): HTMLTableRowElement {
    const team = named(this.match.about.teams[stretch.side].name);
    team.prepend(element("span", { class: `mark ${sideNames[stretch.side]}`, "aria-hidden": "true" }));
    return row([
      timeCell(stretch.from),
      numeric(`${fixed(stretch.samples / 10, 1)} s`),
      named(roleName(this.match, stretch.side, stretch.role)),
      stretch.robots.length > 0 ? stretch.robots.join("  ") : "none",
      team,
    ]);
  }

  // The short ones are listed, or hidden again.
  private unfold(): void {
    this.unfolded = !this.unfolded;
    this.fill();
    if (this.unfolded) reveal(this.table.querySelector<HTMLElement>(".group:nth-last-child(2) tr"), "center");
  }

  // The stretches that are unfolded now, by time.
  get stretches(): readonly Stretch[] {
    return this.shown;
  }

  // Marks the row of the stretch that was jumped to, or of the last one that began before `time`.
  update(time: number, scroll: boolean): void {
    const chosen = this.chosen;
    const holds = chosen !== null && time > chosen.from - 1e-6 && time <= chosen.to && this.shown.includes(chosen);
    const at = holds ? chosen : this.shown[lastNotAfter(this.begins, time + 1e-6)];
    const now = at !== undefined && time <= at.to ? (this.rows[this.listed.indexOf(at)] ?? null) : null;
    if (now === this.marked) return;
    this.marked?.removeAttribute("aria-current");
    now?.setAttribute("aria-current", "true");
    this.marked = now;
    if (scroll) reveal(now, "nearest");
  }
}
