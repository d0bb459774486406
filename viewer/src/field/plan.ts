// SPDX-License-Identifier: MIT
// What a robot planned: the points that its positioner gave, with the edges that it kept between them, and the tasks
// before and after their offset.
import type { Palette } from "../app/palette";
import type { LayerName } from "../app/state";
import type { Moment } from "../model/game";
import { shortRoleName } from "../model/look";
import type { Side } from "../recording/about";
import type { Match } from "../recording/match";
import type { Decision } from "../recording/messages";
import type { Projection } from "./projection";
import type { Labels } from "./labels";
import { type Context, arrow } from "./shapes";

export function drawPlan(
  context: Context,
  to: Projection,
  match: Match,
  moment: Moment,
  side: Side,
  decision: Decision,
  palette: Palette,
  layers: Readonly<Record<LayerName, boolean>>,
  labels: Labels,
): void {
  context.save();
  if (layers.nodes) {
    context.strokeStyle = palette.nodes;
    context.lineWidth = 3; // thicker than the sides of cells, of which they are a part
    context.globalAlpha = 0.8;
    context.beginPath();
    for (const [from, into] of decision.edges) {
      const a = decision.waypoints[from];
      const b = decision.waypoints[into];
      if (a === undefined || b === undefined) continue;
      context.moveTo(to.x(a[0]), to.y(a[1]));
      context.lineTo(to.x(b[0]), to.y(b[1]));
    }
    context.stroke();
    context.globalAlpha = 1;
    context.fillStyle = palette.nodes;
    for (const [x, y, score] of decision.waypoints) {
      // A diamond, larger with its score.
      const size = 4 + 3 * Math.min(1, Math.max(0, score));
      context.beginPath();
      context.moveTo(to.x(x) - size, to.y(y));
      context.lineTo(to.x(x), to.y(y) - size);
      context.lineTo(to.x(x) + size, to.y(y));
      context.lineTo(to.x(x), to.y(y) + size);
      context.closePath();
      context.fill();
    }
  }
  if (layers.tasks) {
    // Whom it sends where: from each robot as it is to its task.
    context.strokeStyle = palette.tasks;
    context.lineWidth = 1;
    context.setLineDash([1.5, 3]);
    context.beginPath();
    for (const [i, role] of decision.assigned.entries()) {
      const task = decision.tasks.find((candidate) => candidate.role === role);
      if (task === undefined || i >= match.game.sizes[side]) continue;
      const [x, y] = task.after ?? task.before;
      const robot = 3 * match.game.place(side, i + 1);
      context.moveTo(to.x(moment.poses[robot]!), to.y(moment.poses[robot + 1]!));
      context.lineTo(to.x(x), to.y(y));
    }
    context.stroke();
    context.setLineDash([]);
    for (const { before, after } of decision.tasks) {
      const [x, y] = [to.x(before[0]), to.y(before[1])];
      context.strokeStyle = palette.tasks;
      context.fillStyle = palette.tasks;
      context.lineWidth = 1.5;
      context.globalAlpha = after === null ? 0.45 : 1;
      context.strokeRect(x - 4, y - 4, 8, 8);
      if (after !== null) {
        const [toX, toY] = [to.x(after[0]), to.y(after[1])];
        arrow(context, x, y, toX, toY);
        context.fillRect(toX - 4, toY - 4, 8, 8);
      }
    }
    context.globalAlpha = 1;
    for (const { role, after } of decision.tasks) {
      if (after === null) continue;
      const [x, y] = [to.x(after[0]), to.y(after[1])];
      const text = shortRoleName(match, side, role).replaceAll("_", " ");
      labels.take(x, y, 4, 4);
      labels.add({ key: `task ${role}`, text, x, y, radius: 4, ink: palette.tasks, rank: "task", pixels: 10 });
    }
  }
  context.restore();
}
