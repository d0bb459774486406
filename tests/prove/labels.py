# SPDX-License-Identifier: MIT
"""Real matches of two teams whose labels are exchanged by a coin in each pair: every test of the program may then
reject in 5 % of the tournaments at most. The matches are played by the program, the coin and the tests are those of
label_exchange. One coin says little of a rate so small, so the coin is thrown anew many times for the same matches.
A test of exactly 5 % rejects more than 5 % of the throws every second time, so each count may exceed it by chance: by
as much as a binomial count exceeds its mean once in a hundred times (the rule of label_exchange for a single coin).

    labels.py PROGRAM LABEL_EXCHANGE SOURCE FOLDER

    REGISTA_TOURNAMENTS   of 50 pairs; default 200
    REGISTA_SEED          first seed of the coin; default 1
    REGISTA_MATCH_SEED    seed of the first pair of matches; default 1

The results stay in FOLDER, and are gone on with where they ended.
"""

import collections
import csv
import io
import math
import os
import pathlib
import re
import subprocess
import sys

import results

PAIRS = 50          # of a tournament
SECONDS = 30        # of a match
COINS = 50          # seeds of the coin, for the same matches
LEVEL = 0.05        # of each test
BY_CHANCE = 2.326   # standard deviations: the 99 % quantile of a normal distribution
MOST_GOALS = 1      # in so many seconds: after a goal the robots walk back for longer
METRIC = "overlap_seconds"  # summed over the roles of a team
TEAMS = ("paper", "fixed_rate")


def main(program, label_exchange, source, folder):
    source, folder = pathlib.Path(source), pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    tournaments = int(os.environ.get("REGISTA_TOURNAMENTS", "200"))
    match_seed = os.environ.get("REGISTA_MATCH_SEED", "1")
    file = folder / f"labels_{tournaments}_{match_seed}.db"
    words = ["--openings", source / "configs/openings", "--limit", SECONDS, "--pairs", tournaments * PAIRS, "--seed",
             match_seed, "--seeds", "consecutive"]
    for team in TEAMS:
        words += ["--team", source / f"configs/teams/{team}.yaml"]
    print(results.played(program, file, words))
    table = with_metric(results.table(program, file))
    return judge([label_exchange, str(PAIRS), str(MOST_GOALS)], table, int(os.environ.get("REGISTA_SEED", "1")))


def judge(label_exchange, table, first):
    """Throws the coins of many seeds for the same matches: the rate of a test is that over all of them."""
    rejections, tournaments = collections.Counter(), 0
    for seed in range(first, first + COINS):
        judged = subprocess.run([*label_exchange, str(seed)], input=table, stdout=subprocess.PIPE, text=True)
        if judged.returncode not in (0, 1):
            sys.exit(f"label_exchange failed with status {judged.returncode}")
        if seed == first:
            print(judged.stdout)
        lines = re.findall(r"^  (\S.*?) +(\d+) of (\d+) ", judged.stdout, re.MULTILINE)
        assert lines, judged.stdout
        for name, of, all_of in lines:
            rejections[name] += int(of)
        tournaments += int(all_of)
    print(f"the coins of {COINS} seeds, {tournaments} tournaments of {PAIRS} pairs:")
    for name, count in rejections.items():
        print(f"  {name:38} {count:5} of {tournaments} {100 * count / tournaments:5.2f} %")
    most = LEVEL * tournaments + BY_CHANCE * math.sqrt(tournaments * LEVEL * (1 - LEVEL))
    print(f"  at most {most:.0f} of {tournaments}: 5 %, and what chance adds once in a hundred times")
    return 0 if max(rejections.values()) <= most else 1


def with_metric(table):
    """The goals of each match, and the metric of both teams."""
    rows = csv.DictReader(io.StringIO(table, newline=""))
    of_side = {side: [name for name in rows.fieldnames if name.startswith(side + ".") and name.endswith("." + METRIC)]
               for side in ("home", "away")}
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["home_goals", "away_goals", "home_metric", "away_metric"])
    for row in rows:
        writer.writerow([row["home_goals"], row["away_goals"],
                         *(sum(float(row[name] or 0) for name in names) for names in of_side.values())])
    return out.getvalue()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
