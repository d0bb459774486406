// SPDX-License-Identifier: MIT
// The field as it is drawn, the whole or a part of it: the truth, and over it what the chosen robot believes and plans.
import { Canvas, font } from "../app/canvas";
import type { Palette } from "../app/palette";
import type { Robot, State, View } from "../app/state";
import { type Game, Moment, inMask } from "../model/game";
import { type Look, ageOf, isOld, knowledgeOf, lookAt, shortRoleName, worldOf } from "../model/look";
import { sitesOf } from "../model/positioner";
import { fixed } from "../model/text";
import { bothSides } from "../recording/about";
import type { Match } from "../recording/match";
import { drawBelief } from "./belief";
import { drawTrueBall, shownBallRadius } from "./ball";
import { drawDiagram } from "./diagram";
import { drawShapes, styleOf } from "./drawings";
import type { Heat } from "./heat";
import { drawGround } from "./ground";
import { Labels } from "./labels";
import type { Box } from "./placement";
import { drawPlan } from "./plan";
import { Projection } from "./projection";
import { bodyPath, headingPath, label } from "./shapes";

const trailSamples = 30; // 3 s

export class Field {
  readonly projection: Projection;
  private readonly canvas: Canvas;
  private readonly ground: Canvas;
  private readonly moment: Moment;
  private readonly labels = new Labels();
  private drawnGround = ""; // of which projection
  private buttons: Box = { left: 0, top: 0, right: 0, bottom: 0 }; // over the field: no name is put there

  constructor(
    element: HTMLCanvasElement,
    private readonly match: Match,
    private palette: Palette,
    private readonly heat: Heat,
  ) {
    this.canvas = new Canvas(element);
    this.ground = new Canvas(document.createElement("canvas"));
    this.projection = new Projection(match.about.field);
    this.moment = new Moment(match.game);
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.drawnGround = "";
  }

  resize(width: number, height: number, buttons: Box): void {
    this.buttons = buttons;
    if (!this.canvas.fit(width, height)) return;
    this.ground.fit(width, height);
    this.projection.fit(width, height);
    this.drawnGround = "";
  }

  // The robot under a point of the canvas.
  robotAt(px: number, py: number): Robot | null {
    let nearest: Robot | null = null;
    let least = Math.max(14, 0.25 * this.projection.scale);
    for (const side of bothSides) {
      for (let n = 1; n <= this.match.game.sizes[side]; ++n) {
        const at = 3 * this.match.game.place(side, n);
        const distance = Math.hypot(
          this.projection.x(this.moment.poses[at]!) - px,
          this.projection.y(this.moment.poses[at + 1]!) - py,
        );
        if (distance < least) [nearest, least] = [{ side, number: n }, distance];
      }
    }
    return nearest;
  }

  draw(state: State): void {
    const { canvas, palette, match, moment, projection: to } = this;
    const { view } = state;
    const context = canvas.context;
    moment.set(view.time);
    if (view.follow) this.follow(view.robot);
    if (this.drawnGround !== to.key) drawGround(this.ground.context, canvas, to, match.about.field, palette);
    this.drawnGround = to.key;
    context.drawImage(this.ground.element, 0, 0, canvas.width, canvas.height);
    this.labels.clear();
    this.labels.takeBox(this.buttons);
    this.takeBodies();
    this.heat.draw(canvas, to, view, palette, this.labels);
    if (view.layers.trails) this.drawTrails();
    this.drawSetPlay();

    const pair = view.panel === "compare" ? view.pair : null;
    const compared = pair === null ? null : pair.robots.map((number) => ({ side: pair.side, number }));
    this.drawDrawings(view, compared);
    if (pair !== null) {
      pair.robots.forEach((number, i) => {
        const look = lookAt(match, pair.side, number, view.time);
        const color = i === 0 ? palette.first : palette.second;
        if (view.layers.belief && look.belief !== null) {
          const world = worldOf(look.belief, look.decision?.knowledge ?? "mine");
          const style = { color, ellipses: view.layers.ellipses, robots: pair.robots };
          drawBelief(context, to, match, moment, pair.side, number, world, palette, style, this.labels);
        }
      });
    } else if (view.robot !== null) {
      const look = lookAt(match, view.robot.side, view.robot.number, view.time);
      this.drawMind(look, view.robot, state);
    }
    this.drawRobots(state, compared);
    this.drawBall();
    this.labels.write(context, canvas, palette.grass);
  }

  // In the middle of the picture: the chosen robot, or, when none is chosen, the ball.
  private follow(robot: Robot | null): void {
    const { moment, match } = this;
    const [of, at] = robot === null ? [moment.ball, 0] : [moment.poses, 3 * match.game.place(robot.side, robot.number)];
    this.projection.centreOn(of[at]!, of[at + 1]!);
  }

  // What plugins drew: of the chosen robot, of both that are compared, or else of all.
  private drawDrawings({ drawings: layers, robot, time }: View, compared: Robot[] | null): void {
    const { drawings } = this.match;
    const robots = compared ?? (robot !== null ? [robot] : drawings.drawers);
    for (const layer of layers) {
      const style = styleOf(layer, this.palette.drawings);
      for (const each of robots) {
        const shapes = drawings.at(layer, each, time);
        const key = `drawing ${layer} ${each.side} ${each.number}`;
        drawShapes(this.canvas.context, this.projection, shapes, style, this.labels, key);
      }
    }
  }

  private drawMind(look: Look, robot: Robot, state: State): void {
    const { view } = state;
    const { context } = this.canvas;
    if (look.belief !== null && view.layers.belief) {
      drawBelief(
        context,
        this.projection,
        this.match,
        this.moment,
        robot.side,
        robot.number,
        worldOf(look.belief, knowledgeOf(look, view.knowledge)),
        this.palette,
        { color: null, ellipses: view.layers.ellipses, robots: null },
        this.labels,
      );
    }
    if (look.decision !== null) {
      const { layers } = view;
      const sites =
        layers.cells || layers.delaunay ? sitesOf(this.match, robot.side, robot.number, look.decision) : null;
      if (sites !== null)
        drawDiagram(this.canvas.context, this.projection, sites, this.match.about.field, this.palette, layers);
      drawPlan(
        context,
        this.projection,
        this.match,
        this.moment,
        robot.side,
        look.decision,
        this.palette,
        layers,
        this.labels,
      );
      const age = ageOf(look.decision, view.time);
      if (isOld(age) && (layers.nodes || layers.cells || layers.delaunay || layers.tasks))
        this.drawAge(`plan ${fixed(age!, 1)} s old`);
    }
  }

  // At the foot of the field: what is drawn of the plan is not of this moment.
  private drawAge(text: string): void {
    const { context, height } = this.canvas;
    context.font = font(11, 600);
    context.textAlign = "left";
    context.textBaseline = "middle";
    label(context, text, 10, height - 10, this.palette.tasks, this.palette.surround);
    const half = context.measureText(text).width / 2;
    this.labels.take(10 + half, height - 10, half + 2, 7);
  }

  private drawTrails(): void {
    const {
      match: { game },
      moment,
      palette,
      projection: to,
    } = this;
    const { context } = this.canvas;
    const first = Math.max(0, moment.index - trailSamples);
    context.lineWidth = 1.5;
    context.globalAlpha = 0.35;
    const robots = game.robots;
    for (const side of bothSides) {
      context.strokeStyle = side === 0 ? palette.home : palette.away;
      context.beginPath();
      for (let n = 1; n <= game.sizes[side]; ++n) {
        const place = game.place(side, n);
        trail(context, to, game.poses, first, moment.index, 3 * robots, 3 * place, 0.5, moment.poses, 3 * place);
      }
      context.stroke();
    }
    context.globalAlpha = 0.7;
    context.strokeStyle = palette.ball;
    context.beginPath();
    trail(context, to, game.ball, first, moment.index, 4, 0, 1.2, moment.ball, 0);
    context.stroke();
    context.globalAlpha = 1;
  }

  // Where the ball lies at a set play: a ring that opponents keep out of.
  private drawSetPlay(): void {
    const {
      match: { game },
      moment,
      palette,
      projection: to,
    } = this;
    if (game.setPlay[moment.index] === 0) return;
    const { context } = this.canvas;
    context.save();
    context.setLineDash([5, 4]);
    context.lineWidth = 1.5;
    context.strokeStyle = game.kicking[moment.index] === 0 ? palette.home : palette.away;
    context.beginPath();
    context.arc(to.x(moment.ball[0]!), to.y(moment.ball[1]!), 0.75 * to.scale, 0, 2 * Math.PI);
    context.stroke();
    context.restore();
  }

  private drawBall(): void {
    const { match, moment, projection: to } = this;
    const radius = shownBallRadius(match.about.ballRadius, to.scale);
    drawTrueBall(this.canvas.context, to.x(moment.ball[0]!), to.y(moment.ball[1]!), radius);
  }

  private drawRobots(state: State, compared: Robot[] | null): void {
    const { match, moment, palette, projection: to } = this;
    const { context } = this.canvas;
    const { game } = match;
    const { view } = state;
    context.textAlign = "center";
    context.textBaseline = "middle";
    const own = compared?.[0]?.side ?? view.robot?.side ?? null;
    for (const side of bothSides) {
      const color = side === 0 ? palette.home : palette.away;
      const radius = Math.max(8, match.about.teams[side].robotRadius * to.scale);
      const penalised = game.penalised[2 * moment.index + side]!;
      const fallen = game.fallen[2 * moment.index + side]!;
      const kicks = game.kicks[2 * moment.index + side]!;
      for (let n = 1; n <= game.sizes[side]; ++n) {
        const at = 3 * game.place(side, n);
        const x = to.x(moment.poses[at]!);
        const y = to.y(moment.poses[at + 1]!);
        const out = inMask(penalised, n);
        const down = inMask(fallen, n);
        const order = compared?.findIndex((robot) => robot.side === side && robot.number === n) ?? -1;
        const chosen = compared === null && view.robot?.side === side && view.robot.number === n;
        if (chosen || order >= 0) {
          context.lineWidth = 3;
          context.strokeStyle = chosen ? palette.text : order === 0 ? palette.first : palette.second;
          context.setLineDash(order === 1 ? [4, 2.5] : []);
          bodyPath(context, side, x, y, radius + 4);
          context.stroke();
          context.setLineDash([]);
        }
        context.globalAlpha = out ? 0.45 : 1;
        bodyPath(context, side, x, y, radius);
        context.fillStyle = down ? palette.grass : color;
        context.fill();
        context.lineWidth = down ? 2 : 1.5;
        context.strokeStyle = down ? color : palette.grass;
        context.stroke();
        context.strokeStyle = color;
        context.lineWidth = inMask(kicks, n) ? 5 : 3;
        headingPath(context, x, y, moment.poses[at + 2]!, radius, radius + (inMask(kicks, n) ? 8 : 5));
        context.stroke();
        context.fillStyle = down ? color : side === 0 ? palette["on-home"] : palette["on-away"];
        context.font = font(Math.round(1.15 * radius), 700);
        context.fillText(String(n), x, y + 0.5);
        if (out) {
          context.lineWidth = 2;
          context.strokeStyle = palette.text;
          context.beginPath();
          context.moveTo(x - radius, y + radius);
          context.lineTo(x + radius, y - radius);
          context.stroke();
        }
        context.globalAlpha = 1;
        const role = out ? "penalised" : roleText(game, match, moment.index, side, n);
        this.labels.add({
          key: `robot ${side} ${n}`,
          text: down ? `${role} fallen`.trim() : role,
          x,
          y,
          radius: chosen || order >= 0 ? radius + 5 : radius,
          ink: own === null || side === own ? palette.text : palette.muted,
          rank: chosen || order >= 0 ? "chosen" : own === null || side === own ? "own" : "other",
          pixels: 10,
        });
      }
    }
  }

  // Names stand beside robots and the ball, not upon them.
  private takeBodies(): void {
    const { match, moment, projection: to } = this;
    const ball = shownBallRadius(match.about.ballRadius, to.scale);
    this.labels.take(to.x(moment.ball[0]!), to.y(moment.ball[1]!), ball, ball);
    for (const side of bothSides) {
      const radius = Math.max(8, match.about.teams[side].robotRadius * to.scale);
      for (let n = 1; n <= match.game.sizes[side]; ++n) {
        const at = 3 * match.game.place(side, n);
        this.labels.take(to.x(moment.poses[at]!), to.y(moment.poses[at + 1]!), radius, radius);
      }
    }
  }
}

function roleText(game: Game, match: Match, index: number, side: 0 | 1, n: number): string {
  const role = game.role(index, side, n);
  return role < 0 ? "" : shortRoleName(match, side, role).replaceAll("_", " ");
}

function trail(
  context: CanvasRenderingContext2D,
  to: Projection,
  from: Float32Array,
  first: number,
  last: number,
  stride: number,
  offset: number,
  most: number,
  now: Float32Array,
  place: number,
): void {
  let x = 0;
  let y = 0;
  for (let i = first; i <= last + 1; ++i) {
    const at = i * stride + offset;
    const nextX = i <= last ? from[at]! : now[place]!;
    const nextY = i <= last ? from[at + 1]! : now[place + 1]!;
    const jumps = i === first || (nextX - x) ** 2 + (nextY - y) ** 2 > most * most;
    if (jumps) context.moveTo(to.x(nextX), to.y(nextY));
    else context.lineTo(to.x(nextX), to.y(nextY));
    x = nextX;
    y = nextY;
  }
}
