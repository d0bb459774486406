# SPDX-License-Identifier: MIT
"""Real matches of two teams whose labels are exchanged by a coin in each pair: every test of the program may then
reject in 5 % of the tournaments at most. The matches are played by the program, the coin and the tests are those of
label_exchange.

    labels.py PROGRAM LABEL_EXCHANGE SOURCE FOLDER

    REGISTA_TOURNAMENTS   of 50 pairs; default 200
    REGISTA_SEED          of the coin; default 1

The results stay in FOLDER, and are gone on with where they ended.
"""

import contextlib
import csv
import io
import json
import os
import pathlib
import sqlite3
import subprocess
import sys

PAIRS = 50          # of a tournament
SECONDS = 30        # of a match
MOST_GOALS = 1      # in so many seconds: after a goal the robots walk back for longer
METRIC = "overlap_seconds"  # summed over the roles of a team
TEAMS = ("paper", "fixed_rate")


def main(program, label_exchange, source, folder):
    source, folder = pathlib.Path(source), pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    tournaments = int(os.environ.get("REGISTA_TOURNAMENTS", "200"))
    results = folder / f"labels_{tournaments}.db"
    words = [program, "tournament", "--openings", source / "configs/openings", "--limit", SECONDS, "--pairs",
             tournaments * PAIRS, "--results", results, "--no-page", "--quiet"]
    for team in TEAMS:
        words += ["--team", source / f"configs/teams/{team}.yaml"]
    if results.exists():
        words.append("--resume")
    print(subprocess.run([str(word) for word in words], check=True, stdout=subprocess.PIPE, text=True).stdout)
    table = with_metric(subprocess.run([program, "report", str(results), "--csv"], check=True, stdout=subprocess.PIPE,
                                       text=True).stdout, results)
    judged = subprocess.run([label_exchange, str(PAIRS), str(MOST_GOALS), os.environ.get("REGISTA_SEED", "1")],
                            input=table, text=True)
    return judged.returncode


def with_metric(table, results):
    """The goals of each match, and the metric of both teams."""
    with contextlib.closing(sqlite3.connect(results)) as database:
        metrics = dict(database.execute("SELECT row, json FROM metrics"))
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["home_goals", "away_goals", "home_metric", "away_metric"])
    for row in csv.DictReader(io.StringIO(table, newline="")):
        sides = json.loads(metrics[int(row["row"])])["roles"]
        writer.writerow([row["home_goals"], row["away_goals"],
                         *(sum(role[METRIC] for role in side.values()) for side in sides)])
    return out.getvalue()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
