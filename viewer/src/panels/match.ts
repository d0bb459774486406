// SPDX-License-Identifier: MIT
// The match in sums: for each role of both teams its role overlaps, how long nobody held it and how often it was taken;
// and what is needed to play the match again.
import { fixed } from "../model/text";
import type { Switches } from "../model/switches";
import { type Side, bothSides, sideNames } from "../recording/about";
import type { Match } from "../recording/match";
import { element, heading, named, numeric, row } from "./elements";

export class MatchPanel {
  private readonly switchCells: [HTMLTableCellElement[], HTMLTableCellElement[]] = [[], []];

  constructor(
    box: HTMLElement,
    private readonly match: Match,
    name: string,
  ) {
    const { about } = match;
    const facts: [string, string][] = [
      ["file", name],
      ["written by", about.program],
      ["seed", about.seed],
      ["rules", about.rules],
      ["opening", about.opening || "kick-off"],
      ["command", about.command],
      ...bothSides.map((side): [string, string] => [sideNames[side], about.teams[side].file || about.teams[side].name]),
    ];
    const list = element("dl", { class: "facts" });
    for (const [key, value] of facts)
      if (value !== "") list.append(element("dt", {}, key), element("dd", { dir: "auto" }, value));
    box.append(
      element(
        "div",
        { class: "match-columns" },
        ...bothSides.map((side) => this.sums(side)),
        element("section", {}, element("h3", {}, "This recording"), list),
      ),
    );
  }

  private sums(side: Side): HTMLElement {
    const team = this.match.about.teams[side];
    const { sums } = this.match.courses[side];
    const body = element(
      "tbody",
      {},
      ...team.roles.map((role, i) => {
        const cell = numeric("…");
        this.switchCells[side].push(cell);
        const { overlap, uncovered } = sums[i]!;
        return row([named(role.name), numeric(fixed(overlap, 1)), numeric(fixed(uncovered, 1)), cell], {
          "data-role": role.name,
        });
      }),
    );
    return element(
      "section",
      {},
      element(
        "h3",
        {},
        element("span", { class: `mark ${sideNames[side]}`, "aria-hidden": "true" }),
        `${team.name} (${sideNames[side]})`,
      ),
      element(
        "table",
        { class: "list tight sums", id: `sums-${sideNames[side]}` },
        heading(["role", "#role overlap,\u00a0s", "#uncovered,\u00a0s", "#switches"]),
        body,
      ),
    );
  }

  setSwitches({ byRole }: Switches): void {
    for (const side of bothSides) {
      this.switchCells[side].forEach((cell, role) => {
        cell.textContent = String(byRole[side][role]);
      });
    }
  }
}
