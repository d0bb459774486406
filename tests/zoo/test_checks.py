# SPDX-License-Identifier: MIT
"""The zoo, looked at by `regista plugin check`: each animal gets the verdict that zoo.json expects,
and none of them takes the checker down, holds it up or leaves anything behind.

`check` of an animal says what is to be made of it:
  "sound"                                nothing fails, and nothing is warned of
  {"fails": CHECK, "says": EXPRESSION}   CHECK fails or crashes, and one of its lines matches
  {"warns": CHECK, "says": EXPRESSION}   CHECK warns and one of its lines matches; nothing fails
  {"passes": WHY}                        nothing fails: no check can see its fault, or none does yet
CHECK is a check, or a kind of plugin, which stands for all checks of it. Beside the one that is
named, others may fail. What an animal imports may be warned of in any case, since it is linked with
its neighbours' faults. One that acts by chance fails `within` so many runs. A check that fails only
now and then, with a line that `at_times` matches, is passed over.

REGISTA_ZOO_ANIMALS: names of those that are checked; empty: all. REGISTA_ZOO_RUNS: how often, each
time with another seed; default 1.
"""

import collections
import concurrent.futures
import json
import os
import re
import sys
import time
import traceback
import unittest

from test_zoo import ANIMALS, ZOO, Zoo

NAMES = os.environ.get("REGISTA_ZOO_ANIMALS", "").split()
RUNS = int(os.environ.get("REGISTA_ZOO_RUNS", "1"))
WORKERS = 2
LONGEST = 60  # s that a command may take
# Of processor time for each check. For an animal that never ends, as short as can be said; for the others many times
# what the longest check takes ("memory", which changes the access of 20 000 pages: a second).
SHORT, LONG = 2, 20
WORSE_AND_WORSE = ("skip", "pass", "warn", "fail", "crash")
BAD = ("fail", "crash")

Seen = collections.namedtuple("Seen", "worst processor_seconds wrong")


class Cage(Zoo):
    """One animal, checked in a folder of its own."""

    plugins = ()

    def __init__(self, animal, seed):
        super().__init__("holds")
        self.animal, self.seed, self.worst = animal, seed, None

    def check(self):
        """What a checker found that ended by itself, and left nothing behind."""
        before = set(os.listdir(self.folder))
        file = ZOO / f"{self.animal['name']}.so"
        says = self.animal["check"]["says"] if "says" in self.animal["check"] else ""
        seconds = SHORT if "processor time" in says else LONG
        words = ("--json", "--processor-seconds", seconds, "--seed", self.seed)
        done = self.bounded("plugin", "check", file, *words, longest=LONGEST)
        self.assertIn(done.returncode, (0, 1), done.stderr[-2000:])
        self.assertEqual(done.stderr, "")
        self.leaves_nothing()
        self.assertEqual(set(os.listdir(self.folder)), before)
        report, = json.loads(done.stdout)
        failed = any(check["status"] in BAD for check in report["checks"])
        self.assertEqual((done.returncode, report["passed"]), (int(failed), not failed))
        return report["checks"]

    def holds(self):
        expected = self.animal["check"]
        conditions = expected if isinstance(expected, dict) else {}
        passed_over = re.compile(conditions.get("at_times", "(?!)"))
        for _ in range(conditions.get("within", 1)):
            checks = [check for check in self.check() if check["status"] not in BAD
                      or not any(map(passed_over.search, check["lines"]))]
            self.worst = max((check["status"] for check in checks), key=WORSE_AND_WORSE.index)
            if self.worst in BAD:
                break
        found = [check for check in checks if check["status"] not in ("skip", "pass")]
        text = "\n".join(f"{check['check']}: {check['status']}: {check['lines']}" for check in found)
        if expected == "sound":
            self.assertEqual(text, "")
        elif "fails" in expected:
            self.is_found(found, BAD, expected["fails"], expected["says"], text)
        elif "warns" in expected:
            self.is_found(found, ("warn",), expected["warns"], expected["says"], text)
            self.assertEqual(self.worst, "warn", text)
        else:
            self.assertTrue(expected["passes"], "say why")
            self.assertNotIn(self.worst, BAD, text)
            self.assertEqual({check["check"] for check in found} - {"imports"}, set(), text)
        for check in found:
            if check["status"] == "crash" and check["check"].endswith(".promises"):
                where = [line for line in check["lines"] if line.startswith("at: ")]
                self.assertTrue(where, f"died, but where?\n{text}")

    def is_found(self, found, statuses, name, says, text):
        lines = [line for check in found for line in check["lines"]
                 if check["status"] in statuses
                 and name in (check["check"], check["check"].partition(".")[0])]
        self.assertRegex("\n".join(lines), f"(?m){says}",
                         f"{name} does not say so; what was found:\n{text}")


def look_at(animal, seed):
    """In a process of its own: what it starts inherits no file that its neighbour just writes."""
    cage, result = Cage(animal, seed), unittest.TestResult()
    before = os.times()
    try:
        cage.run(result)
        wrong = "\n".join(said for _, said in result.failures + result.errors)
    except Exception:
        wrong = traceback.format_exc()
    after = os.times()
    used = after.children_user + after.children_system - before.children_user - before.children_system
    return Seen(cage.worst, used, wrong)


class Checks(unittest.TestCase):
    def test_each_animal(self):
        chosen = [animal for animal in ANIMALS if not NAMES or animal["name"] in NAMES]
        self.assertEqual(set(NAMES) - {animal["name"] for animal in chosen}, set(), "unknown")
        # Those that wait come first, beside those that compute.
        chosen.sort(key=lambda animal: animal["file"] != "waiting")
        tries = [(animal, seed) for seed in range(RUNS) for animal in chosen]
        counts, used, began = collections.Counter(), 0.0, time.monotonic()
        with concurrent.futures.ProcessPoolExecutor(WORKERS) as pool:
            for (animal, seed), seen in zip(tries, pool.map(look_at, *zip(*tries))):
                with self.subTest(animal["name"], seed=seed):
                    if seen.wrong:
                        self.fail(seen.wrong)
                counts[seen.worst] += 1
                used += seen.processor_seconds
        worst = ", ".join(f"{counts[status]} {status}" for status in WORSE_AND_WORSE)
        print(f"{len(tries)} animals checked: {worst}; {used:.0f} s of processor time, "
              f"{time.monotonic() - began:.0f} s of wall time", file=sys.stderr)


if __name__ == "__main__":
    unittest.main()
