// SPDX-License-Identifier: MIT
// What is drawn on the field: buttons below it, one for each layer, with the name of what it draws.
import { type LayerName, type State, type View, layerNames } from "../app/state";
import { type Computed, computedBy } from "../model/positioner";
import { listText, shortened } from "../model/text";
import type { Match } from "../recording/match";
import { element, setText } from "./elements";

const texts: Record<LayerName, string> = {
  belief: "Belief",
  ellipses: "Ellipses",
  tasks: "Tasks",
  trails: "Trails",
  nodes: "Positioner", // the button names what the team's positioner gives
  cells: "Voronoi cells",
  delaunay: "Delaunay edges",
};
export const layerKeys: Record<LayerName, string> = {
  belief: "b",
  ellipses: "i",
  tasks: "j",
  trails: "l",
  nodes: "u",
  cells: "v",
  delaunay: "V",
};
const mostLetters = 32; // of a positioner
const shownKey = (layer: LayerName) => layerKeys[layer].replace(/^[A-Z]$/, (letter) => `Shift ${letter.toLowerCase()}`);

export class LayerChoice {
  private readonly computed: readonly [Computed, Computed]; // by side
  private readonly buttons: Record<LayerName, HTMLButtonElement>;

  constructor(
    bar: HTMLElement,
    private readonly match: Match,
    private readonly state: State,
  ) {
    this.computed = [computedBy(match, 0), computedBy(match, 1)];
    const made = layerNames.map((layer) => {
      const title = `${texts[layer]} on or off (${shownKey(layer)})`;
      const button = element("button", { type: "button", id: `layer-${layer}`, title }, texts[layer]);
      button.addEventListener("click", () => state.toggle(layer));
      return [layer, button] as const;
    });
    this.buttons = Object.fromEntries(made) as Record<LayerName, HTMLButtonElement>;
    const diagram = this.computed.some((each) => each.diagram);
    for (const layer of ["cells", "delaunay"] as const) this.buttons[layer].hidden = !diagram;
    bar.append(...Object.values(this.buttons));
  }

  // As a click on its button: nothing where there is nothing to draw.
  toggle(layer: LayerName): void {
    if (!this.buttons[layer].disabled && !this.buttons[layer].hidden) this.state.toggle(layer);
  }

  // For the list of keys.
  keyOf(layer: LayerName): { shown: string; does: string } {
    const points = listText([...new Set(this.computed.flatMap((each) => each.points))]);
    const text = layer === "nodes" ? points || "what a positioner gives" : texts[layer];
    const word = /^(Voronoi|Delaunay)/.test(text) ? text : `${text[0]!.toLowerCase()}${text.slice(1)}`;
    return { shown: shownKey(layer), does: `${word} on or off` };
  }

  update(view: View): void {
    const team = this.match.about.teams[view.side].name;
    const { points, diagram } = this.computed[view.side];
    for (const layer of layerNames) this.buttons[layer].setAttribute("aria-pressed", String(view.layers[layer]));
    const { nodes, cells, delaunay } = this.buttons;
    nodes.disabled = points.length === 0;
    setText(nodes, points.length === 0 ? "No positioner" : shortened(listText(points), mostLetters));
    nodes.title =
      points.length === 0
        ? `${team} has no positioner`
        : `${listText(points)} that the positioner of the chosen robot of ${team} gave, on or off (${shownKey("nodes")})`;
    cells.disabled = !diagram;
    delaunay.disabled = !diagram;
    const none = `No positioner of ${team} has a Voronoi diagram`;
    const sites = `sites that the chosen robot of ${team} believed in, on or off`;
    cells.title = diagram ? `Voronoi cells of the ${sites} (${shownKey("cells")})` : none;
    delaunay.title = diagram ? `Delaunay edges between the ${sites} (${shownKey("delaunay")})` : none;
  }
}
