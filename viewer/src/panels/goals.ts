// SPDX-License-Identifier: MIT
// The list of goals, or of everything that the referee called, to jump to.
import { bothSides, sideNames } from "../recording/about";
import type { Match } from "../recording/match";
import { type EventMessage, eventText, isGoal } from "../recording/messages";
import { element, named, numeric, row } from "./elements";
import { JumpList, timeCell } from "./jump_list";

export class GoalPanel {
  private readonly kind = element("select", { "aria-label": "What is listed", id: "goals-kind" });
  private readonly count = element("span", { class: "muted", id: "goals-count" });
  private readonly list: JumpList;
  private listed: EventMessage[] = [];

  constructor(
    box: HTMLElement,
    private readonly match: Match,
    jump: (time: number) => void,
  ) {
    this.kind.append(
      element("option", { value: "goals" }, "goals"),
      element("option", { value: "all" }, "all calls of the referee"),
    );
    this.kind.addEventListener("change", () => this.fill());
    const heads = ["time", "what", "team, robot", "#score"];
    this.list = new JumpList(box, "goal-list", heads, [this.kind, this.count], (place) =>
      jump(this.listed[place]!.time),
    );
    this.fill();
  }

  private fill(): void {
    this.listed = this.match.events.filter((event) => this.kind.value === "all" || isGoal(event));
    const times = this.listed.map(({ time }) => time);
    const rows = this.listed.map((event) => this.rowOf(event));
    this.list.fill(times, rows, this.kind.value === "all" ? "No call" : "No goal");
    const { teams } = this.match.about;
    const goals = bothSides.map((side) => this.match.events.filter((event) => isGoal(event) && event.side === side));
    this.count.textContent = bothSides.map((side) => `${teams[side].name} ${goals[side]!.length}`).join(", ");
  }

  private rowOf(event: EventMessage): HTMLTableRowElement {
    const team = named(`${this.match.about.teams[event.side].name}${event.robot > 0 ? ` ${event.robot}` : ""}`);
    team.prepend(element("span", { class: `mark ${sideNames[event.side]}`, "aria-hidden": "true" }));
    return row([timeCell(event.time), named(eventText(event)), team, numeric(event.score.join(" : "))]);
  }

  update(time: number): void {
    this.list.update(time);
  }
}
