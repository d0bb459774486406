# SPDX-License-Identifier: MIT
"""A shared object that is written to while a match uses it: the next instruction may be anything, and what is said is
one line all the same."""

import pathlib
import subprocess
import time
import unittest

import program
import tournament
from processes import processes

LONG = ("--limit", "600")

# What meets it is a process that plays, one that opens its plugins, or one that has opened them and compares them: on a
# busy machine whichever has them just then.
CHANGED = (r"(\S+: was overwritten while a match was played \(.*\)|\S+: .*; that was not so at the beginning|"
           r"(plugin \w+ \(\S+\) has changed(, )?)+)")


def truncated(file):
    with file.open("r+b") as opened:
        opened.truncate(0)


def garbage(file):
    """Of the same length; no instruction of it may be executed."""
    size = file.stat().st_size
    with file.open("r+b") as opened:
        opened.write(b"\x06" * size)


class OverwrittenPlugins(tournament.Tournament):
    def setUp(self):
        super().setUp()
        self.file = self.plugin_folder / program.SOUND.name

    def who_plays(self):
        """The processes that have opened the plugins for good: who only looks at them is gone in a moment."""

        def have_it():
            found = set()
            for number in processes(self.program):
                try:
                    maps = pathlib.Path(f"/proc/{number}/maps").read_text()
                except OSError:
                    continue  # it is gone
                if str(self.file) in maps:
                    found.add(number)
            return found

        before = have_it()
        time.sleep(0.1)
        return before & have_it()

    def overwritten(self, overwrite, *arguments):
        """Status and lines of a command whose plugins are overwritten while it plays."""
        with self.start(*arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            self.wait_for(self.who_plays)
            overwrite(self.file)
            out, err = process.communicate(timeout=program.PATIENCE)
        self.assertEqual(out, "")
        self.assertFalse(processes(self.program))
        # A sanitizer tells of the fault as well.
        lines = [line for line in err.splitlines() if not program.SANITIZED or line.startswith("regista: ")]
        return process.returncode, lines

    def test_match(self):
        for overwrite in truncated, garbage:
            for more in ("--quiet",), ("--quiet", "--json"):
                with self.subTest(overwrite.__name__, more=more):
                    code, lines = self.overwritten(overwrite, "match", "small.yaml", "small.yaml", *LONG, *more)
                    self.assertEqual((code, len(lines)), (2, 1), lines)
                    self.assertTrue(lines[0].startswith(
                        f"regista: {self.file}: was overwritten while the match was played ("), lines)
                self.file.unlink()
                self.file.write_bytes(program.SOUND.read_bytes())

    def test_tournament(self):
        for overwrite in truncated, garbage:
            for more in ("--workers", "1"), ("--isolation", "always"):
                with self.subTest(overwrite.__name__, more=more):
                    results = f"{overwrite.__name__}{more[1]}.db"
                    words = self.arguments("--quiet", *LONG, "--results", results, *more)
                    code, lines = self.overwritten(overwrite, *words)
                    self.assertEqual((code, len(lines)), (2, 1), lines)
                    self.assertRegex(lines[0], rf"^regista: while the tournament was played: {CHANGED}$")
                    self.assertIn(str(self.file), lines[0])
                    # No team forfeits a match by it.
                    self.assertEqual(self.stored("SELECT count(*) FROM matches", results), [(0,)])
                self.file.unlink()
                self.file.write_bytes(program.SOUND.read_bytes())

    def test_between_two_matches(self):
        """What the next worker finds is not what there was when the tournament was set up."""
        first_row = lambda: self.count() > 0
        with self.start(*self.arguments("--quiet", "--workers", "1", pairs=500), stdout=subprocess.PIPE,
                        stderr=subprocess.PIPE) as process:
            self.wait_for(first_row)
            truncated(self.file)
            out, err = process.communicate(timeout=program.PATIENCE)
        self.assertEqual((process.returncode, out), (2, ""))
        self.assertRegex(err, rf"^regista: while the tournament was played: {CHANGED}\n$")
        self.assertIn(str(self.file), err)
        self.assertEqual(self.stored("SELECT count(*) FROM matches WHERE ended <> 'limit'"), [(0,)])


if __name__ == "__main__":
    unittest.main()
