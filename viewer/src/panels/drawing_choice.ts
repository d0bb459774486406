// SPDX-License-Identifier: MIT
// Which layers of the plugins' drawings are drawn: a button among those below the field, which opens a list of switches,
// one for each layer.
import { drawingColours } from "../app/palette";
import type { State, View } from "../app/state";
import { layerText } from "../model/drawings";
import type { Match } from "../recording/match";
import { element, setText } from "./elements";
import { Popover } from "./popover";

export class DrawingChoice {
  private readonly button = element("button", { type: "button", id: "drawings-open" });
  private readonly list = element("div", { id: "drawings", role: "group", "aria-label": "Layers of plugins" });
  private readonly switches: HTMLButtonElement[];

  constructor(
    bar: HTMLElement,
    private readonly match: Match,
    private readonly state: State,
  ) {
    this.switches = match.drawings.layers.map((layer, i) => {
      const text = layerText(layer);
      const colour = element("span", { class: `layer-colour colour-${i % drawingColours}`, "aria-hidden": "true" });
      const title = `${text} on or off; the colour is that of shapes to which the plugin gives none`;
      const made = element("button", { type: "button", title }, colour, element("bdi", {}, text));
      made.addEventListener("click", () => state.toggleDrawing(i));
      return made;
    });
    this.list.append(...this.switches);
    this.button.hidden = !hasDrawings(match);
    new Popover(bar, this.button, this.list);
  }

  // All layers, or, where some are drawn, none.
  toggle(): void {
    const { layers } = this.match.drawings;
    this.state.set({ drawings: this.state.view.drawings.length > 0 ? [] : layers.map((_, i) => i) });
  }

  update({ drawings }: View): void {
    const { length } = this.switches;
    setText(this.button, `Drawings ${drawings.length}/${length}`);
    this.button.title = `Drawings of plugins: ${drawings.length} of ${length} layers (w: all or none)`;
    this.button.setAttribute("aria-pressed", String(drawings.length > 0));
    for (const [i, each] of this.switches.entries()) each.setAttribute("aria-pressed", String(drawings.includes(i)));
  }
}

// Where no plugin has drawn there is nothing to choose.
export const hasDrawings = (match: Match): boolean => match.drawings.layers.length > 0;
