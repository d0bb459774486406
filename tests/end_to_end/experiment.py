# SPDX-License-Identifier: MIT
"""Experiments of short matches: arms of the tests' plugins that do not play the same."""

import csv
import io
import json

import tournament

EXPERIMENT = """\
experiment: trial
question: Does it matter where the striker stands?
arms:
  - {{name: at the ball, team: small.yaml}}
  - {{name: beside it, team: other.yaml}}
opponent: worse.yaml
matches: 4
seed: 3
limit: 12
set: {{rules.durations.ready: 3, rules.durations.set: 1}}
seeds: consecutive
{more}"""
PRIMARY = "primary: {measure: overlap_seconds}\n"


class Experiment(tournament.Tournament):
    def setUp(self):
        super().setUp()
        self.document(PRIMARY)

    def document(self, more="", changes=(), name="e.yaml"):
        text = EXPERIMENT.format(more=more)
        for what, instead in changes:
            self.assertIn(what, text)
            text = text.replace(what, instead)
        return self.write(name, text)

    def arguments(self, *more, file="e.yaml"):
        words = ["experiment", file]
        if not self.pages and "--no-page" not in more:
            words.append("--no-page")
        return [*words, *more]

    def long_table(self, file):
        with open(self.folder / file, newline="") as stream:
            return list(csv.DictReader(stream))

    def table_of(self, *more, file="trial.db"):
        return list(csv.DictReader(io.StringIO(self.succeed("report", file, "--csv", *more), newline="")))

    @staticmethod
    def measure(report, name):
        return next(each for each in report["measures"] if each["measure"] == name)

    def experiment(self, *more, **options):
        """The report of an experiment that must succeed without a word on standard error."""
        return json.loads(self.succeed(*self.arguments("--quiet", "--json", *more, **options)))
