// SPDX-License-Identifier: MIT
// Light or dark: as the system has it, until the reader of the page chooses.
export class Theme {
  private readonly system = window.matchMedia("(prefers-color-scheme: dark)");
  private chosen: "light" | "dark" | null = null;

  changed: () => void = () => {};

  constructor() {
    this.system.addEventListener("change", () => this.apply());
    this.apply();
  }

  get current(): "light" | "dark" {
    return this.chosen ?? (this.system.matches ? "dark" : "light");
  }

  toggle(): void {
    this.chosen = this.current === "dark" ? "light" : "dark";
    this.apply();
  }

  private apply(): void {
    document.documentElement.dataset.theme = this.current;
    this.changed();
  }
}
