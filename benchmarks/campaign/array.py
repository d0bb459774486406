#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What a job array costs besides its matches: the same matches by two workers here and by tasks on the two nodes of
the Slurm of the tests, in turn.

    array.py REGISTA TEAM_A TEAM_B [--pairs N] [--tasks N] [--rounds N]

Times are of the whole command, with its start, the copies and the gathering; which comes first alternates. The second
ratio is of the time for each second that the matches themselves took, by the clock of their own process: a machine that
plays slower for some minutes has no part in it. --pairs: so many that the tasks last some two minutes. The aim is 5 %. scripts/setup cluster installs Slurm.
"""
import argparse
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


SLOTS = 2  # of the workers here, and of the cluster


def seconds(*words, environment):
    began = time.monotonic()
    subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL, env={**os.environ, **environment})
    return time.monotonic() - began


def in_matches(results):
    """Seconds that the matches themselves took."""
    with sqlite3.connect(results) as database:
        out = database.execute("SELECT sum(seconds) FROM matches").fetchone()[0]
    database.close()
    return out


def percent(ratio):
    return f"{100 * (ratio - 1):+.1f} %"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista", type=pathlib.Path)
    parser.add_argument("teams", nargs=2, type=pathlib.Path)
    parser.add_argument("--pairs", type=int, default=48)
    parser.add_argument("--tasks", type=int, default=4, help="of the array; two run at a time")
    parser.add_argument("--rounds", type=int, default=4)
    options = parser.parse_args()
    if slurm.why_not():
        sys.exit(slurm.why_not())
    regista, walls, overheads = options.regista.resolve(), [], []
    cluster = slurm.Slurm(slots=1)
    try:
        cluster.start()
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            document = folder / "array.yaml"
            document.write_text("tournament: array\nteams:\n" +
                                "".join(f"  - {{team: {team.resolve()}}}\n" for team in options.teams) +
                                f"pairs: {options.pairs}\n")
            common = [regista, "run", document, "--quiet", "--no-page"]
            for number in range(options.rounds):
                wall, share = {}, {}
                for what in ("here", "array") if number % 2 == 0 else ("array", "here"):
                    if what == "here":
                        results = folder / f"{number}.db"
                        wall[what] = seconds(*common, "--workers", SLOTS, "--results", results, environment={})
                    else:
                        results = folder / f"{number}.cluster" / "results.db"
                        wall[what] = seconds(*common, "--on", "slurm", "--folder", results.parent, "--array", options.tasks,
                                             "--per-task", 2 * options.pairs, environment=cluster.environment)
                    share[what] = SLOTS * wall[what] / in_matches(results)
                walls.append(wall["array"] / wall["here"])
                overheads.append(share["array"] / share["here"])
                print(f"{2 * options.pairs} matches: two workers {wall['here']:.1f} s, {options.tasks} tasks "
                      f"{wall['array']:.1f} s, {percent(walls[-1])}; for each second of a match {percent(overheads[-1])}",
                      flush=True)
    finally:
        cluster.stop()
    print(f"the array takes {percent(statistics.median(walls))}; for each second of a match "
          f"{percent(statistics.median(overheads))} (medians of {options.rounds} rounds)")


if __name__ == "__main__":
    main()
