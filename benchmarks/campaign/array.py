#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What a job array costs besides its matches: the same matches by two workers here and by two tasks on the Slurm of the
tests, in turn.

    array.py REGISTA TEAM_A TEAM_B [--pairs N] [--rounds N]

Times are of the whole command, with its start, the copies and the gathering. --pairs: so many that the tasks last some two
minutes. The aim is 5 %. scripts/setup cluster installs Slurm.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "end_to_end"))
import slurm  # noqa: E402


def seconds(*words, environment):
    began = time.monotonic()
    subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL, env={**os.environ, **environment})
    return time.monotonic() - began


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista", type=pathlib.Path)
    parser.add_argument("teams", nargs=2, type=pathlib.Path)
    parser.add_argument("--pairs", type=int, default=20)
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    if slurm.why_not():
        sys.exit(slurm.why_not())
    regista, ratios = options.regista.resolve(), []
    cluster = slurm.Slurm(slots=1)
    try:
        cluster.start()
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            document = folder / "array.yaml"
            document.write_text("tournament: array\nteams:\n" +
                                "".join(f"  - {{team: {team.resolve()}}}\n" for team in options.teams) +
                                f"pairs: {options.pairs}\n")
            for number in range(options.rounds):
                common = [regista, "run", document, "--quiet", "--no-page"]
                here = seconds(*common, "--workers", 2, "--results", folder / f"{number}.db", environment={})
                array = seconds(*common, "--on", "slurm", "--folder", folder / f"{number}.cluster", "--array", 2, "--per-task",
                                2 * options.pairs, environment=cluster.environment)
                ratios.append(array / here)
                print(f"{2 * options.pairs} matches: two workers {here:.1f} s, two tasks {array:.1f} s", flush=True)
    finally:
        cluster.stop()
    print(f"the array takes {100 * (statistics.median(ratios) - 1):+.1f} % (median of {options.rounds} rounds)")


if __name__ == "__main__":
    main()
