// SPDX-License-Identifier: MIT
// The list of stretches in which a role was held twice, or by nobody, to jump to.
import { roleName } from "../model/look";
import type { Stretch } from "../model/roles";
import { fixed, timeText } from "../model/text";
import { type Side, bothSides, sideNames } from "../recording/about";
import { lastNotAfter } from "../recording/log";
import type { Match } from "../recording/match";
import { element, heading, numeric, row } from "./elements";

type Kind = "overlaps" | "uncovered";

const mostRows = 2000;

export class OverlapList {
  // As listed and in the order of time: what the jumps go along.
  private shown: Stretch[] = [];
  private begins: number[] = [];
  private listed: Stretch[] = [];
  chosen: Stretch | null = null; // that a jump led to
  private rows: HTMLTableRowElement[] = [];
  private marked: HTMLTableRowElement | null = null;
  private readonly body = element("tbody");
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
    option(this.kind, "overlaps", "roles held twice");
    option(this.kind, "uncovered", "uncovered roles");
    option(this.side, "", "both teams");
    for (const side of bothSides)
      option(this.side, String(side), `${match.about.teams[side].name} (${sideNames[side]})`);
    for (const seconds of ["0.1", "0.3", "0.5", "1", "2", "5"]) option(this.least, seconds, `at least ${seconds} s`);
    option(this.order, "time", "by time");
    option(this.order, "length", "longest first");
    for (const select of [this.kind, this.side, this.role, this.least, this.order]) {
      select.addEventListener("change", () => {
        if (select === this.side) this.fillRoles();
        this.fill();
      });
    }
    const table = element(
      "table",
      { class: "list" },
      heading(["from", "#length", "role", "robots", "team"]),
      this.body,
    );
    this.box.append(
      element("div", { class: "filters" }, this.kind, this.side, this.role, this.least, this.order, this.count),
      element("div", { class: "scroll" }, table),
    );
    this.body.addEventListener("click", (event) => this.pick(event.target));
    this.body.addEventListener("keydown", (event) => {
      if (event.key === "Enter") this.pick(event.target);
    });
    this.fillRoles();
    this.fill();
  }

  private pick(target: EventTarget | null): void {
    const found = target instanceof Element ? target.closest("tr") : null;
    const stretch = found === null ? undefined : this.listed[this.rows.indexOf(found)];
    if (stretch !== undefined) this.jump(stretch);
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
    this.shown = all
      .filter((stretch) => stretch.samples >= samples)
      .filter(
        (stretch) =>
          this.role.value === "" || `=${roleName(this.match, stretch.side, stretch.role)}` === this.role.value,
      )
      .sort((a, b) => a.from - b.from);
    this.begins = this.shown.map((stretch) => stretch.from);
    const sorted = this.order.value === "length" ? [...this.shown].sort((a, b) => b.samples - a.samples) : this.shown;
    this.listed = sorted.slice(0, mostRows);
    this.rows = this.listed.map((stretch) =>
      row([
        element("td", {}, element("button", { class: "link", type: "button" }, timeText(stretch.from))),
        numeric(`${fixed(stretch.samples / 10, 1)} s`),
        roleName(this.match, stretch.side, stretch.role),
        stretch.robots.length > 0 ? stretch.robots.join("  ") : "none",
        element(
          "td",
          {},
          element("span", { class: `mark ${sideNames[stretch.side]}`, "aria-hidden": "true" }),
          this.match.about.teams[stretch.side].name,
        ),
      ]),
    );
    this.body.replaceChildren(...this.rows);
    const sum = this.shown.reduce((total, stretch) => total + stretch.samples, 0) / 10;
    const left = this.shown.length > mostRows ? `, the first ${mostRows} listed` : "";
    this.count.textContent = `${this.shown.length} stretches, ${fixed(sum, 1)} s${left}`;
    this.marked = null;
  }

  // The stretches that are listed now, by time.
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
    if (scroll) now?.scrollIntoView({ block: "nearest" });
  }
}
