// SPDX-License-Identifier: MIT
// One robot's mind: what it decided and why, and how old and how wrong what it knows is.
import type { Robot, View } from "../app/state";
import { Moment } from "../model/game";
import {
  type Knowledge,
  type Look,
  ageOf,
  hasCommon,
  isOld,
  knowledgeOf,
  lookAt,
  roleName,
  shortRoleName,
  worldOf,
} from "../model/look";
import { fixed, timeText } from "../model/text";
import { type Side, sideNames } from "../recording/about";
import type { Match } from "../recording/match";
import type { Belief, Decision } from "../recording/messages";
import { element, heading, named, numeric, row, setText } from "./elements";
import { UtilityMatrix } from "./matrix";

export class RobotPanel {
  private readonly title = element("h2");
  private readonly since = element("span", { class: "muted", id: "decided" });
  private readonly fault = element("p", { class: "fault", role: "alert" });
  private readonly asDecided = element("option", { value: "decided" }, "world: as decided");
  private readonly knowledge = element(
    "select",
    { id: "knowledge", "aria-label": "World that is shown" },
    this.asDecided,
    element("option", { value: "mine" }, "world: mine"),
    element("option", { value: "common" }, "world: common"),
  );
  private readonly matrix: UtilityMatrix;
  private readonly news = element("div");
  private readonly context = element("div");
  private readonly tasks = element("div");
  private readonly moment: Moment;
  private shown: {
    decision: Decision | null;
    belief: Belief | null;
    robot: Robot | null;
    knowledge: string;
    packets: number;
  } = {
    decision: null,
    belief: null,
    robot: null,
    knowledge: "",
    packets: -1,
  };
  private readonly empty = element(
    "p",
    { class: "empty" },
    "Choose a robot: on the field, in the timeline, or with its number on the keyboard.",
  );
  private readonly content: HTMLElement;

  constructor(
    box: HTMLElement,
    private readonly match: Match,
    chooseWorld: (knowledge: Knowledge) => void,
  ) {
    this.matrix = new UtilityMatrix(match);
    this.moment = new Moment(match.game);
    this.knowledge.addEventListener("change", () => chooseWorld(this.knowledge.value as Knowledge));
    this.content = element(
      "div",
      { class: "mind" },
      element("header", { class: "mind-head" }, this.title, this.since, this.knowledge),
      this.fault,
      element(
        "div",
        { class: "mind-columns" },
        element("div", { class: "mind-left" }, element("div", { class: "matrix-box" }, this.matrix.table), this.news),
        element(
          "div",
          { class: "mind-right" },
          this.matrix.terms,
          element("h3", {}, "Context"),
          this.context,
          element("h3", {}, "Tasks"),
          this.tasks,
        ),
      ),
    );
    box.append(this.empty, this.content);
  }

  update(view: View): void {
    const { robot } = view;
    this.empty.hidden = robot !== null;
    this.content.hidden = robot === null;
    if (robot === null) return;
    const look = lookAt(this.match, robot.side, robot.number, view.time);
    this.head(robot, look, view);
    const same = this.shown.robot === robot;
    if (!same || look.decision !== this.shown.decision) {
      this.matrix.update(robot, look.decision);
      this.showContext(robot, look.decision);
      this.showTasks(robot, look.decision);
    }
    const age = ageOf(look.decision, view.time);
    this.matrix.setAge(age);
    this.since.classList.toggle("old", isOld(age));
    this.tasks.classList.toggle("old", isOld(age));
    const knowledge = knowledgeOf(look, view.knowledge);
    // News change with every packet heard, beliefs with every message.
    const packets = Math.floor(view.time * 5);
    if (
      !same ||
      look.belief !== this.shown.belief ||
      knowledge !== this.shown.knowledge ||
      packets !== this.shown.packets
    ) {
      this.showNews(robot, look, view);
    }
    this.shown = { robot, decision: look.decision, belief: look.belief, knowledge, packets };
  }

  private head(robot: Robot, look: Look, view: View): void {
    const { decision } = look;
    const team = this.match.about.teams[robot.side].name;
    setText(this.title, `${team} ${robot.number}`);
    this.title.title = `${team} ${robot.number}`;
    this.title.className = sideNames[robot.side];
    setText(this.since, decision === null ? "has not decided yet" : sinceText(this.match, robot, decision, view.time));
    setText(this.fault, look.fault);
    const common = hasCommon(this.match, robot.side);
    setText(this.asDecided, `world: as decided${common ? ` (${knowledgeOf(look, "decided")})` : ""}`);
    this.knowledge.disabled = !common;
    this.knowledge.title = common ? "" : "No context of this team uses common knowledge";
    this.knowledge.value = common ? view.knowledge : "decided";
  }

  private showContext(robot: Robot, decision: Decision | null): void {
    const { contexts } = this.match.about.teams[robot.side];
    const order = contexts
      .map((context, index) => ({ context, index }))
      .sort((a, b) => b.context.priority - a.context.priority);
    const holds = order.findIndex(({ index }) => index === decision?.context);
    const items = order.map(({ context }, i) => {
      const state =
        holds < 0 || i > holds
          ? holds < 0 && decision !== null
            ? "does not hold"
            : "not asked"
          : i === holds
            ? "holds"
            : "does not hold";
      const item = element(
        "li",
        { class: state === "holds" ? "holds" : "" },
        element("b", {}, context.name),
        ` ${state} `,
        element(
          "span",
          { class: "muted" },
          `priority ${context.priority}: ${context.plugin}${context.parameters !== "" ? ` ${context.parameters}` : ""}`,
        ),
      );
      if (state === "holds") {
        const parts = [
          `roles ${context.list}`,
          context.positioner === "" ? "no positioner" : `positioner ${context.positioner}`,
          `assigner ${context.assigner || "none"}`,
          `sender ${context.sender || "none"}`,
          `tasks on ${context.tasksKnowledge}, utilities on ${context.utilityKnowledge}`,
        ];
        item.append(element("div", { class: "muted" }, parts.join("; ")));
      }
      return item;
    });
    this.context.replaceChildren(element("ol", { class: "contexts" }, ...items));
  }

  private showTasks(robot: Robot, decision: Decision | null): void {
    const body = element(
      "tbody",
      {},
      ...(decision?.tasks ?? []).map((task) => {
        const { before, after } = task;
        const moved = after === null ? null : Math.hypot(after[0] - before[0], after[1] - before[1]);
        const at = (pose: [number, number, number]) => `${fixed(pose[0], 2)}, ${fixed(pose[1], 2)}`;
        return row(
          [
            this.roleCell(robot.side, task.role),
            numeric(at(before)),
            numeric(after === null ? "not kept" : at(after)),
            numeric(moved === null ? "" : fixed(moved, 2)),
          ],
          { class: after === null ? "muted" : task.role === decision?.role ? "own" : "" },
        );
      }),
    );
    this.tasks.replaceChildren(
      element("table", { class: "list tight" }, heading(["task", "#before", "#after", "#offset"]), body),
    );
  }

  private roleCell(side: Side, role: number, more = ""): HTMLTableCellElement {
    return named(`${shortRoleName(this.match, side, role)}${more}`, {}, `${roleName(this.match, side, role)}${more}`);
  }

  private showNews(robot: Robot, look: Look, view: View): void {
    const { belief } = look;
    if (belief === null) {
      this.news.replaceChildren(element("p", { class: "muted" }, "Nothing recorded yet"));
      return;
    }
    const { match } = this;
    const truth = this.moment.set(belief.time);
    const knowledge = knowledgeOf(look, view.knowledge);
    const world = worldOf(belief, knowledge);
    const error = (x: number, y: number, of: ArrayLike<number>, place: number) =>
      Math.hypot(x - of[place]!, y - of[place + 1]!);
    const body = element("tbody");
    const { ball } = world;
    body.append(
      row(
        ball === null
          ? ["ball", element("td", { colspan: "5" }, "not known")]
          : [
              "ball",
              belief.seesBall ? "sees it" : "does not see it",
              numeric(`${fixed(ball.age, 1)} s`),
              numeric(`${fixed(error(ball.at[0], ball.at[1], truth.ball, 0), 2)} m`),
              "",
              "",
            ],
      ),
    );
    for (const mate of world.teammates) {
      if (mate.number < 1 || mate.number > match.game.sizes[robot.side]) continue;
      const own = mate.number === robot.number;
      const place = 3 * match.game.place(robot.side, mate.number);
      const { heard, missed } = match.packets.news(robot.side, robot.number, mate.number, view.time);
      body.append(
        row(
          [
            own ? "itself" : `robot ${mate.number}`,
            this.roleCell(robot.side, mate.role, mate.active ? "" : " (not active)"),
            numeric(own ? "" : `${fixed(mate.age, 1)} s`),
            numeric(`${fixed(error(mate.pose[0], mate.pose[1], truth.poses, place), 2)} m`),
            numeric(own ? "" : heard === null ? "never" : timeText(heard.time)),
            numeric(
              own || missed.length === 0 ? "" : `${missed.length} missed`,
              missed.length > 0 && !own ? { class: "warn" } : {},
            ),
          ],
          own ? { class: "own" } : {},
        ),
      );
    }
    this.news.replaceChildren(
      element(
        "table",
        { class: "list tight" },
        heading(["it knows", "role it heard", "#age", "#off by", "#last heard", ""]),
        body,
        element(
          "caption",
          {},
          `${knowledge === "common" ? "common belief" : "belief"} of ${timeText(belief.time, 2)}; ` +
            `${world.opponents.length} opponents known`,
        ),
      ),
    );
  }
}

function sinceText(match: Match, robot: Robot, decision: Decision, time: number): string {
  const since = decision.role >= 0 ? ` since ${timeText(decision.since)}` : "";
  const ago = fixed(Math.max(0, time - decision.time), 1);
  const role = roleName(match, robot.side, decision.role);
  return `${role}${since}; decision of ${timeText(decision.time, 2)}, ${ago} s ago`;
}
