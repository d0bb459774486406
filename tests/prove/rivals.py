# SPDX-License-Identifier: MIT
"""The published coordination systems against each other: the round robin of configs/studies/rivals.yaml, whole matches of
each against the paper's team, and what a decision costs. Prints the table of docs/rivals.md. A match that was not played
to its end is told in a line of its own, and so is a bar that is missed; each makes the status 1.

    rivals.py PROGRAM SOURCE FOLDER

    REGISTA_PAIRS   whole matches of each system against the paper's team, in pairs; default 10
    REGISTA_SEED    of the first of these; default 20290125

The results stay in FOLDER, and are gone on with where they ended.
"""

import csv
import io
import os
import pathlib
import re
import resource
import subprocess
import sys

import results

REFERENCE = "paper"      # whom the others are measured against
MOST_TIME = 1.5          # times a match of the reference
ROBOTS, DECISIONS_PER_SECOND = 14, 10
TIMED_SECONDS, TIMES = 300, 3


def rows_of(table, team):
    """Each match that the team played to its end, as the numbers of its side."""
    for row in csv.DictReader(io.StringIO(table, newline="")):
        for side in ("home", "away"):
            if row[side] == team and row["in_play_seconds"]:
                yield {key.removeprefix(f"{side}."): value for key, value in row.items()
                       if not key.startswith("away." if side == "home" else "home.")}


def total(rows, path):
    return sum(float(row[path]) for row in rows if row.get(path))


def mean(rows, path):
    numbers = [float(row[path]) for row in rows if row.get(path)]
    return sum(numbers) / len(numbers) if numbers else None


def processor_seconds(words):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class Proof:
    def __init__(self, program, source, folder):
        self.program, self.source, self.folder = program, pathlib.Path(source), pathlib.Path(folder)
        self.study = self.source / "configs" / "studies" / "rivals.yaml"
        self.files = [self.study.parent / name for name in re.findall(r"\{team: (\S+)\}", self.study.read_text())]
        self.pairs = int(os.environ.get("REGISTA_PAIRS") or "10")
        self.seed = int(os.environ.get("REGISTA_SEED") or "20290125")
        self.missed = []

    def name(self, file):
        return re.search(r"^team: (\w+)$", file.read_text(), re.MULTILINE)[1]

    def note_unplayed(self, findings, what):
        self.missed += [f"missed: {what}: {each['team']} forfeited {each['matches']}: {each['plugin']}"
                        for each in findings["forfeits"]]
        left_out = sum(pairing["unplayed_pairs"] for pairing in findings["pairings"])
        self.missed += [f"missed: {what}: {left_out} pairs could not be played"] if left_out else []

    def round_robin(self):
        file = self.folder / "rivals.db"
        print(results.played(self.program, file, [self.study]), flush=True)
        findings = results.findings(self.program, file)
        self.note_unplayed(findings, "the round robin")
        return findings

    def whole_matches(self):
        file = self.folder / f"rivals_whole_{self.pairs}_{self.seed}.db"
        reference = next(each for each in self.files if self.name(each) == REFERENCE)
        words = ["--format", "gauntlet", "--pairs", self.pairs, "--seed", self.seed, "--team", reference]
        for each in self.files:
            words += ["--team", each] if each != reference else []
        print(results.played(self.program, file, words), flush=True)
        findings = results.findings(self.program, file)
        self.note_unplayed(findings, "whole matches")
        return results.table(self.program, file)

    def costs(self):
        """Processor seconds of a match against itself, the least of several that were run in turn."""
        least = {}
        for _ in range(TIMES):
            for file in self.files:
                spent = processor_seconds([self.program, "match", file, file, "--seed", "1", "--limit", str(TIMED_SECONDS),
                                           "--quiet"])
                least[file] = min(spent, least.get(file, spent))
        return {self.name(file): seconds for file, seconds in least.items()}

    def run(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        findings = self.round_robin()
        whole = self.whole_matches()
        costs = self.costs()
        records = {name: [0, 0, 0] for name in costs}
        for pairing in findings["pairings"]:
            games = [pairing["wins"], pairing["draws"], pairing["losses"]]
            for team, counts in zip(pairing["teams"], (games, games[::-1])):
                records[team] = [a + b for a, b in zip(records[team], counts)]
        print("\n| | team | Elo | won, drawn, lost | overlap | uncovered | agreement | packets | bytes | of segments | µs | time |")
        print("|---" * 12 + "|")
        for place, each in enumerate(findings["ranking"], 1):
            team = each["team"]
            rows = list(rows_of(whole, team))
            packets, decisions = total(rows, "packets"), ROBOTS * DECISIONS_PER_SECOND * TIMED_SECONDS
            slower = costs[team] / costs[REFERENCE]
            if slower > MOST_TIME:
                self.missed.append(f"missed: {team}: a match at most {MOST_TIME} times that of {REFERENCE}, {slower:.2f}")
            low, high = each["elo_interval"]
            interval = "" if low is None or high is None else f" ({low:.0f} to {high:.0f})"
            print(f"| {place} | `{team}` | {each['elo']:.0f}{interval} | {', '.join(map(str, records[team]))} | "
                  f"{mean(rows, 'rates.overlap_seconds_per_minute'):.1f} | "
                  f"{mean(rows, 'rates.uncovered_seconds_per_minute'):.0f} | {100 * mean(rows, 'agreement'):.0f} % | "
                  f"{mean(rows, 'packets'):.0f} | {total(rows, 'packet_bytes') / packets:.0f} | "
                  f"{total(rows, 'segment_bytes') / packets:.1f} | {1e6 * costs[team] / decisions:.1f} | {slower:.2f} |")
        print("\n".join(self.missed) or "every bar holds")
        return 1 if self.missed else 0


if __name__ == "__main__":
    sys.exit(Proof(*sys.argv[1:]).run())
