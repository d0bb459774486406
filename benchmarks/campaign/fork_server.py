#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the fork server gains: the same tournament of short games with it and without, in turns.

    fork_server.py REGISTA TEAM_A TEAM_B [--limit SECONDS] [--openings FOLDER] [--pairs N] [--rounds N] [--before OTHER_REGISTA]

Without it means that it is killed as often as it is seen: after three deaths nobody starts it again, and each match
starts the program. --before: that is done by another program, of an earlier version. Printed: processor time of a game, least of all rounds, both ways, and their ratio. One worker."""
import argparse
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

DEATHS = 3


def servers_of(coordinator):
    """Its children that are fork servers."""
    try:
        children = pathlib.Path(f"/proc/{coordinator}/task/{coordinator}/children").read_text().split()
        return [int(each) for each in children if b"fork-server" in pathlib.Path(f"/proc/{each}/cmdline").read_bytes()]
    except OSError:
        return []


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista", type=pathlib.Path)
    parser.add_argument("teams", nargs=2)
    parser.add_argument("--limit", default="30")
    parser.add_argument("--openings", default="configs/openings")  # without scenes nobody plays in so short a game
    parser.add_argument("--pairs", type=int, default=43)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--before", type=pathlib.Path)
    options = parser.parse_args()

    def game(without):
        with tempfile.TemporaryDirectory() as folder:
            before = os.times()
            teams = [word for team in options.teams for word in ("--team", team)]
            program = options.before if without and options.before else options.regista
            running = subprocess.Popen([str(program), "tournament", *teams, "--pairs", str(options.pairs), "--limit",
                                        options.limit, "--openings", options.openings, "--workers", "1", "--play-once", "--no-page", "--quiet",
                                        "--results", f"{folder}/t.db"], stdout=subprocess.DEVNULL)
            seen = set()
            while without and len(seen) < DEATHS and running.poll() is None:
                for each in servers_of(running.pid):
                    seen.add(each)
                    os.kill(each, signal.SIGKILL)
                time.sleep(0.001)
            if running.wait() != 0 or (without and len(seen) < DEATHS):
                sys.exit("the tournament failed")
            after = os.times()
            spent = after.children_user + after.children_system - before.children_user - before.children_system
            return spent / (2 * options.pairs)

    least = {True: float("inf"), False: float("inf")}
    for _ in range(options.rounds):
        for without in (True, False):
            least[without] = min(least[without], game(without))
    print(f"a game of {options.limit} s: {1e3 * least[True]:.1f} ms of processor time, {1e3 * least[False]:.1f} ms with "
          f"the fork server; {least[True] / least[False]:.2f} times as many games")


if __name__ == "__main__":
    main()
