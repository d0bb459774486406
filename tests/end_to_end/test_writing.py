# SPDX-License-Identifier: MIT
"""What is written and cannot be kept: a full disk, a reader who went away."""

import os
import signal
import subprocess
import unittest

import program

COMMANDS = (("--version",), ("--help",), ("plugin", "list"), ("plugin", "list", "--json"),
            ("plugin", "info", "first_free"), ("config", "show", "small.yaml"), ("config", "schema", "team"),
            ("config", "check", "rules.yaml"), ("match", "small.yaml", "small.yaml", "--limit", "1"),
            ("match", "small.yaml", "small.yaml", "--limit", "1", "--json"))


class Writing(program.Case):
    def setUp(self):
        super().setUp()
        self.write("rules.yaml", "rules: small\n")

    def assert_told(self, command, done, reason, target="standard output"):
        self.assertEqual((command, done.returncode, done.stderr),
                         (command, 1, f"regista: cannot write to {target}: {reason}\n"))

    def test_full_disk(self):
        for command in COMMANDS:
            with open("/dev/full", "w") as full:
                self.assert_told(command, self.run_program(*command, stdout=full), "No space left on device")

    def test_reader_went_away(self):
        for command in COMMANDS:
            reading, writing = os.pipe()
            os.close(reading)
            try:
                done = self.run_program(*command, stdout=writing)
            finally:
                os.close(writing)
            # As of a program that the signal ends: who reads the first lines alone knows that.
            self.assertEqual((command, done.returncode, done.stderr), (command, 128 + signal.SIGPIPE, ""))

    def test_closed_standard_output(self):
        command = f'"{self.program}" match small.yaml small.yaml --limit 1 >&-'
        done = subprocess.run(["/bin/sh", "-c", command], cwd=self.folder, env=self.environment(), text=True,
                              stderr=subprocess.PIPE, check=False)
        self.assert_told(command, done, "Bad file descriptor")

    def test_closed_standard_error(self):
        command = f'"{self.program}" match small.yaml missing.yaml 2>&-'
        self.assertEqual(subprocess.run(["/bin/sh", "-c", command], cwd=self.folder, check=False).returncode, 2)

    def test_decisions_on_a_full_disk(self):
        done = self.run_program("match", "small.yaml", "small.yaml", "--limit", "60", "--decisions", "/dev/full")
        self.assertEqual(done.stdout, "")
        self.assert_told("--decisions", done, "No space left on device", "/dev/full")


if __name__ == "__main__":
    unittest.main()
