// SPDX-License-Identifier: MIT
// Two Utility Estimation Matrices, the second minus the first: where the two robots compute most differently. Framed is
// what each of them chose; of one entry the terms stand beside it.
import { type Pair, compareEntry, greatestDifference } from "../model/compare";
import { type Look, roleName, shortRoleName } from "../model/look";
import { fixed, listText, signed } from "../model/text";
import type { Match } from "../recording/match";
import { brokenName, element, heading, manyColumns, moveWithArrows, numeric, row } from "./elements";

export class DifferenceMatrix {
  readonly table = element("table", {
    class: "matrix difference",
    role: "grid",
    "aria-label": "Differences of utility",
  });
  readonly terms = element("div", { class: "terms" });
  private pair: Pair | null = null;
  private looks: [Look, Look] | null = null;
  private pointed: { robot: number; role: number } | null = null; // by the reader; null: at nothing
  private cells = new Map<HTMLTableCellElement, { robot: number; role: number }>();

  constructor(private readonly match: Match) {
    const point = (event: Event) => {
      const cell = event.target instanceof Element ? event.target.closest("td") : null;
      const entry = cell === null ? undefined : this.cells.get(cell);
      if (entry === undefined || entry === this.pointed) return;
      this.pointed = entry;
      this.showTerms();
    };
    for (const kind of ["pointermove", "pointerdown", "focusin"]) this.table.addEventListener(kind, point);
    moveWithArrows(this.table);
  }

  // old: the two are of different moments.
  update(pair: Pair, looks: [Look, Look], old: boolean): void {
    for (const part of [this.table, this.terms]) part.classList.toggle("old", old);
    const same = this.pair !== null && this.pair.role === pair.role && this.pair.robots.join() === pair.robots.join();
    if (same && this.looks !== null && this.looks.every((look, i) => look.decision === looks[i]!.decision)) return;
    this.pair = pair;
    this.looks = looks;
    const [a, b] = looks.map((look) => look.decision);
    const rows = [...new Set([...(a?.rows ?? []), ...(b?.rows ?? [])])].sort((x, y) => x - y);
    const columns = [...new Set([...(a?.columns ?? []), ...(b?.columns ?? [])])].sort((x, y) => x - y);
    this.cells = new Map();
    let greatest = 0.05;
    const body = element(
      "tbody",
      {},
      ...rows.map((robot) => {
        const line = element(
          "tr",
          pair.robots.includes(robot) ? { class: "own" } : {},
          element("th", { scope: "row" }, `robot ${robot}`),
        );
        for (const role of columns) {
          const cell = element("td", { tabindex: this.cells.size === 0 ? "0" : "-1" });
          this.cells.set(cell, { robot, role });
          const entry = compareEntry(this.match, pair, looks, robot, role);
          const known = entry.difference;
          if (known !== null) greatest = Math.max(greatest, Math.abs(known));
          const chosen = [a, b].map((decision) => decision?.assigned[robot - 1] === role);
          const missing = entry.known[0] === entry.known[1] ? "\u2715" : `only ${pair.robots[entry.known[0] ? 0 : 1]}`;
          cell.textContent = known === null ? missing : signed(known, 2);
          cell.className = [chosen[0] ? "first" : "", chosen[1] ? "second" : "", known === null ? "forbidden" : ""]
            .join(" ")
            .trim();
          cell.dataset.difference = String(known ?? "");
          const choosers = pair.robots.filter((_, i) => chosen[i]);
          const by = choosers.length > 0 ? `, chosen by ${listText(choosers)}` : "";
          const value = known === null ? "no difference" : fixed(known, 3);
          cell.setAttribute("aria-label", `robot ${robot}, ${roleName(this.match, pair.side, role)}: ${value}${by}`);
          line.append(cell);
        }
        return line;
      }),
    );
    for (const cell of this.cells.keys()) {
      const known = Number(cell.dataset.difference || 0);
      if (cell.dataset.difference === "") continue;
      const strength = Math.round((85 * Math.abs(known)) / greatest);
      const colour = known > 0 ? "second" : "first";
      cell.style.background = `color-mix(in srgb, var(--${colour}) ${strength}%, var(--sunken))`;
      cell.style.color = strength > 55 ? "var(--on-strong)" : "";
    }
    const heads = columns.map((role) =>
      element(
        "th",
        { scope: "col", class: role === pair.role ? "shared" : "", title: roleName(this.match, pair.side, role) },
        ...brokenName(shortRoleName(this.match, pair.side, role), columns.length > manyColumns ? 6 : 7),
      ),
    );
    this.table.classList.toggle("many", columns.length > manyColumns);
    this.table.style.setProperty("--columns", String(columns.length));
    if (columns.length === 0) this.table.replaceChildren(element("caption", {}, "These decisions have no utilities"));
    else this.table.replaceChildren(heading([element("th"), ...heads]), body);
    const { pointed } = this;
    if (!same || pointed === null || !rows.includes(pointed.robot) || !columns.includes(pointed.role))
      this.pointed = null;
    this.showTerms();
  }

  private showTerms(): void {
    const { pair, looks } = this;
    if (pair === null || looks === null) return;
    const most = this.pointed ?? greatestDifference(this.match, pair, looks);
    const pointed = most ?? { robot: pair.robots[0], role: pair.role };
    for (const [cell, { robot, role }] of this.cells) {
      if (robot === pointed.robot && role === pointed.role) cell.setAttribute("aria-selected", "true");
      else cell.removeAttribute("aria-selected");
    }
    const entry = compareEntry(this.match, pair, looks, pointed.robot, pointed.role);
    const value = (number: number | null | undefined) =>
      numeric(number === null || number === undefined ? "\u2715" : fixed(number, 3));
    const lines = entry.terms.map((term) =>
      row([
        element("th", { scope: "row", class: "name" }, ...brokenName(term.name, Infinity)),
        value(term.values[0]),
        value(term.values[1]),
        numeric(signed(term.difference, 3)),
      ]),
    );
    lines.push(
      row(
        [
          element("th", { scope: "row" }, "utility"),
          value(entry.utility[0]),
          value(entry.utility[1]),
          numeric(entry.difference === null ? "" : signed(entry.difference, 3)),
        ],
        { class: "sum" },
      ),
    );
    this.terms.replaceChildren(
      element(
        "table",
        { class: "list tight", id: "compare-terms" },
        heading([
          `robot ${pointed.robot} as ${shortRoleName(this.match, pair.side, pointed.role)}`,
          `#in ${pair.robots[0]}`,
          `#in ${pair.robots[1]}`,
          "#\u0394",
        ]),
        element("tbody", {}, ...lines),
      ),
    );
  }
}
