// SPDX-License-Identifier: MIT
// Time passing: one loop of frames, which rests while nothing changes.
import { type State, speeds } from "./state";

const longestFrame = 0.25; // s; a page that was hidden goes on where it was

export class Playback {
  private requested = false;
  private last = 0;
  frames = 0; // drawn so far

  constructor(
    private readonly state: State,
    private readonly draw: (now: number) => void,
  ) {
    state.listen(() => this.request());
  }

  request(): void {
    if (this.requested) return;
    this.requested = true;
    requestAnimationFrame((now) => this.frame(now));
  }

  private frame(now: number): void {
    this.requested = false;
    const { view } = this.state;
    if (view.playing) {
      const passed = this.last > 0 ? Math.min(longestFrame, (now - this.last) / 1000) : 0;
      const time = view.time + passed * view.speed;
      this.state.set(time >= this.state.end ? { time, playing: false } : { time });
    }
    this.last = this.state.view.playing ? now : 0;
    this.draw(now);
    ++this.frames;
    if (this.state.view.playing) this.request();
  }

  toggle(): void {
    const { view } = this.state;
    const atEnd = view.time >= this.state.end - 1e-9;
    this.state.set({ playing: !view.playing, ...(atEnd && !view.playing ? { time: this.state.begin } : {}) });
  }

  // One step faster or slower.
  change(direction: 1 | -1): void {
    const at = speeds.findIndex((speed) => speed === this.state.view.speed) + direction;
    const speed = speeds[at];
    if (speed !== undefined) this.state.set({ speed });
  }
}
