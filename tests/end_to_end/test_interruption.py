# SPDX-License-Identifier: MIT
"""Ctrl-C while a match is played."""

import os
import shlex
import signal
import subprocess
import time
import unittest

import program

# Longer than any of these tests may take.
LONG = ("--set", "rules.durations.half=7200")


class Interruption(program.Case):
    def interrupted(self, number, *arguments):
        process = self.start("match", *(arguments or ("small.yaml", "small.yaml", "--seed", "5", *LONG)),
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        with process:
            time.sleep(5.0 if program.SANITIZED else 1.0)
            self.assertIsNone(process.poll(), "ended before it was interrupted")
            asked = time.monotonic()
            process.send_signal(number)
            out, err = process.communicate(timeout=30)
            took = time.monotonic() - asked
        self.assertEqual((process.returncode, out), (128 + number, ""))
        self.assertLess(took, 4.0 if program.SANITIZED else 2.0)
        return err

    def test_says_how_far_it_came_and_how_to_play_it_again(self):
        line = self.interrupted(signal.SIGINT)
        self.assertRegex(line, r"^regista: interrupted in half \d at \d\d+:\d\d, \d+ s simulated, score \d+:\d+; "
                               r"the same match again: [^\n]+\n$")
        again = shlex.split(line.split("again: ")[1])
        self.assertEqual(again, [str(self.program), "match", "small.yaml", "small.yaml", "--seed", "5", *LONG])

    def test_a_request_to_terminate_is_the_same(self):
        self.assertIn("interrupted in half", self.interrupted(signal.SIGTERM))

    def test_a_signal_to_the_whole_group_is_told_once(self):
        for _ in range(4):
            process = self.start("match", "small.yaml", "small.yaml", *LONG, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, start_new_session=True)
            with process:
                time.sleep(5.0 if program.SANITIZED else 0.5)
                os.killpg(process.pid, signal.SIGTERM)
                out, err = process.communicate(timeout=30)
            self.assertEqual((process.returncode, out), (128 + signal.SIGTERM, ""))
            self.assertEqual(err.count("interrupted"), 1, err)

    def test_a_plugin_that_hangs_cannot_hold_it_up(self):
        folder = program.TEST_PLUGINS / "hangs"
        self.write("hanging team.yaml", program.TEAM.format(name="hanging").replace("ball_seen", "hangs"))
        line = self.interrupted(signal.SIGINT, "hanging team.yaml", "small.yaml", "--plugins", folder)
        self.assertEqual(line, "regista: interrupted while a plugin did not return; the same match again: "
                               f"{self.program} match 'hanging team.yaml' small.yaml --plugins {folder}\n")


if __name__ == "__main__":
    unittest.main()
