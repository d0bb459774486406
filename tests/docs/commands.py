#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the commands of a page of the documentation, as they are written, one after the other in a folder of the page's own.

    commands.py PAGE.md [--long]

The folder holds what a reader has who has installed Regista: the program in the path, and nothing else but the shipped
documents in `configs`. Blocks of code that count are

    ```sh        a script: it must end with status 0
    ```console   lines that begin with "$ ", each with what it prints under it; "..." stands for any text, a line of it
                 for any lines

and others with a comment in the line before:

    <!-- file: NAME -->            the block is written to this file
    <!-- status: N -->             its last command ends with this status
    <!-- makes: NAME ... -->       files it writes, which must be those of the folder `images` beside the page
    <!-- takes: 20 min -->         left out, but with --long
    <!-- needs: NAME ... -->       files that are not part of the project; left out where one is not there
    <!-- program: NAME ... -->     programs that a machine may lack; left out where one is not there
    <!-- in: the checkout -->      is run in the folder of the project
    <!-- not run: WHY -->          left out

REGISTA_BIN is the folder of the program, REGISTA_SOURCE that of the project. REGISTA_KEEP_IMAGES=1 writes images anew.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass

LONG = 60  # s, of a block that is run every time; a remark and no fault, for machines differ


@dataclass
class Block:
    line: int
    tag: str
    marks: dict
    lines: list
    indent: int = 0


def blocks_of(page):
    """The blocks of code of a page, with what the comment before each says."""
    out, mark, block = [], {}, None
    for number, line in enumerate(page.read_text().split("\n"), 1):
        text = line.strip()
        if block is not None:
            if text == "```":
                out.append(block)
                block, mark = None, {}
            else:
                block.lines.append(line[block.indent:] if line[:block.indent].isspace() else line)
        elif text.startswith("```"):
            block = Block(number, text[3:], mark, [])
            block.indent = len(line) - len(line.lstrip())
        elif found := re.fullmatch(r"<!-- ([a-z ]+): (.*) -->", text):
            mark[found[1]] = found[2]
        elif text:
            mark = {}
    return out


def commands_outside(page):
    """Lines that look like commands in blocks that are not run."""
    wrong = []
    for block in blocks_of(page):
        if block.tag in ("sh", "console") or "file" in block.marks:
            continue
        for offset, line in enumerate(block.lines, 1):
            if re.match(r"(\$ )?([\w/.]*/)?regista (\w|--)", line.strip()):
                wrong.append((block.line + offset, line))
    return wrong


class Failed(Exception):
    pass


def matches(expected, printed):
    pattern = "".join(r"(?:.*\n)*?" if line.strip() == "..." else re.escape(line).replace(r"\.\.\.", ".*") + r"\n"
                      for line in expected)
    return re.fullmatch(pattern, printed) is not None


class Runner:
    def __init__(self, folder, binaries, source, images):
        self.folder, self.source, self.images = folder, source, images
        self.data = source.parent / "shared" / "data"
        # scripts/check sets options of sanitizers; a reader has none, and what a sanitizer prints would differ.
        kept = {key: value for key, value in os.environ.items()
                if not key.startswith("REGISTA_") and key not in ("ASAN_OPTIONS", "UBSAN_OPTIONS")}
        self.environment = {**kept, "PATH": f"{binaries}:{os.environ['PATH']}", "HOME": str(folder), "TERM": "dumb",
                            "COLUMNS": "80", "LC_ALL": "C.UTF-8"}

    def shell(self, text, folder=None):
        return subprocess.run(["bash", "-e", "-u", "-o", "pipefail", "-c", text], cwd=folder or self.folder, text=True,
                              env=self.environment, stdin=subprocess.DEVNULL, capture_output=True, check=False)

    def needed(self, names):
        """Whether these files are in the folder now."""
        for name in names.split():
            found = sorted(self.data.rglob(name)) if self.data.is_dir() else []
            if not found:
                return False
            shutil.copy2(found[0], self.folder / name)
        return True

    def lacks(self, programs):
        """Those of them that this machine does not have."""
        return [name for name in programs.split() if shutil.which(name, path=self.environment["PATH"]) is None]

    def run(self, block):
        if "file" in block.marks:
            path = self.folder / block.marks["file"]
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("\n".join(block.lines) + "\n")
        elif block.tag == "sh":
            self.script(block)
        else:
            self.conversation(block)

    def script(self, block):
        done = self.shell("\n".join(block.lines), self.source if "in" in block.marks else self.folder)
        wanted = int(block.marks.get("status", 0))
        if done.returncode != wanted:
            raise Failed(f"ended with status {done.returncode} instead of {wanted}:\n{done.stderr[-2000:]}")
        for name in block.marks.get("makes", "").split():
            kept = self.images / name
            if not kept.exists() or kept.read_bytes() != (self.folder / name).read_bytes():
                if "REGISTA_KEEP_IMAGES" not in os.environ:
                    raise Failed(f"{kept} is not what is made now; REGISTA_KEEP_IMAGES=1 puts it there")
                shutil.copy2(self.folder / name, kept)

    def conversation(self, block):
        commands = []
        for line in block.lines:
            if line.startswith("$ "):
                commands.append((line[2:], []))
            elif commands:
                commands[-1][1].append(line)
        for number, (command, expected) in enumerate(commands, 1):
            done = self.shell(command + " 2>&1")
            wanted = int(block.marks.get("status", 0)) if number == len(commands) else 0
            if done.returncode != wanted:
                raise Failed(f"{command}\nended with status {done.returncode} instead of {wanted}:\n{done.stdout[-2000:]}")
            if not matches(expected, done.stdout):
                raise Failed(f"{command}\nprints something else:\n{done.stdout[-6000:]}")


def main():
    page, long = pathlib.Path(sys.argv[1]), "--long" in sys.argv[2:]
    source = pathlib.Path(os.environ["REGISTA_SOURCE"])
    wrong = [f"{page.name}:{number}: a command in a block that is not run: {line}" for number, line in commands_outside(page)]
    with tempfile.TemporaryDirectory(prefix="regista-docs-") as name:
        folder = pathlib.Path(name).resolve()
        runner = Runner(folder, os.environ["REGISTA_BIN"], source, page.parent / "images")
        shutil.copytree(source / "configs", folder / "configs")
        for block in blocks_of(page):
            if block.tag not in ("sh", "console") and "file" not in block.marks:
                continue
            what = f"{page.name}:{block.line}"
            lacking = runner.lacks(block.marks.get("program", ""))
            left_out = (lacking or "not run" in block.marks or ("takes" in block.marks and not long) or
                        ("needs" in block.marks and not runner.needed(block.marks["needs"])))
            if left_out:
                print(f"{what}: left out ({', '.join(f'{key}: {value}' for key, value in block.marks.items())})")
                continue
            began = time.monotonic()
            try:
                runner.run(block)
            except Failed as failure:
                wrong.append(f"{what}: {failure}")
            took = time.monotonic() - began
            is_long = took > LONG and "takes" not in block.marks
            print(f"{what}: {took:.1f} s{'; if it is never shorter, say so: <!-- takes: ... -->' if is_long else ''}", flush=True)
    for each in wrong:
        print(each, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
