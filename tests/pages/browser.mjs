// SPDX-License-Identifier: MIT
// The browser in which pages are looked at: that of the viewer's tests.
import { existsSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const skipped = 77;

// What starts it. Where it is missing the process says so and ends with status 77, which skips the test.
export async function browserOf(source) {
  const skip = (why) => {
    console.log(`skipped: ${why}`);
    process.exit(skipped);
  };
  if (!existsSync(join(source, "viewer/node_modules/playwright-core")))
    skip("viewer/node_modules is missing (run scripts/setup, or `npm ci --ignore-scripts` in viewer/)");
  const { chromiumPath, startBrowser } = await import(pathToFileURL(join(source, "viewer/test/browser.mjs")));
  if (chromiumPath() === null) skip("there is no Chromium");
  return startBrowser;
}
