# SPDX-License-Identifier: MIT
"""The published coordination systems against each other: the round robin of configs/studies/rivals.yaml, whole matches of
each against the paper's team, what the assigner's call and a match cost, and the rehearsal of those that negotiate with
the parameters of their teams. Prints the table of docs/rivals.md: the Elo is that of the round robin, all else that of
the whole matches. A match that was not played to its end is told in a line of its own, and so is a bar that is missed;
each makes the status 1.

    rivals.py PROGRAM SOURCE FOLDER

    REGISTA_PAIRS   whole matches of each system against the paper's team, in pairs; default 10
    REGISTA_SEED    of the first of these; default 20290125

The results stay in FOLDER, and are gone on with where they ended.
"""

import csv
import io
import json
import os
import pathlib
import re
import resource
import subprocess
import sys

import results
import yaml

REFERENCE = "paper"      # whom the others are measured against
MOST_TIME = 1.5          # times a match of the reference
MOST_CALL = 10.0         # us that half of the calls of an assigner that negotiates take at most
TIMED_SECONDS, TIMES = 300, 3
REHEARSALS = (0, 1, 2)   # seeds


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
        self.files = [(self.study.parent / each["team"]).resolve() for each in
                      yaml.safe_load(self.study.read_text())["teams"]]
        self.teams = {file: yaml.safe_load(self.told("config", "show", file)) for file in self.files}
        self.plugins = {each["id"]: each for each in json.loads(self.told("plugin", "list", "--json"))["plugins"]}
        self.pairs = int(os.environ.get("REGISTA_PAIRS") or "10")
        self.seed = int(os.environ.get("REGISTA_SEED") or "20290125")
        self.missed = []

    def told(self, *words):
        return subprocess.run([self.program, *map(str, words)], check=True, stdout=subprocess.PIPE, text=True).stdout

    def name(self, file):
        return self.teams[file]["team"]

    def assigner_check(self, file, *words):
        """The only check that the words leave, of a team's assigner with its parameters."""
        use = self.teams[file]["assigner"]
        plugin = self.plugins[use["plugin"]]
        settings = []
        for key, value in (use.get("params") or {}).items():
            if value is not None and not isinstance(value, (dict, list)):
                settings += ["--set", f"{key}={str(value).lower() if isinstance(value, bool) else value}"]
        done = subprocess.run([self.program, "plugin", "check", plugin["file"], "--plugin", use["plugin"], "--json", *settings,
                               *map(str, words)], stdout=subprocess.PIPE, text=True, check=False)
        check = next(each for each in json.loads(done.stdout)[0]["checks"] if each["check"].startswith("assigner."))
        return check["status"], check["lines"]

    def call(self, file):
        """us within which half of the calls of the assigner are, and 99 %."""
        return tuple(map(float, re.search(r"half of the calls within ([\d.]+) us, 99 % within ([\d.]+) us",
                                          self.assigner_check(file, "--only", "cost")[1][0]).groups()))

    def rehearse(self, file):
        use = self.teams[file]["assigner"]
        if not self.plugins[use["plugin"]]["negotiates"]:
            return
        # Who bids for several tasks leaves robots without one.
        idle = ["--may-idle"] if (use.get("params") or {}).get("bundle", 1) > 1 else []
        for seed in REHEARSALS:
            status, lines = self.assigner_check(file, "--only", "rehearsal", "--seed", seed, *idle)
            if status != "pass":
                self.missed.append(f"missed: {self.name(file)}: rehearsal with seed {seed}: {lines[0]}")

    def note_unplayed(self, findings, what):
        self.missed += [f"missed: {what}: {each['team']} was set aside" for each in findings["set_aside"]]
        if findings["not_reproducible"]["matches"]:
            self.missed.append(f"missed: {what}: {findings['not_reproducible']['matches']} matches are not reproducible")
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
        words = ["--format", "gauntlet", "--pairs", self.pairs, "--seed", self.seed, "--seeds", "consecutive", "--team", reference]
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
        form = lambda value, spec: "-" if value is None else format(value, spec)  # noqa: E731
        print("\n| | team | Elo | won, drawn, lost | overlap | uncovered | agreement | nearest | packets | bytes | of segments | call, µs "
              "| match |")
        print("|---" * 13 + "|")
        for place, each in enumerate(findings["ranking"], 1):
            team = each["team"]
            file = next(file for file in self.files if self.name(file) == team)
            rows, (half, most), slower = list(rows_of(whole, team)), self.call(file), costs[team] / costs[REFERENCE]
            packets = total(rows, "packets")
            negotiates = self.plugins[self.teams[file]["assigner"]["plugin"]]["negotiates"]
            if slower > MOST_TIME:
                self.missed.append(f"missed: {team}: a match at most {MOST_TIME} times that of {REFERENCE}, {slower:.2f}")
            if negotiates and half > MOST_CALL:
                self.missed.append(f"missed: {team}: half of the calls of its assigner within {MOST_CALL} us, {half}")
            self.rehearse(file)
            low, high = each["elo_interval"]
            interval = "" if low is None or high is None else f" ({low:.0f} to {high:.0f})"
            agreement, nearest = mean(rows, "agreement"), mean(rows, "nearest_plays_ball")
            print(f"| {place} | `{team}` | {form(each['elo'], '.0f')}{interval} | {', '.join(map(str, records[team]))} | "
                  f"{form(mean(rows, 'rates.overlap_seconds_per_minute'), '.1f')} | "
                  f"{form(mean(rows, 'rates.uncovered_seconds_per_minute'), '.0f')} | "
                  f"{form(None if agreement is None else 100 * agreement, '.0f')} % | "
                  f"{form(None if nearest is None else 100 * nearest, '.0f')} % | "
                  f"{form(mean(rows, 'packets'), '.0f')} | "
                  f"{form(total(rows, 'packet_bytes') / packets if packets else None, '.0f')} | "
                  f"{form(total(rows, 'segment_bytes') / packets if packets else None, '.1f')} | {half:.1f}, {most:.1f} | "
                  f"{slower:.2f} |", flush=True)
        print("\n".join(self.missed) or "every bar holds")
        return 1 if self.missed else 0


if __name__ == "__main__":
    sys.exit(Proof(*sys.argv[1:]).run())
