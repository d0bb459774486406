// SPDX-License-Identifier: MIT
// How fast a page opens and plays, in headless Chromium:
//   node benchmark.mjs PAGE.html     (made by `regista view`, or by build.mjs --recording)
// CHROMIUM names another browser than the one found in the path.
import { pathToFileURL } from "node:url";

import { startBrowser } from "./test/browser.mjs";

const file = process.argv[2];
if (file === undefined) {
  console.error("usage: node benchmark.mjs PAGE.html");
  process.exit(2);
}
const seconds = 4;
const browser = await startBrowser();
try {
  const page = await browser.newPage();
  const opened = [];
  for (let i = 0; i < 3; ++i) {
    await page.goto(pathToFileURL(file).href);
    await page.waitForFunction(() => window.regista !== undefined, null, { timeout: 60_000 });
    opened.push(await page.evaluate(() => window.regista.openedAfter));
  }
  console.log(`opens after ${opened.map((ms) => ms.toFixed(0)).join(", ")} ms`);
  await page.waitForFunction(() => document.body.dataset.counted === "true");
  for (const panel of ["overlaps", "robot", "compare"]) {
    for (const speed of [1, 4, 16]) {
      const frames = await page.evaluate(
        async ({ panel, speed, seconds }) => {
          const { state, playback } = window.regista.viewer;
          const middle = 0.4 * (state.begin + state.end);
          state.set({
            panel,
            speed,
            time: middle,
            robot: { side: 0, number: 3 },
            pair: { side: 0, robots: [3, 4], role: 1 },
            playing: true,
          });
          const first = playback.frames;
          let last = performance.now();
          let longest = 0;
          const until = last + 1000 * seconds;
          await new Promise((resolve) => {
            const watch = (now) => {
              longest = Math.max(longest, now - last);
              last = now;
              if (now < until) requestAnimationFrame(watch);
              else resolve();
            };
            requestAnimationFrame(watch);
          });
          const rate = (playback.frames - first) / seconds;
          state.set({ playing: false });
          return { rate, longest };
        },
        { panel, speed, seconds },
      );
      console.log(`${panel} at ${speed}x: ${frames.rate.toFixed(1)} frames/s, longest ${frames.longest.toFixed(0)} ms`);
    }
  }
} finally {
  await browser.close();
}
