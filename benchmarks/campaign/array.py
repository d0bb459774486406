#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What a job array costs besides its matches: the same matches by local workers and by tasks of the Slurm of the tests.

    array.py REGISTA TEAM_A TEAM_B [--at-once] [--pairs N] [--tasks N] [--rounds N]

Two workers here and two nodes with a slot each, in turn; which comes first alternates. With --at-once one worker here and
one node with one slot, at the same time: what makes the machine slower for some minutes is in both times.

Times are of the whole command, with its start, the copies and the gathering. The second ratio is of the time for each
second that the matches themselves took, by the clock of their own process. --pairs: so many that the tasks last some
two minutes. The aim is 5 %. scripts/setup cluster installs Slurm.
"""
import argparse
import contextlib
import os
import pathlib
import sqlite3
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "end_to_end"))
import slurm  # noqa: E402


def start(*words, environment):
    return subprocess.Popen([str(word) for word in words], stdout=subprocess.DEVNULL, env={**os.environ, **environment})


def seconds(commands):
    """What each of the commands takes, which are started together. By name: functions that start them."""
    began, out = time.monotonic(), {}
    running = {name: begin() for name, begin in commands.items()}
    try:
        while running:
            for name, process in list(running.items()):
                if process.poll() is None:
                    continue
                out[name] = time.monotonic() - began
                del running[name]
                if process.returncode != 0:
                    sys.exit(f"{name} ended with {process.returncode}")
            time.sleep(0.02)
    finally:
        for process in running.values():  # where another has failed
            process.terminate()
            process.wait()
    return out


def in_matches(results):
    """Seconds that the matches themselves took."""
    with contextlib.closing(sqlite3.connect(results)) as database:
        return database.execute("SELECT sum(seconds) FROM matches").fetchone()[0]


def percent(ratio):
    return f"{100 * (ratio - 1):+.1f} %"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista", type=pathlib.Path)
    parser.add_argument("teams", nargs=2, type=pathlib.Path)
    parser.add_argument("--at-once", action="store_true", help="one worker and one slot, at the same time")
    parser.add_argument("--pairs", type=int, help="of matches; default: 48, with --at-once 24")
    parser.add_argument("--tasks", type=int, help="of the array; default: 4, with --at-once 2")
    parser.add_argument("--rounds", type=int, default=4)
    options = parser.parse_args()
    if slurm.why_not():
        sys.exit(slurm.why_not())
    slots = 1 if options.at_once else 2  # of the workers here, and of the cluster
    pairs, tasks = options.pairs or 24 * slots, options.tasks or 2 * slots
    regista, walls, overheads = options.regista.resolve(), [], []
    cluster = slurm.Slurm(slots=1, nodes=slots)
    try:
        cluster.start()
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            document = folder / "array.yaml"
            document.write_text("tournament: array\nteams:\n" +
                                "".join(f"  - {{team: {team.resolve()}}}\n" for team in options.teams) +
                                f"pairs: {pairs}\n")
            common = [regista, "run", document, "--quiet", "--no-page"]
            for number in range(options.rounds):
                results = {"here": folder / f"{number}.db", "array": folder / f"{number}.cluster" / "results.db"}
                commands = {
                    "here": lambda: start(*common, "--workers", slots, "--results", results["here"], environment={}),
                    "array": lambda: start(*common, "--on", "slurm", "--folder", results["array"].parent, "--array", tasks,
                                           "--per-task", 2 * pairs, environment=cluster.environment)}
                if options.at_once:
                    wall = seconds(commands)
                else:
                    wall = {}
                    for name in ("here", "array") if number % 2 == 0 else ("array", "here"):
                        wall |= seconds({name: commands[name]})
                share = {name: slots * wall[name] / in_matches(results[name]) for name in commands}
                walls.append(wall["array"] / wall["here"])
                overheads.append(share["array"] / share["here"])
                print(f"{2 * pairs} matches: {slots} {'worker' if slots == 1 else 'workers'} {wall['here']:.1f} s, "
                      f"{tasks} tasks {wall['array']:.1f} s, {percent(walls[-1])}; for each second of a match "
                      f"{percent(overheads[-1])}", flush=True)
    finally:
        cluster.stop()
    print(f"the array takes {percent(statistics.median(walls))}; for each second of a match "
          f"{percent(statistics.median(overheads))} (medians of {options.rounds} rounds)")


if __name__ == "__main__":
    main()
