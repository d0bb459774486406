// SPDX-License-Identifier: MIT
// The start of the page: the recording inside it, or one that is chosen or dropped.
import { Theme } from "./app/theme";
import { byId, setText } from "./panels/elements";
import { UnreadableRecording } from "./recording/about";
import { type Source, embedded, ofFile } from "./recording/embedded";
import { readMatch } from "./recording/match";
import { Viewer } from "./viewer";

declare global {
  interface Window {
    regista?: { viewer: Viewer; openedAfter: number }; // for measurements: ms since the page began to load
  }
}

function ask(text: string): void {
  document.body.dataset.state = text === "" ? "asking" : "failed";
  setText(byId("start-text"), text === "" ? "This page plays back a recorded match." : text);
  byId("start-progress").hidden = true;
  byId("start-choose").hidden = false;
  byId("start-hint").hidden = false;
}

// Only the recording that was chosen last counts; once one is shown, opening another begins anew.
let chosen = 0;
let opened = false;

class Outdated extends Error {}

async function open(source: Source): Promise<void> {
  const turn = ++chosen;
  const stillWanted = () => {
    if (turn !== chosen) throw new Outdated();
  };
  const progress = byId<HTMLProgressElement>("start-progress");
  document.body.dataset.state = "reading";
  progress.value = 0;
  progress.hidden = false;
  byId("start-choose").hidden = true;
  byId("start-hint").hidden = true;
  setText(byId("start-text"), `Reading ${source.name} …`);
  try {
    await new Promise((resolve) => setTimeout(resolve, 0));
    stillWanted();
    const bytes = await source.bytes();
    stillWanted();
    const match = await readMatch(bytes, (share) => {
      stillWanted();
      progress.value = share;
    });
    stillWanted();
    opened = true;
    byId("start").hidden = true;
    byId("viewer").hidden = false;
    const viewer = new Viewer(match, source.name, theme);
    document.body.dataset.state = "ready";
    // After the first frame, which the viewer has asked for already.
    requestAnimationFrame(() => {
      window.regista = { viewer, openedAfter: performance.now() };
    });
  } catch (error) {
    if (turn !== chosen) return; // another one is being read
    byId("start").hidden = false;
    byId("viewer").hidden = true;
    const why =
      error instanceof UnreadableRecording
        ? error.message
        : error instanceof RangeError
          ? "The recording is too large for this browser's memory."
          : `The recording cannot be shown: ${error instanceof Error ? error.message : String(error)}`;
    ask(source.name === "" ? why : `${source.name}\n${why}`);
  }
}

function choose(file: File | undefined): void {
  if (file === undefined || opened) return;
  void open(ofFile(file));
}

function listen(): void {
  const file = byId<HTMLInputElement>("file");
  file.addEventListener("change", () => {
    choose(file.files?.[0]);
    file.value = ""; // the same one may be chosen again
  });
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("dropping");
  });
  document.addEventListener("dragleave", () => document.body.classList.remove("dropping"));
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("dropping");
    choose(event.dataTransfer?.files[0]);
  });
}

const theme = new Theme();
listen();
const source = embedded(document);
const again = byId("open");
again.hidden = source !== null;
again.addEventListener("click", () => location.replace(location.href.replace(/#.*/, "")));
if (source === null) ask("");
else void open(source);
