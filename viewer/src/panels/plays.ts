// SPDX-License-Identifier: MIT
// The list of shots, meant passes, clearances and duels, to jump to: a click leads to the moment just before.
import { before, chosenPlays, playCounts, playText, tellsPlays } from "../model/plays";
import { type Side, bothSides, sideNames } from "../recording/about";
import type { Match } from "../recording/match";
import { type PlayKind, type PlayMessage, playKinds } from "../recording/play_messages";
import { element, named, row, titleOf } from "./elements";
import { JumpList, timeCell } from "./jump_list";

const kindTexts: Record<PlayKind, string> = {
  shot: "shots",
  pass: "meant passes",
  clearance: "clearances",
  duel: "duels",
};
const older = "This recording was written before Regista recorded shots, meant passes, clearances and duels.";

export class PlayPanel {
  private readonly kind = element("select", { "aria-label": "What is listed", id: "plays-kind" });
  private readonly side = element("select", { "aria-label": "Team", id: "plays-side" });
  private readonly count = element("span", { class: "muted", id: "plays-count" });
  private readonly list: JumpList | null = null;
  private listed: PlayMessage[] = [];

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
    const filters = [this.kind, this.side, this.count];
    this.list = new JumpList(box, "plays", ["time", "robot", "what", "team"], filters, (place) =>
      jump(this.listed[place]!.began - before),
    );
    this.fill();
  }

  private fill(): void {
    const kind = this.kind.value === "" ? null : (this.kind.value as PlayKind);
    const side = this.side.value === "" ? null : (Number(this.side.value) as Side);
    this.listed = chosenPlays(this.match.plays, { kind, side });
    const begins = this.listed.map((play) => play.began);
    this.list?.fill(
      begins,
      this.listed.map((play) => this.rowOf(play)),
      "There is none",
    );
    this.count.textContent = playCounts(this.listed);
    for (const select of [this.kind, this.side]) titleOf(select);
  }

  private rowOf(play: PlayMessage): HTMLTableRowElement {
    const team = this.match.about.teams[play.side].name;
    return row([
      timeCell(play.began),
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

  update(time: number): void {
    this.list?.update(time);
  }
}
