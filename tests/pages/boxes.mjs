// SPDX-License-Identifier: MIT
// What is wrong with the boxes of a page that a browser has laid out: a list of sentences. Everything here runs in the
// page, so it uses nothing from outside the function.

export function faultsOfPage({ figures }) {
  const faults = [];
  const slack = 1; // pixel, for rounding
  const short = (text) => JSON.stringify(text.replace(/\s+/g, " ").trim().slice(0, 40));
  const shown = (element) => element.checkVisibility({ checkVisibilityCSS: true });
  const root = document.documentElement;

  // --- Texts: a box for each line of each text -----------------------------------------------------------------------
  const texts = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
    const of = node.parentElement;
    if (node.data.trim() === "" || of.closest("svg") !== null || !shown(of)) continue;
    const range = document.createRange();
    range.selectNodeContents(node);
    for (const box of range.getClientRects()) {
      if (box.width > 0) texts.push({ node, of, text: node.data, box });
    }
  }
  for (const of of document.querySelectorAll("svg text")) {
    if (of.textContent.trim() === "" || !shown(of)) continue;
    texts.push({ node: of, of, text: of.textContent, box: of.getBoundingClientRect() });
  }

  // The line box of a text is higher than its letters: a tenth of it above and below is empty.
  const core = ({ box }) => ({
    left: box.left + slack,
    right: box.right - slack,
    top: box.top + 0.1 * box.height,
    bottom: box.bottom - 0.1 * box.height,
  });
  // What a scroll container does not show at the moment does not lie over anything.
  function seen(text) {
    const out = core(text);
    for (let each = text.of; each !== null; each = each.parentElement) {
      if (getComputedStyle(each).overflowX === "visible" && each.tagName !== "svg") continue;
      const box = each.getBoundingClientRect();
      out.left = Math.max(out.left, box.left);
      out.right = Math.min(out.right, box.right);
      out.top = Math.max(out.top, box.top);
      out.bottom = Math.min(out.bottom, box.bottom);
    }
    return out;
  }
  const cores = texts.map((text) => ({ text, ...seen(text) })).filter((a) => a.left < a.right && a.top < a.bottom);
  cores.sort((a, b) => a.top - b.top);
  for (let i = 0; i < cores.length; ++i) {
    for (let j = i + 1; j < cores.length && cores[j].top < cores[i].bottom; ++j) {
      const [a, b] = [cores[i], cores[j]];
      if (a.text.node === b.text.node || a.left >= b.right || b.left >= a.right) continue;
      faults.push(`${short(a.text.text)} and ${short(b.text.text)} lie over each other`);
    }
  }

  // --- Nothing is cut, nothing sticks out ----------------------------------------------------------------------------
  if (root.scrollWidth > window.innerWidth) {
    faults.push(`the page is ${root.scrollWidth} px wide and the window ${window.innerWidth}`);
  }
  const scrolls = (element) => ["auto", "scroll"].includes(getComputedStyle(element).overflowX);
  for (const element of document.querySelectorAll("body *:not(svg *)")) {
    if (!shown(element) || scrolls(element) || getComputedStyle(element).display === "inline") continue;
    if (element.tagName !== "svg" && element.scrollWidth > element.clientWidth + slack && element.clientWidth > 0) {
      faults.push(`<${element.tagName.toLowerCase()} class="${element.className}"> ${short(element.textContent)}: ` +
                  `content of ${element.scrollWidth} px in ${element.clientWidth}`);
    }
  }
  const page = document.querySelector("main").getBoundingClientRect();
  for (const { of, text, box } of texts) {
    const svg = of.closest("svg");
    const container = svg ?? of.closest(".wide, pre");
    const room = svg === null && container !== null ? null : (container?.getBoundingClientRect() ?? page);
    if (room === null) continue; // can be scrolled to
    if (box.left < room.left - slack || box.right > room.right + slack || box.top < room.top - slack ||
        (svg !== null && box.bottom > room.bottom + slack)) {
      faults.push(`${short(text)} sticks out of the ${svg === null ? "page" : "figure"}`);
    }
  }

  // --- One width -----------------------------------------------------------------------------------------------------
  const content = document.querySelector(".content").getBoundingClientRect();
  for (const box of document.querySelectorAll(".content .drawn, .content .wide > table")) {
    if (!shown(box)) continue;
    const { width } = box.getBoundingClientRect();
    const room = box.closest(".two")?.firstElementChild.getBoundingClientRect().width ?? content.width;
    if (width < 0.98 * room) faults.push(`${short(box.textContent)}: ${width} px wide, and the page has room for ${room}`);
  }
  // What scrolls in its box has a shadow at the side.
  for (const box of document.querySelectorAll(".drawn, .wide")) {
    if (shown(box) && box.scrollWidth > box.clientWidth && getComputedStyle(box).backgroundImage === "none") {
      faults.push(`${short(box.textContent)} scrolls, and does not show it`);
    }
  }

  // --- Contents: beside the page where there is room, above it elsewhere; the verdict is seen at once ----------------
  const nav = document.querySelector("nav").getBoundingClientRect();
  const top = document.querySelector(".top").getBoundingClientRect();
  const wide = window.innerWidth >= 1366;
  if (wide && (nav.right > content.left || nav.top > top.top + 40)) faults.push("the contents are not beside the page");
  if (!wide && (nav.bottom > content.top || nav.top < top.bottom)) faults.push("the contents are not above the page");
  for (const link of document.querySelectorAll("nav a")) {
    if (document.getElementById(link.hash.slice(1)) === null) faults.push(`the contents lead to ${link.hash}: not there`);
  }
  if (wide && top.bottom + window.scrollY > window.innerHeight) {
    faults.push(`the verdict and its figure end at ${top.bottom} px, the screen at ${window.innerHeight}`);
  }

  // --- Figures -------------------------------------------------------------------------------------------------------
  const there = document.querySelectorAll("figure svg").length;
  if (there < figures) faults.push(`${there} figures, and ${figures} are wanted`);
  for (const svg of document.querySelectorAll("figure svg")) {
    const box = svg.getBoundingClientRect();
    const name = short(svg.getAttribute("aria-label"));
    const scale = box.width / svg.viewBox.baseVal.width;
    for (const text of svg.querySelectorAll("text")) {
      const size = scale * parseFloat(getComputedStyle(text).fontSize);
      if (size >= 10) continue;
      faults.push(`figure ${name}: letters of ${size.toFixed(1)} px`);
      break;
    }
  }

  // --- Contrast: WCAG 2.1, 1.4.3 ------------------------------------------------------------------------------------
  const sheet = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
  function paint(colours) {
    sheet.clearRect(0, 0, 1, 1);
    for (const colour of colours) {
      sheet.fillStyle = colour;
      sheet.fillRect(0, 0, 1, 1);
    }
    return [...sheet.getImageData(0, 0, 1, 1).data].slice(0, 3);
  }
  const luminance = (rgb) =>
    rgb.map((part) => part / 255)
      .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4))
      .reduce((sum, part, i) => sum + [0.2126, 0.7152, 0.0722][i] * part, 0);
  const told = new Set();
  for (const { of, text } of texts) {
    const grounds = [];
    for (let each = of; each !== null; each = each.parentElement) grounds.unshift(getComputedStyle(each).backgroundColor);
    const own = getComputedStyle(of);
    const ground = luminance(paint(grounds)), ink = luminance(paint([...grounds, of.closest("svg") ? own.fill : own.color]));
    const contrast = (Math.max(ground, ink) + 0.05) / (Math.min(ground, ink) + 0.05);
    const line = `${short(text)}: contrast ${contrast.toFixed(1)}`;
    if (contrast < 4.5 && !told.has(line)) faults.push(line);
    told.add(line);
  }
  return faults;
}
