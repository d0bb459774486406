// SPDX-License-Identifier: MIT
// The names of one picture of the field: gathered while it is drawn, placed so that none lies over another
// (placement.ts), and written last, over everything else.
import { font } from "../app/canvas";
import { type Box, type Wanted, placeNames } from "./placement";
import { type Context, label } from "./shapes";

// Who chooses a place first.
export const ranks = ["chosen", "own", "task", "drawing", "age", "other"] as const;
export type Rank = (typeof ranks)[number];

export interface Name {
  key: string; // the same from picture to picture
  text: string;
  x: number;
  y: number;
  radius: number; // of what is named
  ink: string;
  rank: Rank;
  pixels: number; // of its letters
}

// Names of these may stand farther off, with a line; the others are left out where there is no room.
const mayStandOff: readonly Rank[] = ["chosen", "own", "task", "drawing"];

// Of one rank. More would find no room, and each is held against all others.
const mostNames = 200;

export class Labels {
  private taken: Box[] = [];
  private names: Name[] = [];
  private places = new Map<string, number>(); // of the picture before
  private readonly widths = new Map<string, number>();

  clear(): void {
    this.taken = [];
    this.names = [];
  }

  // No name may stand here.
  take(x: number, y: number, halfWidth: number, halfHeight: number): void {
    this.takeBox({ left: x - halfWidth, top: y - halfHeight, right: x + halfWidth, bottom: y + halfHeight });
  }

  takeBox(box: Box): void {
    this.taken.push(box);
  }

  add(name: Name): void {
    if (name.text !== "") this.names.push(name);
  }

  // Upon a canvas of this size.
  write(context: Context, size: { width: number; height: number }, rim: string): void {
    // What is not in the picture has no name in it either.
    const seen = this.names.filter(({ x, y }) => x >= 0 && y >= 0 && x <= size.width && y <= size.height);
    const names = ranks.flatMap((rank) => seen.filter((name) => name.rank === rank).slice(0, mostNames));
    const wanted = names.map((name): Wanted => ({
      x: name.x,
      y: name.y,
      radius: name.radius,
      width: this.widthOf(context, name) + 3,
      height: name.pixels + 2,
      far: mayStandOff.includes(name.rank),
      upon: name.rank === "drawing",
      before: this.places.get(name.key) ?? -1,
    }));
    const places = placeNames(wanted, this.taken, size);
    this.places = new Map();
    context.save();
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.setLineDash([]);
    // Lines first: they may pass below other names.
    for (const [i, place] of places.entries()) {
      if (place?.far) lead(context, names[i]!, wanted[i]!, place.x, place.y);
    }
    for (const [i, place] of places.entries()) {
      const name = names[i]!;
      if (place === null) continue;
      this.places.set(name.key, place.place);
      context.font = font(name.pixels);
      label(context, name.text, place.x, place.y, name.ink, rim);
    }
    context.restore();
  }

  private widthOf(context: Context, { text, pixels }: Name): number {
    const key = `${pixels} ${text}`;
    let width = this.widths.get(key);
    if (width === undefined) {
      if (this.widths.size > 2000) this.widths.clear(); // ages are many
      context.font = font(pixels);
      width = context.measureText(text).width;
      this.widths.set(key, width);
    }
    return width;
  }
}

// From the rim of what is named to the nearest point of its name.
function lead(context: Context, name: Name, { width, height }: Wanted, x: number, y: number): void {
  const toX = Math.min(x + width / 2, Math.max(x - width / 2, name.x));
  const toY = Math.min(y + height / 2, Math.max(y - height / 2, name.y));
  const length = Math.hypot(toX - name.x, toY - name.y);
  if (length <= name.radius) return;
  context.globalAlpha = 0.7;
  context.lineWidth = 1;
  context.strokeStyle = name.ink;
  context.beginPath();
  context.moveTo(name.x + (name.radius * (toX - name.x)) / length, name.y + (name.radius * (toY - name.y)) / length);
  context.lineTo(toX, toY);
  context.stroke();
  context.globalAlpha = 1;
}
