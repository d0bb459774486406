// SPDX-License-Identifier: MIT
// The list of shots, meant passes, clearances and duels, to jump to: a click leads to the moment just before.
import { before, chosenPlays, playCounts, playText, tellsPlays } from "../model/plays";
import { timeText } from "../model/text";
import { type Side, bothSides, sideNames } from "../recording/about";
import { lastNotAfter } from "../recording/log";
import type { Match } from "../recording/match";
import { type PlayKind, type PlayMessage, playKinds } from "../recording/play_messages";
import { element, heading, named, row, titleOf } from "./elements";

const kindTexts: Record<PlayKind, string> = {
  shot: "shots",
  pass: "meant passes",
  clearance: "clearances",
  duel: "duels",
};
const older = "This recording was written before Regista told of shots, meant passes, clearances and duels.";

export class PlayPanel {
  private readonly kind = element("select", { "aria-label": "What is listed", id: "plays-kind" });
  private readonly side = element("select", { "aria-label": "Team", id: "plays-side" });
  private readonly count = element("span", { class: "muted", id: "plays-count" });
  private readonly body = element("tbody");
  private listed: PlayMessage[] = [];
  private begins: number[] = [];
  private rows: HTMLTableRowElement[] = [];
  private marked: HTMLTableRowElement | undefined;

  constructor(
    box: HTMLElement,
    private readonly match: Match,
    jump: (time: number) => void,
  ) {
    if (!tellsPlays(match)) {
      box.append(element("p", { class: "empty" }, older));
      return;
    }
    const option = (select: HTMLSelectElement, value: string, text: string) =>
      select.append(element("option", { value }, text));
    option(this.kind, "", "everything");
    for (const kind of playKinds) option(this.kind, kind, kindTexts[kind]);
    option(this.side, "", "both teams");
    for (const side of bothSides)
      option(this.side, String(side), `${match.about.teams[side].name} (${sideNames[side]})`);
    for (const select of [this.kind, this.side]) select.addEventListener("change", () => this.fill());
    box.append(
      element("div", { class: "filters" }, this.kind, this.side, this.count),
      element(
        "div",
        { class: "scroll" },
        element("table", { class: "list", id: "plays" }, heading(["time", "robot", "what", "team"]), this.body),
      ),
    );
    this.body.addEventListener("click", ({ target }) => {
      const found = target instanceof Element ? target.closest("tr") : null;
      const play = found === null ? undefined : this.listed[this.rows.indexOf(found)];
      if (play !== undefined) jump(play.began - before);
    });
    this.fill();
  }

  private fill(): void {
    const kind = this.kind.value === "" ? null : (this.kind.value as PlayKind);
    const side = this.side.value === "" ? null : (Number(this.side.value) as Side);
    this.listed = chosenPlays(this.match.plays, { kind, side });
    this.begins = this.listed.map((play) => play.began);
    this.rows = this.listed.map((play) => this.rowOf(play));
    this.marked = undefined;
    this.body.replaceChildren(...this.rows);
    if (this.rows.length === 0)
      this.body.append(element("tr", {}, element("td", { colspan: "4", class: "muted" }, "There is none")));
    this.count.textContent = playCounts(this.listed);
    for (const select of [this.kind, this.side]) titleOf(select);
  }

  private rowOf(play: PlayMessage): HTMLTableRowElement {
    const team = this.match.about.teams[play.side].name;
    return row([
      element("td", {}, element("button", { class: "link", type: "button" }, timeText(play.began))),
      element(
        "td",
        { title: `${team} ${play.robot}` },
        element("span", { class: `mark ${sideNames[play.side]}`, "aria-hidden": "true" }),
        String(play.robot),
      ),
      element("td", { class: "name" }, playText(this.match, play)),
      named(team),
    ]);
  }

  // Marks the last that began by `time`.
  update(time: number): void {
    const now = this.rows[lastNotAfter(this.begins, time + 1e-6)];
    if (now === this.marked) return;
    this.marked?.removeAttribute("aria-current");
    now?.setAttribute("aria-current", "true");
    this.marked = now;
    now?.scrollIntoView({ block: "nearest" });
  }
}
