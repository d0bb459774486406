#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A million matches in a thousand parts: how long it takes to gather them and to report on them, and how much memory.

    million.py REGISTA TEAM_A TEAM_B FOLDER [--rows N] [--parts N]

Some whole matches are really played by a task; their rows, metrics too, are then written again and again under the seeds
of the following pairs, into parts as tasks leave them. Slurm is not needed: small programs stand for sbatch, squeue and
scancel, which say that nothing plays. Times include the start of the program. The bars: gather 120 s and 128 MiB,
text of the verdict 5 s, all metrics as a table 180 s.
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
from many_rows import measured  # noqa: E402

REAL = 10  # matches that are played
BARS = {"gather": (120.0, 128.0), "report": (5.0, 128.0), "report --csv --metrics": (180.0, 128.0)}


def stand_ins(folder):
    folder.mkdir(parents=True)
    for name, says in (("sbatch", "echo 1"), ("squeue", "true"), ("scancel", "true")):
        (folder / name).write_text(f"#!/bin/sh\n{says}\n")
        (folder / name).chmod(0o755)


def write_parts(study, rows, parts):
    """In parts/, under the names that tasks of batch 1 give them. rows: in all, those that were played among them."""
    template = study / "template.db"
    shutil.move(study / "parts" / "1-0.db", template)
    with sqlite3.connect(template) as database:
        matches = database.execute(f"SELECT {', '.join(results_file.TABLES['matches'][1])} FROM matches ORDER BY row").fetchall()
        numbers = database.execute(f"SELECT {', '.join(results_file.TABLES['metrics'][1])} FROM metrics ORDER BY row").fetchall()
        database.execute("DELETE FROM metrics")
        database.execute("DELETE FROM matches")
    database.close()
    assert len(matches) == len(numbers) == REAL
    each = rows // parts
    for part in range(parts):
        file = study / "parts" / f"1-{part}.db"
        shutil.copy(template, file)
        database = sqlite3.connect(file, isolation_level=None)
        database.execute("PRAGMA synchronous=OFF")
        database.execute("BEGIN")
        for row in range(part * each + 1, (part + 1) * each + 1):
            match = [row, *matches[(row - 1) % REAL][1:]]
            match[2] = 1 + (row - 1) // 2  # seed
            metric = [row, *numbers[(row - 1) % REAL][1:]]
            database.execute("INSERT INTO matches VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                             [*match, results_file.checksum(*match)])
            database.execute("INSERT INTO metrics VALUES(?, ?, ?, ?, ?)", [*metric, results_file.checksum(*metric)])
        database.execute("COMMIT")
        database.close()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista", type=pathlib.Path)
    parser.add_argument("teams", nargs=2, type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--rows", type=int, default=1_000_000)
    parser.add_argument("--parts", type=int, default=1_000)
    options = parser.parse_args()
    regista = options.regista.resolve()
    folder = options.folder.resolve() / "million"
    shutil.rmtree(folder, ignore_errors=True)
    stand_ins(folder / "path")
    environment = {**os.environ, "PATH": f"{folder / 'path'}:{os.environ['PATH']}"}
    document = folder / "million.yaml"
    document.write_text("tournament: million\nteams:\n" + "".join(f"  - {{team: {team.resolve()}}}\n" for team in options.teams)
                        + f"pairs: {options.rows // 2}\n")
    study = folder / "study"
    subprocess.run([regista, "run", document, "--on", "slurm", "--folder", study, "--detach", "--per-task", str(REAL),
                    "--array", "1", "--workers", "2", "--quiet"], check=True, env=environment)
    print(f"playing {REAL} whole matches", flush=True)
    subprocess.run([regista, "cluster-task", study, "1", "0"], check=True, env=environment)
    write_parts(study, options.rows, options.parts)
    size = sum(file.stat().st_size for file in (study / "parts").iterdir())
    print(f"{options.rows} matches in {options.parts} parts, {size / options.rows:.0f} bytes a match", flush=True)
    results = study / "results.db"
    missed = 0
    for name, words in (("gather", ["gather", study, "--no-page", "--quiet"]), ("report", ["report", results]),
                        ("report --csv --metrics", ["report", results, "--csv", "--metrics"])):
        seconds, memory = measured(regista, *words, environment=environment)
        bars = BARS[name]
        held = seconds <= bars[0] and memory <= bars[1]
        missed += not held
        print(f"{name:24} {seconds:7.1f} s of {bars[0]:.0f}, largest memory {memory:6.1f} MiB of {bars[1]:.0f}"
              f"{'' if held else ': MISSED'}", flush=True)
    progress = json.loads((study / "cluster.json").read_text())["progress"]
    with sqlite3.connect(results) as database:
        there = database.execute("SELECT count(*) FROM matches").fetchone()[0]
    database.close()
    if progress["state"] != "complete" or there != options.rows:
        sys.exit(f"the study is {progress['state']} with {there} matches")
    shutil.rmtree(folder)
    print(f"{options.rows} matches: " + ("all bars are met" if missed == 0 else f"{missed} bars are missed"))
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
