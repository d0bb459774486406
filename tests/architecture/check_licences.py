#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every source file says its licence in one of its first lines, and it is the one that LICENSES/README.md names.

    check_licences.py ROOT

MIT everywhere but in the plugin that is compiled from CGAL's GPL headers. One line per violation.
"""
import re
import sys
from pathlib import Path

SUFFIXES = {".h", ".hpp", ".hh", ".c", ".cc", ".cpp", ".inl", ".ipp", ".cmake", ".py", ".sh", ".ts", ".mjs", ".js",
            ".rs"}
NOT_OURS = {"build", ".git", ".cache", "node_modules", "__pycache__"}
GPL_PLACE = "plugins/positioners/voronoi/"
IDENTIFIER = re.compile(r"SPDX-License-Identifier:\s*([\w.+-]+)")


def is_source(file):
    if file.suffix in SUFFIXES or file.name == "CMakeLists.txt":
        return True
    if file.suffix:
        return False
    with file.open("rb") as opened:
        return opened.read(2) == b"#!"


def files(folder):
    for entry in sorted(folder.iterdir()):
        if entry.name in NOT_OURS or entry.is_symlink():
            continue
        if entry.is_dir():
            yield from files(entry)
        elif is_source(entry):
            yield entry


def violations(root):
    root = Path(root)
    for file in files(root):
        path = file.relative_to(root).as_posix()
        head = "\n".join(file.read_text(encoding="utf-8", errors="replace").splitlines()[:3])
        found = IDENTIFIER.search(head)
        expected = "GPL-3.0-or-later" if path.startswith(GPL_PLACE) else "MIT"
        if not found:
            yield f"{path}:1: no SPDX-License-Identifier in the first three lines; here it is {expected}"
        elif found[1] != expected:
            line = head.count("\n", 0, found.start()) + 1
            yield f"{path}:{line}: licence {found[1]}; here it is {expected} (LICENSES/README.md)"


def main(arguments):
    lines = list(violations(arguments[0]))
    print("\n".join(lines) if lines else "every source file names its licence")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
