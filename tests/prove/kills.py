# SPDX-License-Identifier: MIT
"""Coordinator and workers of studies killed at random moments, again and again: in the end text, JSON, CSV, page,
figures and every other file of the study are byte for byte those of a study that nobody disturbed.

    REGISTA_KILLS   kills in all, shared out among tournament, experiment and tuning; default 200
    REGISTA_SEED    of the moments; default: a new one, which is printed
"""

import os
import random
import shutil
import signal
import subprocess
import sys
import time
import unittest

import experiment
import program
import test_tune
import tournament
from processes import processes

KILLS = int(os.environ.get("REGISTA_KILLS", "200"))
SEED = int(os.environ.get("REGISTA_SEED") or random.randrange(1_000_000))
KILLS_PER_ROUND = 15  # how often one study is killed until it is done, about
WORKERS_SHARE = 0.4   # of the kills


class Study:
    """What the three have in common. A subclass says `name` (of the results, without .db), `command(*more)` and
    `written`, the files that its command writes at its end beside page and results."""

    pages = True

    def outputs(self, text):
        """Everything the study says, by name."""
        out = {"text": text.encode()}
        for form in ("--json", "--csv"):
            out[form] = self.succeed("report", f"{self.name}.db", form).encode()
        for name in self.written:
            out[name] = (self.folder / name).read_bytes()
        out["page"] = (self.folder / f"{self.name}.html").read_bytes()
        for kind in ("figures", "recordings"):
            for file in sorted((self.folder / f"{self.name}.{kind}").glob("**/*")):
                # What a recording holds is tested elsewhere; that there is one belongs to the page.
                out[str(file.relative_to(self.folder))] = file.read_bytes() if kind == "figures" else b""
        return out

    def clear(self):
        for file in self.folder.glob(f"{self.name}.*"):
            if file.suffix != ".yaml":
                shutil.rmtree(file) if file.is_dir() else file.unlink()
        self.clear_written()

    def clear_written(self):
        for name in self.written:
            (self.folder / name).unlink(missing_ok=True)

    def same(self, text, undisturbed):
        found = self.outputs(text)
        self.assertEqual(sorted(found), sorted(undisturbed))
        for name, content in undisturbed.items():
            said = f"{name} is not that of an undisturbed study{difference(content, found[name])}"
            self.assertTrue(found[name] == content, said)

    def test_kills(self):
        chance = random.Random(SEED)
        began = time.monotonic()
        undisturbed = self.outputs(self.succeed(*self.command("--workers", "2")))
        took = time.monotonic() - began
        self.clear()
        kills = {"coordinator": 0, "worker": 0}
        rounds = 0
        text = None
        while sum(kills.values()) < KILLS * self.share or text is None:
            enough = sum(kills.values()) >= KILLS * self.share
            text = self.once(chance, took, kills, enough)
            if text is None:
                continue
            rounds += 1
            self.same(text, undisturbed)
            self.clear()
            if sum(kills.values()) < KILLS * self.share:
                text = None
        print(f"{type(self).__name__.lower()}: {kills['coordinator']} kills of the coordinator and {kills['worker']} of "
              f"workers in {rounds} rounds of {took:.1f} s undisturbed; {len(undisturbed)} outputs equal each time",
              file=sys.stderr)

    def once(self, chance, took, kills, undisturbed_now):
        """Starts or resumes the study, and kills it. Its text, when it came to its end."""
        more = ["--resume"] if (self.folder / f"{self.name}.db").exists() else []
        self.clear_written()
        with self.start(*self.command("--workers", chance.choice("123"), *more), stdout=subprocess.PIPE,
                        stderr=subprocess.PIPE) as process:
            if not undisturbed_now:
                time.sleep(chance.uniform(0.0, 2.0 * took / KILLS_PER_ROUND))
                if chance.random() < WORKERS_SHARE:
                    kills["worker"] += self.kill_a_worker(process, chance)
                    time.sleep(chance.uniform(0.0, took / KILLS_PER_ROUND))
                if chance.random() < 0.8 and process.poll() is None:
                    process.kill()
                    kills["coordinator"] += 1
            out, err = process.communicate(timeout=600)
        self.assertIn(process.returncode, (0, -signal.SIGKILL), err)
        return out if process.returncode == 0 else None

    def kill_a_worker(self, process, chance):
        """Whether one was there to be killed."""
        workers = []
        end = time.monotonic() + 1
        while not workers and process.poll() is None and time.monotonic() < end:
            workers = [number for number in processes(self.program) if number != process.pid]
        try:
            os.kill(chance.choice(workers), signal.SIGKILL)
        except (IndexError, ProcessLookupError):
            return 0  # it was done before
        return 1


def difference(wanted, found):
    at = next((i for i, (a, b) in enumerate(zip(wanted, found)) if a != b), min(len(wanted), len(found)))
    return f", from byte {at} on: {wanted[at - 60:at + 100]!r} became {found[at - 60:at + 100]!r}"


class Tournament(Study, tournament.Tournament):
    name, written, share = "tournament", (), 0.4

    def command(self, *more):
        return self.arguments("--quiet", "--record-every", "7", *more, pairs=40)


class Experiment(Study, experiment.Experiment):
    name, written, share = "trial", ("long.csv", "short.csv"), 0.3

    def setUp(self):
        super().setUp()
        self.document(experiment.PRIMARY, [("matches: 4", "matches: 60")])

    def command(self, *more):
        return self.arguments("--quiet", "--csv", "long.csv", "--summary", "short.csv", *more)


class Tuning(Study, test_tune.Tuning):
    name, written, share = "trial", ("trace.csv", "tuned.yaml"), 0.3

    def command(self, *more):
        return self.arguments("--quiet", "--trace", "trace.csv", "--output", "tuned.yaml", *more)


if __name__ == "__main__":
    assert not program.SANITIZED
    print(f"kills: {KILLS}, seed {SEED}", file=sys.stderr)
    unittest.main()
