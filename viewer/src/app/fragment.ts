// SPDX-License-Identifier: MIT
// The moment and the chosen robot as the fragment of the page's address, so that they can be shared:
// #t=462.3&robot=home/3
import { type Side, sideNames } from "../recording/about";
import type { Robot } from "./state";

export interface Place {
  time: number | null;
  robot: Robot | null;
}

export function readFragment(fragment: string, sizes: readonly [number, number]): Place {
  const place: Place = { time: null, robot: null };
  for (const part of fragment.replace(/^#/, "").split("&")) {
    const [key, value = ""] = part.split("=");
    if (key === "t" && value !== "" && Number.isFinite(Number(value))) place.time = Number(value);
    if (key === "robot") {
      const [name, digits] = value.split("/");
      const side = sideNames.indexOf(name as (typeof sideNames)[number]);
      const number = Number(digits);
      if (side >= 0 && Number.isInteger(number) && number >= 1 && number <= sizes[side as Side]) {
        place.robot = { side: side as Side, number };
      }
    }
  }
  return place;
}

export function fragmentOf(time: number, robot: Robot | null): string {
  return `#t=${Math.round(time * 100) / 100}${robot === null ? "" : `&robot=${sideNames[robot.side]}/${robot.number}`}`;
}

const pauseMilliseconds = 400; // browsers refuse addresses that change too often

export class Address {
  private timer = 0;
  private written = "";

  constructor(private readonly current: () => string) {}

  // Something has changed: soon the address will.
  touch(): void {
    if (this.timer !== 0) return;
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      const fragment = this.current();
      if (fragment === this.written) return;
      this.written = fragment;
      try {
        history.replaceState(null, "", fragment);
      } catch {
        // A browser that forbids it for pages from disk: the address stays as it is.
      }
    }, pauseMilliseconds);
  }

  listen(changed: (fragment: string) => void): void {
    window.addEventListener("hashchange", () => {
      if (location.hash === this.written) return;
      this.written = location.hash;
      changed(location.hash);
    });
  }
}
