# SPDX-License-Identifier: MIT
"""Studies on a cluster: a Slurm of two nodes on this machine plays them, and what they say equals what one local worker
says. Skipped where Slurm cannot be started."""

import json
import os
import signal
import subprocess
import unittest

import experiment
import program
import test_tune
import tournament
from cluster import OnCluster, cluster, setUpModule, tearDownModule  # noqa: F401

DOCUMENT = """tournament: small_one
question: Which is better?
teams:
  - {team: small.yaml}
  - {team: other.yaml}
  - {team: worse.yaml}
pairs: PAIRS
openings: scenes
"""
TEST = """tournament: decided
teams:
  - {team: small.yaml}
  - {team: worse.yaml}
pairs: 60
openings: scenes
test: {metric: goals}
"""

class Tournaments(OnCluster):
    def document(self, pairs=3, text=DOCUMENT):
        self.write("study.yaml", text.replace("PAIRS", str(pairs)))

    def local(self, *more):
        return self.succeed("run", "study.yaml", "--quiet", "--no-page", "--workers", 1, "--results", "local.db", *more)

    def test_it_says_what_one_worker_says(self):
        self.document()
        local = self.local()
        there = self.succeed(*self.on_slurm("study.yaml", "--array", 4, "--per-task", 3))
        self.assertEqual(there, local)
        self.assert_same_reports("study.cluster/results.db", "local.db")
        self.assertEqual(self.rows("study.cluster/results.db"), self.rows("local.db"))
        # 18 matches in batches of 12 at most, of which the first of each pairing counts as six; nothing is left of the parts.
        self.assertEqual([each["matches"] for each in self.progress()["batches"]], [3, 7, 8])
        self.assertEqual(list((self.folder / "study.cluster" / "parts").iterdir()), [])
        self.assertTrue((self.folder / "study.cluster" / "results.html").exists())
        status = json.loads(self.succeed("status", "study.cluster", "--json"))
        self.assertEqual((status["state"], status["matches"], status["gathered"]), ("complete", 18, 18))
        self.assertIn("18 of 18 matches", self.succeed("status", "study.cluster"))
        # A complete study is reported, and nothing is submitted.
        self.assertEqual(self.succeed("gather", "study.cluster", "--quiet", "--no-page"), local)
        self.assertEqual(cluster().jobs(), [])

    def test_what_is_edited_meanwhile_changes_nothing(self):
        self.document()
        self.local()
        self.begin("study.yaml", "--array", 2, "--per-task", 3)
        for name in ("small.yaml", "other.yaml", "study.yaml", "scenes/left.yaml"):
            (self.folder / name).write_text("nonsense: true\n")
        for plugin in self.plugin_folder.iterdir():
            plugin.unlink()
        self.wait_for_end()
        self.assert_same_reports("study.cluster/results.db", "local.db")

    def test_a_test_stops_at_the_same_pair(self):
        self.document(text=TEST)
        local = json.loads(self.local("--json"))
        there = json.loads(self.succeed(*self.on_slurm("study.yaml", "--array", 2, "--per-task", 4, "--json")))
        self.assertEqual(there, local)
        self.assertLess(local["matches"], 100)
        played = self.count("study.cluster/results.db")
        self.assertLess(played - local["matches"], 8)  # one batch
        self.assertLess(played, 120)
        beyond = f"{played - local['matches']} matches were played beyond the end of the study, and are not counted"
        self.assertEqual(self.progress()["message"], beyond if played > local["matches"] else "")
        self.assert_same_reports("study.cluster/results.db", "local.db")

    def test_a_test_ends_its_array_though_nobody_waits(self):
        self.document(text=TEST)
        local = json.loads(self.local("--json"))
        self.begin("study.yaml", "--array", 12, "--per-task", 11)  # all that there may be is one batch
        self.wait_for_end()
        self.assertEqual(len(self.progress()["batches"]), 1)
        played = self.count("study.cluster/results.db")
        self.assertLess(local["matches"], 100)
        self.assertLess(played, 120)
        self.assert_same_reports("study.cluster/results.db", "local.db")
        self.assertTrue((self.folder / "study.cluster" / "results.html").exists(), self.logs())

    def test_a_scancel_that_fails_is_said_and_tried_again(self):
        self.document(text=TEST.replace("pairs: 60", "pairs: 200"))
        local = self.local()
        path = self.folder / "path"
        path.mkdir()
        cancel = path / "scancel"
        cancel.write_text(f"""#!/bin/sh
if mkdir {path}/asked 2>/dev/null; then
  echo "scancel: error: Unable to contact slurm controller (connect failure)" >&2
  exit 1
fi
if mkdir {path}/failed 2>/dev/null; then
  echo "scancel: error: Kill job error on job id 1: Access/permission denied" >&2
  exit 1
fi
exec "$(PATH={cluster().environment["PATH"]} command -v scancel)" "$@"
""")
        cancel.chmod(0o755)
        there = self.run_program(*self.on_slurm("study.yaml", "--array", 12, "--per-task", 11, "--no-page"),
                                 environment={"PATH": f"{path}:{cluster().environment['PATH']}"})
        self.assertEqual((there.returncode, there.stdout), (0, local), there.stderr)
        self.assertTrue((path / "failed").exists(), "nothing was cancelled")
        self.assertIn("Access/permission denied", "".join(self.progress()["remarks"]))
        self.wait_for(lambda: not cluster().jobs())
        self.assertLess(self.count("study.cluster/results.db"), 400)

    def kill_the_submitter(self):
        """As soon as Slurm has its array. The number of that."""
        path = self.folder / "path"
        path.mkdir()
        submit = path / "sbatch"
        submit.write_text(f"""#!/bin/sh
"$(PATH={cluster().environment["PATH"]} command -v sbatch)" "$@" || exit
kill -KILL $PPID
""")
        submit.chmod(0o755)
        killed = self.run_program(*self.on_slurm("study.yaml", "--array", 2, "--per-task", 20, "--sbatch", "begin=now+5"),
                                  environment={"PATH": f"{path}:{cluster().environment['PATH']}"})
        self.assertEqual(killed.returncode, -signal.SIGKILL)
        self.assertEqual([each["array_job"] for each in self.progress()["batches"]], [""])
        jobs = cluster().jobs()
        self.assertEqual(len(jobs), 1, jobs)
        return jobs[0].split("_")[0]

    def test_an_array_whose_submitter_was_killed_is_found_again(self):
        self.document()
        self.local()
        array = self.kill_the_submitter()
        self.succeed("gather", "study.cluster", "--quiet")
        self.assertEqual([each["array_job"] for each in self.progress()["batches"]], [array])
        self.wait_for_end()
        self.assertEqual(len(self.progress()["batches"]), 1)
        self.assert_same_reports("study.cluster/results.db", "local.db")

    def test_an_array_whose_submitter_was_killed_is_ended(self):
        self.document()
        self.kill_the_submitter()
        self.succeed("stop", "study.cluster")
        self.wait_for(lambda: not cluster().jobs(), 4)  # before it would have begun

    def test_a_sbatch_that_does_not_answer_may_have_submitted(self):
        self.document()
        local = self.local()
        path = self.folder / "path"
        path.mkdir()
        submit = path / "sbatch"
        submit.write_text(f"""#!/bin/sh
"$(PATH={cluster().environment["PATH"]} command -v sbatch)" "$@" >/dev/null || exit
echo "sbatch: error: Batch job submission failed: Socket timed out on send/recv operation" >&2
exit 1
""")
        submit.chmod(0o755)
        there = self.run_program(*self.on_slurm("study.yaml", "--array", 2, "--per-task", 20, "--no-page"),
                                 environment={"PATH": f"{path}:{cluster().environment['PATH']}"})
        self.assertEqual((there.returncode, there.stdout), (0, local), there.stderr)
        self.assertEqual(len(self.progress()["batches"]), 1)

    def test_killed_tasks_lose_nothing(self):
        self.document(pairs=24)
        self.local()
        self.begin("study.yaml", "--array", 4, "--per-task", 18)
        harmed = self.harm(most=12, seed=int(os.environ.get("REGISTA_SEED", "1")))
        self.assertGreater(sum(harmed.values()), 2, "it ended before it was harmed")
        self.wait_for_end()
        self.assert_same_reports("study.cluster/results.db", "local.db")
        self.assertEqual(self.rows("study.cluster/results.db"), self.rows("local.db"))

    def test_a_task_that_runs_twice_at_once(self):
        self.document()
        self.local()
        self.begin("study.yaml", "--array", 1, "--per-task", 18)
        self.wait_for(self.tasks)
        twice = self.start("cluster-task", "study.cluster", 1, 0, stderr=subprocess.PIPE)
        self.wait_for_end()
        _, error = twice.communicate(timeout=program.PATIENCE)
        self.assertEqual((twice.returncode, error), (0, ""))
        self.assertEqual(self.rows("study.cluster/results.db"), self.rows("local.db"))

    def test_a_part_that_is_cut_off_is_named_and_played_again(self):
        self.document()
        self.local()
        self.begin("study.yaml", "--array", 2, "--per-task", 9)
        parts = self.folder / "study.cluster" / "parts"
        self.wait_for(lambda: (parts / "1-0.db.part").exists())
        self.succeed("stop", "study.cluster")
        self.wait_for(lambda: not cluster().jobs())
        part = parts / "1-0.db.part" if (parts / "1-0.db.part").exists() else parts / "1-0.db"
        self.wait_for(lambda: part.stat().st_size > 5000)  # a network file system shows it somewhat later
        part.write_bytes(part.read_bytes()[:5000])
        done = self.run_program("gather", "study.cluster")
        self.assertEqual(done.returncode, 0)
        self.assertIn("cannot be read", done.stderr)
        self.assertIn("the study was stopped; to go on: regista resume", done.stderr)
        self.assertEqual(cluster().jobs(), [])
        self.succeed("resume", "study.cluster", "--quiet")
        self.wait_for_end()
        self.assert_same_reports("study.cluster/results.db", "local.db")

    def test_a_node_with_another_program_plays_nothing(self):
        self.document()
        self.begin("study.yaml", "--array", 2, "--per-task", 9, "--sbatch", "begin=now+4")
        with open(self.folder / "study.cluster" / "bin" / "regista", "ab") as file:
            file.write(b"another")
        self.wait_for(lambda: not cluster().jobs())
        # The job that was to gather ran with it, too.
        self.assertIn("this machine cannot go on with the study: its program is another", self.logs())
        gathered = self.run_program("gather", "study.cluster")
        self.assertRegex(self.succeed("status", "study.cluster"), r"node node[12] plays nothing: its program is another")
        self.assertNotEqual(gathered.stderr, "")
        self.assertEqual(self.progress()["rows"], 0)

    def test_a_node_that_reads_another_plugin_plays_nothing(self):
        self.document()
        self.local()
        self.begin("study.yaml", "--array", 2, "--per-task", 20, "--sbatch", "begin=now+4")
        plugin = next((self.folder / "study.cluster" / "files").rglob("*.so"))
        whole = plugin.read_bytes()
        plugin.unlink()  # not written over: it may be in use
        plugin.write_bytes(whole + b"another")
        self.wait_for(lambda: self.progress()["refused_nodes"])
        self.assertRegex(self.succeed("status", "study.cluster"), f"node node[12] plays nothing: .*{plugin.name}")
        self.assertEqual(self.progress()["rows"], 0)
        self.wait_for(lambda: not cluster().jobs())
        plugin.write_bytes(whole)
        self.succeed("resume", "study.cluster", "--quiet")
        self.wait_for_end()
        self.assert_same_reports("study.cluster/results.db", "local.db")

    def test_a_node_with_other_mathematics_plays_nothing(self):
        self.document()
        self.begin("study.yaml", "--array", 2, "--per-task", 9,
                   "--sbatch", "export=ALL,GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA,-FMA4")
        self.wait_for(lambda: self.progress()["refused_nodes"] or self.progress()["state"] != "running")
        if self.progress()["state"] == "complete":
            self.skipTest("this processor computes the same numbers either way")
        self.assertIn("its mathematics library or processor computes other numbers", self.logs())

    def test_what_slurm_refuses_is_said_in_a_line(self):
        self.document()
        refused = self.refused(*self.on_slurm("study.yaml", "--partition", "nobody"))
        self.assertIn("invalid partition", refused.lower())
        self.assertFalse((self.folder / "study.cluster").exists())
        without = self.run_program(*self.on_slurm("study.yaml"), environment={"PATH": "/nowhere"})
        self.assertEqual(without.returncode, 2)
        self.assertIn("there is no squeue here", without.stderr.replace("sbatch", "squeue"))
        self.assertFalse((self.folder / "study.cluster").exists())

    def test_bad_input(self):
        self.document()
        self.assertIn("belongs to --on", self.refused("run", "study.yaml", "--array", 4))
        self.assertIn("--array", self.refused(*self.on_slurm("study.yaml", "--array", 0)))
        self.assertIn("no such file", self.refused(*self.on_slurm("nobody.yaml")))
        self.assertFalse((self.folder / "study.cluster").exists())
        (self.folder / "study.cluster").mkdir()
        self.assertIn("exists already", self.refused(*self.on_slurm("study.yaml")))
        for command in ("gather", "status", "stop", "resume"):
            self.assertIn("no folder of a study on a cluster", self.refused(command, "study.cluster"))
            self.assertRegex(self.refused(command), f"^{command}: which (study|results)[?] Name (its folder|the file)")

    def test_stopped_and_gone_on_with_at_once(self):
        self.document()
        self.local()
        self.begin("study.yaml", "--array", 2, "--per-task", 9)
        self.wait_for(self.tasks)
        self.succeed("stop", "study.cluster")
        self.assertEqual(self.progress()["state"], "stopped")
        self.assertNotRegex(self.succeed("status", "study.cluster"), "plays?|second")
        self.succeed("resume", "study.cluster", "--quiet")
        self.wait_for_end()
        self.assert_same_reports("study.cluster/results.db", "local.db")

    def test_the_clock_of_a_node_does_not_matter(self):
        self.document()
        self.local()
        self.begin("study.yaml", "--array", 2, "--per-task", 9)
        self.wait_for(lambda: (self.folder / "study.cluster" / "parts" / "1-0.db.part").exists())
        self.succeed("stop", "study.cluster")
        self.wait_for(lambda: not cluster().jobs())
        # As nodes leave them whose clocks are half a century slow and fast.
        for place, file in enumerate(sorted((self.folder / "study.cluster").rglob("*"))):
            os.utime(file, (0, 0) if place % 2 else (4_000_000_000, 4_000_000_000))
        self.succeed("resume", "study.cluster", "--quiet")
        self.wait_for_end()
        self.assert_same_reports("study.cluster/results.db", "local.db")
        self.assertEqual(self.rows("study.cluster/results.db"), self.rows("local.db"))

    def test_more_pairs(self):
        self.document(pairs=4)
        self.local()
        self.document(pairs=2)
        self.succeed(*self.on_slurm("study.yaml", "--array", 2, "--per-task", 9))
        self.succeed("resume", "study.cluster", "--pairs", 4, "--quiet")
        self.wait_for_end()
        self.assertEqual(self.rows("study.cluster/results.db"), self.rows("local.db"))

    def test_a_folder_whose_name_means_something_elsewhere(self):
        self.document(pairs=1)
        name = "a study's %a folder"
        there = self.succeed("run", "study.yaml", "--on", "slurm", "--folder", name + "/", "--quiet", "--no-page")
        self.assertEqual(there, self.local())
        self.assertTrue((self.folder / name / "log" / "1-0.txt").exists())

    def test_a_full_disk_loses_nothing(self):
        if os.geteuid() != 0:
            self.skipTest("only root can make a small file system")
        self.document()
        self.local()
        small = self.folder / "small_disk"
        small.mkdir()
        program_size = program.PROGRAM.stat().st_size // 2**20
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={program_size + 16}m", "none", small],
                                 capture_output=True)
        if mounted.returncode != 0:
            self.skipTest("no small file system can be made here")
        self.addCleanup(lambda: subprocess.run(["umount", "-l", small], check=True))
        self.succeed("run", "study.yaml", "--on", "slurm", "--folder", "small_disk/s", "--detach", "--quiet", "--array", 2,
                     "--per-task", 9, "--sbatch", "begin=now+4")
        with self.assertRaises(OSError), open(small / "filler", "wb", buffering=0) as filler:
            while True:
                self.assertGreater(filler.write(b"x" * 4096), 0)
        self.wait_for(lambda: not cluster().jobs())
        self.assertRegex("".join(each.read_text() for each in (small / "s" / "log").iterdir()) + "nothing was written",
                         "disk is full|No space left|nothing was written")
        (small / "filler").unlink()
        self.succeed("resume", "small_disk/s", "--quiet")
        self.wait_for(lambda: json.loads((small / "s" / "cluster.json").read_text())["progress"]["state"] == "complete")
        self.wait_for(lambda: not cluster().jobs())
        self.assert_same_reports("small_disk/s/results.db", "local.db")

    def test_an_interrupted_wait_leaves_the_array(self):
        self.document()
        waiting = self.start(*self.on_slurm("study.yaml", "--array", 2, "--per-task", 9), stderr=subprocess.PIPE)
        self.wait_for(self.tasks)
        waiting.send_signal(signal.SIGINT)
        _, said = waiting.communicate(timeout=30)
        self.assertEqual(waiting.returncode, 130)
        self.assertIn("the array plays on; to look: regista status", said)
        self.wait_for_end()


class Experiments(OnCluster, experiment.Experiment):
    def test_it_says_what_one_worker_says(self):
        local = self.succeed("run", "e.yaml", "--quiet", "--no-page", "--workers", 1, "--results", "local.db")
        self.assertEqual(self.succeed(*self.on_slurm("e.yaml", "--array", 3, "--per-task", 2)), local)
        self.assert_same_reports("study.cluster/results.db", "local.db")


class Tunings(OnCluster, test_tune.Tuning):
    def test_generations_are_played_as_batches(self):
        self.document(algorithm="sep_cma_es", matches=40)
        local = self.succeed("run", "t.yaml", "--quiet", "--no-page", "--workers", 1, "--results", "local.db")
        there = self.succeed(*self.on_slurm("t.yaml", "--array", 4, "--per-task", 10))
        self.assertEqual(there.replace("study.cluster/results", "local").replace(str(self.folder) + "/", ""), local)
        self.assert_same_reports("study.cluster/results.db", "local.db")
        self.assertGreater(len(self.progress()["batches"]), 3)
        self.succeed("config", "check", "study.cluster/results.tuned.yaml")
        shown = [self.succeed("config", "show", file) for file in ("study.cluster/results.tuned.yaml", "local.tuned.yaml")]
        self.assertEqual(shown[0].replace("study.cluster/results", "local"), shown[1])

    def test_who_does_not_wait_gets_the_same_team(self):
        self.document(algorithm="sep_cma_es", matches=40)
        self.begin("t.yaml", "--array", 4, "--per-task", 10)
        self.wait_for_end()
        self.succeed("config", "check", "study.cluster/results.tuned.yaml")


if __name__ == "__main__":
    unittest.main()
