/* SPDX-License-Identifier: MIT
The only script of a page of results. It sorts and filters the tables of the class "sortable". It reloads the page of a
running study and keeps unfolded parts and typed filters. Without the script the page has the same content. The page
allows only this script, by its hash. */
"use strict";
const foldings = [...document.querySelectorAll("details")], filters = [];
for (const box of document.querySelectorAll(".sortable")) {
  const table = box.querySelector("table"), body = table.tBodies[0], rows = [...body.rows];
  const heads = [...table.tHead.rows[0].cells];
  const value = (row, column) => {
    const text = row.cells[column].textContent.trim(), score = /^(\d+):(\d+)$/.exec(text);
    return score ? score[1] - score[2] : text !== "" && !isNaN(text) ? Number(text) : text;
  };
  const compare = (a, b) => {
    if (typeof a !== typeof b) return typeof a === "number" ? -1 : 1;
    return typeof a === "number" ? a - b : a.localeCompare(b);
  };
  heads.forEach((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const down = head.getAttribute("aria-sort") === "ascending";
      for (const each of heads) each.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      rows.sort((a, b) => (down ? -1 : 1) * compare(value(a, column), value(b, column)));
      body.append(...rows);
    });
  });
  const line = document.createElement("p"), label = document.createElement("label");
  const field = document.createElement("input"), shown = document.createElement("output");
  line.className = "filter";
  field.type = "search";
  label.append("Filter ", field);
  line.append(label, " ", shown);
  box.before(line);
  const filter = () => {
    const words = field.value.toLowerCase().split(/\s+/);
    for (const row of rows) {
      const text = [...row.cells].map((cell) => cell.textContent.toLowerCase()).join(" ");
      row.hidden = !words.every((word) => text.includes(word));
    }
    shown.textContent = field.value.trim() === "" ? "" : `${rows.filter((row) => !row.hidden).length} of ${rows.length}`;
  };
  field.addEventListener("input", filter);
  filters.push({ field, filter });
}
const seconds = Number(document.body.dataset.live);
if (seconds > 0) {
  const before = history.state ?? {};
  before.open?.forEach((open, i) => { if (foldings[i]) foldings[i].open = open; });
  before.words?.forEach((words, i) => {
    if (!filters[i] || words === "") return;
    filters[i].field.value = words;
    filters[i].filter();
  });
  if (before.y !== undefined) scrollTo(0, before.y);
  setInterval(() => {
    if (filters.some(({ field }) => field === document.activeElement)) return;
    history.replaceState({ open: foldings.map((each) => each.open), words: filters.map(({ field }) => field.value), y: scrollY }, "");
    location.reload();
  }, 1000 * seconds);
}
