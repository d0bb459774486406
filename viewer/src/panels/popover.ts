// SPDX-License-Identifier: MIT
// A button below the field that opens a list over the field's foot. Any number of choices takes no more room below the
// field than the button.
export class Popover {
  constructor(
    private readonly bar: HTMLElement,
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
    // Above its button, as far as there is room to the right.
    this.list.style.left = "0";
    if (open) {
      const room = this.bar.clientWidth - this.list.offsetWidth;
      this.list.style.left = `${Math.max(0, Math.min(this.button.offsetLeft, room))}px`;
    }
    this.button.setAttribute("aria-expanded", String(open));
  }
}
