// SPDX-License-Identifier: MIT
// Where names may stand upon a picture so that none lies over another: each in turn takes the first of its places that
// is free. First, for names that may, upon its point; then those beside what it names; then, for names that may, those
// farther off, to which a line leads. A name that finds no place is left out: the number upon the robot is still there.
// Boxes in, places out; nothing is drawn.
export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export interface Wanted {
  x: number; // centre of what is named
  y: number;
  radius: number;
  width: number; // of the name
  height: number;
  far: boolean; // it may stand farther off
  upon?: boolean; // it may stand upon its point, which nothing marks
  before: number; // the place it had last, so that names keep still while their robots walk; -1: none
}

export interface Place {
  x: number; // centre of the name
  y: number;
  far: boolean;
  place: number; // for `before`
}

const gap = 3; // px between a name and what it names

// Below, above, right, left, and the corners; [across, down, of half the name's width, of half its height].
const near = [
  [0, 1, 0, 1],
  [0, -1, 0, -1],
  [1, 0, 1, 0],
  [-1, 0, -1, 0],
  [0.7, 0.7, 1, 1],
  [-0.7, 0.7, -1, 1],
  [0.7, -0.7, 1, -1],
  [-0.7, -0.7, -1, -1],
] as const;

const farDistances = [16, 28, 42, 58]; // px beyond the rim
const directions = 12;
const far = farDistances.flatMap((distance) =>
  Array.from({ length: directions }, (_, i) => {
    const angle = ((i + 0.5) * 2 * Math.PI) / directions;
    const [across, down] = [Math.cos(angle), Math.sin(angle)];
    return [across, down, across, down, distance] as const;
  }),
);

const upon = [[0, 0, 0, 0, 0]] as const;
const offsets = [...near, ...far, ...upon];
const uponPlace = near.length + far.length;

const within = (value: number, half: number, length: number) => Math.min(length - half, Math.max(half, value));

function boxAt(wanted: Wanted, place: number, size: { width: number; height: number }): Box | null {
  const [across, down, ofWidth, ofHeight, distance = 0] = offsets[place]!;
  const reach = wanted.radius + gap + distance;
  const [halfWidth, halfHeight] = [wanted.width / 2, wanted.height / 2];
  const x = wanted.x + across * reach + ofWidth * halfWidth;
  const y = wanted.y + down * reach + ofHeight * halfHeight;
  // Above and below it may be pushed aside by the picture's edge.
  const middle = across === 0 ? within(x, halfWidth, size.width) : x;
  const box = { left: middle - halfWidth, right: middle + halfWidth, top: y - halfHeight, bottom: y + halfHeight };
  const inside = box.left >= 0 && box.top >= 0 && box.right <= size.width && box.bottom <= size.height;
  return inside ? box : null;
}

const meet = (a: Box, b: Box) => a.left < b.right && a.right > b.left && a.top < b.bottom && a.bottom > b.top;

// For each name its place, or null. The first of the list choose first; no name covers anything of `taken`.
export function placeNames(
  names: readonly Wanted[],
  taken: readonly Box[],
  size: { width: number; height: number },
): (Place | null)[] {
  const full = [...taken];
  return names.map((wanted) => {
    const tryAt = (place: number): Place | null => {
      const box = boxAt(wanted, place, size);
      if (box === null || full.some((other) => meet(box, other))) return null;
      full.push(box);
      return {
        x: (box.left + box.right) / 2,
        y: (box.top + box.bottom) / 2,
        far: place >= near.length && place < uponPlace,
        place,
      };
    };
    const first = (from: number, to: number): Place | null => {
      if (wanted.before >= from && wanted.before < to) {
        const again = tryAt(wanted.before);
        if (again !== null) return again;
      }
      for (let place = from; place < to; ++place) {
        const found = tryAt(place);
        if (found !== null) return found;
      }
      return null;
    };
    return (
      (wanted.upon === true ? tryAt(uponPlace) : null) ??
      first(0, near.length) ??
      (wanted.far ? first(near.length, uponPlace) : null)
    );
  });
}
