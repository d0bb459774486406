# SPDX-License-Identifier: MIT
"""`regista plugin check`: sound plugins pass, each kind of fault is named, and nothing takes the checker down."""

import json
import os
import shutil
import struct
import subprocess
import unittest

import program

PLUGINS = program.TEST_PLUGINS
SHIPPED = PLUGINS.parent / "plugins"
EXAMPLES = PLUGINS.parent / "examples"
# What a shipped plugin needs to be checked without a warning.
NEEDS = {
    "delaunay_formation": ("--set", f"file={program.SOURCE}/configs/formations/open_play.conf",
                           "--set", "roles=goalkeeper: 1, striker: 2, supporter: 3"),
    "static_partition": ("--may-idle",),
}


class PluginCheck(program.Case):
    def check(self, *arguments, code, timeout=program.PATIENCE):
        if program.SANITIZED and "--processor-seconds" not in arguments:
            arguments += ("--processor-seconds", "100")
        done = self.run_program("plugin", "check", *arguments, "--json", timeout=timeout)
        self.assertEqual((done.returncode, done.stderr), (code, ""), (arguments, done.stdout[-2000:]))
        (report,) = json.loads(done.stdout)
        self.assertEqual(report["passed"], code == 0)
        return report["checks"]

    def found(self, *arguments, code=1, **options):
        """{check: (status, lines)} of all that did not pass."""
        return {check["check"]: (check["status"], check["lines"]) for check in self.check(*arguments, code=code, **options)
                if check["status"] not in ("pass", "skip")}


class Sound(PluginCheck):
    def passes(self, file, *more):
        with self.subTest(file.stem):
            checks = self.check(file, *NEEDS.get(file.stem, ()), *more, code=0)
            self.assertEqual([check for check in checks if check["status"] not in ("pass", "skip")], [])
            return [check["check"] for check in checks]

    def test_shipped_plugins_and_examples_pass_without_a_warning(self):
        """Every fifth of them; the tests of each plugin make the same checks."""
        files = sorted(SHIPPED.glob("*.so")) + sorted(EXAMPLES.glob("*.so"))
        self.assertGreater(len(files), 35)
        for file in files[::8 if program.SANITIZED else 5]:
            self.assertTrue(any(name.endswith(".promises") for name in self.passes(file)))

    def test_all_of_them_call_nothing_strange_and_can_be_created(self):
        for file in (*SHIPPED.glob("*.so"), *EXAMPLES.glob("*.so")):
            self.assertEqual(self.passes(file, "--only", "imports", "--only", "creation"), ["imports", "creation"])

    def test_text_and_only(self):
        text = self.succeed("plugin", "check", SHIPPED / "greedy.so", "--only", "assigner.promises", "--only", "imports")
        self.assertEqual(text.splitlines(), [
            str(SHIPPED / "greedy.so"),
            "  pass   imports                   calls nothing that sound plugins do not need",
            "greedy",
            "  pass   assigner.promises         every output is as abi.h promises",
            f"{SHIPPED / 'greedy.so'}: 2 checks, 2 pass",
        ])

    def test_in_its_own_process(self):
        self.check(SHIPPED / "greedy.so", "--in-process", code=0)

    def test_what_is_missing_is_said(self):
        found = self.found(SHIPPED / "delaunay_formation.so", code=0)
        self.assertEqual(found, {"creation": ("warn", [
            "create: file: none is named, or it is empty; a formation file is needed",
            "nothing more can be checked without it: --set file=FILE"])})
        found = self.found(SHIPPED / "static_partition.so", code=0)
        self.assertEqual(found["assigner.promises"][0], "warn")
        self.assertEqual(found["assigner.promises"][1][-1], "if that is meant: --may-idle")


class Files(PluginCheck):
    def object_says(self, path):
        (check,) = self.check(path, code=1)
        self.assertEqual((check["check"], check["status"]), ("object", "fail"))
        return check["lines"]

    def test_what_is_no_shared_object(self):
        self.write("text.so", "hello\n")
        self.write("empty.so", "")
        (self.folder / "folder.so").mkdir()
        os.mkfifo(self.folder / "pipe.so")
        self.assertEqual(self.object_says("text.so"), ["is not a shared object"])
        self.assertEqual(self.object_says("empty.so"), ["is not a shared object"])
        self.assertEqual(self.object_says("folder.so"), ["is a folder, not a shared object"])
        self.assertEqual(self.object_says("pipe.so"), ["is not a regular file"])
        self.assertEqual(self.object_says("/dev/null"), ["is not a regular file"])

    def test_names_that_are_no_text(self):
        name = os.fsdecode(b"\xff.so")
        (self.folder / name).write_text("hello\n")
        self.assertEqual(self.object_says(name), ["is not a shared object"])
        # Of a plugin, several checks have the name in their lines.
        shutil.copy(PLUGINS / "when_opened_crash" / "crash.so", self.folder / name)
        self.assertEqual(self.found(name)["open"][0], "fail")
        done = self.run_program("plugin", "check", name, "--only", "open")
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertTrue(done.stdout.startswith("\ufffd.so\n"), done.stdout)

    def test_objects_of_another_machine(self):
        whole = bytearray((SHIPPED / "always.so").read_bytes())
        machine = struct.unpack_from("<H", whole, 18)[0]
        other = 183 if machine == 62 else 62  # AArch64, x86-64
        struct.pack_into("<H", whole, 18, other)
        (self.folder / "foreign.so").write_bytes(whole)
        self.assertRegex(self.object_says("foreign.so")[0], "^is built for (AArch64|x86-64); this machine is ")
        # The header of a 32-bit file of x86.
        header = b"\x7fELF\x01\x01\x01" + bytes(9) + struct.pack("<HHIIIIIHHHHHH", 3, 3, 1, 0, 0, 0, 0, 52, 32, 0, 40, 0, 0)
        (self.folder / "small.so").write_bytes(header)
        self.assertRegex(self.object_says("small.so")[0], "^is built for 32-bit x86; this machine is ")

    def test_what_is_cut_off(self):
        whole = (SHIPPED / "always.so").read_bytes()
        for bytes_left in (len(whole) - 1, len(whole) // 2, 64):
            (self.folder / "cut.so").write_bytes(whole[:bytes_left])
            self.assertEqual(self.object_says("cut.so"),
                             [f"is cut off: its header speaks of {len(whole)} bytes, it has {bytes_left}"])

    def test_an_object_without_sections(self):
        bare = bytearray((SHIPPED / "always.so").read_bytes())
        struct.pack_into("<Q", bare, 40, 0)  # where they stand
        struct.pack_into("<HHH", bare, 58, 0, 0, 0)
        (self.folder / "bare.so").write_bytes(bare)
        def seen(file):
            return [(check["check"], check["status"], check["lines"])
                    for check in self.check(file, "--only", "exports", "--only", "needs", "--only", "imports", code=0)]
        self.assertEqual(seen("bare.so"), seen(SHIPPED / "always.so"))

    def test_libraries_that_it_needs(self):
        (check,) = self.check(SHIPPED / "greedy.so", "--only", "needs", code=0)
        self.assertEqual(check["status"], "pass")
        self.assertRegex(check["lines"][0], r"^needs .*libc\.so\.6")
        compiler = shutil.which("gcc") or shutil.which("cc")
        if compiler is None:
            self.skipTest("no compiler")
        self.write("own.c", "int own(void) { return 1; }\n")
        self.write("a.c", "const void* regista_plugin_entry(unsigned a, unsigned b, unsigned c) { return 0; }\n"
                   "extern int own(void);\nstatic int (*volatile called)(void) = own;\n")
        self.write("a.map", "{ global: regista_plugin_entry; local: *; };\n")
        (self.folder / "libs").mkdir()
        subprocess.run([compiler, "-shared", "-fPIC", "own.c", "-o", "libs/libown.so"], cwd=self.folder, check=True)
        build = [compiler, "-shared", "-fPIC", "a.c", "-o", "a.so", "-Llibs", "-Wl,--no-as-needed", "-lown",
                 "-Wl,--version-script=a.map"]
        subprocess.run(build, cwd=self.folder, check=True)
        found = self.found("a.so")
        self.assertEqual(found["needs"][0], "warn")
        self.assertEqual(found["needs"][1][1:],
                         ["libown.so has to be installed wherever the plugin plays: link it statically"])
        self.assertIn("libown.so", found["open"][1][0])  # which nobody finds
        for path in (self.folder / "libs", "$ORIGIN/libs"):
            subprocess.run([*build, f"-Wl,-rpath,{path}"], cwd=self.folder, check=True)
            self.assertEqual(self.found("a.so")["needs"][1][1:],
                             [f"finds libown.so in {self.folder}/libs, which it was built with: others do not have that "
                              "folder"])

    def test_what_cannot_be_linked(self):
        compiler = shutil.which("gcc") or shutil.which("cc")
        if compiler is None:
            self.skipTest("no compiler")
        self.write("a.c", "const void* regista_plugin_entry(unsigned a, unsigned b, unsigned c) { return 0; }\n"
                   "extern int nobody_has_this(void);\nint calls(void) { return nobody_has_this(); }\n")
        subprocess.run([compiler, "-fPIC", "-c", "a.c", "-o", "a.o"], cwd=self.folder, check=True)
        self.assertIn("has not been linked", self.object_says("a.o")[0])
        subprocess.run([compiler, "-shared", "a.o", "-o", "a.so"], cwd=self.folder, check=True)
        found = self.found("a.so")
        self.assertEqual(found["exports"], ("fail", [
            "exports 1 symbol beside regista_plugin_entry: calls",
            "others may take its symbols for their own: link it with a version script, as regista_add_plugin does"]))
        self.assertIn("undefined symbol: nobody_has_this", found["open"][1][0])

    def test_bad_input(self):
        self.assertEqual(self.refused("plugin", "check"),
                         "plugin check: which file? Name a shared object, such as build/my_plugin.so")
        self.assertEqual(self.refused("plugin", "check", "nobody.so"), "nobody.so: no such file")
        self.assertIn('unknown check "promise" in --only; nearest: "promises"',
                      self.refused("plugin", "check", SHIPPED / "greedy.so", "--only", "promise"))
        self.assertEqual(self.refused("plugin", "check", SHIPPED / "greedy.so", "--plugin", "gredy"),
                         f'unknown plugin "gredy" in {SHIPPED / "greedy.so"}; nearest: "greedy"; known: greedy')
        self.assertEqual(self.refused("plugin", "check", SHIPPED / "static_partition.so", "--set", "fill=yes"),
                         '--set fill="yes": expected true or false')
        for value, reason in (("vote_age=0", '--set vote_age="0": expected a number from 0.1 to 60'),
                              ("vote_age=nan", '--set vote_age="nan": expected a number from 0.1 to 60'),
                              ("cost=distances", 'unknown value "distances" in --set cost; nearest: "distance"; '
                                                 "known: distance, utility"),
                              ("vote_aged=1", f'unknown parameter "vote_aged" in the plugins of {SHIPPED / "scram_vote.so"}; '
                                              'nearest: "vote_age"; known: criterion, cost, incumbent, vote_age, stop_negotiating_at')):
            self.assertEqual(self.refused("plugin", "check", SHIPPED / "scram_vote.so", "--set", value), reason)
        self.assertEqual(self.refused("plugin", "check", SHIPPED / "greedy.so", "--set", "reach"),
                         '--set "reach": expected NAME=VALUE')


    def test_the_command_that_is_for_the_program_itself(self):
        for words in ((), ("a", "b"), ("a", "b", "/x", "y", "2", "0", "/dev/null"), ("800", "801", "/x", "y", "2", "0", "/dev/null"),
                      ("800", "801", "/x", "y", "2", "0", "/dev/null", "no_sign")):
            self.refused("plugin", "check-elsewhere", *words)

    def test_checks_that_a_file_does_not_have(self):
        greedy = SHIPPED / "greedy.so"
        self.assertEqual(self.refused("plugin", "check", greedy, "--only", "assigner", "--only", "labels"),
                         f"--only labels: {greedy} has no such check")
        self.assertEqual(self.refused("plugin", "check", greedy, SHIPPED / "scram.so", "--only", "capacity"),
                         "--only capacity: none of these files has such a check")
        # Which holds only of a file that was opened.
        self.write("text.so", "hello\n")
        self.assertEqual(self.found("text.so", "--only", "labels"), {"object": ("fail", ["is not a shared object"])})
        crash = PLUGINS / "when_opened_crash" / "crash.so"
        self.assertEqual([check["check"] for check in self.check(crash, "--only", "labels", code=1)], ["open"])

    def test_parameters_are_those_of_the_chosen_plugins(self):
        bad = PLUGINS / "contract" / "contract_bad_assigners.so"
        self.assertEqual(self.refused("plugin", "check", bad, "--plugin", "keeps", "--set", "reach=1"),
                         f'unknown parameter "reach" in the chosen plugins of {bad}')
        for words in ((), ("--plugin", "wrong_in_a_corner"), ("--plugin", "keeps", "--plugin", "wrong_in_a_corner")):
            self.check(bad, *words, "--set", "reach=1", "--only", "imports", code=0)
        # A name that several plugins of a file have is listed once.
        line = self.refused("plugin", "check", PLUGINS / "contract" / "contract_good.so", "--set", "nobody_has_this=1")
        known = line.partition("known: ")[2].split(", ")
        self.assertEqual(sorted(known), sorted(set(known)))

    def test_a_folder_for_a_file(self):
        self.assertEqual(self.refused("plugin", "check", SHIPPED / "delaunay_formation.so", "--set", "file=/tmp"),
                         "/tmp: is a folder; expected a file")

    def test_several_files_are_looked_at_first(self):
        greedy, static = SHIPPED / "greedy.so", SHIPPED / "static_partition.so"
        for later in (("nobody.so",), (static, "--set", "fill=yes"), (static, "--plugin", "gredy")):
            done = self.run_program("plugin", "check", greedy, *later, "--only", "promises")
            self.assertEqual((done.returncode, done.stdout), (2, ""), "nothing is told before all was looked at")
        # What one of them has is not unknown.
        for words in (("--set", "fill=true"), ("--plugin", "static_partition")):
            done = self.run_program("plugin", "check", greedy, static, *words, "--only", "imports", "--json")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual([report["file"] for report in json.loads(done.stdout)], [str(greedy), str(static)])
        self.assertIn('unknown parameter "filled" in the plugins of these files; nearest: "fill"',
                      self.refused("plugin", "check", greedy, static, "--set", "filled=true"))
        text = self.succeed("plugin", "check", greedy, static, "--only", "imports").splitlines()
        self.assertEqual([text[0], text[3]], [str(greedy), str(static)])


class Faults(PluginCheck):
    def test_when_it_is_opened(self):
        # Sanitizers end the process before the signal does.
        crash = "ended the process" if program.SANITIZED else "died when it was opened: Segmentation fault"
        for name, reason in (("crash", crash),
                             ("leave", "ended the process when it was opened"),
                             # Where much else is to be done, it has no two seconds in ten.
                             ("spin", "used more than 2 s of processor time when it was opened|could not be opened within "),
                             ("sleep_on", "slept for 2 s when it was opened"),
                             ("start_a_thread", "starts a thread when it is opened")):
            with self.subTest(name):
                status, lines = self.found(PLUGINS / f"when_opened_{name}" / f"{name}.so")["open"]
                self.assertEqual(status, "fail")
                self.assertRegex(lines[0], reason)

    def test_of_its_declaration(self):
        for name, reason in (("duplicate_parameter", "declared twice"), ("default_out_of_range", "outside its range"),
                             ("older_minor", "built for Regista plugin interface"), ("empty_list", "contains no plugin")):
            with self.subTest(name):
                (file,) = (PLUGINS / name).glob("*.so")
                self.assertIn(reason, self.found(file)["open"][1][0])

    def test_of_its_answers(self):
        found = self.found(PLUGINS / "contract" / "contract_bad_scorers.so")
        self.assertIn("fail", {status for status, _ in found.values()})
        found = self.found(PLUGINS / "bad_values" / "bad_values.so")
        self.assertEqual(found["assigner.promises"][0], "fail")
        self.assertIn("utility.promises", found)

    def test_of_chance(self):
        for plugin in ("asks_for_the_folder", "asks_who_else_is_there"):
            status, lines = self.of("chance/chance.so", plugin, "--only", "elsewhere", code=1)
            self.assertEqual(status, "fail")
            self.assertTrue(lines[0].startswith("the same calls give another result in another process"), lines)
        # Where there is no other plugin, none plays.
        for file in self.plugin_folder.glob("*.so"):
            file.unlink()
        self.assertEqual(self.of("chance/chance.so", "asks_who_else_is_there", "--only", "elsewhere", code=0)[0], "pass")

    def test_elsewhere_the_files_of_parameters_are_found(self):
        shutil.copy(program.SOURCE / "configs" / "formations" / "open_play.conf", self.folder / "own.conf")
        words = ("--set", "file=own.conf", "--set", "roles=goalkeeper: 1, striker: 2, supporter: 3")
        (check,) = self.check(SHIPPED / "delaunay_formation.so", "--only", "elsewhere", *words, code=0)
        self.assertEqual((check["status"], check["lines"]), ("pass", []))

    def test_what_ends_or_holds_the_process(self):
        found = self.found(PLUGINS / "hangs" / "hangs.so", "--processor-seconds", "1")
        self.assertEqual(found["context.promises"],
                         ("crash", ["used more than 1 s of processor time", "at: defaults; 3 robots: usual"]))
        self.assertNotIn("context.growth", found, "nobody waits twice")
        checks = self.check(PLUGINS / "deaths" / "deaths.so", "--only", "promises", "--processor-seconds", "1", code=1)
        crashed = {check["plugin"]: check["lines"][0] for check in checks if check["status"] == "crash"}
        self.assertIn("Segmentation fault" if not program.SANITIZED else "ended the process", " ".join(crashed.values()))
        self.assertGreater(len(crashed), 2)

    def test_when_the_process_ends(self):
        found = self.found(PLUGINS / "when_closed_spin" / "spin.so", "--processor-seconds", "1")
        self.assertEqual(found, {"ending": ("crash", ["used more than 1 s of processor time", "at: the end of the process"])})
        found = self.found(PLUGINS / "when_closed_sleep_on" / "sleep_on.so")
        self.assertEqual(found["ending"], ("crash", ["did nothing for 5 s", "at: the end of the process"]))
        found = self.found(PLUGINS / "when_closed_leave" / "leave.so")
        self.assertEqual(found["ending"], ("fail", ["the process ends with exit code 7"]))

    def test_a_refusal_in_its_own_process(self):
        bad = "contract/contract_bad_assigners.so"
        for words in (("--in-process",), ()):
            self.assertEqual(self.of(bad, "never_created", "--only", "cost", *words, code=1),
                             ("fail", ["create: no such formation"]))

    def of(self, file, plugin, *arguments, code):
        """The one check of the one plugin of a file."""
        checks = self.check(PLUGINS / file, "--plugin", plugin, *arguments, code=code)
        (found,) = [check for check in checks if check["plugin"] == plugin]
        return found["status"], found["lines"]

    def test_of_memory(self):
        bad = "contract/contract_bad_assigners.so"
        for plugin, reason in (("reads_behind", "it went behind the end of what it was given"),
                               ("scribbles_tasks", "it wrote to what it may only read")):
            status, lines = self.of(bad, plugin, "--only", "memory", code=1)
            self.assertEqual(status, "crash")
            self.assertRegex(lines[1], "^at: 3 robots: ")  # in which scene
            if not program.SANITIZED:
                self.assertEqual((lines[0], lines[2]), ("Segmentation fault", reason))

    @unittest.skipIf(program.SANITIZED, "rehearsals take long there; contract_negotiations has two")
    def test_of_negotiations(self):
        negotiations = "contract/contract_negotiations.so"
        status, lines = self.of(negotiations, "consensus_auction", "--only", "rehearsal", code=0)
        self.assertEqual(status, "pass")
        for line, loss in zip(lines, (0, 30, 60), strict=True):
            self.assertRegex(line, rf"^{loss} % of the packets lost: they agree after [\d.]+ s \(median\) and [\d.]+ s "
                                   r"\(longest\), and a robot says [\d.]+ bytes a second$")
        for plugin in ("counts_columns", "falls_silent"):
            status, failed = self.of(negotiations, plugin, "--only", "rehearsal", code=1)
            self.assertEqual(status, "fail")
            self.assertRegex(failed[0], r"^no agreement within 20\.0 s: .* \(0 % of the packets lost, 3 robots; ")
        # Another seed plays another rehearsal, and the same seed the same.
        with_seed = ("--only", "rehearsal", "--seed", "7")
        again = self.of(negotiations, "consensus_auction", *with_seed, code=0)
        self.assertNotEqual(again[1], lines)
        self.assertEqual(self.of(negotiations, "consensus_auction", *with_seed, code=0), again)

    @unittest.skipIf(program.SANITIZED, "rehearsals take long there; contract_negotiations has two")
    def test_of_who_talks_and_does_not_negotiate(self):
        status, lines = self.of("contract/contract_negotiations.so", "does_not_say_it_negotiates", "--only", "rehearsal", code=0)
        self.assertEqual(status, "warn")
        self.assertIn("robot 2 does not know one of the tasks", lines[0])
        self.assertIn("it does not say that it negotiates, and may mean to decide alone", lines)

    def test_what_a_call_costs(self):
        lines = self.of("contract/contract_negotiations.so", "consensus_auction", "--only", "cost", code=0)[1]
        counted = "" if program.SANITIZED else r", 0\.0 allocations a call"
        self.assertRegex(lines[0], rf"^assign: half of the calls within [\d.]+ us, 99 % within [\d.]+ us{counted} \(\d+ calls\)$")

    def test_what_it_leaves_behind(self):
        found = self.found(PLUGINS / "threads" / "threads.so", "--only", "promises", "--only", "imports")
        self.assertEqual(found["imports"][0], "warn")
        self.assertTrue(any("pthread_create" in line or "std::thread" in line for line in found["imports"][1]))


if __name__ == "__main__":
    unittest.main()
