#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A tournament of many rows: how long it takes to go on with it and to report on it, and how much memory.

    many_rows.py REGISTA TEAM_A TEAM_B [--rows N]

Some matches are really played; their rows, metrics too, are then written again and again under the seeds of the
following pairs, until all rows but the last two are there. What is measured is `tournament --resume`, which reads them
all and plays the last pair, and `report` in its forms. Times include the start of the program.
"""
import argparse
import contextlib
import os
import pathlib
import sqlite3
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "end_to_end"))
import results_file  # noqa: E402

REAL = 20  # pairs that are played
LIMIT = "30"


def fill(file, rows):
    """Copies of the rows of the first pairs, up to but without the last pair."""
    with sqlite3.connect(file) as database:
        database.execute("PRAGMA synchronous=OFF")
        have = database.execute("SELECT max(row) FROM matches").fetchone()[0]
        have -= have % 2
        for table in ("packets", "metrics", "matches"):
            database.execute(f"DELETE FROM {table} WHERE row > ?", (have,))
        copies = """WITH RECURSIVE place(row) AS (SELECT ? UNION ALL SELECT row + 1 FROM place WHERE row < ?)"""
        database.execute(copies + """
            INSERT INTO matches SELECT place.row, fixture, 1 + (place.row - 1) / 2, home_goals, away_goals, ended, hash,
            failure, seconds, attempts, 0 FROM place JOIN matches ON matches.row = 1 + (place.row - 1) % ?""",
                         (have + 1, rows - 2, have))
        for table in ("metrics", "packets"):
            others = ", ".join(results_file.TABLES[table][1][1:])
            database.execute(copies + f"""
                INSERT INTO {table} SELECT place.row, {others}, 0
                FROM place JOIN {table} ON {table}.row = 1 + (place.row - 1) % ?""", (have + 1, rows - 2, have))
        for table in ("matches", "metrics", "packets"):
            columns = results_file.TABLES[table][1]
            sums = ((results_file.checksum(*row), row[0]) for row in
                    database.execute(f"SELECT {', '.join(columns)} FROM {table} WHERE row > ?", (have,)).fetchall())
            database.executemany(f"UPDATE {table} SET checksum = ? WHERE row = ?", sums)
    database.close()


def largest_memory(process):
    """Looked at again and again, in MiB: the kernel's own account of a child begins with that of its parent."""
    most = 0.0
    while process.poll() is None:
        try:
            for line in pathlib.Path(f"/proc/{process.pid}/status").read_text().splitlines():
                if line.startswith("VmHWM:"):
                    most = max(most, int(line.split()[1]) / 1024)
        except OSError:
            pass  # it is gone
        time.sleep(0.005)
    return most


def measured(*words, environment=None):
    began = time.monotonic()
    with open(os.devnull, "w") as nothing:
        process = subprocess.Popen([str(word) for word in words], stdout=nothing, env=environment)
        memory = largest_memory(process)
    if process.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))} failed")
    return time.monotonic() - began, memory


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista", type=pathlib.Path)
    parser.add_argument("teams", nargs=2, type=pathlib.Path)
    parser.add_argument("--rows", type=int, default=1_000_000)
    options = parser.parse_args()
    regista = options.regista.resolve()
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "many.db"

        openings = options.teams[0].resolve().parent.parent / "openings"  # without them nobody plays in so short a game

        def tournament(pairs):
            return [regista, "tournament", "--team", options.teams[0].resolve(), "--team", options.teams[1].resolve(),
                    "--pairs", pairs, "--limit", LIMIT, "--openings", openings, "--results", file, "--quiet", "--no-page"]

        words = tournament(options.rows // 2)
        with subprocess.Popen([str(word) for word in words], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as process:
            while True:
                time.sleep(0.2)
                try:
                    with contextlib.closing(sqlite3.connect(f"file:{file}?mode=ro", uri=True)) as database:
                        if database.execute("SELECT count(*) FROM matches").fetchone()[0] >= 2 * REAL:
                            break
                except sqlite3.OperationalError:
                    pass  # not there yet
            process.terminate()
        fill(file, options.rows)
        print(f"{options.rows} rows, {file.stat().st_size / 2**20:.0f} MiB")
        for name, command in [("tournament --resume", [*words, "--resume"]),
                              ("report", [regista, "report", file]),
                              ("report --json", [regista, "report", file, "--json"]),
                              ("report --csv", [regista, "report", file, "--csv"])]:
            seconds, memory = measured(*command)
            print(f"{name:20} {seconds:6.2f} s, largest memory {memory:5.1f} MiB")


if __name__ == "__main__":
    main()
