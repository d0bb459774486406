// SPDX-License-Identifier: MIT
// The head of the page: teams, score, the game's clock and phase, and what of the recording could not be read.
import { timeText, words } from "../model/text";
import { phases, setPlays } from "../recording/messages";
import type { Match } from "../recording/match";
import { byId, setText } from "./elements";

export class Head {
  constructor(private readonly match: Match) {
    const { teams } = match.about;
    setText(byId("home-name"), teams[0].name);
    setText(byId("away-name"), teams[1].name);
    byId("home-name").title = teams[0].name;
    byId("away-name").title = teams[1].name;
    document.title = `${teams[0].name} \u2013 ${teams[1].name}`;
  }

  update(time: number): void {
    const { game, about, drawings } = this.match;
    const i = game.indexAt(time);
    const missing = this.match.gaps.some(({ from, to }) => time > from + 0.1 && time < (to ?? Infinity) - 1e-6);
    setText(byId("goals"), `${game.score[2 * i]} : ${game.score[2 * i + 1]}`);
    // What is wrong with a drawing is known once it was to be drawn.
    const faults = [...this.match.faults, drawings.fault].filter((fault) => fault !== "");
    setText(byId("faults"), faults.join(" "));
    if (byId("faults").title !== faults.join("\n")) byId("faults").title = faults.join("\n");
    const setPlay = setPlays[game.setPlay[i]!]!;
    const kicking =
      setPlay === "none" ? "" : `, ${words(setPlay)} of ${about.teams[game.kicking[i] === 0 ? 0 : 1].name}`;
    const half = `half ${game.half[i]}, clock ${timeText(game.clock[i]!, 0)}, ${phases[game.phase[i]!]}${kicking}`;
    const toRight = game.half[i]! % 2 === 1 ? 0 : 1;
    for (const [id, text] of [
      ["game", missing ? "this part of the recording is damaged" : half],
      ["attack", `${about.teams[toRight].name} attacks \u2192`],
    ] as const) {
      setText(byId(id), text);
      byId(id).title = text;
    }
  }
}
