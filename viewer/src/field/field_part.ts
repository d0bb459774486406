// SPDX-License-Identifier: MIT
// Which part of the field is shown: by the pointer, by buttons over the field's edge, by keys.
import type { State, View } from "../app/state";
import { element, setText } from "../panels/elements";
import type { Box } from "./placement";
import { listenToPointer } from "./pointer";
import type { Projection } from "./projection";

const step = 1.5;
const followZoom = 3; // where following begins with the whole field

export class FieldPart {
  private readonly out = this.button("field-out", "\u2212", "Less near (Shift z, wheel)", () => this.zoom(1 / step));
  private readonly in = this.button("field-in", "+", "Nearer (z, wheel)", () => this.zoom(step));
  private readonly all = this.button("field-whole", "whole", "The whole field (x, double click)", () => this.whole());
  private readonly followed = this.button("field-follow", "follow ball", "", () => this.follow());

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly bar: HTMLElement,
    private readonly to: Projection,
    private readonly state: State,
    clicked: (px: number, py: number) => void,
  ) {
    bar.append(this.out, this.in, this.all, this.followed);
    listenToPointer(canvas, to, { clicked, shown: (byHand) => this.shown(byHand), whole: () => this.whole() });
  }

  private button(id: string, text: string, title: string, run: () => void): HTMLButtonElement {
    const made = element("button", { type: "button", id, title, "aria-label": title }, text);
    made.addEventListener("click", run);
    return made;
  }

  zoom(factor: number): void {
    this.to.zoomBy(factor);
    this.shown(false);
  }

  whole(): void {
    this.to.whole();
    this.shown(true);
  }

  follow(): void {
    const follow = !this.state.view.follow;
    if (follow && this.to.zoom === 1) this.to.zoomBy(followZoom);
    this.state.set({ follow });
    this.shown(!follow);
  }

  // byHand: what was followed is so no longer.
  private shown(byHand: boolean): void {
    if (byHand) this.state.set({ follow: false });
    this.update(this.state.view);
    this.state.touch();
  }

  // The part of the canvas that the buttons cover.
  get box(): Box {
    const [bar, field] = [this.bar.getBoundingClientRect(), this.canvas.getBoundingClientRect()];
    const [left, top] = [bar.left - field.left, bar.top - field.top];
    return { left, top, right: left + bar.width, bottom: top + bar.height };
  }

  update({ follow, robot }: View): void {
    const zoomed = this.to.zoom > 1;
    this.canvas.classList.toggle("zoomed", zoomed);
    this.out.disabled = !zoomed;
    this.all.disabled = !zoomed;
    setText(this.followed, robot === null ? "follow ball" : `follow ${robot.number}`);
    const whom = robot === null ? "the ball" : "the chosen robot";
    const title = `The field follows ${whom}, or rests (y)`;
    this.followed.title = title;
    this.followed.setAttribute("aria-label", title);
    this.followed.setAttribute("aria-pressed", String(follow));
  }
}
