// SPDX-License-Identifier: MIT
// The pointer upon the field: a click chooses, a drag moves the picture, the wheel and two fingers zoom, a double click
// shows the whole field again.
import type { Projection } from "./projection";

const still = 4; // px: a pointer that moves less clicks
const perPixel = 0.002; // of the wheel

type Place = [number, number];

// shown: the picture has changed; byHand: it was moved by hand.
export function listenToPointer(
  canvas: HTMLCanvasElement,
  to: Projection,
  on: { clicked(px: number, py: number): void; shown(byHand: boolean): void; whole(): void },
): void {
  const down = new Map<number, Place>();
  let begin: Place = [0, 0];
  let dragged = false;
  const at = (event: MouseEvent): Place => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    if (down.size === 0) [begin, dragged] = [at(event), false];
    down.set(event.pointerId, at(event));
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (before === undefined) return;
    const now = at(event);
    if (Math.hypot(now[0] - begin[0], now[1] - begin[1]) > still) dragged = true;
    if (!dragged) return;
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    down.set(event.pointerId, now);
    // Of two fingers one rests while the other moves: the part between them grows, and follows by half.
    if (other !== undefined) {
      const apart = ([x, y]: Place) => Math.max(1, Math.hypot(x - other[0], y - other[1]));
      to.zoomAt((now[0] + other[0]) / 2, (now[1] + other[1]) / 2, apart(now) / apart(before));
    }
    const share = other === undefined ? 1 : 0.5;
    to.pan(share * (now[0] - before[0]), share * (now[1] - before[1]));
    on.shown(to.zoom > 1);
  });
  for (const kind of ["pointerup", "pointercancel"] as const)
    canvas.addEventListener(kind, (event) => down.delete(event.pointerId));
  canvas.addEventListener("click", (event) => {
    if (!dragged) on.clicked(...at(event));
  });
  canvas.addEventListener("dblclick", () => on.whole());
  canvas.addEventListener(
    "wheel",
    (event) => {
      // Where there is nothing more to see the page scrolls.
      if (event.deltaY >= 0 && to.zoom === 1) return;
      event.preventDefault();
      const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 33 : 1);
      to.zoomAt(...at(event), Math.exp(-perPixel * Math.min(200, Math.max(-200, pixels))));
      on.shown(false);
    },
    { passive: false },
  );
}
