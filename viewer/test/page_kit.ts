// SPDX-License-Identifier: MIT
// What tests of the page share: a browser, pages with recordings in them, and what stands on the screen.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";

import { McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";
import type { Page } from "playwright-core";

import { startBrowser } from "./browser.mjs";

// As JSON.parse gives it: the assertions look at what is there.
export type Json = any;

export const folder = mkdtempSync(join(tmpdir(), "regista-viewer-"));
export let browser: Awaited<ReturnType<typeof startBrowser>>;

before(async () => {
  browser = await startBrowser();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

// Tests run in the viewer's folder.
export function pageOf(recordingFile: string | null, name: string): string {
  const out = join(folder, `${name}.html`);
  const with_ = recordingFile === null ? [] : ["--recording", recordingFile];
  execFileSync(process.execPath, ["build.mjs", "--out", out, ...with_]);
  return pathToFileURL(out).href;
}

export async function synthetic(name: string, bytes: Uint8Array): Promise<string> {
  const file = join(folder, `${name}.mcap`);
  writeFileSync(file, bytes);
  return pageOf(file, name);
}

// Opens the page; every complaint of the browser and every request but for the page itself ends in `complaints`.
export async function open(address: string, state = "ready"): Promise<{ page: Page; complaints: string[] }> {
  const page = await browser.newPage();
  const complaints: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error" || message.type() === "warning") complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("request", (request) => {
    if (!request.url().startsWith("data:") && request.url().replace(/#.*/, "") !== address.replace(/#.*/, ""))
      complaints.push(request.url());
  });
  await page.goto(address);
  await page.waitForFunction((wanted) => document.body.dataset.state === wanted, state, { timeout: 60_000 });
  return { page, complaints };
}

export const text = async (page: Page, selector: string) => (await page.locator(selector).first().textContent()) ?? "";
export const shownTime = async (page: Page) => page.locator("#time").inputValue();
export const frame = (page: Page) =>
  page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
// The panels' last update, when time stands still.
export const settle = async (page: Page) => {
  await frame(page);
  await page.waitForTimeout(150);
};
export const secondsOf = (shown: string) => {
  const [minutes, rest] = shown.split(":");
  return 60 * Number(minutes) + Number(rest);
};

// Another fragment of the address, as somebody pastes it.
export const goTo = async (page: Page, fragment: string) => {
  await page.evaluate(
    (wanted) =>
      new Promise((resolve) => {
        window.addEventListener("hashchange", resolve, { once: true });
        location.hash = wanted;
      }),
    fragment,
  );
  await settle(page);
};

export async function messages(file: string): Promise<Map<string, Json[]>> {
  const reader = new McapStreamReader({ decompressHandlers: await loadDecompressHandlers() });
  reader.append(new Uint8Array(readFileSync(file)));
  const topics = new Map<number, string>();
  const found = new Map<string, Json[]>();
  for (let record; (record = reader.nextRecord()) !== undefined;) {
    if (record.type === "Channel") topics.set(record.id, record.topic);
    if (record.type !== "Message") continue;
    const topic = topics.get(record.channelId)!;
    if (!found.has(topic)) found.set(topic, []);
    found.get(topic)!.push(JSON.parse(new TextDecoder().decode(record.data)));
  }
  return found;
}

export const lastBefore = (all: Json[], time: number) => all.filter((message) => message.time <= time + 1e-9).pop()!;

// Every entry of the matrix on the screen against the recording.
export async function checkMatrix(page: Page, decision: Json): Promise<void> {
  const rows = page.locator("table.matrix:not(.difference) tbody tr");
  assert.equal(await rows.count(), decision.rows.length);
  for (const [i, robot] of decision.rows.entries()) {
    assert.equal(await rows.nth(i).locator("th").textContent(), `robot ${robot}`);
    const cells = await rows.nth(i).locator("td").allTextContents();
    const expected = decision.utility[i].map((value: number | null, j: number) =>
      value === null
        ? "\u2715"
        : `${decision.assigned[robot - 1] === decision.columns[j] ? "\u25cf" : ""}${value.toFixed(2)}`,
    );
    assert.deepEqual(cells, expected);
  }
}

// Where a robot stands on the canvas.
export async function placeOnField(page: Page, pose: number[]): Promise<{ x: number; y: number; scale: number }> {
  const box = (await page.locator("#field").boundingBox())!;
  const scale = Math.min(box.width / 10.4, box.height / 7.4);
  return { x: box.x + box.width / 2 + scale * pose[0]!, y: box.y + box.height / 2 - scale * pose[1]!, scale };
}

// The colour of the field at a place in metres.
export async function colourAt(page: Page, x: number, y: number): Promise<number[]> {
  const place = await placeOnField(page, [x, y]);
  return page.evaluate(({ x, y }) => {
    const field = document.getElementById("field") as HTMLCanvasElement;
    const box = field.getBoundingClientRect();
    const scale = field.width / box.width;
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [1, 1];
    const context = copy.getContext("2d")!;
    context.drawImage(field, -Math.round((x - box.x) * scale), -Math.round((y - box.y) * scale));
    return [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)];
  }, place);
}

// Colours of the field around a point of the page, by row.
export async function pixels(page: Page, x: number, y: number, reach: number): Promise<number[][][]> {
  return page.evaluate(
    ({ x, y, reach }) => {
      const field = document.getElementById("field") as HTMLCanvasElement;
      const box = field.getBoundingClientRect();
      const size = 2 * reach + 1;
      const copy = document.createElement("canvas");
      [copy.width, copy.height] = [size, size];
      const context = copy.getContext("2d")!;
      context.drawImage(field, Math.round(box.x - x) + reach, Math.round(box.y - y) + reach);
      const { data } = context.getImageData(0, 0, size, size);
      return Array.from({ length: size }, (_, row) =>
        Array.from({ length: size }, (__, column) => [
          ...data.slice(4 * (row * size + column), 4 * (row * size + column) + 3),
        ]),
      );
    },
    { x, y, reach },
  );
}

// Contrast of two colours by the Web Content Accessibility Guidelines 2.1: 1 to 21.
export function contrast(a: number[], b: number[]): number {
  const luminance = (colour: number[]) => {
    const [red, green, blue] = colour.map((part) => {
      const share = part / 255;
      return share <= 0.03928 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * red! + 0.7152 * green! + 0.0722 * blue!;
  };
  const [least, most] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (most! + 0.05) / (least! + 0.05);
}
