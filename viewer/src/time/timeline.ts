// SPDX-License-Identifier: MIT
// The foot of the page: whole match, budget of packets, and the window around the moment, with one line through each
// for the moment itself.
import type { Palette } from "../app/palette";
import type { State } from "../app/state";
import type { Match } from "../recording/match";
import { Budget, budgetHeight } from "./budget";
import { Detail } from "./detail";
import { Overview, overviewHeight } from "./overview";
import { TimeScale } from "./scale";
import { goalsUnderPointer, underPointer } from "./under_pointer";

const shortest = 4; // s that a window shows at least
const usual = 60;
const forward = 0.12; // of the window lie before the moment when the window turns a page

export interface TimelineElements {
  box: HTMLElement;
  overview: HTMLCanvasElement;
  budget: HTMLElement;
  detail: HTMLCanvasElement;
  wholeLine: HTMLElement;
  windowLine: HTMLElement;
  tip: HTMLElement;
}

export class Timeline {
  private readonly overview: Overview;
  private readonly budget: Budget;
  private readonly detail: Detail;
  private seconds: number;
  private stale = true;
  private palette: Palette;

  constructor(
    private readonly elements: TimelineElements,
    match: Match,
    private readonly state: State,
    palette: Palette,
  ) {
    const { begin, end } = match.game;
    this.palette = palette;
    this.seconds = Math.min(usual, Math.max(shortest, end - begin));
    this.overview = new Overview(elements.overview, match, new TimeScale(begin, end));
    this.budget = new Budget(elements.budget, match);
    this.detail = new Detail(elements.detail, match, new TimeScale(begin, begin + this.seconds));
    this.listen();
  }

  // What the window shows, s.
  get window(): readonly [number, number] {
    return [this.detail.scale.from, this.detail.scale.to];
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    this.overview.invalidate();
    this.budget.draw(this.elements.box.clientWidth, palette);
    this.stale = true;
  }

  invalidate(): void {
    this.stale = true;
  }

  resize(): void {
    const { box } = this.elements;
    const width = box.clientWidth;
    this.overview.resize(width);
    this.budget.draw(width, this.palette);
    this.detail.resize(width, box.clientHeight - overviewHeight - budgetHeight);
    this.stale = true;
  }

  // factor > 1 shows more of the match.
  zoom(factor: number): void {
    const whole = this.state.end - this.state.begin;
    const before = this.seconds;
    this.seconds = Math.min(Math.max(shortest, whole), Math.max(shortest, this.seconds * factor));
    const { scale } = this.detail;
    const share = (this.state.view.time - scale.from) / before;
    scale.from = this.state.view.time - Math.min(1, Math.max(0, share)) * this.seconds;
    this.keepInside();
    this.stale = true;
  }

  private keepInside(): void {
    const { scale } = this.detail;
    scale.from = Math.max(this.state.begin, Math.min(scale.from, this.state.end - this.seconds));
    scale.to = scale.from + this.seconds;
  }

  // The window turns a page when the moment leaves it.
  private follow(time: number): void {
    const { scale } = this.detail;
    if (time >= scale.from && time <= scale.to) return;
    const running = this.state.view.playing && time > scale.to && time < scale.to + 2;
    scale.from = time - (running ? forward : 0.4) * this.seconds;
    this.keepInside();
    this.stale = true;
  }

  draw(): void {
    const { view } = this.state;
    this.follow(view.time);
    if (this.stale) {
      this.detail.draw(view, this.palette);
      this.overview.draw(this.palette, this.detail.scale);
      this.stale = false;
    }
    this.elements.wholeLine.style.transform = `translateX(${this.overview.scale.x(view.time).toFixed(2)}px)`;
    this.elements.windowLine.style.transform = `translateX(${this.detail.scale.x(view.time).toFixed(2)}px)`;
  }

  private listen(): void {
    const { overview, budget, detail } = this.elements;
    const scrub = (element: HTMLElement, scale: TimeScale, chosen?: (x: number, y: number) => void) => {
      const at = (event: PointerEvent) => {
        const box = element.getBoundingClientRect();
        return [event.clientX - box.left, event.clientY - box.top] as const;
      };
      element.addEventListener("pointerdown", (event) => {
        if (event.button !== 0) return;
        element.setPointerCapture(event.pointerId);
        const [x, y] = at(event);
        chosen?.(x, y);
        this.state.set({ time: scale.time(x) });
      });
      element.addEventListener("pointermove", (event) => {
        if (element.hasPointerCapture(event.pointerId)) this.state.set({ time: scale.time(at(event)[0]) });
      });
    };
    scrub(overview, this.overview.scale);
    scrub(budget, this.overview.scale);
    scrub(detail, this.detail.scale, (x, y) => {
      const { robot } = underPointer(this.detail, this.state.view, x, y);
      if (robot !== null) this.state.choose(robot);
    });
    detail.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
          this.detail.scale.from += event.deltaX / this.detail.scale.pixelsPerSecond;
          this.keepInside();
          this.stale = true;
          this.state.set({
            time: Math.min(this.detail.scale.to, Math.max(this.detail.scale.from, this.state.view.time)),
          });
        } else {
          this.zoom(event.deltaY > 0 ? 1.25 : 0.8);
        }
        this.state.touch();
      },
      { passive: false },
    );
    detail.addEventListener("pointermove", (event) => {
      const box = detail.getBoundingClientRect();
      const { lines } = underPointer(this.detail, this.state.view, event.clientX - box.left, event.clientY - box.top);
      this.showTip(lines, event);
    });
    overview.addEventListener("pointermove", (event) => {
      const { left } = overview.getBoundingClientRect();
      this.showTip(goalsUnderPointer(this.detail.match, this.overview.scale, event.clientX - left), event);
    });
    for (const canvas of [overview, detail]) canvas.addEventListener("pointerleave", () => this.showTip([], null));
  }

  // Beside the pointer; nothing without lines.
  private showTip(lines: readonly string[], at: PointerEvent | null): void {
    const { tip } = this.elements;
    tip.hidden = at === null || lines.length === 0;
    if (at === null || tip.hidden) return;
    tip.textContent = lines.join("\n");
    const left = Math.max(0, Math.min(at.clientX + 12, window.innerWidth - tip.offsetWidth - 8));
    tip.style.transform = `translate(${left}px, ${at.clientY - tip.offsetHeight - 12}px)`;
  }
}
