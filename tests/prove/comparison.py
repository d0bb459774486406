# SPDX-License-Identifier: MIT
"""The quick comparison of README.md finds large differences, and finds none where there is none. It is played with ten
seeds for each of two pairings whose difference is known, and has to decide every time. Then the two teams exchange their
labels by a coin in each pair, three times for each of these comparisons: a difference that is found now is an error. What
decides is p of the exact sign flips of the pairs' goal differences, worked out here and not by the program.

    comparison.py PROGRAM SOURCE FOLDER

    REGISTA_SEED         of the coin; default 1
    REGISTA_MATCH_SEED   of the first comparison, the next ones are 1000 apart; default 20350000

The results stay in FOLDER, and are gone on with where they ended."""

import os
import pathlib
import random
import re
import resource
import sys

import results
from pairs import goal_differences, sign_flip_p

PAIRINGS = (("regista", "paper"), ("fixed_rate", "scram"))  # the first team is the stronger one
SEEDS = 10          # of each
APART = 1000        # so that no two comparisons share a match
COINS = 3           # for each comparison
LEVEL = 0.05
MOST_ERRORS = 6     # of 60; a test that errs in 5 % makes more in 3 of 100 cases
MOST_SECONDS = 120  # of processor time, which depends on the machine and is only reported


def words_of(readme):
    """What the command of README.md says behind its two teams."""
    return re.search(r"^regista tournament (?:--team \S+ ){2}(.*)$", readme.read_text(), re.MULTILINE)[1].split()


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def differences(program, source, folder, teams, words, seed):
    """Of the pairs of one comparison, and the processor time that it took now."""
    file = folder / f"{'_'.join(teams)}_{seed}.db"
    paths = [word for team in teams for word in ("--team", source / f"configs/teams/{team}.yaml")]
    before = processor_seconds()
    results.played(program, file, [*paths, *words, "--seed", seed])
    seconds = processor_seconds() - before
    return goal_differences(results.told(program, file, "--csv"), teams[0]), seconds


def main(program, source, folder):
    source, folder = pathlib.Path(source), pathlib.Path(folder) / "comparison"
    folder.mkdir(parents=True, exist_ok=True)
    first = int(os.environ.get("REGISTA_MATCH_SEED", "20350000"))
    words = words_of(source / "README.md")
    played, most_seconds, holds = [], 0, True
    for number, teams in enumerate(PAIRINGS):
        decided = 0
        for seed in range(first + number * SEEDS * APART, first + (number + 1) * SEEDS * APART, APART):
            of_pairs, seconds = differences(program, source, folder, teams, words, seed)
            played.append(of_pairs)
            most_seconds = max(most_seconds, seconds)
            p = sign_flip_p(of_pairs)
            decided += p < LEVEL and sum(of_pairs) > 0
            print(f"{teams[0]} against {teams[1]}, seed {seed}: {len(of_pairs)} pairs, "
                  f"{sum(of_pairs) / 2 / len(of_pairs):+.2f} goals a match, p {p:.2g}, {seconds:.0f} s", flush=True)
        print(f"{teams[0]} against {teams[1]}: decided with {decided} of {SEEDS} seeds")
        holds = holds and decided == SEEDS

    coin = random.Random(int(os.environ.get("REGISTA_SEED", "1")))
    errors = sum(sign_flip_p([coin.choice((-1, 1)) * each for each in of_pairs]) < LEVEL
                 for of_pairs in played for _ in range(COINS))
    print(f"labels by a coin: a difference is found in {errors} of {COINS * len(played)} comparisons; at most {MOST_ERRORS}")
    print(f"`{' '.join(words)}` took at most {most_seconds:.0f} s of processor time; at most {MOST_SECONDS}")
    return 0 if holds and errors <= MOST_ERRORS else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
