#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The memory that one decision of one robot touches: code and data in lines of the cache (64 bytes) and pages (4 KiB),
medians over the decisions of the first seconds of open play. Every reference is traced (valgrind's lackey).

    footprint.py TRACED_MATCH HOME AWAY [--limit SECONDS] [--json]
"""
import argparse
import json
import statistics
import subprocess
import sys

LINE, PAGE = 64, 4096
BEGIN, END = b" S 5eed00000000,", b" S 5eed00000040,"  # traced_match.cpp


def units(address, size, unit):
    return range(address // unit, (address + size - 1) // unit + 1)


class Decision:
    def __init__(self):
        self.instructions = self.references = 0
        self.code, self.data, self.written, self.pages = set(), set(), set(), set()

    def add(self, kind, address, size):
        self.pages.update(units(address, size, PAGE))
        if kind == b"I ":
            self.instructions += 1
            self.code.update(units(address, size, LINE))
            return
        self.references += 1
        self.data.update(units(address, size, LINE))
        if kind != b" L":
            self.written.update(units(address, size, LINE))

    def numbers(self):
        return {"instructions": self.instructions, "code_kb": len(self.code) * LINE / 1024,
                "data_kb": len(self.data) * LINE / 1024, "data_lines_written": len(self.written),
                "pages": len(self.pages), "data_references": self.references}


def decisions(options):
    command = ["valgrind", "--quiet", "--tool=lackey", "--trace-mem=yes", "--log-fd=1", options.traced_match,
               options.home, options.away, str(options.limit)]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as traced:
        yield from between(traced.stdout)
        if traced.wait() != 0:
            sys.exit("footprint.py: the match was not played")


def between(trace):
    now = None
    for line in trace:
        if now is None:
            if line.startswith(BEGIN):
                now = Decision()
        elif line.startswith(END):
            yield now.numbers()
            now = None
        elif line[2:3] == b" ":
            address, size = line[3:].split(b",")
            now.add(line[:2], int(address, 16), int(size))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("traced_match", "home", "away"):
        parser.add_argument(name)
    parser.add_argument("--limit", type=float, default=4, help="simulated seconds; 4")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    all_of_them = list(decisions(options))
    if not all_of_them:
        sys.exit("footprint.py: no decision in open play")
    median = {name: statistics.median(each[name] for each in all_of_them) for name in all_of_them[0]}
    if options.json:
        print(json.dumps({"decisions": len(all_of_them), "median": median}))
        return
    print(f"{len(all_of_them)} decisions; medians of one")
    for name, value in median.items():
        print(f"  {name.replace('_', ' '):20}{value:>10,.0f}")


if __name__ == "__main__":
    main()
