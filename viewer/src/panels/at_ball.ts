// SPDX-License-Identifier: MIT
// Who goes for the ball at this moment, and why nobody does: what is the case in a few sentences, and every able robot
// of both teams in the order in which it could be at the ball.
import { type AtBall, Claims, ballMoment, ballSentences, claimText } from "../model/at_ball";
import { roleName } from "../model/look";
import { fixed, timeText } from "../model/text";
import { type Side, bothSides, sideNames } from "../recording/about";
import type { Match } from "../recording/match";
import { element, heading, named, numeric, row } from "./elements";

const yes = (value: boolean | null): string => (value === null ? "?" : value ? "yes" : "no");

export class AtBallPanel {
  private readonly claims: Claims;
  private readonly verdict = element("div", { class: "verdict", id: "ball-verdict" });
  private readonly bodies = bothSides.map(() => element("tbody"));

  constructor(
    box: HTMLElement,
    private readonly match: Match,
  ) {
    this.claims = new Claims(match.lines);
    box.append(this.verdict, ...bothSides.map((side) => this.tableOf(side)));
    const notes: string[] = [];
    if (!this.claims.any) notes.push("No plugin has logged a claim to the ball in this recording.");
    if (!match.game.tellsChases) notes.push("It was written before Regista recorded who goes for the ball.");
    notes.push("Seconds away: walking straight at full speed until the body touches the ball.");
    box.append(element("p", { class: "muted note" }, notes.join(" ")));
  }

  private tableOf(side: Side): HTMLElement {
    return element(
      "section",
      {},
      element(
        "h3",
        {},
        element("span", { class: `mark ${sideNames[side]}`, "aria-hidden": "true" }),
        this.match.about.teams[side].name,
      ),
      element(
        "table",
        { class: "list tight at-ball", id: `ball-${sideNames[side]}` },
        heading(["robot", "#away,\u00a0s", "#m", "role", "role plays it", "goes for it", "its last claim"]),
        this.bodies[side]!,
      ),
    );
  }

  update(time: number): void {
    const { match } = this;
    const moment = ballMoment(match, this.claims, time);
    this.verdict.classList.toggle("warn", moment.restsSince !== null);
    this.verdict.replaceChildren(...ballSentences(match, moment, time).map((sentence) => element("p", {}, sentence)));
    for (const side of bothSides) {
      const rows = moment.robots[side].map((robot) => this.rowOf(side, robot));
      const none = element("tr", {}, element("td", { colspan: "7", class: "muted" }, "no able robot"));
      this.bodies[side]!.replaceChildren(...(rows.length > 0 ? rows : [none]));
    }
  }

  private rowOf(side: Side, robot: AtBall): HTMLTableRowElement {
    const { claim } = robot;
    return row(
      [
        String(robot.number),
        numeric(robot.seconds === null ? "?" : fixed(robot.seconds, 1)),
        numeric(fixed(robot.metres, 2)),
        named(roleName(this.match, side, robot.role)),
        element("td", { class: robot.plays === true ? "" : "muted" }, yes(robot.plays)),
        element("td", { class: robot.chases === true ? "goes" : "muted" }, yes(robot.chases)),
        claim === null
          ? element("td", { class: "muted" }, "none")
          : element("td", { class: "name", dir: "auto" }, `${claimText(claim)} (${timeText(claim.time)})`),
      ],
      { class: robot.chases === true ? "own" : "" },
    );
  }
}
