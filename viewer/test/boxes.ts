// SPDX-License-Identifier: MIT
// What of the text on the screen overlaps, is cut or sticks out, measured in the browser: the boxes of all text that
// can be seen, of all controls, and of what the canvases say.
import type { Page } from "playwright-core";

interface CanvasText {
  text: string;
  left: number;
  right: number;
  top: number;
  bottom: number;
}

declare global {
  interface Window {
    canvasTexts?: Map<HTMLCanvasElement, CanvasText[]>;
  }
}

// Before the page opens: notes every text that is written upon a canvas since the whole of it was last painted.
export async function noteCanvasTexts(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const texts = new Map<HTMLCanvasElement, CanvasText[]>();
    window.canvasTexts = texts;
    const kind = CanvasRenderingContext2D.prototype;
    const { fillText, fillRect, drawImage, clearRect } = kind;
    const inPixels = (context: CanvasRenderingContext2D, x: number, y: number) => {
      const { a, d, e, f } = context.getTransform();
      const { width, clientWidth } = context.canvas;
      const scale = clientWidth > 0 ? width / clientWidth : 1;
      return [(a * x + e) / scale, (d * y + f) / scale] as const;
    };
    const whole = (context: CanvasRenderingContext2D, x: number, y: number, width: number, height: number) => {
      const { a, d } = context.getTransform();
      const { canvas } = context;
      if (x <= 0 && y <= 0 && width * a >= canvas.width - 1 && height * d >= canvas.height - 1) texts.set(canvas, []);
    };
    kind.fillText = function (text: string, x: number, y: number) {
      const size = this.measureText(text);
      const [left, top] = inPixels(this, x - size.actualBoundingBoxLeft, y - size.actualBoundingBoxAscent);
      const [right, bottom] = inPixels(this, x + size.actualBoundingBoxRight, y + size.actualBoundingBoxDescent);
      if (!texts.has(this.canvas)) texts.set(this.canvas, []);
      if (text.trim() !== "") texts.get(this.canvas)!.push({ text, left, right, top, bottom });
      return fillText.call(this, text, x, y);
    };
    kind.fillRect = function (x: number, y: number, width: number, height: number) {
      whole(this, x, y, width, height);
      return fillRect.call(this, x, y, width, height);
    };
    kind.clearRect = function (x: number, y: number, width: number, height: number) {
      whole(this, x, y, width, height);
      return clearRect.call(this, x, y, width, height);
    };
    kind.drawImage = function (this: CanvasRenderingContext2D, ...all: unknown[]) {
      const image = all[0] as HTMLCanvasElement;
      if (all.length === 5) whole(this, ...(all.slice(1) as [number, number, number, number]));
      // What stands on a canvas that is painted upon another.
      if (texts.has(image) && all.length === 5) texts.set(this.canvas, [...texts.get(image)!]);
      return (drawImage as (...all: unknown[]) => void).apply(this, all);
    } as typeof drawImage;
  });
}

// A sentence for everything that is wrong now. wholeNames: nothing may be cut at all; otherwise a name may end in an
// ellipsis where its title says the whole.
export async function troubles(page: Page, wholeNames: boolean): Promise<string[]> {
  return page.evaluate((wholeNames) => {
    const tolerance = 1;
    const found: string[] = [];
    interface Rect {
      left: number;
      top: number;
      right: number;
      bottom: number;
    }
    interface Box {
      what: string;
      node: Node;
      element: Element;
      rects: Rect[]; // as laid out, whether or not it is scrolled out of sight
      seen: Rect[]; // what scrolling and cutting leave
      scroller: Element | null;
    }
    const short = (text: string) => {
      const line = text.trim().replace(/\s+/g, " ");
      return line.length > 40 ? `${line.slice(0, 39)}…` : line;
    };
    const nameOf = (element: Element) => {
      const part = element.closest("[id]");
      return `${element.localName}${element.className ? `.${String(element.className).trim().replaceAll(" ", ".")}` : ""}${
        part !== null ? ` in #${part.id}` : ""
      }`;
    };
    const inner = (element: Element): Rect => {
      const box = element.getBoundingClientRect();
      const left = box.left + element.clientLeft;
      const top = box.top + element.clientTop;
      return { left, top, right: left + element.clientWidth, bottom: top + element.clientHeight };
    };
    const titled = (element: Element, text: string) =>
      (element.closest("[title]")?.getAttribute("title") ?? "").includes(text.trim());
    const scrolls = (overflow: string) => overflow === "auto" || overflow === "scroll";
    const cuts = (overflow: string) => overflow === "hidden" || overflow === "clip";
    const root = document.querySelector("dialog[open]") ?? document.body;
    // Where all parts are one below the other the page scrolls down, and only down.
    const goesOn = scrolls(getComputedStyle(document.body).overflowY);
    window.scrollTo(0, 0);
    for (const element of root.querySelectorAll("*"))
      if (scrolls(getComputedStyle(element).overflowY)) element.scrollTop = 0;

    const boxes: Box[] = [];
    const add = (node: Node, element: Element, what: string, rects: Rect[]) => {
      let seen = rects;
      let laidOut = rects;
      let scroller: Element | null = null;
      let said = false;
      for (
        let at: Element | null = node === element ? element.parentElement : element;
        at !== null;
        at = at.parentElement
      ) {
        const style = getComputedStyle(at);
        if (style.position === "fixed" && at !== root) break;
        if (style.display === "inline" || at === document.body || at === document.documentElement) continue;
        const room = inner(at);
        const cut: string[] = [];
        for (const rect of seen) {
          const beyond = rect.right > room.right + tolerance || rect.left < room.left - tolerance;
          const below = rect.bottom > room.bottom + 2 * tolerance || rect.top < room.top - 2 * tolerance;
          if (beyond && cuts(style.overflowX)) {
            const deliberate = style.textOverflow === "ellipsis" && titled(at, what);
            if (!deliberate || wholeNames)
              cut.push(`${Math.round(Math.max(rect.right - room.right, room.left - rect.left))} px at its side`);
          }
          if (beyond && scrolls(style.overflowX) && at.matches(".panel, .scroll, dialog"))
            cut.push(`${Math.round(rect.right - room.right)} px, to be scrolled sideways`);
          if (below && cuts(style.overflowY)) cut.push(`${Math.round(rect.bottom - room.bottom)} px at its foot`);
        }
        if (cut.length > 0 && !said) {
          found.push(`cut by ${nameOf(at)}: "${short(what)}", ${cut[0]}`);
          said = true;
        }
        if (scrolls(style.overflowY) || scrolls(style.overflowX)) scroller ??= at;
        if (style.overflowX === "visible" && style.overflowY === "visible") continue;
        seen = seen
          .map((rect) => ({
            left: Math.max(rect.left, room.left),
            right: Math.min(rect.right, room.right),
            top: Math.max(rect.top, room.top),
            bottom: Math.min(rect.bottom, room.bottom),
          }))
          .filter((rect) => rect.right > rect.left && rect.bottom > rect.top);
        if (scroller === null) laidOut = seen;
      }
      boxes.push({ what: short(what), node, element, rects: laidOut, seen, scroller });
    };

    const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
      const element = node.parentElement!;
      const text = node.textContent ?? "";
      if (text.trim() === "" || element.closest("script, style, select, noscript, #tip") !== null) continue;
      if (!element.checkVisibility({ checkVisibilityCSS: true })) continue;
      const range = document.createRange();
      range.selectNodeContents(node);
      const rects = [...range.getClientRects()].filter((rect) => rect.width > 0.5 && rect.height > 0.5);
      add(node, element, text, rects);
    }
    for (const control of root.querySelectorAll("button:not(.link), select, input")) {
      if (!control.checkVisibility({ checkVisibilityCSS: true })) continue;
      const text = control instanceof HTMLInputElement ? control.value : (control.textContent ?? "");
      add(control, control, `[${control.id || short(text)}]`, [control.getBoundingClientRect()]);
      if (control instanceof HTMLInputElement && control.scrollWidth > control.clientWidth)
        found.push(`cut by its box: "${control.value}" in #${control.id}`);
      if (control instanceof HTMLSelectElement) {
        // As wide as the option that it shows would have it.
        const option = control.selectedOptions[0];
        const alone = control.cloneNode(false) as HTMLSelectElement;
        alone.append(option?.cloneNode(true) ?? "");
        alone.style.cssText = "position:absolute;visibility:hidden;width:auto;min-width:0;max-width:none";
        control.after(alone);
        const wanted = alone.offsetWidth;
        alone.remove();
        const shown = option?.textContent ?? "";
        if (wanted > control.offsetWidth + tolerance && (wholeNames || !titled(control, shown)))
          found.push(`cut by #${control.id}: "${short(shown)}", ${wanted - control.offsetWidth} px`);
      }
    }

    // Letters fill their line's box neither at its top nor at its foot.
    const overlap = (a: Rect, b: Rect) => {
      const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      return across > tolerance && down > 3 ? `${Math.round(across)} x ${Math.round(down)} px` : "";
    };
    for (const [i, a] of boxes.entries()) {
      for (const b of boxes.slice(i + 1)) {
        if (a.node.contains(b.node) || b.node.contains(a.node)) continue;
        const together = a.scroller === b.scroller;
        for (const one of together ? a.rects : a.seen) {
          const size = (together ? b.rects : b.seen).map((other) => overlap(one, other)).find((text) => text !== "");
          if (size === undefined) continue;
          found.push(`"${a.what}" and "${b.what}" overlap, ${size} (${nameOf(a.element)})`);
          break;
        }
      }
      for (const rect of a.seen) {
        const below = rect.bottom > innerHeight + tolerance && !(goesOn && root === document.body);
        if (rect.right <= innerWidth + tolerance && rect.left >= -tolerance && !below) continue;
        found.push(`"${a.what}" sticks out of the page (${nameOf(a.element)})`);
        break;
      }
    }
    const page = document.documentElement;
    if (page.scrollWidth > page.clientWidth || (page.scrollHeight > innerHeight && !goesOn))
      found.push(
        `the page is ${page.scrollWidth} x ${page.scrollHeight} px, the window ${innerWidth} x ${innerHeight}`,
      );

    // Canvases lie whole in the parts of the page that hold them.
    for (const canvas of document.querySelectorAll("canvas")) {
      const box = canvas.getBoundingClientRect();
      const room = canvas.parentElement!.getBoundingClientRect();
      const sticksOut = box.right > innerWidth + tolerance || (!goesOn && box.bottom > innerHeight + tolerance);
      if (sticksOut || box.right > room.right + tolerance || box.bottom > room.bottom + tolerance)
        found.push(`canvas ${canvas.id} is cut`);
    }

    if (root !== document.body) return found;
    for (const [canvas, texts] of window.canvasTexts ?? []) {
      if (!canvas.isConnected || !canvas.checkVisibility()) continue;
      const where = canvas.id || nameOf(canvas);
      // Numbers stand upon robots, and robots may stand upon each other.
      const names = canvas.id === "field" ? texts.filter(({ text }) => !/^\d+$/.test(text)) : texts;
      // Names of rows stand left of 92 px, and the window of time ends 14 px before the edge.
      const edges = canvas.id === "detail" ? [0, 92 - 1.5, canvas.clientWidth - 14] : [0, canvas.clientWidth];
      for (const [i, a] of names.entries()) {
        for (const b of names.slice(i + 1)) {
          const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
          const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
          if (across > tolerance && down > tolerance)
            found.push(`"${a.text}" and "${b.text}" overlap on canvas ${where}`);
        }
        if (edges.some((edge) => a.left < edge - tolerance && a.right > edge + tolerance))
          found.push(`"${a.text}" is cut on canvas ${where}`);
        if (a.top < -tolerance || a.bottom > canvas.clientHeight + tolerance)
          found.push(`"${a.text}" is cut on canvas ${where}`);
      }
    }
    return found;
  }, wholeNames);
}
