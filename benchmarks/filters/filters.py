#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How a ball filter does on a recording at several image rates and losses, as the tables of docs/predictors.md.

    filters.py PROGRAM STUDY.yaml RECORDING.csv.gz [--referee FILE] [--set PATH=VALUE ...]

A cell: the filter's errors over those of decayed velocity, median and 90th percentile ("!": worse by more than 3 % and by
more than its 95 % interval), and the share of untouched balls inside the 95 % ellipses. The velocity of the baseline comes
from the last five images, and from no less than 0.15 s. Takes about ten seconds.
"""

import argparse
import concurrent.futures
import json
import subprocess
import sys

RATES = (10, 20, 30, 70)  # images a second; the recording has about 70
DROPS = (0.0, 0.3, 0.6)   # of which so many are lost
MOST = 1.03


def evaluation(arguments, rate, drop):
    every = 0.0 if rate == 70 else round(1.0 / rate, 4)
    window = max(0.15, round(5.0 / rate / (1.0 - drop), 3))
    command = [arguments.program, "evaluate-predictor", arguments.study, "--data", arguments.recording, "--quiet", "--json",
               "--set", f"observations={{every: {every}, drop: {drop}, seed: 1}}", "--set", f"baselines.window={window}"]
    if arguments.referee:
        command += ["--referee", arguments.referee]
    for each in arguments.set:
        command += ["--set", each]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stderr.strip())
    return json.loads(done.stdout)


def number(ratio):
    worse = ratio["value"] > MOST and ratio["interval"][0] > 1.0
    return f"{ratio['value']:.2f}{'!' if worse else ''}"


def cell(at):
    covered = at["covariance"].get("untouched_within_95")
    share = "-" if covered is None else f"{100 * covered:.0f} %"
    return f"{number(at['to_decayed']['median'])} / {number(at['to_decayed']['ninetieth_percentile'])}, {share}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("study")
    parser.add_argument("recording")
    parser.add_argument("--referee")
    parser.add_argument("--set", action="append", default=[])
    arguments = parser.parse_args()
    cells = [(rate, drop) for rate in RATES for drop in DROPS]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        found = list(pool.map(lambda each: evaluation(arguments, *each), cells))
    horizons = [at["seconds"] for at in found[0]["horizons"]]
    print("| images a second | lost |" + "".join(f" {each:g} s |" for each in horizons))
    print("|---|---|" + "---|" * len(horizons))
    for (rate, drop), evaluated in zip(cells, found):
        print(f"| {rate} | {100 * drop:.0f} % |" + "".join(f" {cell(at)} |" for at in evaluated["horizons"]))


if __name__ == "__main__":
    main()
