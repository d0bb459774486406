// SPDX-License-Identifier: MIT
// Who is at the ball, who could soon be, who goes for it, and what each said of it: of one moment. Able are robots that
// are not penalised and have not fallen; one that has crashed counts as able here, for recordings do not tell of that.
import { type Side, bothSides } from "../recording/about";
import { lastNotAfter } from "../recording/log";
import type { Match } from "../recording/match";
import type { LogLine } from "../recording/plugin_messages";
import { inMask, inPlay } from "./game";
import { shortRoleName } from "./look";
import { fixed, listText, secondsText, timeText, words } from "./text";

// Those of the metric ball_rest_seconds.
export const atRest = 0.05; // m/s
export const soon = 3; // s

export interface AtBall {
  number: number;
  metres: number; // from the robot's centre to the ball's
  seconds: number | null; // until its body is there, straight, at full forward speed; null: the speed is not recorded
  role: number;
  plays: boolean | null; // its role plays the ball; null: not recorded
  chases: boolean | null; // it goes for the ball; null: not recorded
  claim: LogLine | null; // the last that it said of its claim to the ball
}

export interface BallMoment {
  inPlay: boolean;
  robots: [AtBall[], AtBall[]]; // by side, the soonest first
  restsSince: number | null; // s; null: it does not rest, or nobody could be there soon
  nobodyGoes: boolean; // of neither team
}

// Lines of the log that tell of a claim to the ball, by robot.
export class Claims {
  private readonly lines = new Map<string, { times: number[]; lines: LogLine[] }>();

  // all: by time.
  constructor(all: readonly LogLine[]) {
    for (const line of all) {
      if (!line.text.startsWith("claim:")) continue;
      const key = `${line.side} ${line.robot}`;
      const own = this.lines.get(key) ?? { times: [], lines: [] };
      this.lines.set(key, own);
      own.times.push(line.time);
      own.lines.push(line);
    }
  }

  get any(): boolean {
    return this.lines.size > 0;
  }

  last(side: Side, robot: number, time: number): LogLine | null {
    const own = this.lines.get(`${side} ${robot}`);
    return own === undefined ? null : (own.lines[lastNotAfter(own.times, time + 1e-9)] ?? null);
  }
}

export const claimText = (line: LogLine): string => line.text.slice("claim:".length).trim();

function robotsAt(match: Match, claims: Claims | null, side: Side, i: number): AtBall[] {
  const { game, about } = match;
  const team = about.teams[side];
  const out: AtBall[] = [];
  for (let number = 1; number <= game.sizes[side]; ++number) {
    if (game.isPenalised(i, side, number) || inMask(game.fallen[2 * i + side]!, number)) continue;
    const at = 3 * (i * game.robots + game.place(side, number));
    const metres = Math.hypot(game.poses[at]! - game.ball[4 * i]!, game.poses[at + 1]! - game.ball[4 * i + 1]!);
    const role = game.role(i, side, number);
    out.push({
      number,
      metres,
      seconds: team.walkSpeed === null ? null : Math.max(0, metres - team.robotRadius) / team.walkSpeed,
      role,
      plays: role < 0 ? false : (team.roles[role]?.playsBall ?? null),
      chases: game.tellsChases ? inMask(game.chases[2 * i + side]!, number) : null,
      claim: claims?.last(side, number, game.times[i]!) ?? null,
    });
  }
  return out.sort((a, b) => a.metres - b.metres || a.number - b.number);
}

// As in the metric ball_rest_seconds: in this sample the ball lies in play, and somebody could soon be there.
function rests(match: Match, i: number): boolean {
  const { game } = match;
  if (!inPlay(game, i)) return false;
  if (Math.hypot(game.ball[4 * i + 2]!, game.ball[4 * i + 3]!) >= atRest) return false;
  return bothSides.some((side) => {
    const first = robotsAt(match, null, side, i)[0];
    return first !== undefined && first.seconds !== null && first.seconds <= soon;
  });
}

export function ballMoment(match: Match, claims: Claims, time: number): BallMoment {
  const { game } = match;
  const i = game.indexAt(time);
  let restsSince: number | null = null;
  for (let at = i; at >= 0 && rests(match, at); --at) {
    restsSince = game.times[at]!;
    if (!game.follows(at)) break;
  }
  return {
    inPlay: inPlay(game, i),
    robots: [robotsAt(match, claims, 0, i), robotsAt(match, claims, 1, i)],
    restsSince,
    nobodyGoes: game.tellsChases && game.chases[2 * i] === 0 && game.chases[2 * i + 1] === 0,
  };
}

const away = (robot: AtBall): string =>
  robot.seconds === null ? `${fixed(robot.metres, 1)} m away` : `${secondsText(robot.seconds)} away`;

// "robot 2 (defender, 2.4 s away), which said at 0:36.0: “leaves the ball to 3”"
function whole(match: Match, side: Side, robot: AtBall): string {
  const role = robot.role < 0 ? "no role" : words(shortRoleName(match, side, robot.role));
  const { claim } = robot;
  const said = claim === null ? "" : `, which said at ${timeText(claim.time)}: “${claimText(claim)}”`;
  return `robot ${robot.number} (${role}, ${away(robot)})${said}`;
}

// Of one team: who goes; and where the nearest does not, who that is, who has the role, what the claim said.
function teamSentence(match: Match, side: Side, robots: readonly AtBall[]): string {
  const team = match.about.teams[side].name;
  const first = robots[0];
  if (first === undefined) return `${team}: no robot is able to play.`;
  const chasing = robots.filter((robot) => robot.chases === true);
  const who = chasing.map((robot) => `robot ${robot.number} (${away(robot)})`);
  const goes = `${team}: ${who.length === 0 ? "nobody goes" : `${listText(who)} ${who.length === 1 ? "goes" : "go"}`} for the ball.`;
  if (first.chases === true) return goes;
  const holders = robots.filter((robot) => robot.plays === true);
  const nearest = `Nearest is ${whole(match, side, first)}`;
  if (holders.includes(first)) return `${goes} ${nearest}; its role plays the ball.`;
  if (holders.length === 0) return `${goes} ${nearest}; nobody has a role that plays the ball.`;
  const others = holders.map((robot) => whole(match, side, robot));
  return `${goes} ${nearest}; the role that plays the ball is that of ${listText(others)}.`;
}

// The moment in sentences: first whether the ball rests, then a sentence for each team.
export function ballSentences(match: Match, moment: BallMoment, time: number): string[] {
  if (!moment.inPlay) return ["The ball is not in play."];
  if (!match.game.tellsChases) return ["This recording does not tell who goes for the ball."];
  const rests = moment.restsSince === null ? null : secondsText(Math.max(0, time - moment.restsSince));
  return [
    ...(rests === null
      ? []
      : [`The ball has rested for ${rests}${moment.nobodyGoes ? ", and nobody goes for it" : ""}.`]),
    ...bothSides.map((side) => teamSentence(match, side, moment.robots[side])),
  ];
}
