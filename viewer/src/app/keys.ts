// SPDX-License-Identifier: MIT
// The keyboard: one table, which is also what the help shows.
export interface Key {
  keys: string[]; // as in KeyboardEvent.key; with Shift: "Shift+" and key (arrows) or code (digits)
  shown: string; // empty: the row of the key before it names it too
  does: string;
  run(event: KeyboardEvent): void;
}

// Elements that need some keys for themselves.
function takesKey(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest("dialog") !== null) return true;
  if (target instanceof HTMLInputElement && target.type === "range") {
    return key.startsWith("Arrow") || key === "Home" || key === "End" || key.startsWith("Page");
  }
  if (target instanceof HTMLSelectElement || target instanceof HTMLInputElement) return true;
  return target instanceof HTMLButtonElement && (key === " " || key === "Enter");
}

export function listenToKeys(keys: readonly Key[]): void {
  const byKey = new Map(keys.flatMap((key) => key.keys.map((name) => [name, key] as const)));
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    // What a digit gives with Shift is another on each keyboard; what it gives may be a key of its own.
    const shifted = event.shiftKey && event.key.startsWith("Arrow") ? `Shift+${event.key}` : event.key;
    const key = byKey.get(shifted) ?? (event.shiftKey ? byKey.get(`Shift+${event.code}`) : undefined);
    if (key === undefined || takesKey(event.target, event.key)) return;
    event.preventDefault();
    key.run(event);
  });
}
