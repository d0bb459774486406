#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the tuner costs around its matches: processor time of the coordinator over that of all its workers.

    benchmarks/tuning/share.py build/release/bin/regista

For whole matches, and for short ones, by each of three algorithms.
"""

import pathlib
import subprocess
import sys
import tempfile

CONFIGS = pathlib.Path(__file__).resolve().parents[2] / "configs"
TUNING = """\
tuning: share
team: {configs}/teams/paper.yaml
opponents: [{{team: {configs}/teams/fixed_rate.yaml}}]
parameters: [utility.terms.*.weight]
{scenes}
search: {{algorithm: {algorithm}, matches: {matches}}}
selection: {{finalists: 2, matches: 4}}
verification: {{matches: 8}}
slices: {{points: 0}}
"""
CASES = (("whole matches", "", 24), ("scenes of 8 to 15 s", f"openings: {CONFIGS}/openings", 240))



def share(program, algorithm, scenes, matches):
    """The coordinator's own time is what is known of it and not of the workers it has waited for."""
    with tempfile.TemporaryDirectory() as folder:
        document = pathlib.Path(folder) / "t.yaml"
        document.write_text(TUNING.format(configs=CONFIGS, scenes=scenes, algorithm=algorithm, matches=matches))
        script = ("import os, sys\n"
                  "pid = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ)\n"
                  "os.waitid(os.P_PID, pid, os.WEXITED | os.WNOWAIT)\n"
                  "numbers = open(f'/proc/{pid}/stat').read().rsplit(')', 1)[1].split()\n"
                  "print(*numbers[11:15])\n")
        done = subprocess.run([sys.executable, "-c", script, program, "tune", document.name, "--quiet", "--no-page",
                               "--json"], cwd=folder, check=True, stdout=subprocess.PIPE, text=True)
        own, own_system, workers, workers_system = map(int, done.stdout.splitlines()[-1].split())
        return (own + own_system) / (workers + workers_system)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    print("| | " + " | ".join(name for name, _, _ in CASES) + " |\n|---|---|---|")
    for algorithm in ("sbplx", "spsa", "sep_cma_es"):
        cells = [f"{100 * share(program, algorithm, scenes, matches):.2f} %" for _, scenes, matches in CASES]
        print(f"| {algorithm} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
