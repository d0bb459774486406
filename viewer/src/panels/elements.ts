// SPDX-License-Identifier: MIT
// Elements of the page. Text goes in as text, never as markup: names come from files that others wrote.
type Child = Node | string | number;

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Readonly<Record<string, string>> = {}, ...children: Child[]
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

export function row(cells: readonly (Child | HTMLTableCellElement)[], attributes: Readonly<Record<string, string>> = {}): HTMLTableRowElement {
  return element("tr", attributes, ...cells.map((cell) => (cell instanceof HTMLTableCellElement ? cell : element("td", {}, cell))));
}

export const numeric = (text: Child, attributes: Readonly<Record<string, string>> = {}) =>
  element("td", { ...attributes, class: `number ${attributes.class ?? ""}`.trim() }, text);

export function heading(cells: readonly (string | HTMLTableCellElement)[]): HTMLTableSectionElement {
  return element("thead", {}, element("tr", {}, ...cells.map((cell) =>
    typeof cell === "string" ? element("th", { scope: "col", class: cell.startsWith("#") ? "number" : "" }, cell.replace(/^#/, "")) : cell)));
}

export function setText(node: HTMLElement, text: string): void {
  if (node.textContent !== text) node.textContent = text;
}

// A column's head that may break a long name at its underscores, and within a long word.
export function brokenName(name: string): (Node | string)[] {
  return name.split("_").flatMap((part, i) => {
    const letters = [...part];
    const half = Math.ceil(letters.length / 2);
    const soft = letters.length > 9 ? [...letters.slice(0, half), "\u00ad", ...letters.slice(half)].join("") : part;
    return i > 0 ? [element("wbr"), `_${soft}`] : [soft];
  });
}
