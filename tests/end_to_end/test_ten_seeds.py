# SPDX-License-Identifier: MIT
"""Ten whole matches of the shipped teams: each ends as a game does, within 64 MB, and over all both sides score."""
import json
import os
import resource
import subprocess
import unittest

PROGRAM = os.environ["REGISTA_PROGRAM"]
CONFIGS = os.environ["REGISTA_SOURCE"] + "/configs"


class TenSeeds(unittest.TestCase):
    def test_both_sides_score(self):
        goals, hashes = [0, 0], set()
        for seed in range(1, 11):
            done = subprocess.run(
                [PROGRAM, "match", CONFIGS + "/teams/paper.yaml", CONFIGS + "/teams/fixed_rate.yaml", "--seed", str(seed),
                 "--json"], capture_output=True, text=True, check=True)
            match = json.loads(done.stdout)
            self.assertIn(match["ended"], ("full_time", "mercy"))
            self.assertEqual(match["seed"], seed)
            for side in (0, 1):
                self.assertLessEqual(match["packets"][side], 1200)
                goals[side] += match["score"][side]
            hashes.add(match["state_hash"])
        self.assertEqual(len(hashes), 10)
        self.assertGreater(min(goals), 0, goals)
        peak_mb = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
        self.assertLessEqual(peak_mb, 64)


if __name__ == "__main__":
    unittest.main()
