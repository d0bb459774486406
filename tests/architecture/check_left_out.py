#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What scripts/check leaves out is decided, not forgotten: docs/decisions.md names each test of tests/left_out.txt, by
its name in quotes of code.

    check_left_out.py PROJECT
"""

import pathlib
import sys


def left_out(text):
    return [line.split()[0] for line in text.splitlines() if line.strip() and not line.startswith("#")]


def undecided(listed, decisions):
    return [name for name in left_out(listed) if f"`{name}`" not in decisions]


def main(root):
    root = pathlib.Path(root)
    wrong = undecided((root / "tests/left_out.txt").read_text(), (root / "docs/decisions.md").read_text())
    for name in wrong:
        print(f"tests/left_out.txt: {name} has no line in docs/decisions.md")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
