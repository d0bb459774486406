// SPDX-License-Identifier: MIT
// A whole recording, read: the course of the match ready to be drawn, decisions and beliefs as bytes until they are
// asked for. What cannot be read is left out and named in `faults`.
import { Drawings } from "../model/drawings";
import { Game, playing, sampleSeconds } from "../model/game";
import { Packets } from "../model/packets";
import { type RoleCourse, roleCourse } from "../model/roles";
import { Segments } from "../model/segments";
import { listText, timeText } from "../model/text";
import { type About, type Side, UnreadableRecording, aboutOf, bothSides, sideNames } from "./about";
import { WrongForm } from "./checked";
import type { Content } from "./content";
import { type ContainerMessage, Slices, readContainer } from "./container";
import { aheadOfMatch, isInOrder, sortByTime } from "./in_time";
import { Log, parsedJson } from "./log";
import {
  type Belief,
  type Decision,
  type EventMessage,
  beliefOf,
  decisionOf,
  eventOf,
  gameOf,
  heardOf,
  packetOf,
  phases,
  segmentOf,
} from "./messages";
import { type PlayMessage, playOf } from "./play_messages";
import { type LogLine, logLineOf } from "./plugin_messages";

export interface Match {
  about: About;
  game: Game;
  events: EventMessage[];
  plays: PlayMessage[]; // shots, meant passes, clearances, duels, by when they began
  packets: Packets;
  segments: Segments;
  lines: LogLine[]; // that plugins wrote, by time
  drawings: Drawings;
  decisions: [Log<Decision>[], Log<Decision>[]]; // by side and robot (n - 1)
  beliefs: [Log<Belief>[], Log<Belief>[]];
  courses: [RoleCourse, RoleCourse]; // by side
  // Whether the phase was Playing when a decision was taken: [side][robot - 1][decision].
  inPlay: [boolean[][], boolean[][]];
  gaps: Gap[]; // of the truth, in the order of time: chunks that cannot be read
  faults: string[]; // sentences, the first ones of each kind
}

// Nothing is known between two samples; s. to: null: the end of the match is missing.
export interface Gap {
  from: number;
  to: number | null;
}

// A whole match has some 22 MB; unpacked, a recording takes about five times its size in memory.
export const mostBytes = 256 * 2 ** 20;

// Events with which a phase begins; the truth is sampled, so a phase may begin between two samples.
const phaseOfEvent: Readonly<Record<string, number>> = {
  half_begins: phases.indexOf("initial"),
  ready: phases.indexOf("ready"),
  set: phases.indexOf("set"),
  penalty_kick: phases.indexOf("ready"),
  kick_off: playing,
  whistle: playing,
  opening: playing,
  finished: phases.indexOf("finished"),
};

const finished = phases.indexOf("finished");

// Robots a recording may name: the truth holds them as bits.
const mostRobots = 31;

class Reading {
  game: Game | null = null;
  events: EventMessage[] = [];
  readonly plays: PlayMessage[] = [];
  packets: Packets | null = null;
  readonly segments = new Segments();
  readonly lines: LogLine[] = [];
  readonly drawings = new Drawings();
  decisions: [Log<Decision>[], Log<Decision>[]] = [[], []];
  beliefs: [Log<Belief>[], Log<Belief>[]] = [[], []];
  inPlay: [boolean[][], boolean[][]] = [[], []];
  waiting: (() => void)[] = []; // packets written before the first sample of the truth
  phase = -1;
  gaps: Gap[] = [];
  private open: Gap | null = null;
  faultCount = new Map<string, { count: number; first: string }>();

  // time: s, of the log
  message(topic: string, time: number, content: Content): void {
    try {
      this.take(topic, time, content);
    } catch (error) {
      if (!(error instanceof WrongForm)) throw error;
      const fault = this.faultCount.get(topic);
      if (fault !== undefined) ++fault.count;
      else this.faultCount.set(topic, { count: 1, first: `at ${timeText(time)}: ${error.message}` });
    }
  }

  damage(): void {
    this.open ??= { from: this.game === null || this.game.count === 0 ? 0 : this.game.end, to: null };
  }

  // What is missing up to the end.
  close(): void {
    if (this.open !== null && this.game !== null && this.game.phase[this.game.count - 1] !== finished)
      this.gaps.push(this.open);
  }

  private take(topic: string, time: number, content: Content): void {
    switch (topic) {
      case "/game": {
        const message = gameOf(parsedJson(content));
        if (this.game === null) {
          const sizes = [message.robots[0].length, message.robots[1].length] as const;
          if (Math.max(...sizes) > mostRobots) throw new WrongForm(`more than ${mostRobots} robots in a team`);
          this.game = new Game(sizes);
          this.packets = new Packets(sizes);
        }
        this.game.add(message);
        if (this.open !== null) {
          this.open.to = message.time;
          // Nothing of the truth is missing when the samples go on as usual.
          if (message.time - this.open.from > 1.5 * sampleSeconds) this.gaps.push(this.open);
          this.open = null;
        }
        this.phase = phases.indexOf(message.phase);
        this.waiting.splice(0).forEach((add) => add());
        return;
      }
      case "/event": {
        const event = eventOf(parsedJson(content));
        this.events.push(event);
        this.phase = phaseOfEvent[event.event] ?? this.phase;
        return;
      }
      case "/play":
        this.plays.push(playOf(parsedJson(content)));
        return;
      case "/packet": {
        const packet = packetOf(parsedJson(content));
        return this.whenKnown(() => this.packets!.addSent(packet));
      }
      case "/heard": {
        const heard = heardOf(parsedJson(content));
        return this.whenKnown(() => this.packets!.addHeard(heard));
      }
      case "/segment":
        return this.segments.add(segmentOf(parsedJson(content)));
      case "/log":
        this.lines.push(logLineOf(parsedJson(content)));
        return;
      case "/draw":
        return this.drawings.add(content);
    }
    const [, kind, sideName, digits] = topic.split("/");
    const side = sideNames.indexOf(sideName as "home" | "away") as Side | -1;
    const number = Number(digits);
    if ((kind !== "decision" && kind !== "belief") || side === -1) return; // of something else: leave it
    if (!Number.isInteger(number) || number < 1 || number > mostRobots) return;
    if (kind === "decision") {
      (this.decisions[side][number - 1] ??= new Log(decisionOf)).add(time, content);
      (this.inPlay[side][number - 1] ??= []).push(this.phase === playing);
    } else {
      (this.beliefs[side][number - 1] ??= new Log(beliefOf)).add(time, content);
    }
  }

  private whenKnown(add: () => void): void {
    if (this.packets === null) this.waiting.push(add);
    else add();
  }
}

function missingText(gaps: readonly Gap[]): string {
  const texts = gaps.map(({ from, to }) =>
    to === null ? `everything after ${timeText(from)}` : `${timeText(from)} to ${timeText(to)}`,
  );
  if (texts.length === 0) return "no moment of the match is missing";
  const few = texts.length > 4 ? [...texts.slice(0, 3), `${texts.length - 3} times more`] : texts;
  return `${listText(few)} ${texts.length === 1 ? "is" : "are"} missing, the rest is shown`;
}

// Other topics are of something else: they take no memory.
const ourTopics = /^\/(game|event|play|packet|heard|segment|log|draw|(decision|belief)\/(home|away)\/[1-9]\d*)$/;

// Shares of the time that reading takes.
const unpacking = 0.4;

const early = "This recording breaks off before it describes its match.";
const foreign = "This is an MCAP file, but not the recording of a match by Regista: it does not describe a match.";

const unordered =
  "Of this recording the messages are not in the order of time, so this page cannot say what is missing of it.";

export async function readMatch(bytes: Uint8Array, progress: (share: number) => void = () => {}): Promise<Match> {
  const found: { about: About | null } = { about: null };
  const messages: ContainerMessage[] = [];
  const damagedBefore: number[] = []; // places in `messages`
  const damage = await readContainer(
    bytes,
    {
      metadata: (name, pairs) => {
        if (name === "match") found.about ??= aboutOf(pairs);
      },
      message: (message) => {
        if (ourTopics.test(message.topic)) messages.push(message);
      },
      damage: () => damagedBefore.push(messages.length),
    },
    (share) => progress(unpacking * share),
  );
  const broken = damage.parts > 0 ? ` The file is damaged: ${damage.reason}.` : damage.cutOff ? " It is cut off." : "";
  const { about } = found;
  if (about === null) throw new UnreadableRecording(broken === "" ? foreign : early + broken);
  if (!isInOrder(messages)) {
    if (damage.parts > 0) throw new UnreadableRecording(unordered + broken);
    sortByTime(messages);
  }

  const reading = new Reading();
  const ahead = aheadOfMatch(messages);
  const slices = new Slices(progress);
  for (let i = 0, next = 0; ; ++i) {
    for (; damagedBefore[next] === i; ++next) reading.damage();
    const message = messages[i];
    if (message === undefined) break;
    const { topic, logTime, content } = message;
    reading.message(topic, Math.max(0, Number(logTime - ahead) * 1e-9), content);
    if (slices.due) await slices.rest(unpacking + ((1 - unpacking) * i) / messages.length);
  }
  reading.close();
  const { game, packets } = reading;
  const faults: string[] = [];
  for (const [topic, { count, first }] of reading.faultCount) {
    faults.push(`${count} ${count === 1 ? "message" : "messages"} of ${topic} cannot be read, the first one ${first}.`);
  }
  if (game === null || packets === null || game.count === 0) {
    const why = reading.faultCount.size > 0 ? ` ${faults.join(" ")}` : "";
    throw new UnreadableRecording(`The recording holds no moment of the match.${why}${broken}`);
  }
  if (damage.cutOff)
    faults.unshift(`This recording is cut off. What is complete is shown, up to ${timeText(game.end)}.`);
  if (damage.parts > 0) {
    const parts = damage.parts === 1 ? "1 part of it" : `${damage.parts} parts of it`;
    const missing = missingText(reading.gaps);
    faults.unshift(`This recording is damaged: ${missing}. ${parts} cannot be read: ${damage.reason}.`);
  }

  packets.close(game.end, reading.gaps);
  reading.segments.close();
  reading.plays.sort((a, b) => a.began - b.began);
  reading.lines.sort((a, b) => a.time - b.time);
  reading.drawings.close();
  for (const side of bothSides) {
    for (let n = 0; n < game.sizes[side]; ++n) {
      reading.decisions[side][n] ??= new Log(decisionOf);
      reading.beliefs[side][n] ??= new Log(beliefOf);
      reading.inPlay[side][n] ??= [];
    }
  }
  const course = (side: Side) => roleCourse(game, side, about.teams[side].roles);
  return {
    about,
    game,
    plays: reading.plays,
    packets,
    segments: reading.segments,
    lines: reading.lines,
    drawings: reading.drawings,
    faults,
    gaps: reading.gaps,
    events: reading.events,
    decisions: reading.decisions,
    beliefs: reading.beliefs,
    inPlay: reading.inPlay,
    courses: [course(0), course(1)],
  };
}
