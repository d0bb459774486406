# SPDX-License-Identifier: MIT
"""How well configs/teams/regista.yaml plays football: whole matches against every other shipped team, and against
spqr2023 over a radio that loses 30 % of the packets and with half of the packets. Each bar that is missed is told in a
line of its own, and makes the status 1. docs/metrics.md says what the numbers mean.

    football.py PROGRAM SOURCE FOLDER

    REGISTA_PAIRS   of matches against each opponent; default 100
    REGISTA_SEED    of the first pair; default 20281125

The results stay in FOLDER, and are gone on with where they ended. What a test or an interval says is the program's:
p is that of the signs of pairs, after Holm for all opponents, the interval Student's t over pairs.
"""

import csv
import io
import operator
import os
import pathlib
import sys
from dataclasses import dataclass
from typing import Callable, Optional

import results

TEAM = "regista"
OPPONENTS = ("spqr2023", "paper", "fixed_rate", "events_only", "formation", "scram")
RIVAL = "spqr2023"       # against whom goals count, and packets are scarce
BASELINE = "fixed_rate"  # whose striker overlap, in its matches against the team, that of the team is compared with
HARDER = {               # both teams play under these
    "30 % loss of the packets": ("lossy", "disturbance.radio.loss=0.3"),
    "half of the budget": ("half_budget", "rules.messages.budget=600"),
}
SECONDS_PER_HOUR = 3600


@dataclass(frozen=True)
class Bar:
    holds: Callable
    limit: float

    WORDS = {operator.lt: "below", operator.le: "at most", operator.ge: "at least", operator.gt: "above"}

    def missed(self, value):
        return value is None or not self.holds(value, self.limit)

    def text(self, form):
        return f"{self.WORDS[self.holds]} {form(self.limit)}"


@dataclass(frozen=True)
class Figure:
    """A number of both teams, or of the match alone."""
    name: str
    form: Callable
    own: Optional[float]
    other: Optional[float] = None
    bar: Optional[Bar] = None


def told(form, value):
    return "none" if value is None else form(value)


def percent(value):
    return f"{100 * value:.3g} %"


def plain(value):
    return f"{value:.3g}"


def signed(value):
    return f"{value:+.2f}"


def rows_of(table, team, other):
    """The matches of two teams that were played to their end."""
    return [row for row in csv.DictReader(io.StringIO(table, newline=""))
            if {row["home"], row["away"]} == {team, other} and row["in_play_seconds"]]


def values(rows, path, team=None):
    """Of a team or of the match: as many of the rows as have the number."""
    columns = [path if team is None else f"{'home' if row['home'] == team else 'away'}.{path}" for row in rows]
    return [float(row[column]) for row, column in zip(rows, columns) if row.get(column)]


def mean(numbers):
    return sum(numbers) / len(numbers) if numbers else None


def ratio(part, whole):
    return part / whole if whole else None


def share(rows, part, whole, team=None):
    """Of sums over all matches."""
    return ratio(sum(values(rows, part, team)), sum(values(rows, whole, team)))


def overlap_per_hour(rows, team):
    """Seconds in an hour of play; nothing for a team without such a role."""
    overlap = values(rows, "striker.overlap_seconds", team)
    return ratio(SECONDS_PER_HOUR * sum(overlap), sum(values(rows, "playing_seconds"))) if overlap else None


def of_play(rows, other, baseline_overlap):
    """What is measured in the matches against one opponent. baseline_overlap: per hour, of the baseline."""
    both = lambda measure, *more: (measure(rows, *more, TEAM), measure(rows, *more, other))  # noqa: E731
    average = lambda rows, path, team: mean(values(rows, path, team))  # noqa: E731
    overlap = overlap_per_hour(rows, TEAM)
    return [
        Figure("open play with a ball at rest that a robot could touch within 3 s", percent,
               share(rows, "ball_rest_seconds", "in_play_seconds"), bar=Bar(operator.le, 0.05)),
        Figure("rests of it that last over 15 s", percent, share(rows, "long_ball_rests", "ball_rests"),
               bar=Bar(operator.le, 0.01)),
        Figure("open play with five robots within 1 m of the ball", percent,
               share(rows, "ball_crowd_seconds", "in_play_seconds"), bar=Bar(operator.le, 0.03)),
        Figure("the nearest robot plays the ball", percent, *both(average, "nearest_plays_ball"), Bar(operator.ge, 0.9)),
        Figure("all robots in the same context", percent, *both(average, "context_agreement"), Bar(operator.ge, 0.95)),
        Figure("all robots compute the same assignment", percent, *both(average, "agreement")),
        Figure("meant passes a match", plain, *both(average, "meant_passes")),
        Figure("meant passes that arrive", percent, share(rows, "meant_passes_arrived", "meant_passes", TEAM),
               share(rows, "meant_passes_arrived", "meant_passes", other), Bar(operator.gt, 0.5)),
        Figure("striker overlap, s in an hour of play", plain, overlap, overlap_per_hour(rows, other)),
        Figure(f"the same, of {BASELINE} against {TEAM}", plain, baseline_overlap),
        Figure(f"striker overlap as a share of that of {BASELINE}", percent,
               None if overlap is None else ratio(overlap, baseline_overlap), bar=Bar(operator.le, 0.1)),
    ]


def of_score(pairing, other):
    """What the program found of a pairing."""
    goals = pairing.get("goals_per_match", {})
    difference = goals.get("mean")
    figures = [Figure("goals a match", plain, *(ratio(each, pairing["games"]) for each in pairing["goals"])),
               Figure("goal difference a match", signed, difference,
                      bar=Bar(operator.ge, 1.0) if other == RIVAL else None),
               Figure("p after Holm", plain, pairing.get("p_holm"), bar=Bar(operator.lt, 0.01)),
               Figure("share of the points", percent, ratio(pairing["points"], pairing["games"]),
                      bar=Bar(operator.gt, 0.5))]
    return figures


def record(pairing):
    lost, drawn, won = sum(pairing["pentanomial"][:2]), pairing["pentanomial"][2], sum(pairing["pentanomial"][3:])
    low_high = pairing.get("goals_per_match", {}).get("t_interval")
    interval = f"[{low_high[0]:+.2f}, {low_high[1]:+.2f}]" if low_high else "none, too few pairs"
    return [f"won, drawn, lost: pairs {won}, {drawn}, {lost}; matches {pairing['wins']}, {pairing['draws']}, "
            f"{pairing['losses']}; goals {pairing['goals'][0]} : {pairing['goals'][1]}",
            f"95 % interval of the goal difference a match: {interval}"]


def missed(figures, where):
    return [f"missed: {where}: {each.name}, {each.bar.text(each.form)}, {told(each.form, each.own)}"
            for each in figures if each.bar and each.bar.missed(each.own)]


def table_of(figures, other):
    lines = [("", TEAM, other, "bar")]
    for each in figures:
        # What belongs to the match alone stands under the team.
        lines.append((each.name, told(each.form, each.own), "" if each.other is None else each.form(each.other),
                      each.bar.text(each.form) if each.bar else ""))
    widths = [max(map(len, column)) for column in zip(*lines)]
    return ["  ".join([line[0].ljust(widths[0]), *(text.rjust(width) for text, width in zip(line[1:], widths[1:]))]).rstrip()
            for line in lines]


def unplayed(findings):
    """Matches that nobody may count: forfeits, and those that could not be played."""
    forfeits = [f"{each['team']} forfeited {each['matches']}: {each['plugin']}" for each in findings["forfeits"]]
    left_out = sum(pairing["unplayed_pairs"] for pairing in findings["pairings"])
    return forfeits + ([f"{left_out} pairs could not be played"] if left_out else [])


class Proof:
    def __init__(self, program, source, folder):
        self.program, self.source, self.folder = program, pathlib.Path(source), pathlib.Path(folder)
        self.pairs = int(os.environ.get("REGISTA_PAIRS") or "100")
        self.seed = int(os.environ.get("REGISTA_SEED") or "20281125")
        self.missed = []

    def play(self, name, opponents, *settings):
        """The team against each of them, or as far as that has been played before. The file of results."""
        file = self.folder / f"{name}_{self.pairs}_{self.seed}.db"
        words = ["--format", "gauntlet", "--pairs", self.pairs, "--seed", self.seed, "--seeds", "consecutive", "--workers", 2]
        for team in (TEAM, *opponents):
            words += ["--team", self.source / f"configs/teams/{team}.yaml"]
        for each in settings:
            words += ["--set", each]
        print(results.played(self.program, file, words), flush=True)
        self.missed += [f"missed: {name}: every match played to its end, all, {each}"
                        for each in unplayed(results.findings(self.program, file))]
        return file

    def against_all(self):
        file = self.play("football", OPPONENTS)
        table, findings = results.table(self.program, file), results.findings(self.program, file)
        baseline = overlap_per_hour(rows_of(table, TEAM, BASELINE), BASELINE)
        for other, pairing in zip(OPPONENTS, findings["pairings"], strict=True):
            assert pairing["teams"] == [TEAM, other], pairing["teams"]
            figures = of_score(pairing, other) + of_play(rows_of(table, TEAM, other), other, baseline)
            self.tell(f"{TEAM} against {other}", pairing, table_of(figures, other))
            self.missed += missed(figures, f"against {other}")

    def against_the_rival(self):
        for what, (name, setting) in HARDER.items():
            file = self.play(f"football_{name}", (RIVAL,), setting)
            pairing, = results.findings(self.program, file)["pairings"]
            self.tell(f"{TEAM} against {RIVAL}, {what} of both teams: {setting}", pairing, [
                f"goal difference a match: {told(signed, pairing.get('goals_per_match', {}).get('mean'))}"])

    @staticmethod
    def tell(title, pairing, lines):
        print("\n".join((title, *("  " + each for each in (*record(pairing), *lines)), "")), flush=True)


def main(program, source, folder):
    proof = Proof(program, source, folder)
    proof.folder.mkdir(parents=True, exist_ok=True)
    proof.against_all()
    proof.against_the_rival()
    print("\n".join(proof.missed) or "every bar holds")
    return 1 if proof.missed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
