// SPDX-License-Identifier: MIT
// The course of a match as columns, one entry for each sample of the truth (10 Hz), and the moment between two samples.
import { type Side, bothSides } from "../recording/about";
import { type GameMessage, phases, setPlays } from "../recording/messages";
import { WrongForm } from "../recording/checked";
import { lastNotAfter } from "../recording/log";

export const sampleSeconds = 0.1;
const longestSample = 0.15; // s; longer, and a part of the recording is missing
export const playing = phases.indexOf("playing");

// Farther than this between two samples nothing moves by itself: it was put there.
const greatestStep = { robot: 0.5, ball: 1.2 }; // m

type Column = Float64Array | Float32Array | Int32Array | Int16Array | Uint32Array | Uint8Array;

function grown<T extends Column>(column: T, length: number): T {
  const larger = new (column.constructor as new (length: number) => T)(length);
  larger.set(column);
  return larger;
}

export function maskOf(numbers: readonly number[]): number {
  let mask = 0;
  for (const number of numbers) mask |= 1 << (number - 1);
  return mask >>> 0;
}

export const inMask = (mask: number, number: number): boolean => ((mask >>> (number - 1)) & 1) === 1;

export class Game {
  count = 0;
  times = new Float64Array(0);
  clock = new Float32Array(0);
  half = new Uint8Array(0);
  phase = new Uint8Array(0); // place in phases
  setPlay = new Uint8Array(0); // place in setPlays
  kicking = new Uint8Array(0);
  score = new Int32Array(0); // [sample * 2 + side]
  packetsLeft = new Int32Array(0);
  penalised = new Uint32Array(0); // robots as bits
  fallen = new Uint32Array(0);
  kicks = new Uint32Array(0);
  chases = new Uint32Array(0); // who goes for the ball
  tellsChases = false; // recordings of earlier versions do not
  ball = new Float32Array(0); // [sample * 4]: x, y, vx, vy
  poses = new Float32Array(0); // [(sample * robots + robot) * 3]: x, y, heading; home first
  roles = new Int16Array(0); // [sample * robots + robot]

  constructor(readonly sizes: readonly [number, number]) {}

  get robots(): number {
    return this.sizes[0] + this.sizes[1];
  }

  // Place of a robot among those of both teams.
  place(side: Side, number: number): number {
    return (side === 0 ? 0 : this.sizes[0]) + number - 1;
  }

  add(m: GameMessage): void {
    for (const side of bothSides) {
      if (m.robots[side].length !== this.sizes[side] || m.roles[side].length !== this.sizes[side]) {
        throw new WrongForm("it has another number of robots than those before it");
      }
    }
    if (this.count > 0 && m.time <= this.times[this.count - 1]!)
      throw new WrongForm("it is not later than the one before it");
    if (this.count === this.times.length) this.grow();
    const i = this.count++;
    this.times[i] = m.time;
    this.clock[i] = m.clock;
    this.half[i] = m.half;
    this.phase[i] = phases.indexOf(m.phase);
    this.setPlay[i] = setPlays.indexOf(m.setPlay);
    this.kicking[i] = m.kicking;
    this.ball.set(m.ball, 4 * i);
    this.tellsChases ||= m.chases !== null;
    let robot = i * this.robots;
    for (const side of bothSides) {
      this.score[2 * i + side] = m.score[side];
      this.packetsLeft[2 * i + side] = m.packetsLeft[side];
      this.penalised[2 * i + side] = maskOf(m.penalised[side]);
      this.fallen[2 * i + side] = maskOf(m.fallen[side]);
      this.kicks[2 * i + side] = maskOf(m.kicks[side]);
      this.chases[2 * i + side] = maskOf(m.chases?.[side] ?? []);
      for (let n = 0; n < this.sizes[side]; ++n, ++robot) {
        this.poses.set(m.robots[side][n]!, 3 * robot);
        this.roles[robot] = m.roles[side][n]!;
      }
    }
  }

  private grow(): void {
    const length = Math.max(1024, 2 * this.times.length);
    const robots = this.robots;
    this.times = grown(this.times, length);
    this.clock = grown(this.clock, length);
    this.half = grown(this.half, length);
    this.phase = grown(this.phase, length);
    this.setPlay = grown(this.setPlay, length);
    this.kicking = grown(this.kicking, length);
    this.score = grown(this.score, 2 * length);
    this.packetsLeft = grown(this.packetsLeft, 2 * length);
    this.penalised = grown(this.penalised, 2 * length);
    this.fallen = grown(this.fallen, 2 * length);
    this.kicks = grown(this.kicks, 2 * length);
    this.chases = grown(this.chases, 2 * length);
    this.ball = grown(this.ball, 4 * length);
    this.poses = grown(this.poses, 3 * robots * length);
    this.roles = grown(this.roles, robots * length);
  }

  get begin(): number {
    return this.times[0] ?? 0;
  }

  get end(): number {
    return this.times[this.count - 1] ?? 0;
  }

  // When the ball was first in play; the beginning where it never was.
  get kickOff(): number {
    const first = this.phase.subarray(0, this.count).indexOf(playing);
    return this.times[Math.max(0, first)] ?? 0;
  }

  // The sample in force at `time`: the last not after it, or the first.
  indexAt(time: number): number {
    return Math.max(0, lastNotAfter(this.times, time, this.count));
  }

  // When a sample ceases to tell of the match: at the next one, or 0.1 s later where none follows so soon.
  until(index: number): number {
    const next = index + 1 < this.count ? this.times[index + 1]! : Infinity;
    return next - this.times[index]! > longestSample ? this.times[index]! + sampleSeconds : next;
  }

  // The sample follows its predecessor as usual: nothing is missing between them.
  follows(index: number): boolean {
    return index > 0 && this.times[index]! - this.times[index - 1]! <= longestSample;
  }

  role(index: number, side: Side, number: number): number {
    return this.roles[index * this.robots + this.place(side, number)]!;
  }

  isPenalised(index: number, side: Side, number: number): boolean {
    return inMask(this.penalised[2 * index + side]!, number);
  }
}

// Truth at one time, between two samples.
export class Moment {
  time = 0;
  index = 0; // of the sample in force
  ball = new Float32Array(2);
  poses: Float32Array; // [robot * 3]

  constructor(private readonly game: Game) {
    this.poses = new Float32Array(3 * game.robots);
  }

  set(time: number): this {
    const { game } = this;
    const i = game.indexAt(time);
    this.time = time;
    this.index = i;
    const next = Math.min(i + 1, game.count - 1);
    const span = game.times[next]! - game.times[i]!;
    const share = span > 0 && span <= longestSample ? Math.min(1, Math.max(0, (time - game.times[i]!) / span)) : 0;
    mix(game.ball, 4 * i, 4 * next, share, greatestStep.ball, this.ball, 0);
    const stride = 3 * game.robots;
    for (let offset = 0; offset < stride; offset += 3) {
      const from = i * stride + offset;
      const to = next * stride + offset;
      const moved = mix(game.poses, from, to, share, greatestStep.robot, this.poses, offset);
      const turn = game.poses[to + 2]! - game.poses[from + 2]!;
      this.poses[offset + 2] = game.poses[from + 2]! + (moved ? share * Math.atan2(Math.sin(turn), Math.cos(turn)) : 0);
    }
    return this;
  }
}

function mix(
  from: Float32Array,
  a: number,
  b: number,
  share: number,
  most: number,
  to: Float32Array,
  at: number,
): boolean {
  const dx = from[b]! - from[a]!;
  const dy = from[b + 1]! - from[a + 1]!;
  const moves = dx * dx + dy * dy <= most * most;
  to[at] = from[a]! + (moves ? share * dx : 0);
  to[at + 1] = from[a + 1]! + (moves ? share * dy : 0);
  return moves;
}

// In the phase Playing, without a set play.
export const inPlay = (game: Game, i: number): boolean => game.phase[i] === playing && game.setPlay[i] === 0;
