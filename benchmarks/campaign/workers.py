#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a tournament costs around its matches, and what a second worker gains.

    workers.py REGISTA TEAM_A TEAM_B [--pairs N] [--rounds N] [more options of both commands, such as --limit 60]

The same matches are played four ways, in turns: by `regista match` one after the other and two side by side, and by
`regista tournament` with one worker and with two. Printed: the gain of the second one in both, their ratio, and the
processor time of the tournament over that of the matches alone.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time


def processor():
    times = os.times()
    return times.children_user + times.children_system


def measured(work):
    began, before = time.monotonic(), processor()
    work()
    return time.monotonic() - began, processor() - before


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista", type=pathlib.Path)
    parser.add_argument("teams", nargs=2, type=pathlib.Path)
    parser.add_argument("--pairs", type=int, default=6)
    parser.add_argument("--rounds", type=int, default=5)
    options, more = parser.parse_known_args()
    regista = str(options.regista.resolve())
    a, b = (str(team) for team in options.teams)
    matches = [[regista, "match", *teams, "--seed", str(seed), "--json", "--quiet", *more]
               for seed in range(1, options.pairs + 1) for teams in ((a, b), (b, a))]

    def bare(at_once):
        waiting, running = list(reversed(matches)), []
        while waiting or running:
            while waiting and len(running) < at_once:
                running.append(subprocess.Popen(waiting.pop(), stdout=subprocess.DEVNULL))
            pid, status = os.wait()
            for process in running:
                if process.pid == pid:
                    process.returncode = os.waitstatus_to_exitcode(status)
            if status != 0:
                sys.exit("a match failed")
            running = [process for process in running if process.returncode is None]

    def tournament(workers):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([regista, "tournament", "--team", a, "--team", b, "--pairs", str(options.pairs), "--workers",
                            str(workers), "--results", f"{folder}/t.db", "--quiet", *more], check=True,
                           stdout=subprocess.DEVNULL)

    ways = {"bare, one": lambda: bare(1), "bare, two": lambda: bare(2),
            "tournament, one": lambda: tournament(1), "tournament, two": lambda: tournament(2)}
    wall, cpu = {name: [] for name in ways}, {name: [] for name in ways}
    for _ in range(options.rounds):
        for name, way in ways.items():
            seconds, used = measured(way)
            wall[name].append(seconds)
            cpu[name].append(used)
    best = {name: min(times) for name, times in wall.items()}
    for name in ways:
        print(f"{name:16} wall {best[name]:7.3f} s (best of {options.rounds}; median "
              f"{statistics.median(wall[name]):7.3f}), processor {min(cpu[name]):7.3f} s")
    bare_gain = best["bare, one"] / best["bare, two"]
    gain = best["tournament, one"] / best["tournament, two"]
    print(f"gain of the second: bare {bare_gain:.3f}, tournament {gain:.3f}, ratio {gain / bare_gain:.3f}")
    print(f"around the matches: processor {100 * (min(cpu['tournament, one']) / min(cpu['bare, one']) - 1):+.2f} %, "
          f"wall {100 * (best['tournament, one'] / best['bare, one'] - 1):+.2f} %")


if __name__ == "__main__":
    main()
