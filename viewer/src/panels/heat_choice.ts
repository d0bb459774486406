// SPDX-License-Identifier: MIT
// Which heat map is drawn, and over which stretch of the match: a button among those below the field, which opens a
// list of choices.
import { type HeatWhat, type HeatStretch, type State, type View, heatStretches, heatWhats } from "../app/state";
import type { Match } from "../recording/match";
import { element } from "./elements";
import { Popover } from "./popover";

export const stretchTexts: Record<HeatStretch, string> = {
  match: "whole match",
  first: "first half",
  second: "second half",
  window: "what the timeline shows",
};

// "ball", "robots of blue", "robot 3 of blue"
export function heatText(match: Match, what: HeatWhat, { robot }: View): string {
  if (what === "ball") return "ball";
  if (what === "robot")
    return robot === null ? "chosen robot" : `robot ${robot.number} of ${match.about.teams[robot.side].name}`;
  return `robots of ${match.about.teams[what === "home" ? 0 : 1].name}`;
}

export class HeatChoice {
  private readonly button = element("button", { type: "button", id: "heat-open" }, "Heat map");
  private readonly stretch = element("select", { id: "heat-stretch", "aria-label": "Stretch of the match" });
  private readonly whats: [HeatWhat | null, HTMLButtonElement][];

  constructor(
    bar: HTMLElement,
    private readonly match: Match,
    private readonly state: State,
  ) {
    const second = match.game.half[match.game.count - 1]! >= 2;
    for (const value of heatStretches)
      if (value !== "second" || second) this.stretch.append(element("option", { value }, stretchTexts[value]));
    this.stretch.addEventListener("change", () => state.set({ heatStretch: this.stretch.value as HeatStretch }));
    this.whats = [null, ...heatWhats].map((what) => {
      const made = element("button", { type: "button" }, element("bdi", {}));
      made.addEventListener("click", () => state.set({ heat: what }));
      return [what, made];
    });
    const list = element("div", { id: "heat", role: "group", "aria-label": "Heat map" });
    list.append(...this.whats.map(([, made]) => made), this.stretch);
    new Popover(bar, this.button, list);
  }

  // On, of what it was the last time, or off.
  toggle(): void {
    const { heat } = this.state.view;
    this.state.set({ heat: heat === null ? this.last : null });
  }
  private last: HeatWhat = "ball";

  update(view: View): void {
    const { heat, heatStretch } = view;
    if (heat !== null) this.last = heat;
    const shown = heat === null ? "none" : `${heatText(this.match, heat, view)}, ${stretchTexts[heatStretch]}`;
    this.button.title = `Heat map: ${shown} (h: on or off)`;
    this.button.setAttribute("aria-pressed", String(heat !== null));
    this.stretch.value = heatStretch;
    for (const [what, made] of this.whats) {
      const text = what === null ? "no heat map" : heatText(this.match, what, view);
      if (made.textContent !== text) made.firstElementChild!.textContent = text;
      made.setAttribute("aria-pressed", String(what === heat));
    }
  }
}
