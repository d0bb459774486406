// SPDX-License-Identifier: MIT
// The decisions of two robots side by side: who takes which role in the head of each, what each computed, where their
// beliefs differ, and which packets did not arrive.
import type { View } from "../app/state";
import { type Comparison, type Estimate, type Pair, compare } from "../model/compare";
import { shortRoleName } from "../model/look";
import type { News } from "../model/packets";
import { fixed, shortened, timeText, words } from "../model/text";
import type { Match } from "../recording/match";
import { DifferenceMatrix } from "./difference";
import { element, heading, named, numeric, row, titleOf } from "./elements";
import { packetLines } from "./packet_lines";
import { ageText, verdict } from "./verdict";

const mostLettersOfTeam = 12; // in the menus of robots

export class ComparePanel {
  private readonly content = element("div", { class: "compare" });
  private readonly selects: [HTMLSelectElement, HTMLSelectElement];
  private readonly role = element("select", { "aria-label": "Role", id: "compare-role" });
  private readonly verdict = element("p", { class: "verdict", id: "verdict" });
  private readonly bar: HTMLElement;
  private readonly empty: HTMLElement;
  private shownPair: Pair | null = null;
  private shownTime = NaN;
  private filledSide = -1;
  private readonly difference: DifferenceMatrix;

  constructor(
    box: HTMLElement,
    tabs: HTMLElement,
    private readonly match: Match,
    private readonly choose: (pair: Pair) => void,
  ) {
    this.difference = new DifferenceMatrix(match);
    this.selects = [
      element("select", { "aria-label": "First robot", id: "compare-first" }),
      element("select", { "aria-label": "Second robot", id: "compare-second" }),
    ];
    for (const select of [...this.selects, this.role]) {
      select.addEventListener("change", () => {
        if (this.shownPair === null) return;
        const robots: [number, number] = [Number(this.selects[0].value), Number(this.selects[1].value)];
        if (robots[0] === robots[1])
          robots[select === this.selects[0] ? 1 : 0] = this.shownPair.robots[select === this.selects[0] ? 0 : 1];
        this.choose({ ...this.shownPair, robots, role: Number(this.role.value) });
      });
    }
    const swatch = (name: string) => element("span", { class: `swatch ${name}`, "aria-hidden": "true" });
    this.bar = element(
      "div",
      { class: "pair" },
      swatch("first"),
      this.selects[0],
      element("span", { class: "muted" }, "and"),
      swatch("second"),
      this.selects[1],
      element("span", { class: "muted" }, "as"),
      this.role,
    );
    this.empty = element(
      "p",
      { class: "empty" },
      "Choose a role overlap in the list, or press ] for the next one: " +
        "the decisions of the robots that share the role are compared here.",
    );
    tabs.append(this.bar);
    box.append(this.empty, this.verdict, this.content);
  }

  // Which robots are compared stands beside the tabs.
  showBar(view: View): void {
    this.bar.hidden = view.panel !== "compare" || view.pair === null;
  }

  update(view: View): void {
    const { pair } = view;
    this.empty.hidden = pair !== null;
    for (const part of [this.verdict, this.content]) part.hidden = pair === null;
    const time = Math.floor(view.time * 10 + 1e-6) / 10;
    if (pair === null || (pair === this.shownPair && time === this.shownTime)) return;
    this.fillSelects(pair);
    this.shownPair = pair;
    this.shownTime = time;
    this.show(pair, compare(this.match, pair, view.time), view.time);
  }

  private fillSelects(pair: Pair): void {
    if (this.filledSide !== pair.side) {
      this.filledSide = pair.side;
      const team = this.match.about.teams[pair.side].name;
      const robots = () =>
        Array.from({ length: this.match.game.sizes[pair.side] }, (_, i) =>
          element(
            "option",
            { value: String(i + 1), title: `${team} ${i + 1}` },
            `${shortened(team, mostLettersOfTeam)} ${i + 1}`,
          ),
        );
      for (const select of this.selects) select.replaceChildren(...robots());
      this.role.replaceChildren(
        ...this.match.about.teams[pair.side].roles.map((role, i) => element("option", { value: String(i) }, role.name)),
      );
    }
    this.selects.forEach((select, i) => {
      select.value = String(pair.robots[i]);
    });
    this.role.value = String(pair.role);
    for (const select of [...this.selects, this.role]) titleOf(select);
  }

  private show(pair: Pair, found: Comparison, time: number): void {
    const [a, b] = pair.robots;
    this.verdict.textContent = verdict(this.match, pair, found, time).join(" ");
    this.verdict.title = this.verdict.textContent;
    const faults = found.looks
      .map((look) => look.fault)
      .filter((fault) => fault !== "")
      .join(" ");
    const assigned = element(
      "table",
      { class: "list tight", id: "compare-assigned" },
      heading(["", `given by ${a}`, `given by ${b}`, "holds"]),
      element(
        "tbody",
        {},
        ...found.assigned.map((line) => {
          const name = (role: number | null) => (role === null ? "\u2013" : shortRoleName(this.match, pair.side, role));
          const cell = (role: number | null) => named(name(role), line.differs ? { class: "differs" } : {});
          return row(
            [
              element("th", { scope: "row" }, `${line.robot}${line.differs ? " \u2260" : ""}`),
              cell(line.assigned[0]),
              cell(line.assigned[1]),
              line.penalised ? named("penalised", {}, name(line.holds)) : named(name(line.holds)),
            ],
            pair.robots.includes(line.robot) ? { class: "own" } : {},
          );
        }),
      ),
    );
    this.difference.update(pair, found.looks, found.old.includes(true));
    const decided = found.looks
      .map(({ decision }) => (decision === null ? "never" : timeText(decision.time, 2)))
      .join(" and ");
    const estimate = (of: Estimate | null, own: boolean) => [
      numeric(of === null ? "\u2013" : `${fixed(of.error, 2)} m`),
      numeric(of === null || own ? "" : `${fixed(of.age, 1)} s`),
    ];
    const beliefs = element(
      "table",
      { class: "list tight", id: "compare-beliefs" },
      heading(["where is", "#apart", `#${a} off by`, "#age", `#${b} off by`, "#age"]),
      element(
        "tbody",
        {},
        ...found.beliefs.map((line) =>
          row([
            element("th", { scope: "row" }, line.robot === 0 ? "ball" : `robot ${line.robot}`),
            numeric(
              line.apart === null ? "\u2013" : `${fixed(line.apart, 2)} m`,
              (line.apart ?? 1) > 0.5 ? { class: "warn" } : {},
            ),
            ...estimate(line.by[0], line.robot === a),
            ...estimate(line.by[1], line.robot === b),
          ]),
        ),
      ),
    );
    this.content.replaceChildren(
      ...(faults === "" ? [] : [element("p", { class: "fault" }, faults)]),
      element(
        "div",
        { class: `compare-columns${this.difference.table.classList.contains("many") ? " many" : ""}` },
        element(
          "section",
          {},
          element("h3", {}, `In each head, decided ${decided}`),
          assigned,
          element("h3", {}, "Beliefs, farthest apart first"),
          beliefs,
        ),
        element(
          "section",
          {},
          element(
            "h3",
            { id: "compare-utilities", class: found.old.includes(true) ? "old" : "" },
            `Utilities: of ${b} less of ${a}${ageText(pair, found)}`,
          ),
          element("div", { class: "matrix-scroll" }, this.difference.table),
          this.difference.terms,
          element("h3", {}, "Packets between them"),
          this.packets(pair, found.news),
        ),
      ),
    );
  }

  private packets(pair: Pair, news: [News, News]): HTMLElement {
    const items: HTMLElement[] = [];
    news.forEach(({ heard, missed, underWay }, i) => {
      const listener = pair.robots[i]!;
      const sender = pair.robots[1 - i]!;
      items.push(
        element(
          "li",
          {},
          heard === null
            ? `${listener} has never heard ${sender}`
            : `${listener} last heard ${sender}: packet of ${timeText(heard.time, 2)} (${words(heard.reason)})`,
        ),
      );
      for (const packet of missed.slice(-3)) {
        items.push(
          element(
            "li",
            { class: "warn", title: packetLines(this.match, packet).join("\n") },
            `${listener} did not hear ${sender} at ${timeText(packet.time, 2)} (${words(packet.reason)})`,
          ),
        );
      }
      for (const packet of underWay) {
        items.push(
          element(
            "li",
            { title: packetLines(this.match, packet).join("\n") },
            `under way to ${listener}: packet of ${timeText(packet.time, 2)} (${words(packet.reason)})`,
          ),
        );
      }
    });
    return element("ul", { class: "packets" }, ...items);
  }
}
