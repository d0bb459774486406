// SPDX-License-Identifier: MIT
// Lists to jump from: each row begins with a time, which is a button.
import { timeText } from "../model/text";
import { lastNotAfter } from "../recording/log";
import { element, heading } from "./elements";

export const timeCell = (time: number) =>
  element("td", {}, element("button", { class: "link", type: "button" }, timeText(time)));

// A click on a row jumps, and Enter on its button; the arrows lead from row to row.
export function jumpFrom(table: HTMLTableElement, jump: (row: HTMLTableRowElement) => void): void {
  table.classList.add("jumps");
  table.addEventListener("click", ({ target }) => {
    const found = target instanceof Element ? target.closest("tr") : null;
    // Those who mark text to copy it stay.
    if (found?.querySelector("button") && getSelection()?.isCollapsed !== false) jump(found);
  });
  table.addEventListener("keydown", (event) => {
    const step = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const buttons = [...table.querySelectorAll("button")];
    const next = buttons[buttons.indexOf(document.activeElement as HTMLButtonElement) + step];
    next?.focus({ preventScroll: true });
    reveal(next, "nearest");
  });
}

// Scrolls the list, never the page, to a part of it.
export function reveal(part: HTMLElement | null | undefined, where: "nearest" | "center"): void {
  const box = part?.closest(".scroll") ?? null;
  if (!part || box === null) return;
  const head = box.querySelector("thead")?.clientHeight ?? 0;
  const [line, room] = [(part.closest("tr") ?? part).getBoundingClientRect(), box.getBoundingClientRect()];
  const above = line.top - room.top - head; // below the head, which stays
  const below = line.bottom - room.bottom;
  if (where === "center") box.scrollTop += (above + below) / 2;
  else if (above < 0) box.scrollTop += above;
  else if (below > 0) box.scrollTop += below;
}

// Rows in place of others, with that of the moment marked and in sight; the focus stays in the list.
export function replaceRows(
  body: HTMLTableSectionElement,
  rows: readonly HTMLTableRowElement[],
  current: HTMLTableRowElement | null,
  none: string,
): void {
  const focused = body.contains(document.activeElement);
  current?.setAttribute("aria-current", "true");
  const columns = String(body.closest("table")?.rows[0]?.cells.length ?? 1);
  const empty = element("tr", {}, element("td", { colspan: columns, class: "muted" }, none));
  body.replaceChildren(...(rows.length > 0 ? rows : [empty]));
  if (focused) (current ?? rows[0])?.querySelector("button")?.focus({ preventScroll: true });
  reveal(current, "center");
}

// A whole list in the order of time, below its filters; the last row that began is marked.
export class JumpList {
  private readonly body = element("tbody");
  private times: readonly number[] = [];
  private rows: readonly HTMLTableRowElement[] = [];
  private marked: HTMLTableRowElement | undefined;

  // jump: to the row of this place.
  constructor(box: HTMLElement, id: string, heads: string[], filters: Node[], jump: (place: number) => void) {
    const table = element("table", { class: "list", id }, heading(heads), this.body);
    jumpFrom(table, (row) => jump(this.rows.indexOf(row)));
    box.append(element("div", { class: "filters" }, ...filters), element("div", { class: "scroll" }, table));
  }

  fill(times: readonly number[], rows: readonly HTMLTableRowElement[], none: string): void {
    [this.times, this.rows, this.marked] = [times, rows, undefined];
    replaceRows(this.body, rows, null, none);
  }

  update(time: number): void {
    const now = this.rows[lastNotAfter(this.times, time + 1e-6)];
    if (now === this.marked) return;
    this.marked?.removeAttribute("aria-current");
    now?.setAttribute("aria-current", "true");
    this.marked = now;
    reveal(now, "nearest");
  }
}
