// SPDX-License-Identifier: MIT
// Elements of the page. Text goes in as text, never as markup: names come from files that others wrote.
type Child = Node | string | number;

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Readonly<Record<string, string>> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  for (const child of children) made.append(typeof child === "object" ? child : document.createTextNode(String(child)));
  return made;
}

export function byId<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (found === null) throw new Error(`no element ${id}`);
  return found as T;
}

export function row(
  cells: readonly (Child | HTMLTableCellElement)[],
  attributes: Readonly<Record<string, string>> = {},
): HTMLTableRowElement {
  return element(
    "tr",
    attributes,
    ...cells.map((cell) => (cell instanceof HTMLTableCellElement ? cell : element("td", {}, cell))),
  );
}

export const numeric = (text: Child, attributes: Readonly<Record<string, string>> = {}) =>
  element("td", { ...attributes, class: `number ${attributes.class ?? ""}`.trim() }, text);

export function heading(cells: readonly (string | HTMLTableCellElement)[]): HTMLTableSectionElement {
  return element(
    "thead",
    {},
    element(
      "tr",
      {},
      ...cells.map((cell) =>
        typeof cell === "string"
          ? element("th", { scope: "col", class: cell.startsWith("#") ? "number" : "" }, cell.replace(/^#/, ""))
          : cell,
      ),
    ),
  );
}

export function setText(node: HTMLElement, text: string): void {
  if (node.textContent !== text) node.textContent = text;
}

// More columns than these, and a matrix takes smaller letters and more of the width.
export const manyColumns = 7;

// A name that may break before its underscores and after its points, and within a word of more letters than `most`.
export function brokenName(name: string, most = 7): (Node | string)[] {
  return name.split(/(?=_)|(?<=\.)/).flatMap((part, i) => {
    const letters = [...part];
    const half = Math.ceil(letters.length / 2);
    const whole = letters.length - (part.startsWith("_") ? 1 : 0) <= most;
    const soft = whole ? part : [...letters.slice(0, half), "\u00ad", ...letters.slice(half)].join("");
    return i > 0 ? [element("wbr"), soft] : [soft];
  });
}

// A cell for a name, which may go on in the next line; `whole` stands in its title where the text is a shorter one.
export const named = (text: string, attributes: Readonly<Record<string, string>> = {}, whole = text) =>
  element(
    "td",
    { title: whole, ...attributes, class: `name ${attributes.class ?? ""}`.trim() },
    ...brokenName(text, Infinity),
  );

// What a menu shows, for one whose names may be longer than there is room.
export function titleOf(select: HTMLSelectElement): void {
  const text = select.selectedOptions[0]?.title || select.selectedOptions[0]?.textContent || "";
  if (select.title !== text) select.title = text;
}

// From cell to cell with the arrow keys; the table takes one stop of the tab key.
export function moveWithArrows(table: HTMLTableElement): void {
  table.addEventListener("keydown", (event) => {
    const cell = event.target instanceof Element ? event.target.closest("td") : null;
    const step = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] }[event.key];
    if (cell === null || step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const line = cell.parentElement as HTMLTableRowElement;
    table.rows[line.rowIndex + step[0]!]?.cells[cell.cellIndex + step[1]!]?.focus();
  });
}
