#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The largest memory of the workers of a study, for whole matches.

    worker_memory.py REGISTA TEAM_A TEAM_B [--pairs N] [--limit SECONDS]

A tournament is played by one worker at a time, whose account of the kernel (/proc/PID/status) is read ten times a second. The
first match of the pairing is played twice; the second play starts the program, the others are copies of the fork server.
"""
import argparse
import os
import pathlib
import re
import subprocess
import tempfile
import time


def value(status, name):
    return int(re.search(rf"^{name}:\s+(\d+)", status, re.M).group(1)) / 1024


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista", type=pathlib.Path)
    parser.add_argument("teams", nargs=2, type=pathlib.Path)
    parser.add_argument("--pairs", type=int, default=2)
    parser.add_argument("--limit", type=float)
    options = parser.parse_args()
    regista = options.regista.resolve()
    seen = {}
    with tempfile.TemporaryDirectory() as folder:
        words = [regista, "tournament", "--workers", "1", "--quiet", "--no-page", "--pairs", str(options.pairs), "--results",
                 pathlib.Path(folder) / "memory.db"]
        for team in options.teams:
            words += ["--team", team.resolve()]
        if options.limit:
            words += ["--limit", str(options.limit)]
        with subprocess.Popen(words, stdout=subprocess.DEVNULL) as process:
            while process.poll() is None:
                for name in filter(str.isdigit, os.listdir("/proc")):
                    try:
                        if os.readlink(f"/proc/{name}/exe") != str(regista) or int(name) == process.pid:
                            continue
                        command = pathlib.Path(f"/proc/{name}/cmdline").read_bytes().split(b"\0")
                        status = pathlib.Path(f"/proc/{name}/status").read_text()
                        if command[1] == b"play-one" and "VmHWM" in status:
                            # A copy still has the room of the server's longer command.
                            seen[int(name)] = (len(command) > 3, status)
                    except (OSError, IndexError):
                        pass  # it is gone
                time.sleep(0.1)
    for copy, status in (seen[each] for each in sorted(seen)):
        print(f"{'copy of the fork server' if copy else 'started by itself':24} at most {value(status, 'VmHWM'):5.1f} MiB, at "
              f"last {value(status, 'RssAnon'):5.1f} of its own and {value(status, 'RssFile'):5.1f} of files")


if __name__ == "__main__":
    main()
