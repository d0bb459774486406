// SPDX-License-Identifier: MIT
// A button below the field that opens a list over the field's foot. Any number of choices takes no more room below the
// field than the button.
export class Popover {
  constructor(
    bar: HTMLElement,
    private readonly button: HTMLButtonElement,
    private readonly list: HTMLElement,
  ) {
    button.setAttribute("aria-haspopup", "true");
    button.setAttribute("aria-controls", list.id);
    list.classList.add("popover");
    button.addEventListener("click", () => this.show(list.hidden));
    document.addEventListener("pointerdown", ({ target }) => {
      if (target instanceof Node && !button.contains(target) && !list.contains(target)) this.show(false);
    });
    bar.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || list.hidden) return;
      event.stopPropagation(); // the chosen robot stays
      this.show(false);
      button.focus();
    });
    this.show(false);
    bar.append(button, list);
  }

  private show(open: boolean): void {
    this.list.hidden = !open;
    this.button.setAttribute("aria-expanded", String(open));
  }
}
