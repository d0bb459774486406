#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files are ideas: none has more than 500 lines, and no two headers of the host have one name.

    check_sizes.py ROOT

One line per violation. LONGER lists the files that may be longer, and why.
"""
import sys
from pathlib import Path

MOST_LINES = 500
SOURCES = {".h", ".hpp", ".c", ".cpp", ".py", ".ts", ".mjs", ".css"}
FOLDERS = ("sdk", "host", "plugins", "league", "tests", "benchmarks", "viewer/src", "scripts")
LONGER = {
    "sdk/include/regista/abi.h": "the interface, in one place",
    "tests/contract/abi/layout.h": "a table: each size, offset and value of the interface",
    "host/match/metric_table.cpp": "a table: a row for each metric",
}


def files(root):
    for folder in FOLDERS:
        yield from sorted(file for file in (root / folder).rglob("*") if file.suffix in SOURCES and file.is_file())


def violations(root):
    root = Path(root)
    headers = {}
    for file in files(root):
        path = file.relative_to(root).as_posix()
        if "/frozen/" in path or "/node_modules/" in path:
            continue
        lines = len(file.read_text(encoding="utf-8", errors="replace").splitlines())
        if lines > MOST_LINES and path not in LONGER:
            yield f"{path}: has {lines} lines; none has more than {MOST_LINES}, but what LONGER in {Path(__file__).name} lists"
        if path.startswith("host/") and file.suffix == ".hpp":
            headers.setdefault(file.name, []).append(path)
    for name, paths in sorted(headers.items()):
        if len(paths) > 1:
            yield f"{paths[0]}: another header has its name: {', '.join(paths[1:])}"
    for path in LONGER:
        if (root / path).is_file() and len((root / path).read_text().splitlines()) <= MOST_LINES:
            yield f"{path}: has at most {MOST_LINES} lines; take it off the list"


def main(arguments):
    if len(arguments) != 1:
        print("usage: check_sizes.py ROOT")
        return 2
    lines = list(violations(arguments[0]))
    print("\n".join(lines) if lines else f"no file has more than {MOST_LINES} lines, and no header's name is there twice")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
