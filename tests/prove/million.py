#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A million matches in a thousand parts: how long it takes to gather them and to report on them, and how much memory.

    million.py REGISTA FOLDER TEAM TEAM [TEAM...] [--rows N] [--parts N]

First whole matches of the first two teams, then of a league of all, then short games of that league. The matches of the
first pairs are really played by a task; their rows, metrics too, are then written again and again under the seeds of the
following pairs, into parts as tasks leave them. Slurm is not needed: small programs stand for sbatch, squeue and scancel,
which say that nothing plays.
Times include the start of the program. The bars: gather 120 s and 128 MiB, verdict or ranking 5 s, all metrics as a
table 180 s. A ranking of short games reports packets, too.
"""
import argparse
import json
import os
import pathlib
import shutil
import sqlite3
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "end_to_end"))
sys.path.insert(0, str(ROOT / "benchmarks" / "campaign"))
import results_file  # noqa: E402
import slurm  # noqa: E402
from many_rows import measured  # noqa: E402

FEWEST = 10  # matches that are played
MEMORY = 128.0  # MiB
BARS = {"gather": 120.0, "report": 5.0, "report --csv --metrics": 180.0}  # s


def write_parts(study, rows, parts, in_a_round):
    """In parts/, under the names that tasks of batch 1 give them. rows: in all, those that were played among them.
    in_a_round: matches that have the same seed, in which every two teams meet twice."""
    template = study / "template.db"
    shutil.move(study / "parts" / "1-0.db", template)
    with sqlite3.connect(template) as database:
        matches = database.execute(f"SELECT {', '.join(results_file.TABLES['matches'][1])} FROM matches ORDER BY row").fetchall()
        numbers = database.execute(f"SELECT {', '.join(results_file.TABLES['metrics'][1])} FROM metrics ORDER BY row").fetchall()
        packets = [each for each, in database.execute("SELECT numbers FROM packets ORDER BY row")]
        for table in ("packets", "metrics", "matches"):
            database.execute(f"DELETE FROM {table}")
    database.close()
    real = len(matches)
    assert real % in_a_round == 0 and len(numbers) == len(packets) == real
    for part in range(parts):
        file = study / "parts" / f"1-{part}.db"
        shutil.copy(template, file)
        database = sqlite3.connect(file, isolation_level=None)
        database.execute("PRAGMA synchronous=OFF")
        database.execute("BEGIN")
        for row in range(part * rows // parts + 1, (part + 1) * rows // parts + 1):
            match = [row, *matches[(row - 1) % real][1:]]
            match[2] = 1 + (row - 1) // in_a_round  # seed
            metric = [row, *numbers[(row - 1) % real][1:]]
            database.execute("INSERT INTO matches VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                             [*match, results_file.checksum(*match)])
            database.execute("INSERT INTO metrics VALUES(?, ?, ?, ?, ?)", [*metric, results_file.checksum(*metric)])
            spent = packets[(row - 1) % real]
            database.execute("INSERT INTO packets VALUES(?, ?, ?)", [row, spent, results_file.checksum(row, spent)])
        database.execute("COMMIT")
        database.close()


class Million:
    """A tournament of these teams in `folder`. rows: about so many; only whole rounds are played. more: of its document."""

    def __init__(self, regista, folder, teams, rows, parts, more=""):
        self.regista, self.study = regista, folder / "study"
        shutil.rmtree(folder, ignore_errors=True)
        slurm.stand_ins(folder / "path")
        self.environment = {**os.environ, "PATH": f"{folder / 'path'}:{os.environ['PATH']}"}
        in_a_round = len(teams) * (len(teams) - 1)
        rounds = rows // in_a_round
        self.rows, played = rounds * in_a_round, -(-FEWEST // in_a_round) * in_a_round
        document = folder / "million.yaml"
        document.write_text("tournament: million\nteams:\n" + "".join(f"  - {{team: {team.resolve()}}}\n" for team in teams)
                            + f"pairs: {rounds}\nplay_twice: false\n{more}")
        self.run("run", document, "--on", "slurm", "--folder", self.study, "--detach", "--per-task", str(played), "--array",
                 "1", "--workers", "2", "--quiet")
        print(f"{len(teams)} teams: playing {played} matches", flush=True)
        self.run("cluster-task", self.study, "1", "0")
        write_parts(self.study, self.rows, parts, in_a_round)
        size = sum(file.stat().st_size for file in (self.study / "parts").iterdir())
        print(f"{self.rows} matches in {parts} parts, {size / self.rows:.0f} bytes a match", flush=True)

    def run(self, *words):
        subprocess.run([self.regista, *words], check=True, env=self.environment)

    def missed(self, *names):
        """Does these and prints what they took. How many missed a bar."""
        results, out = self.study / "results.db", 0
        words = {"gather": ["gather", self.study, "--no-page", "--quiet"], "report": ["report", results],
                 "report --csv --metrics": ["report", results, "--csv", "--metrics"]}
        for name in names:
            seconds, memory = measured(self.regista, *words[name], environment=self.environment)
            held = seconds <= BARS[name] and memory <= MEMORY
            out += not held
            print(f"{name:24} {seconds:7.1f} s of {BARS[name]:.0f}, largest memory {memory:6.1f} MiB of {MEMORY:.0f}"
                  f"{'' if held else ': MISSED'}", flush=True)
        progress = json.loads((self.study / "cluster.json").read_text())["progress"]
        with sqlite3.connect(results) as database:
            there = database.execute("SELECT count(*) FROM matches").fetchone()[0]
        database.close()
        if progress["state"] != "complete" or there != self.rows:
            sys.exit(f"the study is {progress['state']} with {there} matches")
        return out


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("teams", nargs="+", type=pathlib.Path)
    parser.add_argument("--rows", type=int, default=1_000_000)
    parser.add_argument("--parts", type=int, default=1_000)
    options = parser.parse_args()
    if len(options.teams) < 2:
        parser.error("two teams at least")
    regista, folder = options.regista.resolve(), options.folder.resolve() / "million"
    two = Million(regista, folder, options.teams[:2], options.rows, options.parts)
    missed = two.missed("gather", "report", "report --csv --metrics")
    if len(options.teams) > 2:
        missed += Million(regista, folder, options.teams, options.rows, options.parts).missed("gather", "report")
        league = Million(regista, folder, options.teams, options.rows, options.parts,
                         f"limit: 30\nopenings: {options.teams[0].resolve().parent.parent / 'openings'}\n")
        missed += league.missed("gather", "report")
    shutil.rmtree(folder)
    print(f"{options.rows} matches: " + (f"{missed} bars are missed" if missed else "all bars are met"))
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
