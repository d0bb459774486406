# SPDX-License-Identifier: MIT
"""Pairs of matches of two teams, and the exact sign flips of their goal differences. It shares no code with the program,
so that it can say whether the program's own verdicts are right."""

import collections
import csv
import io


def goal_differences(table, team):
    """Of each pair, summed over its two matches, from the team's side. table: the CSV of `regista report`."""
    of_pair = collections.defaultdict(list)
    for row in csv.DictReader(io.StringIO(table, newline="")):
        ahead = int(row["home_goals"]) - int(row["away_goals"])
        of_pair[int(row["pair"])].append(ahead if row["home"] == team else -ahead)
    return [sum(matches) for _, matches in sorted(of_pair.items()) if len(matches) == 2]


def sign_flip_p(differences):
    """The share of all signs of these whole numbers whose sum is at least as far from zero, by convolution."""
    ways = {0: 1}
    for each in filter(None, differences):
        more = collections.Counter()
        for total, count in ways.items():
            more[total + each] += count
            more[total - each] += count
        ways = more
    seen = abs(sum(differences))
    return sum(count for total, count in ways.items() if abs(total) >= seen) / sum(ways.values())
