// SPDX-License-Identifier: MIT
import type { Page } from "playwright-core";

export function chromiumPath(): string | null;
export function startBrowser(options?: object): Promise<{ newPage(): Promise<Page>; close(): Promise<void> }>;
