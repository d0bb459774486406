# SPDX-License-Identifier: MIT
"""Coordinator and workers of a tournament killed at random moments, again and again: in the end no row is missing,
doubled or different, and the report is that of a tournament that nobody disturbed."""

import os
import random
import signal
import subprocess
import time
import unittest

import tournament

PAIRS = 20
KILLS = 24


class Resume(tournament.Tournament):
    def test_a_tournament_that_is_complete_is_not_played_again(self):
        report = self.play()
        rows = self.rows()
        self.assertEqual(self.play("--resume"), report)
        self.assertEqual(len(rows), 6)
        self.assertEqual(self.rows(), rows)

    def test_killed_at_random_moments(self):
        began = time.monotonic()
        undisturbed = self.play("--results", "undisturbed.db", "--workers", "2", pairs=PAIRS)
        took = time.monotonic() - began
        seed = random.randrange(1_000_000)
        chance = random.Random(seed)
        kills = {"coordinator": 0, "worker": 0}
        with self.subTest(seed=seed):
            while sum(kills.values()) < KILLS:
                more = ["--resume"] if (self.folder / "tournament.db").exists() else []
                words = self.arguments("--quiet", "--workers", chance.choice("123"), *more, pairs=PAIRS)
                with self.start(*words, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
                    # Short enough that the tournament lasts for all the kills.
                    time.sleep(chance.uniform(0.0, 1.5 * took / KILLS))
                    if chance.random() < 0.4:
                        self.wait_for(lambda: self.workers() or process.poll() is not None)
                        try:
                            os.kill(chance.choice(self.workers()), signal.SIGKILL)
                            kills["worker"] += 1
                        except (ProcessLookupError, IndexError):
                            pass  # it was done before
                        time.sleep(chance.uniform(0.0, took / KILLS))
                    if process.poll() is None:
                        process.kill()
                        kills["coordinator"] += 1
                    _, err = process.communicate()
                    self.assertIn(process.returncode, (0, -signal.SIGKILL), err)
                if process.returncode == 0 and sum(kills.values()) < KILLS:
                    # Done before its time: what is left to kill is a new beginning.
                    self.assertEqual(self.rows(), self.rows("undisturbed.db"))
                    for file in self.folder.glob("tournament.db*"):
                        file.unlink()
            if not (self.folder / "tournament.db").exists():
                self.play(pairs=PAIRS)
            done = self.run_program(*self.arguments("--quiet", "--resume", pairs=PAIRS))
            self.assertEqual((done.returncode, done.stdout), (0, undisturbed), done.stderr)
            self.assertEqual(self.rows(), self.rows("undisturbed.db"))
            self.assertGreater(kills["coordinator"], 5)
            self.assertGreater(kills["worker"], 0)


if __name__ == "__main__":
    unittest.main()
