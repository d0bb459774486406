#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files that pages and comments name are there.

    check_paths.py ROOT

Of pages: what is in backticks and begins with a folder of the tree, or is the name of a source. Of code: headers that
comments name. One line per violation.
"""
import re
import sys
from pathlib import Path

FOLDERS = ("host", "plugins", "league", "sdk", "viewer", "tests", "benchmarks", "configs", "scripts", "docs")
CODE = {".cpp", ".hpp", ".h", ".c"}
IN_PAGE = re.compile(r"`([\w./+-]+)`")
IN_COMMENT = re.compile(r"(?:^|\s)(?://|\*|/\*).*?$", re.M)
HEADER = re.compile(r"(?<![\w<\".])([\w/]*[a-z_0-9]+\.hpp)\b")
NOT_OURS = {"nlopt.hpp"}


def is_there(root, name):
    return any((root / (name + ending)).exists() for ending in ("", ".hpp", ".cpp"))


def violations(root):
    root = Path(root)
    names = {file.name for folder in FOLDERS for file in (root / folder).rglob("*")
             if file.is_file() and "node_modules" not in file.parts}
    for page in sorted([*root.glob("*.md"), *(root / "docs").glob("*.md"), *(root / "benchmarks").glob("*.md")]):
        if page.name == "CHANGELOG.md":  # says what was there then
            continue
        for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
            for name in IN_PAGE.findall(line):
                of_tree = name.split("/")[0] in FOLDERS and "/" in name and not is_there(root, name)
                source = Path(name).suffix in (".cpp", ".hpp") and Path(name).name not in names
                if of_tree or source:
                    yield f"{page.relative_to(root)}:{number}: names {name}, which is not there"
    for folder in FOLDERS[:4]:
        for file in sorted(f for f in (root / folder).rglob("*") if f.suffix in CODE and f.is_file()):
            for number, line in enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
                for comment in IN_COMMENT.findall(line) if "#include" not in line else ():
                    for name in HEADER.findall(comment):
                        if Path(name).name not in names | NOT_OURS:
                            yield f"{file.relative_to(root)}:{number}: names {name}, which is not there"


def main(arguments):
    if len(arguments) != 1:
        print("usage: check_paths.py ROOT")
        return 2
    lines = list(violations(arguments[0]))
    print("\n".join(lines) if lines else "every file that pages and comments name is there")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
