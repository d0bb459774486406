#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Internal, for scripts/test: runs the tests of a label whose programs or data have changed since they passed last.

    run_changed_tests.py BUILD_FOLDER LABEL JOBS [--all]

What a test reads stands in BUILD_FOLDER/test_inputs/NAME, a file, folder or definition NAME="PATH" a line
(cmake/test_programs.cmake); a test without such a file is run each time. Passes are noted in
BUILD_FOLDER/passed_tests.json, by a hash of all that the test reads and of its command.
"""

import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

IGNORED = {"__pycache__", "node_modules", ".git", "build"}


class Digests:
    """SHA-256 of files and folders; each file is read once."""

    def __init__(self):
        self.known = {}

    def of(self, path):
        if path not in self.known:
            if path.is_dir():
                parts = sorted(each for each in path.iterdir() if each.name not in IGNORED)
                text = "".join(f"{each.name} {self.of(each)}\n" for each in parts).encode()
            else:
                text = path.read_bytes() if path.is_file() else b"absent"
            self.known[path] = hashlib.sha256(text).hexdigest()
        return self.known[path]


def described_tests(build, label):
    described = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1", "-L", f"^{label}$"], check=True,
                               capture_output=True, text=True).stdout
    return {test["name"]: test for test in json.loads(described)["tests"]}


def digest_of(test, inputs, digests):
    """Nothing for a test that does not say what it reads."""
    if not inputs.exists():
        return None
    parts = [json.dumps(test.get("command")), json.dumps(test["properties"])]
    for line in inputs.read_text().splitlines():
        path = re.search(r"/[^\"]*", line)  # of a definition: what stands between the quotes
        parts.append(f"{line} {digests.of(pathlib.Path(path[0])) if path else ''}")
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def run(build, names, jobs):
    """The names of those that passed or were skipped, and the status of ctest."""
    report = build / "tests.xml"
    report.unlink(missing_ok=True)
    pattern = "^(" + "|".join(re.escape(name) for name in names) + ")$"
    status = subprocess.run(["ctest", "--test-dir", build, "-R", pattern, "--no-tests=error", "--output-on-failure", "-j", jobs,
                             "--output-junit", report.resolve()], check=False).returncode
    passed = []
    if report.exists():
        for case in xml.etree.ElementTree.parse(report).iter("testcase"):
            if case.get("status") == "run":
                passed.append(case.get("name"))
    return passed, status


def write(notes, passed):
    temporary = notes.with_suffix(".new")
    temporary.write_text(json.dumps(passed, indent=1, sort_keys=True))
    os.replace(temporary, notes)


def main(build, label, jobs, everything):
    build = pathlib.Path(build)
    notes = build / "passed_tests.json"
    try:
        passed = json.loads(notes.read_text())
    except (OSError, ValueError):
        passed = {}
    digests = Digests()
    tests = {name: digest_of(test, build / "test_inputs" / name, digests)
             for name, test in described_tests(build, label).items()}
    if not tests:
        sys.exit(f"no test has the label {label}")
    wanted = [name for name, digest in tests.items() if everything or digest is None or passed.get(name) != digest]
    print(f"{len(wanted)} of {len(tests)} tests are run; of the others nothing has changed since they passed", flush=True)
    status = 0
    if wanted:
        passed = {name: digest for name, digest in passed.items() if name not in wanted}
        write(notes, passed)  # who interrupts this has seen none of them pass
        now_passed, status = run(build, wanted, jobs)
        write(notes, {**passed, **{name: tests[name] for name in now_passed if tests.get(name)}})
    return 1 if status else 0


if __name__ == "__main__":
    arguments = [each for each in sys.argv[1:] if each != "--all"]
    if len(arguments) != 3:
        sys.exit(__doc__)
    sys.exit(main(*arguments, everything="--all" in sys.argv))
