// SPDX-License-Identifier: MIT
// The world as a robot believes it: ghosts beside the truth, each tied to what it stands for, with the ellipse of two
// standard deviations and the age of the news in seconds.
import { font } from "../app/canvas";
import type { Palette } from "../app/palette";
import type { Moment } from "../model/game";
import { fixed } from "../model/text";
import { type Side, otherSide } from "../recording/about";
import type { Match } from "../recording/match";
import type { World } from "../recording/messages";
import { drawBelievedBall, shownBallRadius } from "./ball";
import type { Projection } from "./projection";
import type { Labels } from "./labels";
import { type Context, bodyPath, ellipseOf, ellipsePath, headingPath, label, shownDeviations } from "./shapes";

// color: of everything (two beliefs are compared), or null: of the teams. robots: whose ellipses and ages are drawn
// beside the ball's; null: everybody's.
export interface BeliefStyle {
  color: string | null;
  ellipses: boolean;
  robots: readonly number[] | null;
}

const shownAge = 0.35; // s; younger news carry no number

export function drawBelief(
  context: Context,
  to: Projection,
  match: Match,
  moment: Moment,
  side: Side,
  self: number,
  world: World,
  palette: Palette,
  style: BeliefStyle,
  labels: Labels,
): void {
  const { game, about } = match;
  const own = style.color ?? (side === 0 ? palette.home : palette.away);
  const other = otherSide(side);
  const theirs = style.color ?? (side === 0 ? palette.away : palette.home);
  const radius = Math.max(8, about.teams[side].robotRadius * to.scale);
  const ballRadius = shownBallRadius(about.ballRadius, to.scale);
  context.save();
  context.textAlign = "center";
  context.textBaseline = "middle";

  const ellipse = (x: number, y: number, covariance: [number, number, number], color: string) => {
    if (!style.ellipses) return;
    ellipsePath(context, to, x, y, covariance);
    // What may be anywhere is drawn fainter: its ellipse covers the field and says little.
    const faint = Math.min(1, 1.5 / (shownDeviations * ellipseOf(covariance).major));
    context.globalAlpha = 0.08 * faint;
    context.fillStyle = color;
    context.fill();
    context.globalAlpha = 0.2 + 0.3 * faint;
    context.lineWidth = 1;
    context.strokeStyle = color;
    context.setLineDash([]);
    context.stroke();
    context.globalAlpha = 1;
  };
  const tie = (x: number, y: number, truthX: number, truthY: number, color: string) => {
    context.setLineDash([2, 3]);
    context.lineWidth = 1.25;
    context.strokeStyle = color;
    context.beginPath();
    context.moveTo(to.x(x), to.y(y));
    context.lineTo(to.x(truthX), to.y(truthY));
    context.stroke();
  };
  const age = (seconds: number, x: number, y: number, of: string, reach = radius) => {
    if (seconds < shownAge) return;
    labels.add({
      key: `age ${self} ${of}`,
      text: of === "ball" ? `ball ${fixed(seconds, 1)} s` : `${fixed(seconds, 1)} s`,
      x: to.x(x),
      y: to.y(y),
      radius: reach,
      ink: palette.text,
      rank: "age",
      pixels: 10,
    });
  };

  for (const [i, opponent] of world.opponents.entries()) {
    const [x, y] = opponent.at;
    if (style.robots === null) ellipse(x, y, opponent.covariance, theirs);
    context.setLineDash([3, 2]);
    context.lineWidth = 1.5;
    context.strokeStyle = theirs;
    context.globalAlpha = Math.min(1, 0.35 + 0.65 * Math.max(0, opponent.weight));
    bodyPath(context, other, to.x(x), to.y(y), radius);
    context.stroke();
    context.globalAlpha = 1;
    if (style.color === null) age(opponent.age, x, y, `opponent ${i}`);
  }
  for (const mate of world.teammates) {
    if (mate.number > game.sizes[side] || mate.number < 1) continue;
    const [x, y, heading] = mate.pose;
    const truth = 3 * game.place(side, mate.number);
    const whole = style.robots === null || style.robots.includes(mate.number);
    if (whole) ellipse(x, y, mate.covariance, own);
    tie(x, y, moment.poses[truth]!, moment.poses[truth + 1]!, own);
    context.setLineDash([3, 2]);
    context.lineWidth = 1.75;
    context.strokeStyle = own;
    context.globalAlpha = mate.active ? 1 : 0.45;
    bodyPath(context, side, to.x(x), to.y(y), radius);
    context.stroke();
    context.setLineDash([]);
    headingPath(context, to.x(x), to.y(y), heading, radius, radius + 5);
    context.stroke();
    context.font = font(Math.round(radius), 600);
    label(context, String(mate.number), to.x(x), to.y(y) + 0.5, own, palette.grass);
    labels.take(to.x(x), to.y(y), radius / 2, radius / 2);
    context.globalAlpha = 1;
    if (mate.number !== self && whole) age(mate.age, x, y, `mate ${mate.number}`);
  }
  const { ball } = world;
  if (ball !== null) {
    const [x, y] = ball.at;
    const color = style.color ?? palette.ball;
    ellipse(x, y, ball.covariance, color);
    tie(x, y, moment.ball[0]!, moment.ball[1]!, color);
    drawBelievedBall(context, to.x(x), to.y(y), ballRadius, color);
    labels.take(to.x(x), to.y(y), ballRadius + 4, ballRadius + 4);
    age(ball.age, x, y, "ball", ballRadius + 6);
  }
  context.restore();
}
