#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Search algorithms beside each other on a tuning of your own: each searches several times with other seeds and an
equal budget, and what each run came to plays the base team's opponents on seeds that none of them has seen. It is
judged by the goal difference, whatever the tuning's objective is.

    benchmarks/tuning/compare_searches.py build/release/bin/regista TUNING.yaml spsa random_search --repeats 3 \\
        --matches 60 --pairs 20

Prints the median and the quartiles of the differences from the base team, over the runs of each algorithm, by the
opponents' weights. Nothing is tested: it says how these runs went.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile

MOST_RUNS = 31
HELD_OUT = 1_000_000_000  # first seed of the matches that judge; searches begin at small ones


def regista(program, *words):
    done = subprocess.run([program, *map(str, words), "--quiet", "--no-page", "--json"], check=True,
                          stdout=subprocess.PIPE, text=True)
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("tuning")
    parser.add_argument("algorithms", nargs="+")
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--matches", type=int, default=400, help="of each search")
    parser.add_argument("--pairs", type=int, default=50, help="that judge each run, against each opponent")
    asked = parser.parse_args()
    if asked.repeats * len(asked.algorithms) > MOST_RUNS:
        parser.error(f"at most {MOST_RUNS} runs, as an experiment has 32 arms")
    program = str(pathlib.Path(asked.program).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        arms, document = {}, None
        for algorithm in asked.algorithms:
            for repeat in range(1, asked.repeats + 1):
                run = f"{algorithm} {repeat}"
                results = folder / f"{algorithm}_{repeat}.db"
                report = regista(program, "tune", asked.tuning, "--results", results, "--matches", asked.matches,
                                 "--seed", repeat, "--set", f"search.algorithm={algorithm}", "--set",
                                 "slices.points=0")
                document = report["played"]["document"]
                base = str(pathlib.Path.cwd() / document["team"])  # what nothing was found better than
                arms[run] = {"name": run, "team": report["tuned_file"] or base}
        here = pathlib.Path.cwd()
        absolute = {key: str(here / document[key]) for key in ("rules", "robot", "disturbance", "opponent_disturbance")
                    if key in document}
        experiment = {
            "arms": [{"name": "base", "team": str(here / document["team"])}, *arms.values()],
            "matches": 2 * asked.pairs, "seed": HELD_OUT, "measures": ["goal_difference"],
            "primary": {"measure": "goal_difference", "compare": [[run, "base"] for run in arms]}, **absolute,
            **{key: document[key] for key in ("limit", "limits", "set", "allow_shared_memory")
                          if key in document},
            **({"openings": [str(here / each) for each in document["openings"]]} if "openings" in document else {}),
        }
        differences = dict.fromkeys(arms, 0.0)
        weights = sum(each["weight"] for each in document["opponents"])
        for number, opponent in enumerate(document["opponents"]):
            page = folder / f"judge_{number}.yaml"
            page.write_text(json.dumps({"experiment": f"judge_{number}", "opponent": str(here / opponent["team"]),
                                        **experiment}))
            report = regista(program, "experiment", page, "--results", page.with_suffix(".db"))
            for each in report["primary"]["comparisons"]:
                differences[each["first"]["arm"]] += opponent["weight"] / weights * (each["mean"] or 0.0)
    print("| algorithm | median | quartiles | better than the base team |\n|---|---|---|---|")
    for algorithm in asked.algorithms:
        values = [differences[f"{algorithm} {repeat}"] for repeat in range(1, asked.repeats + 1)]
        low, _, high = statistics.quantiles(values, n=4, method="inclusive") if len(values) > 1 else values * 3
        print(f"| {algorithm} | {statistics.median(values):+.3f} | {low:+.3f} to {high:+.3f} | "
              f"{sum(value > 0 for value in values)} of {len(values)} |")


if __name__ == "__main__":
    main()
