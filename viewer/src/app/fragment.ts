// SPDX-License-Identifier: MIT
// The moment, the chosen robot and the comparison as the fragment of the page's address, so that they can be shared:
// #t=462.3&robot=home/3&compare=home/4,6/2 (robots 4 and 6 as the role of row 2 of their team's table, from 0).
import type { Pair } from "../model/compare";
import { type Side, sideNames } from "../recording/about";
import type { Robot } from "./state";

export interface Place {
  time: number | null;
  robot: Robot | null;
  pair: Pair | null;
}

const sideOf = (name: string | undefined) => sideNames.indexOf(name as (typeof sideNames)[number]) as Side | -1;

// sizes, roles: of both teams, how many robots and roles they have.
export function readFragment(
  fragment: string,
  sizes: readonly [number, number],
  roles: readonly [number, number],
): Place {
  const place: Place = { time: null, robot: null, pair: null };
  const whole = (digits: string | undefined) => (/^\d{1,4}$/.test(digits ?? "") ? Number(digits) : -1);
  for (const part of fragment.replace(/^#/, "").split("&")) {
    const [key, value = ""] = part.split("=");
    if (key === "t" && value !== "" && !Number.isNaN(Number(value))) place.time = Number(value);
    const [name, numbers, row] = value.replace(/%2[cC]/g, ",").split("/");
    const side = sideOf(name);
    if (side === -1) continue;
    const isRobot = (number: number) => number >= 1 && number <= sizes[side];
    if (key === "robot" && row === undefined && isRobot(whole(numbers))) place.robot = { side, number: whole(numbers) };
    if (key === "compare") {
      const robots = (numbers ?? "").split(",").map(whole);
      const role = whole(row);
      const [first = 0, second = 0] = robots;
      if (robots.length === 2 && robots.every(isRobot) && first !== second && role >= 0 && role < roles[side])
        place.pair = { side, robots: [first, second], role };
    }
  }
  return place;
}

export function fragmentOf(time: number, robot: Robot | null, pair: Pair | null): string {
  const parts = [`t=${Math.round(time * 100) / 100}`];
  if (robot !== null) parts.push(`robot=${sideNames[robot.side]}/${robot.number}`);
  if (pair !== null) parts.push(`compare=${sideNames[pair.side]}/${pair.robots.join(",")}/${pair.role}`);
  return `#${parts.join("&")}`;
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
    window.addEventListener("hashchange", ({ newURL }) => {
      // Of the event: by now the address may have been written over, with a moment that is no longer wanted.
      const wanted = new URL(newURL).hash;
      if (wanted === this.written) return;
      this.written = wanted;
      changed(wanted);
    });
  }
}
