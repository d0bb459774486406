# SPDX-License-Identifier: MIT
"""The process that opens plugins and reads teams once for all matches of a study: whatever becomes of it, each match is
that of a program just started."""

import os
import pathlib
import signal
import subprocess
import time
import unittest

import processes
import program
import tournament


def command_of(process):
    try:
        return pathlib.Path(f"/proc/{process}/cmdline").read_bytes().split(b"\0")[1:2]
    except OSError:
        return []


class ForkServer(tournament.Tournament):
    def servers(self):
        return [each for each in processes.processes(self.program) if command_of(each) == [b"fork-server"]]

    def begin(self, *more, **options):
        return self.start(*self.arguments("--quiet", *more, **options), stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def test_its_matches_are_those_of_a_program_just_started(self):
        self.play(pairs=3)
        for row, (hash_of_row,) in enumerate(self.stored("SELECT hash FROM matches ORDER BY row"), 1):
            done = self.run_program("match", "--from", "tournament.db", "--row", row)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, rf"hash {hash_of_row}\n$")

    def test_what_was_played_before_does_not_matter(self):
        """Three teams in two orders: every match that both tournaments have is the same."""
        teams = ["small.yaml", "other.yaml", "worse.yaml"]
        played = []
        for name, order in (("forwards", teams), ("backwards", teams[::-1])):
            self.play("--results", f"{name}.db", "--workers", "1", "--play-once", teams=order)
            played.append({(row[1], row[2]): row[3:] for row in self.rows(f"{name}.db")})
        both = played[0].keys() & played[1].keys()
        self.assertEqual(len(both), 18)
        for match in both:
            self.assertEqual(played[0][match], played[1][match])

    def test_it_is_killed(self):
        """As often as it is seen: matches go on without it, and the report is the same."""
        expected = self.play("--results", "expected.db", pairs=20)
        running = self.begin(pairs=20)
        seen = set()
        while running.poll() is None:
            for each in self.servers():
                seen.add(each)
                try:
                    os.kill(each, signal.SIGKILL)
                except ProcessLookupError:
                    pass
            time.sleep(0.01)
        output, errors = running.communicate()
        self.assertEqual((running.returncode, errors), (0, ""))
        self.assertGreater(len(seen), 0)
        self.assertEqual(output.replace("tournament.db", "expected.db"), expected)
        self.assertEqual(self.rows(), self.rows("expected.db"))
        self.assertEqual(self.servers(), [])

    def test_it_is_stopped(self):
        """Nobody waits for it for ever."""
        running = self.begin("--processor-seconds", "1", pairs=20)
        stopped = None
        while running.poll() is None and stopped is None:
            for each in self.servers():
                os.kill(each, signal.SIGSTOP)
                stopped = each
            time.sleep(0.01)
        output, errors = running.communicate(timeout=120)
        self.assertEqual((running.returncode, errors), (0, ""))
        self.assertIsNotNone(stopped)
        self.assertEqual(self.servers(), [])

    def test_what_a_match_finds_open(self):
        """Its standard streams, answer, note and trail, and nothing of the server's."""
        running = self.begin("--play-once", "--workers", "1", pairs=40)
        found = []
        while running.poll() is None:
            for each in processes.processes(self.program):
                if each == running.pid or command_of(each) != [b"play-one"]:
                    continue
                try:
                    found.append({file.name: os.readlink(file) for file in pathlib.Path(f"/proc/{each}/fd").iterdir()})
                except OSError:
                    pass  # it has ended
            time.sleep(0.002)
        output, errors = running.communicate()
        self.assertEqual((running.returncode, errors), (0, ""))
        whole = [each for each in found if len(each) == 6 and each["2"].startswith("pipe:")]
        self.assertGreater(len(whole), 5)
        for each in whole:
            self.assertEqual(sorted(each), list("012345"))
            self.assertEqual([each[name] for name in "015"], ["/dev/null"] * 3)
            self.assertTrue(each["3"].startswith("pipe:") and "regista-note" in each["4"], each)

    def test_the_coordinator_is_killed(self):
        running = self.begin(pairs=200)
        while not self.servers():
            time.sleep(0.01)
        running.kill()
        running.communicate()
        for _ in range(100):
            if not processes.processes(self.program):
                break
            time.sleep(0.05)
        self.assertEqual(processes.processes(self.program), [])

    def test_a_file_is_touched(self):
        """It is read anew; as it holds what it held, nothing else happens."""
        running = self.begin(pairs=60)
        while not self.servers():
            time.sleep(0.01)
        seen = set()
        while len(seen) < 2 and running.poll() is None:
            seen.update(self.servers())
            os.utime(self.folder / "small.yaml")
            time.sleep(0.02)
        output, errors = running.communicate()
        self.assertEqual((running.returncode, errors), (0, ""))
        self.assertGreater(len(seen), 1)

    def test_a_file_is_changed(self):
        running = self.begin(pairs=400)
        while not self.servers():
            time.sleep(0.01)
        time.sleep(0.3)
        text = (self.folder / "small.yaml").read_text()
        self.write("small.yaml", text + "\ndecision_rate: 5\n")
        output, errors = running.communicate()
        self.assertEqual(running.returncode, 2, errors)
        self.assertIn("small.yaml", errors)

    def test_the_command_is_not_for_people(self):
        done = self.run_program("fork-server")
        self.assertEqual(done.returncode, 2)
        self.assertIn("is for the program itself", done.stderr)


if __name__ == "__main__":
    unittest.main()
