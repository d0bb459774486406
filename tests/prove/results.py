# SPDX-License-Identifier: MIT
"""Studies that a proof plays once: their results stay in a file, and are gone on with where they ended."""

import json
import subprocess
import sys


def played(program, file, words, command="tournament"):
    """What `regista tournament` or another study says with these words."""
    more = ["--resume"] if file.exists() else []
    done = subprocess.run([program, command, *map(str, words), "--results", str(file), "--no-page", "--quiet", *more],
                          stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{file} ended with status {done.returncode}")
    return done.stdout


def told(program, file, *form):
    return subprocess.run([program, "report", str(file), *form], check=True, stdout=subprocess.PIPE, text=True).stdout


def table(program, file):
    """With all numbers of each match."""
    return told(program, file, "--csv", "--metrics")


def findings(program, file):
    return json.loads(told(program, file, "--json"))
