# SPDX-License-Identifier: MIT
"""Tournaments whose results cannot be written: no room, no right to."""

import contextlib
import os
import resource
import shutil
import sqlite3
import subprocess
import unittest

import tournament

NOBODY = 65534
PAIRS = 20


class NoRoom(tournament.Tournament):
    def setUp(self):
        super().setUp()
        self.undisturbed = self.play("--results", "undisturbed.db", pairs=PAIRS)

    def check_completed(self):
        done = self.run_program(*self.arguments("--quiet", "--resume", pairs=PAIRS))
        self.assertEqual((done.returncode, done.stdout), (0, self.undisturbed), done.stderr)
        self.assertEqual(self.rows(), self.rows("undisturbed.db"))

    def test_a_limit_on_the_size_of_files(self):
        """What a quota does: at some point nothing more can be written. Python ignores SIGXFSZ, and so does what it
        starts, if it may: then writing fails."""
        size = 160_000
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        began = self.run_program(*self.arguments("--quiet", "--workers", "2", pairs=PAIRS), preexec_fn=limit,
                                 restore_signals=False)
        self.assertEqual((began.returncode, began.stdout), (1, ""), began.stderr)
        self.assertEqual(began.stderr.count("\n"), 1)
        self.assertRegex(began.stderr, r"^regista: results in tournament\.db: .*; to go on: .* --resume\n$")
        self.assertFalse(self.workers())
        rows = self.rows()
        self.assertGreater(len(rows), 0)
        self.assertLess(len(rows), 2 * PAIRS)
        self.assertTrue(set(rows) <= set(self.rows("undisturbed.db")))
        # Still no room.
        again = self.run_program(*self.arguments("--quiet", "--resume", pairs=PAIRS), preexec_fn=limit,
                                 restore_signals=False)
        self.assertEqual(again.returncode, 1, again.stderr)
        self.check_completed()

    def test_a_full_disk(self):
        """A file system with little room, in a name space of its own."""
        name_space = ["unshare", "--user", "--map-root-user", "--mount"]
        disk = self.folder / "disk"
        disk.mkdir()
        mount = f"mount -t tmpfs -o size=140k tmpfs '{disk}'"
        if shutil.which("unshare") is None or subprocess.run([*name_space, "sh", "-c", mount],
                                                             capture_output=True).returncode != 0:
            self.skipTest("nobody may mount a file system here")
        play = " ".join(map(str, self.arguments("--quiet", "--results", "disk/tournament.db", pairs=PAIRS)))
        script = (f"{mount} && bin/regista {play} >out 2>err; echo $? >code; "
                  f"mount -o remount,size=64m '{disk}' && bin/regista {play} --resume; "
                  "last=$?; cp disk/tournament.db* . ; exit $last")
        done = subprocess.run([*name_space, "sh", "-c", script], cwd=self.folder, env=self.environment(), text=True,
                              capture_output=True, timeout=120)
        read = lambda name: (self.folder / name).read_text()
        self.assertEqual((read("code"), read("out")), ("1\n", ""))
        self.assertRegex(read("err"), r"^regista: results in disk/tournament\.db: the disk is full; to go on: .*\n$")
        self.assertEqual((done.returncode, done.stdout), (0, self.undisturbed), done.stderr)
        self.assertEqual(self.rows(), self.rows("undisturbed.db"))


class NoRight(tournament.Tournament):
    """Rights of files do not bind the superuser; where the tests are run by that one, the program is run by nobody."""

    def setUp(self):
        super().setUp()
        self.closed = self.folder / "closed"
        self.closed.mkdir()
        self.play("--results", "closed/there.db", "--no-page", pairs=1)
        self.text = self.succeed("report", "closed/there.db")
        self.who = {}
        if os.geteuid() == 0:
            self.folder.chmod(0o755)
            self.who = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
        self.closed.chmod(0o555)
        self.addCleanup(self.closed.chmod, 0o755)

    def test_a_folder_that_may_not_be_written(self):
        line = self.refused(*self.arguments("--results", "closed/new.db"), **self.who)
        self.assertEqual(line, "cannot write results to closed/new.db: Permission denied")
        self.assertEqual([file.name for file in self.closed.iterdir()], ["there.db"])

    def test_a_file_that_may_not_be_written_can_be_told_of(self):
        (self.closed / "there.db").chmod(0o444)
        line = self.refused(*self.arguments("--resume", "--results", "closed/there.db", pairs=1), **self.who)
        self.assertEqual(line, "cannot write results to closed/there.db: Permission denied")
        self.assertEqual(self.succeed("report", "closed/there.db", **self.who), self.text)
        self.assertEqual([file.name for file in self.closed.iterdir()], ["there.db"])

    def test_a_file_in_a_folder_that_may_not_be_written(self):
        """The file alone is not enough: its log has no place."""
        (self.closed / "there.db").chmod(0o666)
        done = self.run_program(*self.arguments("--resume", "--results", "closed/there.db", pairs=1), **self.who)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertRegex(done.stderr, r"^regista: .*closed/there\.db.*\n$")
        self.assertEqual(self.succeed("report", "closed/there.db", **self.who), self.text)

    def test_a_log_beside_a_file_in_a_folder_that_may_not_be_written(self):
        """As a copy of a study that is played has it: SQLite reads a log by an index, a file of its own."""
        self.closed.chmod(0o755)
        log = self.closed / "there.db-wal"
        with contextlib.closing(sqlite3.connect(self.closed / "there.db")) as database:
            database.execute("PRAGMA journal_mode=WAL")
            database.execute("PRAGMA user_version=2")
            database.commit()
            log_bytes = log.read_bytes()
        log.write_bytes(log_bytes)
        self.closed.chmod(0o555)
        self.assertEqual(sorted(file.name for file in self.closed.iterdir()), ["there.db", "there.db-wal"])
        self.assertEqual(self.refused("report", "closed/there.db", **self.who),
                         "closed/there.db: its log closed/there.db-wal can only be read where closed/there.db-shm may be "
                         "written; copy both to a folder that may be written")
        copy = self.folder / "copy"
        shutil.copytree(self.closed, copy)
        copy.chmod(0o777)
        self.assertEqual(self.succeed("report", "copy/there.db", **self.who).replace("copy/", "closed/"), self.text)

    def test_a_file_that_may_not_be_read(self):
        (self.closed / "there.db").chmod(0o000)
        self.assertEqual(self.refused("report", "closed/there.db", **self.who),
                         "cannot read closed/there.db: Permission denied")


if __name__ == "__main__":
    unittest.main()
