# SPDX-License-Identifier: MIT
"""Tournaments of short matches: teams of the tests' plugins that do not play the same, from scenes in which goals
fall."""

import contextlib
import csv
import io
import json
import os
import pathlib
import sqlite3
import subprocess
import time

import program
import results_file

# The home team before an empty goal, the away team's robots too far away to help.
SCENE = """\
opening: {name}
length: 10
ball: {{at: [3, {y}]}}
home: [{{at: [-4.2, 0.2]}}, {{at: [2.7, {y}]}}, {{at: [-1, 1.5]}}, {{at: [-1, -1.5]}}, {{at: [-3, 1]}},
       {{at: [-3, -1]}}, {{at: [-2, 2]}}]
away: [{{at: [1.2, -2.2]}}, {{at: [0.5, -1]}}, {{at: [1, 2.5]}}, {{at: [1, -2.9]}}, {{at: [2, 1.8]}},
       {{at: [2, -1.8]}}, {{at: [2, 2.5]}}]
"""
SHORT = ("--openings", "scenes")


class Tournament(program.Case):
    """small.yaml scores in most matches in which it is at home, other.yaml in as many but not in the same, worse.yaml
    never."""

    pages = False  # whether tournaments write theirs, which takes longer than a few short matches

    def setUp(self):
        super().setUp()
        striker = "target: {at: ball}"
        for name, instead in (("other", "target: {at: ball, shift: [-0.15, 0]}"), ("worse", "target: {at: own_goal}")):
            text = program.TEAM.format(name=name)
            self.assertIn(striker, text)
            self.write(f"{name}.yaml", text.replace(striker, instead))
        for name, y in (("left", 0.2), ("right", -0.2)):
            self.write(f"scenes/{name}.yaml", SCENE.format(name=name, y=y))

    def with_context(self, plugin, name="bad"):
        """NAME.yaml, a team that asks this plugin for its context."""
        text = program.TEAM.format(name=name)
        self.assertIn("plugin: ball_seen", text)
        self.write(f"{name}.yaml", text.replace("plugin: ball_seen", f"plugin: {plugin}"))

    def arguments(self, *more, teams=("small.yaml", "other.yaml"), pairs=3):
        words = ["tournament"]
        for team in teams:
            words += ["--team", team]
        if not self.pages and "--no-page" not in more:
            words.append("--no-page")
        return [*words, "--pairs", pairs, "--seeds", "consecutive", *SHORT, *more]

    def play(self, *more, **options):
        """The report of a tournament that must succeed without a word on standard error."""
        return self.succeed(*self.arguments("--quiet", *more, **options))

    def report(self, *more, **options):
        return json.loads(self.play("--json", *more, **options))

    def only(self, *more, **options):
        """The report, with what it says of its only pairing beside the rest."""
        report = self.report(*more, **options)
        self.assertEqual(len(report["pairings"]), 1)
        return {**report["pairings"][0], **report}

    def rows(self, file="tournament.db"):
        """Every match that is stored, without what changes from run to run."""
        return self.stored("SELECT row, key, seed, home_goals, away_goals, ended, hash, failure, "
                           "metric_names.names, numbers FROM matches JOIN fixtures ON fixture = fixtures.id "
                           "LEFT JOIN metrics USING(row) LEFT JOIN metric_names ON metric_names.id = metrics.names "
                           "ORDER BY row", file)

    def stored(self, query, file="tournament.db"):
        with contextlib.closing(sqlite3.connect(self.folder / file)) as database:
            return database.execute(query).fetchall()

    def metrics(self, file="tournament.db"):
        """By row."""
        with contextlib.closing(sqlite3.connect(self.folder / file)) as database:
            return results_file.metrics(database)

    def change(self, statement, file="tournament.db", mend=True):
        """mend: checksums fit afterwards, as if the program had written it so."""
        with contextlib.closing(sqlite3.connect(self.folder / file)) as database, database:
            database.execute(statement)
            if mend:
                results_file.mend(database)

    def table(self, *more, file="tournament.db"):
        """Rows of `regista report --csv`, by the names of the columns."""
        return list(csv.DictReader(io.StringIO(self.succeed("report", file, "--csv", *more), newline="")))

    def kill_when(self, condition, *arguments):
        """A tournament that is killed when the condition holds."""
        with self.start(*arguments, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            self.wait_for(condition)
            process.kill()
        self.assertEqual(process.returncode, -9, "ended before it was killed")
        self.wait_for(lambda: not self.workers())

    def count(self, file="tournament.db"):
        """Rows that there are now, whoever writes at the moment."""
        if not (self.folder / file).exists():
            return 0
        try:
            return self.stored("SELECT count(*) FROM matches", file)[0][0]
        except sqlite3.OperationalError:
            return 0  # no tables yet

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

    def wait_for(self, condition, seconds=program.PATIENCE):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, "waited in vain")
            time.sleep(0.01)
