// SPDX-License-Identifier: MIT
// The Utility Estimation Matrix as a heat map: a row for each active robot, a column for each kept task, the chosen
// entries framed; and the terms behind one entry: that of the role held, until the reader points at another.
import { heat } from "../app/palette";
import type { Robot } from "../app/state";
import { isOld, roleName, shortRoleName } from "../model/look";
import { fixed } from "../model/text";
import type { Match } from "../recording/match";
import type { Decision } from "../recording/messages";
import { brokenName, element, heading, manyColumns, moveWithArrows, numeric, row, setText } from "./elements";

// Where a value lies between the least and the greatest: by its logarithm where they differ by orders of magnitude.
function shareOf(value: number, least: number, most: number): number {
  if (!(most > least)) return 0.5;
  if (least > 0 && most > 20 * least) return Math.log(value / least) / Math.log(most / least);
  return (value - least) / (most - least);
}

const shown = (value: number) => fixed(value, Math.abs(value) < 10 ? 2 : 1);

interface Entry {
  robot: number;
  role: number;
}

const hasNoEntry = ({ rows, columns }: Decision) => rows.length === 0 || columns.length === 0;

// The entry of the role that the robot holds. Where there is none: another one, and `why` it is not that of the role.
export function heldEntry(decision: Decision, self: number, nameOf: (role: number) => string): Entry & { why: string } {
  const { rows, columns, role, utility } = decision;
  const i = Math.max(0, rows.indexOf(self));
  const robot = rows[i]!;
  if (robot !== self) return { robot, role: columns[0]!, why: `robot ${self} has no row; shown: robot ${robot}` };
  if (columns.includes(role)) return { robot, role, why: "" };
  const values = columns.map((_, j) => utility[i]?.[j] ?? -Infinity);
  const best = columns[values.indexOf(Math.max(...values))]!;
  const holds = role < 0 ? "holds no role" : `holds ${nameOf(role)}, which has no column`;
  return { robot, role: best, why: `robot ${self} ${holds}; shown: its best entry,` };
}

export class UtilityMatrix {
  readonly table = element("table", { class: "matrix", role: "grid", "aria-label": "Utility Estimation Matrix" });
  readonly terms = element("div", { class: "terms" });
  private readonly corner = element("th", { scope: "col", class: "corner" }, "utility");
  private readonly termsAge = element("span");
  private shape = "";
  private cells: HTMLTableCellElement[][] = [];
  private decision: Decision | null = null;
  private robot: Robot = { side: 0, number: 0 };
  private pointed: Entry | null = null; // by the reader; null: at nothing

  constructor(private readonly match: Match) {
    const place = (event: Event) => (event.target instanceof Element ? event.target.closest("td") : null);
    const point = (event: Event) => {
      const cell = place(event);
      const robot = this.decision?.rows[Number(cell?.dataset.row)];
      const role = this.decision?.columns[Number(cell?.dataset.column)];
      if (robot === undefined || role === undefined) return;
      if (robot === this.pointed?.robot && role === this.pointed.role) return;
      this.pointed = { robot, role };
      this.showTerms();
    };
    // Not when cells come to lie under a pointer that rests: that is no choice of the reader.
    for (const kind of ["pointermove", "pointerdown", "focusin"]) this.table.addEventListener(kind, point);
    moveWithArrows(this.table);
  }

  update(robot: Robot, decision: Decision | null): void {
    if (decision === this.decision && robot === this.robot) return;
    if (robot !== this.robot) this.pointed = null;
    this.robot = robot;
    this.decision = decision;
    const { side, number: self } = robot;
    if (decision === null || hasNoEntry(decision)) {
      this.shape = "";
      this.pointed = null;
      this.table.replaceChildren(
        element("caption", {}, decision === null ? "No decision yet" : "This decision has no utilities"),
      );
      this.terms.replaceChildren();
      return;
    }
    const shape = `${side} ${self} ${decision.rows.join(",")} ${decision.columns.join(",")}`;
    if (shape !== this.shape) this.build(decision);
    this.shape = shape;
    this.fill(decision);
    const { pointed } = this;
    if (pointed !== null && !(decision.rows.includes(pointed.robot) && decision.columns.includes(pointed.role)))
      this.pointed = null;
    this.showTerms();
  }

  // How old the numbers are; beyond a second they are muted.
  setAge(age: number | null): void {
    const old = isOld(age);
    for (const part of [this.table, this.terms]) part.classList.toggle("old", old);
    setText(this.corner, old ? `${fixed(age!, 1)} s old` : "utility");
    setText(this.termsAge, old ? `, ${fixed(age!, 1)} s old` : "");
  }

  private build(decision: Decision): void {
    this.cells = decision.rows.map((_, i) =>
      decision.columns.map((__, j) =>
        element("td", { tabindex: i === 0 && j === 0 ? "0" : "-1", "data-row": String(i), "data-column": String(j) }),
      ),
    );
    const heads = decision.columns.map((role) =>
      element(
        "th",
        { scope: "col", title: roleName(this.match, this.robot.side, role) },
        ...brokenName(shortRoleName(this.match, this.robot.side, role), decision.columns.length > manyColumns ? 6 : 7),
      ),
    );
    const body = element(
      "tbody",
      {},
      ...decision.rows.map((robot, i) =>
        element(
          "tr",
          robot === this.robot.number ? { class: "own" } : {},
          element("th", { scope: "row" }, `robot ${robot}`),
          ...this.cells[i]!,
        ),
      ),
    );
    this.table.classList.toggle("many", decision.columns.length > manyColumns);
    this.table.closest(".mind-columns")?.classList.toggle("many", decision.columns.length > manyColumns);
    this.table.style.setProperty("--columns", String(decision.columns.length));
    this.table.replaceChildren(heading([this.corner, ...heads]), body);
  }

  private fill(decision: Decision): void {
    let least = Infinity;
    let most = -Infinity;
    for (const values of decision.utility) {
      for (const value of values) {
        if (value === null) continue;
        least = Math.min(least, value);
        most = Math.max(most, value);
      }
    }
    for (const [i, cells] of this.cells.entries()) {
      for (const [j, cell] of cells.entries()) {
        const value = decision.utility[i]?.[j] ?? null;
        const robot = decision.rows[i]!;
        const chosen = decision.assigned[robot - 1] === decision.columns[j];
        setText(cell, value === null ? "\u2715" : `${chosen ? "\u25cf" : ""}${shown(value)}`);
        const shade = value === null ? null : heat(shareOf(value, least, most));
        cell.style.background = shade?.fill ?? "";
        cell.style.color = shade?.ink ?? "";
        cell.className = `${value === null ? "forbidden" : ""} ${chosen ? "chosen" : ""}`.trim();
        const role = roleName(this.match, this.robot.side, decision.columns[j]!);
        cell.setAttribute(
          "aria-label",
          `robot ${robot}, ${role}: ${value === null ? "forbidden" : value}${chosen ? ", chosen" : ""}`,
        );
      }
    }
  }

  private showTerms(): void {
    const { decision, pointed } = this;
    if (decision === null || hasNoEntry(decision)) return;
    const nameOf = (role: number) => roleName(this.match, this.robot.side, role);
    const { robot, role, why } =
      pointed === null ? heldEntry(decision, this.robot.number, nameOf) : { ...pointed, why: "" };
    const i = decision.rows.indexOf(robot);
    const j = decision.columns.indexOf(role);
    for (const cells of this.cells) for (const cell of cells) cell.removeAttribute("aria-selected");
    this.cells[i]?.[j]?.setAttribute("aria-selected", "true");
    const utility = decision.utility[i]?.[j] ?? null;
    const terms = this.match.about.teams[this.robot.side].contexts[decision.context]?.terms ?? [];
    const body = element("tbody");
    let sum = 0;
    const greatest = Math.max(
      1e-9,
      ...terms.map((term, t) => Math.abs(term.weight * (decision.terms[t]?.[i]?.[j] ?? 0))),
    );
    if (terms.length === 0)
      body.append(row([element("td", { colspan: "5", class: "muted" }, "this context has no terms")]));
    for (const [t, term] of terms.entries()) {
      const value = decision.terms[t]?.[i]?.[j] ?? null;
      const part = term.weight * (value ?? 0);
      sum += part;
      const bar = element("div", { class: "bar" });
      bar.style.width = `${(100 * Math.abs(part)) / greatest}%`;
      body.append(
        row([
          element("th", { scope: "row", class: "name" }, ...brokenName(term.name, Infinity)),
          numeric(fixed(term.weight, 2)),
          numeric(value === null ? "\u2715" : fixed(value, 3)),
          numeric(value === null ? "\u2715" : fixed(part, 3)),
          element("td", { class: "bars" }, bar),
        ]),
      );
    }
    body.append(
      row(
        [
          element("th", { scope: "row" }, "utility"),
          "",
          "",
          numeric(utility === null ? "forbidden" : fixed(utility, 3), { id: "utility-sum" }),
          element(
            "td",
            { class: "bars muted" },
            utility !== null && Math.abs(utility - sum) > 2e-3 ? `terms give ${fixed(sum, 3)}` : "",
          ),
        ],
        { class: "sum" },
      ),
    );
    this.terms.replaceChildren(
      element("h3", {}, `${why === "" ? `robot ${robot}` : why} as ${nameOf(role)}`, this.termsAge),
      element("table", { class: "list tight" }, heading(["term", "#weight", "#value", "#share", ""]), body),
    );
  }
}
