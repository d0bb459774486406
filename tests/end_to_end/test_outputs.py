# SPDX-License-Identifier: MIT
"""What is written never costs what is read, what was found, or another file that is written; and what cannot be kept,
because results, a folder or a disk are gone, is told in one line."""

import contextlib
import os
import pathlib
import resource
import shutil
import sqlite3
import subprocess
import tempfile
import time
import unittest

import experiment
import program
import tournament

MATCH = ("match", "small.yaml", "other.yaml", "--limit", "1", "--quiet")
TUNING = """\
tuning: trial
team: small.yaml
opponents: [{team: other.yaml}]
openings: scenes
limit: 12
parameters: [utility.terms.near.weight]
search: {algorithm: random_search, matches: 8, pairs: 1}
selection: {finalists: 1, matches: 2}
verification: {candidates: 1, matches: 12, confidence: 0.5}
slices: {points: 0}
set: {rules.durations.ready: 3, rules.durations.set: 1}
"""


class Outputs(experiment.Experiment):
    def setUp(self):
        super().setUp()
        self.write("t.yaml", TUNING)
        small = (self.folder / "small.yaml").read_text()
        self.assertIn("weight: 1,", small)
        self.write("small.yaml", small.replace("weight: 1,", "weight: 1, tune: [0.5, 2],"))

    def tuning(self, *more):
        return ["tune", "t.yaml", "--no-page", "--quiet", *more]

    def kept(self):
        """Every file of the folder that was not just made, by what it holds."""
        return {path: path.read_bytes() for path in self.folder.rglob("*")
                if path.is_file() and not path.is_relative_to(self.folder / "bin")}

    def refused_and_nothing_lost(self, *arguments):
        before = self.kept()
        line = self.refused(*arguments)
        self.assertEqual(self.kept(), before, arguments)
        return line

    def studies(self):
        """Commands of studies and their outputs, as words that a file name is to follow."""
        yield from ((self.arguments("--quiet"), option) for option in ("--csv", "--summary", "--results"))
        yield from ((self.tuning(), option) for option in ("--trace", "--output", "--results"))
        yield [*tournament.Tournament.arguments(self, "--quiet", "--no-page")], "--results"


class Inputs(Outputs):
    """Files that a study reads, however it comes to them."""

    def read_by(self, command):
        yield from ("small.yaml", "other.yaml", f"lib/regista/plugins/{tournament.program.SOUND.name}")
        if command[0] != "experiment":
            yield "scenes/left.yaml"  # in a folder that is named
        if command[0] != "tournament":
            yield from ({"experiment": "e.yaml", "tune": "t.yaml"}[command[0]], "base.yaml", "rules.yaml")

    def test_no_output_replaces_what_is_read(self):
        # Parents of a document, and profiles that it names.
        self.write("base.yaml", (self.folder / "small.yaml").read_text())
        self.write("small.yaml", "extends: base.yaml\n")
        self.write("rules.yaml", "rules: mine\n")
        for name in ("e.yaml", "t.yaml"):
            self.write(name, (self.folder / name).read_text() + "rules: rules.yaml\n")
        for command, option in self.studies():
            for name in self.read_by(command):
                for more in ((), ("--force",)) if option in ("--csv", "--summary", "--trace", "--output") else ((),):
                    line = self.refused_and_nothing_lost(*command, option, name, *more)
                    self.assertEqual(line, f"{option} {name}: is a file that this "
                                           f"{ {'tune': 'tuning'}.get(command[0], command[0]) } reads")

    def test_by_whatever_link(self):
        os.symlink("small.yaml", self.folder / "soft.csv")
        os.link(self.folder / "small.yaml", self.folder / "hard.csv")
        os.symlink(self.folder, self.folder / "folder")
        for name in ("soft.csv", "hard.csv", "./e.yaml", "scenes/../e.yaml", "folder/e.yaml", self.folder / "e.yaml"):
            for option in ("--csv", "--summary"):
                self.assertIn("is a file that this experiment reads",
                              self.refused_and_nothing_lost(*self.arguments("--quiet", "--force"), option, name))

    def test_links_in_the_folders_of_recordings_and_figures(self):
        (self.folder / "trial.recordings").mkdir()
        os.symlink("../small.yaml", self.folder / "trial.recordings/1.mcap")
        line = self.refused_and_nothing_lost(*self.arguments("--quiet", "--record-every", "1"))
        self.assertIn("trial.recordings/1.mcap is a file that this experiment reads", line)
        (self.folder / "trial.recordings/1.mcap").unlink()
        (self.folder / "trial.figures").mkdir()
        os.link(self.folder / "other.yaml", self.folder / "trial.figures/overlap_seconds.csv")
        command = [word for word in self.arguments("--quiet") if word != "--no-page"]
        self.assertIn("is a file that this experiment reads", self.refused_and_nothing_lost(*command))

    def test_what_stands_beside_results(self):
        """A team may be called as SQLite would call its log: it would be taken for one, and deleted."""
        for ending in ("-wal", "-shm", "-journal"):
            self.write(f"n.db{ending}", (self.folder / "small.yaml").read_text())
            self.document(changes=(("team: small.yaml", f"team: n.db{ending}"),))
            line = self.refused_and_nothing_lost(*self.arguments("--quiet", "--results", "n.db"))
            self.assertEqual(line, f"the log of --results n.db{ending}: is a file that this experiment reads")

    def test_a_match_from_results(self):
        self.succeed(*tournament.Tournament.arguments(self, "--quiet", "--no-page"))
        again = ("match", "--from", "tournament.db", "--row", "1", "--quiet")
        for option in ("--record", "--decisions", "--metrics"):
            force = ("--force",) if option == "--record" else ()
            for name in ("tournament.db", "tournament.db-wal", "small.yaml", "scenes/left.yaml"):
                self.assertIn("is a file that this match reads",
                              self.refused_and_nothing_lost(*again, option, name, *force))
        for name in ("tournament.db", "tournament.db-wal"):
            self.assertIn("is a file that this report reads",
                          self.refused_and_nothing_lost("report", "tournament.db", "-o", name, "--force"))
        (self.folder / "figures").mkdir()
        os.symlink("../tournament.db", self.folder / "figures/elo.csv")
        self.assertIn("is a file that this report reads",
                      self.refused_and_nothing_lost("report", "tournament.db", "--figures", "figures", "--force"))


class Each(Outputs):
    """Outputs and one another."""

    def test_two_outputs_of_one_name(self):
        os.symlink("new.csv", self.folder / "link.csv")  # to a file that is not there yet
        for one, other in (("new.csv", "./new.csv"), ("new.csv", "link.csv"), ("new.csv", self.folder / "new.csv")):
            line = self.refused_and_nothing_lost(*self.arguments("--quiet", "--csv", one, "--summary", other))
            self.assertEqual(line, f"--csv and --summary: both name {other}")
        for other in ("new.db", "new.db-wal", "new.db-shm", "new.db-journal"):
            for command, option in (*[(self.arguments("--quiet"), each) for each in ("--csv", "--summary")],
                                    *[(self.tuning(), each) for each in ("--trace", "--output")]):
                line = self.refused_and_nothing_lost(*command, "--results", "new.db", option, other)
                self.assertIn(f"both name new.db{other.removeprefix('new.db')}", line)
        self.assertIn("both name", self.refused_and_nothing_lost(*self.tuning("--trace", "trial.tuned.yaml")))
        self.assertFalse((self.folder / "new.csv").exists())

    def test_the_page_and_the_folders_beside_results(self):
        command = [word for word in self.arguments("--quiet") if word != "--no-page"]
        self.assertIn("both name trial.html", self.refused_and_nothing_lost(*command, "--csv", "trial.html"))
        (self.folder / "trial.figures").mkdir()
        self.assertIn("are written to that folder",
                      self.refused_and_nothing_lost(*command, "--summary", "trial.figures/means.csv"))
        (self.folder / "trial.recordings").mkdir()
        self.assertIn("are written to that folder",
                      self.refused_and_nothing_lost(*command, "--csv", "trial.recordings/1.mcap"))

    def test_names_that_are_free(self):
        (self.folder / "out").mkdir()
        self.succeed(*self.arguments("--quiet", "--csv", "out/a.csv", "--summary", "out/b.csv", "--results", "out/c.db"))
        self.assertEqual(len(list((self.folder / "out").iterdir())), 3)


class Foreign(Outputs):
    """Files that nobody reads, but somebody may want."""

    def test_only_by_force(self):
        for command, option in ((self.arguments("--quiet"), "--csv"), (self.arguments("--quiet"), "--summary"),
                                (self.tuning(), "--trace"), (self.tuning(), "--output")):
            for database in self.folder.glob("trial*"):
                database.unlink()
            self.write("mine.txt", "mine\n")
            line = self.refused_and_nothing_lost(*command, option, "mine.txt")
            self.assertRegex(line, rf"^{option} mine\.txt: is there, and is no .*; --force replaces it")
            self.assertFalse((self.folder / "trial.db").exists(), "nothing is played")
            self.succeed(*command, option, "mine.txt", "--force")
            first = (self.folder / "mine.txt").read_text()
            if option == "--output":
                continue  # all weights of a single term are equally good: nothing is found that could be written
            self.assertNotIn("mine\n", first[:5])
            # One of its own kind is replaced, as it always was.
            self.succeed(*command, option, "mine.txt", "--resume")
            self.assertEqual((self.folder / "mine.txt").read_text(), first)

    def test_results_of_another_study_never(self):
        self.succeed(*tournament.Tournament.arguments(self, "--quiet", "--no-page"))
        for command, option in ((self.arguments("--quiet"), "--csv"), (self.arguments("--quiet"), "--summary"),
                                (self.tuning(), "--trace"), (self.tuning(), "--output")):
            line = self.refused_and_nothing_lost(*command, option, "tournament.db", "--force")
            self.assertIn("there is a file of another kind", line)

    def test_a_summary_looks_again(self):
        """What came there while the study was played is kept; the results are safe."""
        with self.start(*self.arguments("--quiet", "--matches", "60", "--summary", "s.csv"),
                        stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            self.wait_for(lambda: self.count("trial.db") > 0)
            self.write("s.csv", "mine\n")
            _, said = process.communicate(timeout=tournament.program.PATIENCE)
        self.assertEqual((process.returncode, said.count("\n")), (2, 1), said)
        self.assertIn("--summary s.csv: is there", said)
        self.assertEqual((self.folder / "s.csv").read_text(), "mine\n")

    def test_force_belongs_to_what_it_forces(self):
        self.assertEqual(self.refused(*self.arguments("--force")),
                         "--force: belongs to --csv and --summary, which are not given")

    def test_places_where_nothing_can_be_written(self):
        for command, option in ((self.arguments("--quiet"), "--csv"), (self.arguments("--quiet"), "--summary"),
                                (self.tuning(), "--trace"), (self.tuning(), "--output")):
            for place, why in (("none/a.csv", "No such file or directory"), ("scenes", "Is a directory")):
                self.assertEqual(self.refused_and_nothing_lost(*command, option, place),
                                 f"{option} {place}: cannot be written there: {why}")
            self.assertFalse((self.folder / "trial.db").exists(), "nothing is played")


class Gone(Outputs):
    """Results, folders and disks that are not there, or no longer."""

    def long(self, *more, results="tournament.db"):
        return tournament.Tournament.arguments(self, "--quiet", "--no-page", "--workers", "1", "--results", results,
                                               *more, pairs=500)

    def ended_when(self, change, *arguments, file="tournament.db"):
        """How a long tournament ends whose results are changed after the first row."""
        with self.start(*arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            self.wait_for(lambda: self.count(file) > 2)
            change()
            out, said = process.communicate(timeout=20)
        self.assertEqual((process.returncode, out, said.count("\n")), (1, "", 1), said)
        return said

    def test_results_that_disappear(self):
        file = self.folder / "tournament.db"

        def replace():
            shutil.copy(file, self.folder / "copy")
            os.replace(self.folder / "copy", file)

        for change in (file.unlink, lambda: file.rename(self.folder / "elsewhere.db"), replace):
            for each in self.folder.glob("*.db*"):
                each.unlink()
            said = self.ended_when(change, *self.long())
            self.assertIn("results in tournament.db: the file is no longer there, or is another one", said)
            self.assertNotIn("--resume", said, "there is nothing to resume")

    def test_limits_of_the_system(self):
        """Of open files and of memory: one line, status 1, and no plugin or file is blamed."""
        command = tournament.Tournament.arguments(self, "--quiet", "--no-page", pairs=1)
        for kind, most, line in ((resource.RLIMIT_NOFILE, 8, "no process can look at plugin files"),
                                 (resource.RLIMIT_NOFILE, 20, "cannot keep a file open"),
                                 (resource.RLIMIT_AS, 30 << 20, "")):
            if kind == resource.RLIMIT_AS and program.SANITIZED:
                continue  # they reserve more
            for each in self.folder.glob("*.db*"):
                each.unlink()
            done = self.run_program(*command, preexec_fn=lambda: resource.setrlimit(kind, (most, most)))
            if done.returncode == 0 and kind == resource.RLIMIT_AS:
                continue  # it was enough
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (1, "", 1), done.stderr)
            self.assertIn(line, done.stderr)
            self.assertNotIn("internal error", done.stderr)

    def test_a_log_that_disappears(self):
        """What stands in it only is lost should the program be killed now."""
        said = self.ended_when((self.folder / "tournament.db-wal").unlink, *self.long())
        self.assertIn("results in tournament.db-wal: the file is no longer there", said)
        self.assertGreater(self.count(), 2)

    def test_results_that_are_written_over(self):
        """In place, by a shell's redirection."""
        file = self.folder / "tournament.db"
        for change, why in ((lambda: os.truncate(file, 0), "it had"),
                            (lambda: file.write_bytes(b"hello\n" + file.read_bytes()[6:]), "does not begin as a file of")):
            for each in self.folder.glob("*.db*"):
                each.unlink()
            said = self.ended_when(change, *self.long())
            self.assertIn("results in tournament.db: something else has written into the file: ", said)
            self.assertIn(why, said)

    def test_results_that_are_written_over_in_the_middle(self):
        """The file is read as a whole before the study ends."""
        self.succeed(*tournament.Tournament.arguments(self, "--quiet", "--no-page", pairs=20))
        file = self.folder / "tournament.db"
        page = 4096
        with open(file, "r+b") as opened:
            opened.seek(2 * page)
            opened.write(bytes(file.stat().st_size - 2 * page))
        done = self.run_program(*tournament.Tournament.arguments(self, "--quiet", "--no-page", "--resume", pairs=20))
        self.assertIn(done.returncode, (1, 2))
        self.assertEqual((done.stdout, done.stderr.count("\n")), ("", 1), done.stderr)
        self.assertIn("tournament.db", done.stderr)

    def test_another_program_holds_the_lock(self):
        """As an open transaction in SQLite's shell does, all night: matches wait in memory, and none is lost."""
        undisturbed = self.succeed(*tournament.Tournament.arguments(self, "--quiet", "--no-page", "--results", "once.db",
                                                                   pairs=40))
        command = tournament.Tournament.arguments(self, "--quiet", "--no-page", "--workers", "1", pairs=40)
        with self.start(*command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            self.wait_for(lambda: self.count() > 2)
            with contextlib.closing(sqlite3.connect(self.folder / "tournament.db", isolation_level=None)) as other:
                other.execute("BEGIN IMMEDIATE")
                held = self.count()
                time.sleep(7)
                self.assertEqual(self.count(), held)
                self.assertIsNone(process.poll())
                other.execute("COMMIT")
            out, said = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (0, undisturbed), said)
        self.assertEqual(said, "regista: tournament.db: another program keeps it from being written to; what is played "
                               "waits in memory\nregista: tournament.db: is free again, and all that waited is written\n")
        self.assertEqual(self.rows("tournament.db"), self.rows("once.db"))

    def test_what_waits_for_a_lock_is_lost_by_name(self):
        command = tournament.Tournament.arguments(self, "--quiet", "--no-page", "--workers", "1", pairs=500)
        with self.start(*command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            self.wait_for(lambda: self.count() > 2)
            with contextlib.closing(sqlite3.connect(self.folder / "tournament.db", isolation_level=None)) as other:
                other.execute("BEGIN IMMEDIATE")
                time.sleep(1)
                process.send_signal(2)
                out, said = process.communicate(timeout=30)
        self.assertEqual((process.returncode, out), (1, ""), said)
        self.assertRegex(said.splitlines()[-1], r"locked by another process, so that (a match that was played is|"
                                                r"\d+ matches that were played are) lost; to go on: .* --resume$")

    def test_a_folder_of_results_that_disappears(self):
        (self.folder / "away").mkdir()
        said = self.ended_when(lambda: shutil.rmtree(self.folder / "away"), *self.long(results="away/r.db"),
                               file="away/r.db")
        self.assertIn("results in away/r.db: the file is no longer there", said)

    def test_no_file_to_report_on(self):
        os.mkfifo(self.folder / "pipe")
        for command in (("report", "pipe"), ("report", "pipe", "--json"), ("match", "--from", "pipe", "--row", "1"),
                        self.long("--resume", results="pipe"), self.arguments("--resume", "--results", "pipe")):
            self.assertEqual(self.refused(*command), "pipe is no ordinary file, so it holds no results")
        for command in (("report", "scenes"), ("match", "--from", "scenes", "--row", "1"),
                        self.long("--resume", results="scenes")):
            self.assertEqual(self.refused(*command), "scenes is a folder, not a file of results")

    def test_no_document_waits_for_ever(self):
        os.mkfifo(self.folder / "pipe")
        for command in (("match", "pipe", "small.yaml"), ("match", "small.yaml", "pipe"),
                        (*MATCH, "--opening", "pipe"), (*MATCH, "--rules", "pipe"), (*MATCH, "--disturbance", "pipe"),
                        ("config", "check", "pipe"), ("config", "show", "pipe"), ("experiment", "pipe"),
                        ("tune", "pipe"), ("view", "pipe"), ("tournament", "--team", "pipe", "--team", "pipe", "--pairs",
                                                             "1"), ("evaluate-predictor", "pipe", "--data", "pipe")):
            self.assertIn("not a regular file", self.refused(*command))

    def test_a_working_folder_that_was_removed(self):
        gone = self.folder / "gone"
        commands = (MATCH, ("report", "x.db"), ("config", "check", "x.yaml"), ("plugin", "list"), ("view", "a.mcap"),
                    ("tournament", "--team", self.folder / "small.yaml", "--team", self.folder / "other.yaml", "--pairs",
                     "1", "--results", self.folder / "t.db"), ("experiment", self.folder / "e.yaml"),
                    ("tune", self.folder / "t.yaml"))
        for command in commands:
            gone.mkdir()
            words = " ".join(map(str, command))
            done = subprocess.run(["/bin/sh", "-c", f'cd gone && rmdir ../gone && exec "{self.program}" {words}'],
                                  cwd=self.folder, env=self.environment(), text=True, capture_output=True, timeout=30,
                                  check=False)
            self.assertEqual((done.returncode, done.stdout, done.stderr),
                             (2, "", "regista: the working folder is no longer there, or may not be entered\n"), command)
        self.assertEqual(list(self.folder.glob("*.db")), [])

    def test_a_working_folder_that_is_removed_while_a_tournament_is_played(self):
        """What stands in it is missing; what does not is not."""
        gone = self.folder / "gone"
        for results, teams, pairs, code, why in (
                ("here.db", self.folder, 500, 1, "results in here.db: the file is no longer there"),
                (self.folder / "there.db", "", 500, 2, "while the tournament was played: "),
                (self.folder / "elsewhere.db", self.folder, 20, 0, "")):
            gone.mkdir()
            command = [self.program, "tournament", "--pairs", pairs, "--limit", "10", "--quiet", "--workers", "1",
                       "--results", results]
            for name in ("small.yaml", "other.yaml"):
                shutil.copy(self.folder / name, gone)
                command += ["--team", os.path.join(teams, name)]
            with subprocess.Popen(list(map(str, command)), cwd=gone, env=self.environment(), text=True,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
                self.wait_for(lambda: self.count(gone / results) > 2)
                shutil.rmtree(gone)
                out, said = process.communicate(timeout=60)
            self.assertEqual((process.returncode, out == "", said.count("\n")), (code, code != 0, int(code != 0)), said)
            self.assertIn(why, said)

    @unittest.skipUnless(os.geteuid() == 0, "only root can mount a disk")
    def test_a_disk_that_is_full_when_results_are_created(self):
        with tempfile.TemporaryDirectory() as place:
            mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", place], check=False,
                                     capture_output=True)
            if mounted.returncode != 0:
                self.skipTest("a disk cannot be mounted here")
            try:
                for filled in (16384, 12288, 8192, 4096):
                    disk = pathlib.Path(place)
                    for each in disk.iterdir():
                        each.unlink()
                    (disk / "filler").write_bytes(b"x" * filled)
                    done = self.run_program(*self.long(results=disk / "r.db"), timeout=30)
                    self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (1, "", 1), done.stderr)
                    self.assertRegex(done.stderr, r"^regista: .*r\.db: the disk is full")
            finally:
                subprocess.run(["umount", place], check=True)


del experiment.Experiment  # or its empty case would be found here, too


if __name__ == "__main__":
    unittest.main()
