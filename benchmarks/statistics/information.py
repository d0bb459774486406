#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Scenes or whole matches: which of them finds out for less processor time that one team is better. docs/openings.md has
the table that this prints, and what follows from it.

    information.py REGISTA FOLDER [--rounds N]

A difference of standardised size d = mean/sd (of a pair's goal difference, the mean of its two matches) is found after a
number of pairs that goes with 1/d^2. So d^2 over the processor seconds of a pair is what a second tells. d^2 is less its
bias: of n pairs, E[d_hat^2] is about (n-1)/(n-3) (d^2 + 1/n). Every form has seeds of its own. A pairing counts if any
form finds its difference at p < .01 by exact sign flips; pairings are played in the order of their list until eleven count.

A round is 10 pairs of whole matches, and in the first three also 43 pairs of each length of scenes: each shipped scene
once. What is played stays in FOLDER, and is gone on with. All four take an hour of one core; --rounds 1 is a quick look."""

import argparse
import json
import math
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "prove"))

from pairs import goal_differences, sign_flip_p  # noqa: E402

PAIRINGS = (  # chosen by docs/team-results.md and docs/rivals.md: large and small differences of shipped and league teams
    ("regista", "paper"),
    ("regista", "spqr2023"),
    ("fixed_rate", "scram"),
    ("spqr2023", "paper"),
    ("regista", "events_only"),
    ("events_only", "formation"),
    ("paper", "league/nao_devils"),
    ("league/b_human", "league/cs_freiburg"),
    ("league/hulks", "league/helios_scram"),
    ("league/context_based", "league/distributed_auction"),
    ("league/static_partition", "league/scram_vote"),
    ("league/b_human", "league/static_partition"),
)
SCENES = ["--openings", ROOT / "configs/openings", "--limit"]
FORMS = {  # what is played, pairs of a round, rounds, first seed
    "scenes of 30 s": ([*SCENES, 30], 43, 3, 20310000),
    "scenes of 60 s": ([*SCENES, 60], 43, 3, 20320000),
    "scenes of 120 s": ([*SCENES, 120], 43, 3, 20330000),
    "whole matches": ([], 10, 4, 20340000),
}
SEEDS_OF_A_ROUND = 1000  # pair k of a study has its seed plus k - 1
LEVEL = 0.01
ENOUGH = 11              # pairings that count
FEWEST_PAIRS = 6         # below them sign flips cannot reach 5 %
FOUND_BY_80 = 7.85       # (1.96 + 0.84)^2: d^2 times this number of pairs is found at 5 % in 80 of 100 cases


def short(pairing):
    return "-".join(pathlib.PurePath(team).name for team in pairing)


def played(program, folder, pairing, form, number):
    """One round of a pairing: the goal differences of its pairs and the processor time, or as it was played before."""
    words, pairs, _, seed = FORMS[form]
    stored = folder / f"{short(pairing)}_{form.replace(' ', '_')}_{number}.json"
    if stored.exists():
        return json.loads(stored.read_text())
    for team in pairing:
        words = [*words, "--team", ROOT / f"configs/teams/{team}.yaml"]
    with tempfile.TemporaryDirectory() as temporary:
        results = f"{temporary}/played.db"
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([program, "tournament", *map(str, words), "--pairs", str(pairs), "--seed",
                        str(seed + number * SEEDS_OF_A_ROUND), "--workers", "1", "--play-once", "--no-page", "--quiet",
                        "--results", results], check=True, stdout=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        table = subprocess.run([program, "report", results, "--csv"], check=True, stdout=subprocess.PIPE, text=True).stdout
    differences = goal_differences(table, pathlib.PurePath(pairing[0]).name)
    if len(differences) != pairs:
        sys.exit(f"{short(pairing)}, {form}: {pairs - len(differences)} pairs were not played")
    round_of = {"differences": differences,
                "seconds": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime}
    unfinished = stored.with_suffix(".part")
    unfinished.write_text(json.dumps(round_of))
    unfinished.rename(stored)
    return round_of


class Measured:
    """What the rounds of one pairing in one form say."""

    def __init__(self, rounds):
        differences = [each for played_round in rounds for each in played_round["differences"]]
        self.pairs = n = len(differences)
        self.seconds = sum(each["seconds"] for each in rounds) / n
        self.mean, self.sd = statistics.mean(differences) / 2, statistics.stdev(differences) / 2
        self.p = sign_flip_p(differences)
        d_hat = self.mean / self.sd if self.sd else 0
        self.d = d_hat
        self.d_error = math.sqrt(1 / n + d_hat**2 / (2 * n))
        self.d_squared = (n - 3) / (n - 1) * d_hat**2 - 1 / n
        self.information = self.d_squared / self.seconds

    def seconds_to_find(self):
        if self.d_squared <= 0:
            return math.inf
        return max(FOUND_BY_80 / self.d_squared, FEWEST_PAIRS) * self.seconds

    def line(self):
        seconds = self.seconds_to_find()
        return (f"| {self.pairs} | {self.mean:+.3f} | {self.sd:.3f} | {self.d:.2f} +- {self.d_error:.2f} | {self.d_squared:.3f} "
                f"| {self.seconds:.2f} | {self.information:.3f} | {'-' if math.isinf(seconds) else f'{seconds:.0f}'} "
                f"| {self.p:.2g} |")


def counts(forms):
    return any(each.p < LEVEL for each in forms.values())


def table_of(measured):
    print("| pairing | form | pairs | mean | sd | d | d^2 less bias | s a pair | d^2 a second | s to find it | p |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for pairing, forms in measured.items():
        for form, each in forms.items():
            print(f"| {short(pairing)} | {form} {each.line()}")
    counted = {pairing: forms for pairing, forms in measured.items() if counts(forms)}
    if not counted:
        return
    print(f"\n{len(counted)} of {len(measured)} pairings count: one form at least finds their difference at p < {LEVEL}.")
    for form in FORMS:
        worst = min(counted, key=lambda pairing: counted[pairing][form].information)
        first = sum(max(forms, key=lambda each: forms[each].information) == form for forms in counted.values())
        print(f"{form}: the most informative in {first}, finds {sum(forms[form].p < LEVEL for forms in counted.values())}; "
              f"worst {short(worst)}, {counted[worst][form].information:.3f} a second")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=max(rounds for _, _, rounds, _ in FORMS.values()))
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    measured = {}
    for pairing in PAIRINGS:
        measured[pairing] = {form: Measured([played(options.regista, options.folder, pairing, form, number)
                                             for number in range(min(rounds, options.rounds))])
                             for form, (_, _, rounds, _) in FORMS.items()}
        print(f"{short(pairing)} {'counts' if counts(measured[pairing]) else 'does not count'}", file=sys.stderr, flush=True)
        if sum(map(counts, measured.values())) == ENOUGH:
            break
    table_of(measured)


if __name__ == "__main__":
    main()
