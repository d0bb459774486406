# SPDX-License-Identifier: MIT
"""Tournaments of short matches: two teams of the tests' plugins that do not play the same."""

import contextlib
import json
import os
import pathlib
import sqlite3
import time

import program

# Matches of a few simulated seconds, with the ball in play and goals possible.
SHORT = ("--limit", "12", *program.PLAY_SOON)


class Tournament(program.Case):
    def setUp(self):
        super().setUp()
        other = program.TEAM.format(name="other").replace("shift: [-1, 0]", "shift: [-2, 1]")
        self.write("other.yaml", other)

    def arguments(self, *more, teams=("small.yaml", "other.yaml"), pairs=3):
        words = ["tournament"]
        for team in teams:
            words += ["--team", team]
        return [*words, "--pairs", pairs, *SHORT, *more]

    def play(self, *more, **options):
        """The report of a tournament that must succeed without a word on standard error."""
        return self.succeed(*self.arguments("--quiet", *more, **options))

    def report(self, *more, **options):
        return json.loads(self.play("--json", *more, **options))

    def rows(self, file="tournament.db"):
        """Every match that is stored, in an order of its own, without what changes from run to run."""
        with contextlib.closing(sqlite3.connect(self.folder / file)) as database:
            return database.execute("SELECT key, seed, home_goals, away_goals, ended, hash, matches.metrics, failure "
                                    "FROM matches JOIN fixtures ON fixture = id ORDER BY key, seed").fetchall()

    def stored(self, query, file="tournament.db"):
        with contextlib.closing(sqlite3.connect(self.folder / file)) as database:
            return database.execute(query).fetchall()

    def workers(self):
        """Processes that play a match for this installation of the program."""
        found = []
        for folder in pathlib.Path("/proc").iterdir():
            if not folder.name.isdigit():
                continue
            try:
                mine = os.readlink(folder / "exe") == str(self.program)
                if mine and (folder / "cmdline").read_bytes().split(b"\0")[1] == b"play-one":
                    found.append(int(folder.name))
            except (OSError, IndexError):
                pass  # it is gone, or another user's
        return found

    def wait_for(self, condition, seconds=20):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, "waited in vain")
            time.sleep(0.01)
